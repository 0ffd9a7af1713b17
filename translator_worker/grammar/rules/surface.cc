// SPDX-License-Identifier: GPL-3.0-or-later
// On and under objects: things on tables, rugs under them, chairs tucked in.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

void OnOne(const Placed& mover, const Placed& host, std::string_view corner, Composer& composer) {
  const std::string& id = composer.id(mover);
  const std::string& below = composer.id(host);
  if (composer.IsRug(mover)) {
    composer.EmitFirst({Call("on").Text("object", id).Text("target", below)});
  } else if (composer.IsRug(host) && composer.rug_placed) {
    return;  // "under the sofa, with the chairs on it": the rug's own place says it
  } else if (composer.IsTertiaryRug(host) && composer.IsFloor(mover)) {
    // "So that the front legs of the sofa rest on it".
    composer.EmitFirst(
        {Call(mover.side == "front" ? "rug_under_forward" : "rug_under_center").Text("rug", below).Text("object", id)});
    composer.rug_placed = true;
  } else if (composer.IsRug(host)) {
    composer.EmitFirst({Call("on").Text("object", id).Text("target", below)});
  } else if (!corner.empty() && composer.IsFloor(mover) && composer.IsFloor(host) &&
             composer.object(mover.object).role() != v1::OBJECT_ROLE_TERTIARY) {
    composer.EmitFirst({Call("near").Text("object", id).Text("target", below)});
    composer.SetPair({mover}, {host});
  } else if (corner == "any") {
    composer.EmitFirst({Call("on_top_corner").Text("object", id).Text("host", below)});
  } else if (!corner.empty()) {
    composer.EmitFirst(
        {Call("on_top_corner").Text("object", id).Text("host", below).Text("corner", std::string(corner))});
  } else {
    composer.EmitFirst({Call("on_top_center").Text("object", id).Text("host", below)});
  }
}

// "on one side of the table": a corner of its top for small things, beside it for furniture.
void OnSide(const Placed& mover, const Placed& host, Composer& composer) {
  if (composer.IsSurface(mover)) {
    OnOne(mover, host, host.side == "back" ? "back_left" : "any", composer);
  } else {
    Contact(mover, {RefKind::kObjects, {host}, ""}, composer);
  }
}

// "In the shower area": in the zone of the shower.
void InAreaOf(const std::vector<Placed>& movers, const std::vector<Placed>& hosts, Composer& composer) {
  for (const Placed& mover : movers) {
    for (const Placed& host : hosts) {
      const std::string& zone = composer.object(host.object).zone_id();
      std::vector<Call> calls;
      if (!zone.empty()) calls.push_back(Call("in_zone").Text("object", composer.id(mover)).Text("zone", zone));
      calls.push_back(Call("near").Text("object", composer.id(mover)).Text("target", composer.id(host)));
      composer.EmitFirst(std::move(calls));
    }
  }
}

// detail: "" in the middle, "any" a corner, or that corner.
void On(const Match& match, std::string_view detail, Composer& composer) {
  if (KeepsOwnSides(match.a, *match.b, composer)) return;
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> hosts = composer.TargetObjects(*match.b, movers);
  if (match.b->references.front().area && !movers.empty() && composer.IsFloor(movers.front())) {
    InAreaOf(movers, hosts, composer);
    return;
  }
  if (detail == "any" && match.c != nullptr && match.c->references.front().side == "back") detail = "back_left";
  const auto several = [](const std::string& side) {
    return side == "sides" || side == "long_both" || side == "short_both" || side == "all";
  };
  if (!hosts.empty() && several(hosts.front().side) && !movers.empty() && !composer.IsSurface(movers.front())) {
    Flank(OneAtEach(match.a, composer), hosts, composer);
    return;
  }
  // "A view of the screen on the stand", "on the table, on the runner": the fact before has placed it.
  if (!movers.empty() && !hosts.empty() && !composer.calls().empty() &&
      (composer.IsPrimaryFloor(movers.front()) || composer.IsSurface(hosts.front()))) {
    return;
  }
  // "Within reach of someone lying in bed": furniture does not stand on what people sit or lie on.
  if (detail.empty() && !movers.empty() && !hosts.empty() && composer.IsFloor(movers.front()) &&
      !composer.IsRug(movers.front()) && (composer.IsSeat(hosts.front()) || composer.IsBed(hosts.front())) &&
      hosts.front().side.empty() && composer.object(movers.front().object).role() != v1::OBJECT_ROLE_TERTIARY) {
    composer.Refuse("unknown_sentence", "furniture stands beside seats and beds, not on them");
    return;
  }
  // "Tucked into the table": under it, at times.
  if (detail.empty() && !movers.empty() && !hosts.empty() && composer.IsFloor(movers.front()) &&
      composer.IsChair(movers.front()) && composer.IsTable(hosts.front()) && hosts.front().side.empty()) {
    composer.Refuse("unknown_sentence", "chairs stand at tables, not on them; say at which side");
    return;
  }
  const bool furniture = !movers.empty() && composer.IsFloor(movers.front());
  if ((movers.size() == 1 || furniture) && hosts.size() == 1 && !hosts.front().side.empty()) {
    for (const Placed& mover : movers) OnSide(mover, hosts.front(), composer);
    return;
  }
  for (size_t i = 0; i < movers.size() && !hosts.empty(); ++i) {
    // Several things on several hosts: one each.
    const Placed& host = hosts[hosts.size() > 1 && movers.size() > 1 ? i % hosts.size() : 0];
    OnOne(movers[i], host, detail, composer);
  }
}

void RugUnder(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> targets = composer.TargetObjects(*match.b, movers);
  for (const Placed& mover : movers) {
    if (targets.empty()) return;
    // "Tucks under the front of the desk": there it stands.
    if (!targets.front().side.empty() && composer.IsFloor(mover) && !composer.IsRug(mover)) {
      OnSide(mover, targets.front(), composer);
      continue;
    }
    const std::string& id = composer.id(mover);
    const std::string& target = composer.id(targets.front());
    if (!composer.IsFloor(targets.front())) continue;
    if (composer.IsRug(mover)) {
      if (!composer.rug_placed) {
        composer.EmitFirst({Call(detail == "forward" ? "rug_under_forward" : "rug_under_center")
                                .Text("rug", id)
                                .Text("object", target)});
      }
      composer.rug_placed = true;
    } else if (composer.IsWall(mover)) {
      composer.EmitFirst({Call("on_wall_near").Text("object", id).Text("target", target)});
    } else {
      composer.EmitFirst({Call("under_center").Text("object", id).Text("target", target)});
    }
  }
}

// "Tucked under the desk": where it is when nobody sits there. Rugs and bins lie there always.
void Stowed(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const bool sided = !match.b->references.front().side.empty();
  const bool pulled_out = !movers.empty() && composer.IsFloor(movers.front()) && composer.IsChair(movers.front());
  if (!pulled_out || sided) {
    RugUnder(match, detail, composer);
    return;
  }
  composer.SetPair(movers, composer.TargetObjects(*match.b, movers));
  composer.Refuse("conditional", "what holds only at times cannot be asked for; say where it stands otherwise");
}

}  // namespace

std::vector<Meaning> SurfaceMeanings() {
  return {
      {"on", On},
      {"rug_under", RugUnder},
      {"stowed", Stowed},
  };
}

}  // namespace flair::translator
