// SPDX-License-Identifier: GPL-3.0-or-later
// Free space: in front, behind, at the sides, around, to pull chairs out, with or without a figure.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
namespace {

// People get at what is longer than wide from a long side, at everything else from the front.
std::string UsualSide(const Placed& placed, Composer& composer) {
  constexpr double kMuchLonger = 1.25;
  const v1::Object& object = composer.object(placed.object);
  return composer.IsBed(placed) || object.depth_m() > kMuchLonger * object.width_m() ? "side" : "front";
}

// "One side is accessible": the usual one, unless another side of the object is named beside it.
void ChooseOpenSides(std::vector<Placed>& placed, Composer& composer) {
  for (Placed& one : placed) {
    const bool alone = std::none_of(placed.begin(), placed.end(), [&](const Placed& other) {
      return &other != &one && other.object == one.object && !other.side.empty();
    });
    if (one.side == "side" && alone) one.side = UsualSide(one, composer);
    if (one.side == "two_any" && alone && UsualSide(one, composer) == "side") one.side = "sides";
  }
}

}  // namespace

void KeepSpaceAt(const Placed& placed, const std::vector<std::string>& sides, const Distance* distance,
                 Composer& composer) {
  Call call = Call("accessible").Text("object", composer.id(placed)).Texts("sides", sides);
  if (distance != nullptr) call.Number("min_clearance_m", distance->Nominal());
  composer.EmitFirst({std::move(call)});
}

void KeepSpace(std::vector<Placed> placed, const Distance* distance, Composer& composer) {
  ChooseOpenSides(placed, composer);
  std::vector<int> done;
  for (const Placed& first : placed) {
    if (std::find(done.begin(), done.end(), first.object) != done.end()) continue;
    done.push_back(first.object);
    std::vector<std::string> sides;
    for (const Placed& other : placed) {
      if (other.object != first.object) continue;
      for (const std::string& side : SidesOf(composer, other)) {
        if (std::find(sides.begin(), sides.end(), side) == sides.end()) sides.push_back(side);
      }
    }
    if (sides.empty()) sides = {"front"};
    KeepSpaceAt(first, sides, distance, composer);
  }
}

bool KeepsOwnSides(const Mention* mover, const Mention& place, Composer& composer) {
  const Reference& reference = place.references.front();
  const std::string& side = reference.side;
  const bool several = side == "sides" || side == "all" || side == "opposite_two" || side.ends_with("both");
  const bool own = reference.kind == RefKind::kPronoun && reference.name.empty();
  // "5 cm on each side and at the back": as much there.
  const bool more = own && mover == nullptr && composer.topic().size() == 1 && !composer.calls().empty() &&
                    composer.calls().back().type == "accessible" && composer.scope() == v1::SENTENCE_SCOPE_INTRA;
  if (more && composer.AddSides(SidesOf(composer, {composer.topic().front().object, side}))) return true;
  if (mover != nullptr || !own || !several || composer.scope() != v1::SENTENCE_SCOPE_INTRA) return false;
  std::vector<Placed> sided;
  for (const Placed& placed : composer.topic()) sided.push_back({placed.object, side});
  KeepSpace(std::move(sided), nullptr, composer);
  return true;
}

namespace {

// "The bookshelf and the bed have a gap of 0.5 m": between them.
bool IsPairWithoutSides(const Mention& mention, const Composer& composer) {
  return composer.scope() == v1::SENTENCE_SCOPE_INTER && mention.references.size() == 2 &&
         std::all_of(mention.references.begin(), mention.references.end(), [](const Reference& reference) {
           return reference.kind == RefKind::kObjects && reference.side.empty();
         });
}

}  // namespace

// "Not in front of sockets, so that they remain accessible": of the sockets that is said already.
bool IsOfFeature(const Mention* mention, const Composer& composer) {
  return mention != nullptr && mention->references.front().kind == RefKind::kPronoun &&
         mention->references.front().name == "them" && !composer.last_feature.empty() && composer.topic().size() == 1 &&
         !composer.calls().empty();
}

