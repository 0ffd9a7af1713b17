// SPDX-License-Identifier: GPL-3.0-or-later
// Groups: chairs round a table, between two, side by side in a row.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
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
  if (ids.empty()) {
    composer.Refuse("unknown_sentence", "nothing says what stands around it; name the objects");
    return;
  }
  composer.EmitFirst({Call("surround").Text("center", composer.id(centers.front())).Texts("objects", ids)});
  composer.SetPair(movers, {centers.front()});
}

// detail "plain": only "around", which several stand and one moves.
void Surround(const Match& match, std::string_view detail, Composer& composer) {
  if (match.a != nullptr && composer.RefuseUnnamed(*match.a)) return;
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
  std::vector<Placed> targets = composer.TargetObjects(*match.b, movers, false);
  if (match.a != nullptr && targets.size() != 2 && match.b->references.front().name == "them") {
    // "Side by side with the lamp between them".
    targets = composer.pair_movers();
    targets.insert(targets.end(), composer.pair_targets().begin(), composer.pair_targets().end());
    if (targets.size() != 2) targets = composer.subjects();
  }
  if (targets.size() != 2 || movers.empty()) {
    composer.Refuse("unknown_sentence", "between needs exactly two objects; name them");
    return;
  }
  for (const Placed& mover : movers) {
    // "In the middle of the room, covering the floor between the desk and the sofa".
    if (composer.IsTertiaryRug(mover) && !composer.calls().empty()) continue;
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
  // "Side by side above the sofa": the sofa says where pictures hang.
  if (!composer.IsFloor(movers.front()) && !composer.calls().empty()) return;
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
  } else if (all.size() < 2) {
    all = composer.subjects();
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
  if (movers.size() < 2) composer.Refuse("unknown_sentence", "nothing says what is near what; name two objects");
  for (size_t i = 1; i < movers.size(); ++i) {
    Call call = Call("near").Text("object", composer.id(movers[i])).Text("target", composer.id(movers[0]));
    if (match.distance != nullptr) call.MaybeNumber("max_distance_m", match.distance->max_m);
    composer.EmitFirst({std::move(call)});
  }
}

}  // namespace

std::vector<Meaning> GroupMeanings() {
  return {
      {"surround", Surround}, {"surrounded_by", SurroundedBy}, {"place_between", PlaceBetween},
      {"row", Row},           {"back_to_back", BackToBack},    {"near_each_other", NearEachOther},
  };
}

}  // namespace flair::translator
