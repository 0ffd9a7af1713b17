// SPDX-License-Identifier: GPL-3.0-or-later
// Groups (round a table, between two, in a row) and what is on or under objects.
#include <string>
#include <utility>
#include <vector>

#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {

namespace {

void EmitSurround(const std::vector<Placed>& movers, const std::vector<Placed>& centers, Composer& composer) {
  if (movers.empty() || centers.empty()) return;
  // "Each table is surrounded by four chairs": the first four stand round the first.
  if (centers.size() > 1 && movers.size() > centers.size() && movers.size() % centers.size() == 0) {
    const auto each = static_cast<long>(movers.size() / centers.size());
    for (size_t i = 0; i < centers.size(); ++i) {
      const auto first = movers.begin() + static_cast<long>(i) * each;
      EmitSurround({first, first + each}, {centers[i]}, composer);
    }
    return;
  }
  std::vector<std::string> ids;
  for (const Placed& mover : movers) {
    if (mover.object != centers.front().object) ids.push_back(composer.id(mover));
  }
  if (ids.empty()) return;
  composer.EmitFirst({Call("surround").Text("center", composer.id(centers.front())).Texts("objects", ids)});
  composer.SetPair(movers, {centers.front()});
}

// detail "plain": only "around", which several stand and one moves.
void Surround(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  if (detail == "plain" && movers.size() < 2) {
    composer.Refuse("unknown_sentence", "one object cannot stand around another; say beside or near it");
    return;
  }
  EmitSurround(movers, composer.TargetObjects(*match.b, movers), composer);
}

void SurroundedBy(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> centers = composer.Movers(match.a);
  EmitSurround(composer.TargetObjects(*match.b, centers), centers, composer);
}

void PlaceBetween(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> targets = composer.TargetObjects(*match.b, movers, false);
  if (targets.size() != 2 || movers.empty()) {
    composer.Refuse("unknown_sentence", "between needs exactly two objects; name them");
    return;
  }
  for (const Placed& mover : movers) {
    if (composer.IsWall(mover)) {
      composer.Relate("on_wall_near", mover, targets[0]);
      continue;
    }
    composer.EmitFirst({Call("between")
                            .Text("object", composer.id(mover))
                            .Text("first", composer.id(targets[0]))
                            .Text("second", composer.id(targets[1]))});
  }
}

void Row(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> movers = composer.Movers(match.a);
  if (movers.size() < 2) movers = composer.subjects();
  if (movers.size() < 2) {
    composer.Refuse("unknown_sentence", "a row needs at least two objects; name them");
    return;
  }
  std::vector<std::string> ids;
  for (const Placed& mover : movers) ids.push_back(composer.id(mover));
  if (composer.Emit(Call("row").Texts("objects", ids))) return;
  for (size_t i = 0; i + 1 < movers.size(); ++i) {
    composer.EmitFirst({Call("next_to")
                            .Text("object", ids[i + 1])
                            .Text("target", ids[i])
                            .Text("object_side", "left")
                            .Text("target_side", "right")});
  }
}

// "The desks stand back to back".
void BackToBack(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> all = composer.Movers(match.a);
  if (match.b != nullptr) {
    const std::vector<Placed> others = composer.TargetObjects(*match.b, all);
    all.insert(all.end(), others.begin(), others.end());
  }
  if (all.size() != 2) {
    composer.Refuse("unknown_sentence", "two objects can stand back to back; name them");
    return;
  }
  composer.EmitFirst({Call("next_to")
                          .Text("object", composer.id(all[0]))
                          .Text("target", composer.id(all[1]))
                          .Text("object_side", "back")
                          .Text("target_side", "back")});
  composer.SetPair({all[0]}, {all[1]});
}

void NearEachOther(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> movers = composer.Movers(match.a);
  if (movers.size() < 2) movers = composer.subjects();
  for (size_t i = 1; i < movers.size(); ++i) {
    Call call = Call("near").Text("object", composer.id(movers[i])).Text("target", composer.id(movers[0]));
    if (match.distance != nullptr) call.MaybeNumber("max_distance_m", match.distance->max_m);
    composer.EmitFirst({std::move(call)});
  }
}

void OnOne(const Placed& mover, const Placed& host, std::string_view corner, Composer& composer) {
  const std::string& id = composer.id(mover);
  const std::string& below = composer.id(host);
  if (composer.IsRug(host) && composer.rug_placed) {
    return;  // "under the sofa, with the chairs on it": the rug's own place says it
  } else if (composer.IsTertiaryRug(host) && composer.IsFloor(mover)) {
    // "So that the front legs of the sofa rest on it".
    LayRug(mover.side == "front" ? "rug_under_forward" : "rug_under_center", host, mover, composer);
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
      LayRug(detail == "forward" ? "rug_under_forward" : "rug_under_center", mover, targets.front(), composer);
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

std::vector<Meaning> GroupMeanings() {
  return {{"surround", Surround},
          {"surrounded_by", SurroundedBy},
          {"place_between", PlaceBetween},
          {"row", Row},
          {"back_to_back", BackToBack},
          {"near_each_other", NearEachOther},
          {"on", On},
          {"rug_under", RugUnder},
          {"stowed", Stowed}};
}

}  // namespace flair::translator