// Space at a place relative to B, or to the topic: detail is "front", "back", "sides" or "around".
void SpaceAt(const Match& match, std::string_view detail, Composer& composer) {
  const Mention* const of = match.b != nullptr ? match.b : match.a;
  if (of != nullptr && of->references.front().kind == RefKind::kGroup && of->references.front().name != "seating") {
    composer.Refuse("not_about_layout", "space around pieces that are not named cannot be asked for; name them");
    return;
  }
  if (detail == "named" && match.b == nullptr && IsOfFeature(match.a, composer)) return;
  // "No more than 0.3 m behind the chair": there it stands.
  if (detail == "back" && match.a != nullptr && match.b != nullptr && match.distance != nullptr &&
      !match.distance->min_m) {
    const std::vector<Placed> movers = composer.Movers(match.a);
    const std::vector<Placed> targets = composer.TargetObjects(*match.b, movers);
    for (const Placed& mover : movers) {
      Beside(mover, targets, "back", composer);
      for (const Placed& target : targets) KeepDistance(mover, target, match.distance, composer);
    }
    return;
  }
  // "..., so they should have a separation of 0.5 m": from each other.
  const bool them = match.a != nullptr && match.a->references.front().kind == RefKind::kPronoun &&
                    match.a->references.front().name == "them" && match.a->references.front().side.empty();
  if (detail == "named" && match.b == nullptr && them && composer.scope() == v1::SENTENCE_SCOPE_INTER &&
      !composer.pair_targets().empty() && match.distance != nullptr) {
    ApartFromEachOther({nullptr, nullptr, nullptr, match.distance, match.length}, "", composer);
    return;
  }
  if (detail == "named" && match.b == nullptr && match.a != nullptr && IsPairWithoutSides(*match.a, composer)) {
    const std::vector<Placed> pair = composer.Movers(match.a);
    if (pair.size() == 2) {
      KeepDistance(pair[0], pair[1], match.distance, composer);
      return;
    }
  }
  // "Parallel to the locker, 1 m in front": of the locker.
  if (detail == "front" && of == nullptr && match.distance != nullptr && composer.scope() == v1::SENTENCE_SCOPE_INTER &&
      !composer.calls().empty() && composer.pair_movers().size() == 1 && composer.pair_targets().size() == 1) {
    composer.EmitFirst({Call("in_front_of")
                            .Text("object", composer.id(composer.pair_movers().front()))
                            .Text("target", composer.id(composer.pair_targets().front()))
                            .Number("distance_m", match.distance->Nominal())});
    return;
  }
  const std::vector<Placed> owners =
      match.b != nullptr && detail != "free_sides" ? composer.TargetObjects(*match.b, {}) : composer.Movers(match.a);
  std::vector<Placed> placed;
  for (Placed owner : owners) {
    if (detail == "back" && composer.StandsAtSubject(owner)) {
      // "Behind the chair" of a desk is in front of the desk, behind the chairs of a table all round it.
      placed.push_back({composer.subjects().front().object, owners.size() > 1 ? "all" : "front"});
      continue;
    }
    if (detail == "around") {
      if (owner.side.empty()) {
        // Most pieces have their back at a wall; chairs are got at from there.
        owner.side = composer.IsChair(owner) ? "all" : "three";
      }
    } else if (detail == "free_sides") {
      owner.side = "three";  // the back is at the wall
    } else if (detail != "named" || owner.side.empty()) {
      owner.side = detail == "named" ? "front" : std::string(detail);
    }
    placed.push_back(owner);
  }
  KeepSpace(placed, match.distance, composer);
}

// "A clear path around the bed" is space; other vague things around it are not.
void PathAround(const Match& match, std::string_view detail, Composer& composer) {
  if (match.c->references.front().name == "paths") {
    SpaceAt(match, detail, composer);
  } else {
    composer.Refuse("not_about_layout", "only free space can be kept around an object");
  }
}

namespace {

// "0.1 m on each side and behind": as much as at the sides.
void MoreSpace(const Match&, std::string_view detail, Composer& composer) {
  const bool sides = detail == "sides";
  if (!composer.AddSides(sides ? std::vector<std::string>{"left", "right"}
                               : std::vector<std::string>{std::string(detail)}))
    composer.Refuse("unknown_sentence", "nothing says what is there");
}

// "No furniture in front".
void SpaceBefore(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.topic()) KeepSpaceAt(owner, {"front"}, match.distance, composer);
}

// "Nothing within half a metre of its shelves".
void NothingWithin(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.TargetObjects(*match.b, {})) KeepFreeBeside(owner, match.distance, composer);
}

void NothingInFront(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& owner : composer.TargetObjects(*match.b, {})) {
    KeepSpace({{owner.object, "front"}}, match.distance, composer);
  }
}

// A chair is pulled out backwards; room for "the chair" of a desk is in front of the desk.
void PullOut(const Match& match, std::string_view, Composer& composer) {
  const Mention* const chairs = match.a != nullptr ? match.a : match.b;
  std::vector<Placed> movers = composer.Movers(chairs);
  const std::vector<Placed>& subjects = composer.subjects();
  if (!subjects.empty() && !composer.IsChair(subjects.front())) {
    // Several chairs stand all round a table, one in front of a desk.
    const bool all_round = chairs != nullptr && chairs->references.front().plural;
    for (const Placed& subject : subjects) {
      // "0.8 m around the table, so that chairs can be pulled out": the figure serves it.
      if (all_round && composer.KeepsSpace(subject)) return;
      if (all_round) KeepSpaceAt(subject, {"front", "back", "left", "right"}, match.distance, composer);
    }
    if (all_round) return;
    movers = subjects;
  }
  for (const Placed& mover : movers) {
    KeepSpaceAt(mover, {composer.IsChair(mover) ? "back" : "front"}, match.distance, composer);
  }
}

}  // namespace

std::vector<Meaning> SpaceMeanings() {
  return {
      {"space_at", SpaceAt},         {"path_around", PathAround},       {"more_space", MoreSpace},
      {"space_before", SpaceBefore}, {"nothing_within", NothingWithin}, {"nothing_in_front", NothingInFront},
      {"pull_out", PullOut},
  };
}

}  // namespace flair::translator
