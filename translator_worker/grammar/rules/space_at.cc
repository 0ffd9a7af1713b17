// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rules/space_at.h"

#include <algorithm>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/gaps.h"
#include "translator_worker/grammar/rules/space.h"

namespace flair::translator {
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

// Space at a place relative to B, or to the topic: tag is "front", "back", "sides" or "around".
void SpaceAt(const Match& match, std::string_view tag, Composer& composer) {
  const Mention* const of = match.b != nullptr ? match.b : match.a;
  if (of != nullptr && of->references.front().kind == RefKind::kGroup && of->references.front().name != "seating") {
    composer.Refuse("not_about_layout", "space around pieces that are not named cannot be asked for; name them");
    return;
  }
  if (tag == "named" && match.b == nullptr && IsOfFeature(match.a, composer)) return;
  // "No more than 0.3 m behind the chair": there it stands.
  if (tag == "back" && match.a != nullptr && match.b != nullptr && match.distance != nullptr &&
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
  if (tag == "named" && match.b == nullptr && them && composer.scope() == v1::SENTENCE_SCOPE_INTER &&
      !composer.pair_targets().empty() && match.distance != nullptr) {
    ApartFromEachOther({nullptr, nullptr, nullptr, match.distance, match.length}, "", composer);
    return;
  }
  if (tag == "named" && match.b == nullptr && match.a != nullptr && IsPairWithoutSides(*match.a, composer)) {
    const std::vector<Placed> pair = composer.Movers(match.a);
    if (pair.size() == 2) {
      KeepDistance(pair[0], pair[1], match.distance, composer);
      return;
    }
  }
  // "Parallel to the locker, 1 m in front": of the locker.
  if (tag == "front" && of == nullptr && match.distance != nullptr && composer.scope() == v1::SENTENCE_SCOPE_INTER &&
      !composer.calls().empty() && composer.pair_movers().size() == 1 && composer.pair_targets().size() == 1) {
    composer.EmitFirst({Call("in_front_of")
                            .Text("object", composer.id(composer.pair_movers().front()))
                            .Text("target", composer.id(composer.pair_targets().front()))
                            .Number("distance_m", match.distance->Nominal())});
    return;
  }
  const std::vector<Placed> owners =
      match.b != nullptr && tag != "free_sides" ? composer.TargetObjects(*match.b, {}) : composer.Movers(match.a);
  std::vector<Placed> placed;
  for (Placed owner : owners) {
    if (tag == "back" && composer.StandsAtSubject(owner)) {
      // "Behind the chair" of a desk is in front of the desk, behind the chairs of a table all round it.
      placed.push_back({composer.subjects().front().object, owners.size() > 1 ? "all" : "front"});
      continue;
    }
    if (tag == "around") {
      if (owner.side.empty()) {
        // Most pieces have their back at a wall; chairs are got at from there.
        owner.side = composer.IsChair(owner) ? "all" : "three";
      }
    } else if (tag == "free_sides") {
      owner.side = "three";  // the back is at the wall
    } else if (tag != "named" || owner.side.empty()) {
      owner.side = tag == "named" ? "front" : std::string(tag);
    }
    placed.push_back(owner);
  }
  KeepSpace(placed, match.distance, composer);
}

// "A clear path around the bed" is space; other vague things around it are not.
void PathAround(const Match& match, std::string_view tag, Composer& composer) {
  if (match.c->references.front().name == "paths") {
    SpaceAt(match, tag, composer);
  } else {
    composer.Refuse("not_about_layout", "only free space can be kept around an object");
  }
}

}  // namespace flair::translator
