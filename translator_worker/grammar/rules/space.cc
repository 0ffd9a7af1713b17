// SPDX-License-Identifier: GPL-3.0-or-later
// Free space and what is to be got at: in front, behind, at the sides, around, from where, with or without a figure.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

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
  }
}

}  // namespace

void KeepSpaceAt(const Placed& placed, const std::vector<std::string>& sides, const Distance* distance,
                 Composer& composer) {
  Call call = Call("accessible").Text("object", composer.id(placed)).Texts("sides", sides);
  if (distance != nullptr) call.Number("min_clearance_m", distance->Nominal());
  composer.EmitFirst({std::move(call)});
}

void KeepFront(const Placed& placed, Composer& composer) {
  const std::vector<std::string> sides = SidesOf(composer, placed);
  KeepSpaceAt(placed, !sides.empty() ? sides : std::vector<std::string>{"front"}, nullptr, composer);
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

// Space at a place relative to B, or to the topic: detail is "front", "back", "sides" or "around".
void SpaceAt(const Match& match, std::string_view detail, Composer& composer) {
  const Mention* const of = match.b != nullptr ? match.b : match.a;
  if (of != nullptr && of->references.front().kind == RefKind::kGroup && of->references.front().name != "seating") {
    composer.Refuse("not_about_layout", "space around pieces that are not named cannot be asked for; name them");
    return;
  }
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
  const std::vector<Placed> owners =
      match.b != nullptr ? composer.TargetObjects(*match.b, {}) : composer.Movers(match.a);
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
  composer.AddSides(sides ? std::vector<std::string>{"left", "right"} : std::vector<std::string>{std::string(detail)});
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
    movers = subjects;
  }
  for (const Placed& mover : movers) {
    KeepSpaceAt(mover, {composer.IsChair(mover) ? "back" : "front"}, match.distance, composer);
  }
}

// "Used from both sides, so both must be free by 1 m": of the sides that were spoken of.
bool IsSaidOfSides(const Mention* mention, const Composer& composer) {
  const bool they = mention == nullptr || (mention->references.front().kind == RefKind::kPronoun &&
                                           mention->references.front().name == "both");
  if (!they || composer.calls().empty() || composer.topic().empty()) return false;
  const Call& last = composer.calls().back();
  return last.type == "accessible" &&
         std::any_of(composer.topic().begin(), composer.topic().end(),
                     [&](const Placed& one) { return last.arguments.front().value().text() == composer.id(one); });
}

void Accessible(const Match& match, std::string_view, Composer& composer) {
  if (match.a != nullptr && match.a->references.front().name == "all") {
    composer.Refuse("not_about_layout", "access to pieces that are not named cannot be asked for; name them");
    return;
  }
  if (match.b == nullptr && IsSaidOfSides(match.a, composer)) return;
  std::vector<Placed> movers = composer.Movers(match.a);
  if (match.b != nullptr) {
    // "accessible from the front": the sides are those named after the verb.
    std::vector<Placed> sided;
    for (const Placed& mover : movers) {
      for (const Reference& reference : match.b->references) {
        sided.push_back({mover.object, reference.side});
        if (match.b->either) break;
      }
    }
    movers = sided;
  }
  KeepSpace(movers, match.distance, composer);
}

// "Easy access from the front".
void AccessToSide(const Match& match, std::string_view, Composer& composer) {
  KeepSpace(composer.TargetObjects(*match.b, {}), match.distance, composer);
}

// "Access to the bed from both sides".
void AccessFromSide(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> sided;
  for (const Placed& other : composer.TargetObjects(*match.b, {})) {
    for (const Reference& reference : match.c->references) sided.push_back({other.object, reference.side});
  }
  KeepSpace(sided, match.distance, composer);
}

// "Must open fully", of the piece that the sentence is about, when nothing else was said.
void OpensFully(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed>& topic = composer.topic();
  if (!composer.calls().empty() || topic.empty() || composer.scope() != v1::SENTENCE_SCOPE_INTRA) return;
  KeepSpace(topic, match.distance, composer);
}

// "All sides where chairs stand are accessible", "the front is clear of obstacles".
void OfMovers(const Match& match, std::string_view, Composer& composer) {
  KeepSpace(composer.Movers(match.a), match.distance, composer);
}

// "X is accessible from Y": from one of Y's sides that is Y's own matter, else X is near Y.
void AccessibleFrom(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers)) {
    for (const Placed& other : target.objects) {
      for (const Placed& mover : movers) {
        composer.Relate("near", mover, other);
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// "Its top and front are accessible": the front is.
void Unreachable(const Match& match, std::string_view, Composer& composer) {
  Mention sides;
  for (const Reference& reference : match.a->references) {
    if (reference.kind != RefKind::kVague && !reference.side.empty()) sides.references.push_back(reference);
  }
  if (!sides.references.empty()) {
    KeepSpace(composer.Movers(&sides), match.distance, composer);
    return;
  }
  composer.Refuse("not_about_layout", "access is kept at the front, back, left and right, not from above");
}

void MovementAround(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_about_layout", "ways cannot be asked for; say which sides are kept free");
}

// "The cabinet's doors must not bump into the bench": its own front is kept free; of others that of what is blocked.
void NotHitting(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const bool doors = !movers.empty() && movers.front().side == "front" && composer.HasDoors(movers.front());
  doors ? KeepSpace(movers, match.distance, composer) : NotBlock(match, detail, composer);
}

}  // namespace

std::vector<Meaning> SpaceMeanings() {
  return {{"space_at", SpaceAt},
          {"path_around", PathAround},
          {"more_space", MoreSpace},
          {"space_before", SpaceBefore},
          {"nothing_within", NothingWithin},
          {"nothing_in_front", NothingInFront},
          {"pull_out", PullOut},
          {"accessible", Accessible},
          {"access_to_side", AccessToSide},
          {"access_from_side", AccessFromSide},
          {"opens_fully", OpensFully},
          {"of_movers", OfMovers},
          {"accessible_from", AccessibleFrom},
          {"unreachable", Unreachable},
          {"movement_around", MovementAround},
          {"not_hitting", NotHitting}};
}

}  // namespace flair::translator
