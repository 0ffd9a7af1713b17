// SPDX-License-Identifier: GPL-3.0-or-later
// Free space at an object's sides: accessible, clearance in front.
#include <algorithm>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/gaps.h"
#include "translator_worker/grammar/rules/keep_clear.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

// "Not in front of sockets, so that they remain accessible": of the sockets that is said already.
bool IsOfFeature(const Mention* mention, const Composer& composer) {
  return mention != nullptr && mention->references.front().kind == RefKind::kPronoun &&
         mention->references.front().name == "them" && !composer.last_feature.empty() && composer.topic().size() == 1 &&
         !composer.calls().empty();
}

void Accessible(const Match& match, std::string_view, Composer& composer) {
  if (match.a != nullptr && match.a->references.front().name == "all") {
    composer.Refuse("not_about_layout", "access to pieces that are not named cannot be asked for; name them");
    return;
  }
  if (IsOfFeature(match.a, composer)) return;
  std::vector<Placed> movers = composer.Movers(match.a);
  // "From the front or side": the choice is free.
  if (match.a != nullptr && match.a->either && movers.size() > 1 && movers[0].object == movers[1].object)
    movers.resize(1);
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

// "The front is accessible and it does not block the window".
void AccessibleAndNotBlocking(const Match& match, std::string_view tag, Composer& composer) {
  Match first = match;
  first.b = nullptr;
  Accessible(first, tag, composer);
  Match second = match;
  second.a = nullptr;
  NotBlock(second, "", composer);
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
    if (target.name == "all" || target.name == "others") {
      composer.Refuse("not_about_layout", "say from which object it is reached");
      continue;
    }
    if (target.kind == RefKind::kFeature) {
      for (const Placed& mover : movers) {
        composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", target.name)});
      }
    }
    for (const Placed& other : target.objects) {
      for (const Placed& mover : movers) {
        composer.EmitFirst({Call("near").Text("object", composer.id(mover)).Text("target", composer.id(other))});
      }
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
  }
}

// "The bookshelf and the bed have a gap of 0.5 m": between them.
bool IsPairWithoutSides(const Mention& mention, const Composer& composer) {
  return composer.scope() == v1::SENTENCE_SCOPE_INTER && mention.references.size() == 2 &&
         std::all_of(mention.references.begin(), mention.references.end(), [](const Reference& reference) {
           return reference.kind == RefKind::kObjects && reference.side.empty();
         });
}

// Space at a place relative to B, or to the topic: tag is "front", "back", "sides" or "around".
void SpaceAt(const Match& match, std::string_view tag, Composer& composer) {
  const Mention* const of = match.b != nullptr ? match.b : match.a;
  if (of != nullptr && of->references.front().kind == RefKind::kGroup && of->references.front().name != "seating") {
    composer.Refuse("not_about_layout", "space around pieces that are not named cannot be asked for; name them");
    return;
  }
  if (tag == "named" && match.b == nullptr && IsOfFeature(match.a, composer)) return;
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
  const std::vector<Placed> owners =
      match.b != nullptr && tag != "free_sides" ? composer.TargetObjects(*match.b, {}) : composer.Movers(match.a);
  std::vector<Placed> placed;
  for (Placed owner : owners) {
    if (tag == "back" && composer.StandsAtSubject(owner)) {
      // "Behind the chair" of a desk is in front of the desk.
      placed.push_back({composer.subjects().front().object, "front"});
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

void MovementAround(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_about_layout", "ways cannot be asked for; say which sides are kept free");
}

// "0.1 m on each side and behind": as much as at the sides.
void MoreSpace(const Match&, std::string_view tag, Composer& composer) {
  const bool sides = tag == "sides";
  if (!composer.AddSides(sides ? std::vector<std::string>{"left", "right"}
                               : std::vector<std::string>{std::string(tag)}))
    composer.Refuse("unknown_sentence", "nothing says what is there");
}

// "Legroom underneath": inside of the piece nothing is kept free.
void SpaceUnderneath(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "free space can be asked for beside an object, not under it");
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

}  // namespace

std::vector<Rule> AccessRules() {
  return {
      {"C.feature space? D? space? keep_clear? in_front keep_clear?", SpaceAt, "front"},
      {"swing_open A not block next_to B", OfMovers},
      {"C.feature in_front space? D space? swing_open?", SpaceAt, "front"},
      {"A.side D space? swing_open", SpaceAt, "named"},
      {"A.side D of? space? swing_open", SpaceAt, "named"},
      {"A? D of? in_front_of C.pronoun", SpaceAt, "front"},
      {"A? D to in_front_of C.pronoun", SpaceAt, "front"},
      {"A? space? legroom under B?", SpaceUnderneath},
      {"A? space? D? of? legroom ,? of? D? space? ,? in_front?", SpaceAt, "front"},
      {"D keep_clear behind B.object", SpaceAt, "back"},
      {"D keep_clear in_front_of B.object", SpaceAt, "front"},
      {"D keep_clear around B.object", SpaceAt, "around"},
      {"D keep_clear at_sides", SpaceAt, "sides"},
      {"behind B.object ,? D keep_clear", SpaceAt, "back"},
      {"in_front_of B.object ,? D keep_clear", SpaceAt, "front"},
      {"around B.object ,? D keep_clear", SpaceAt, "around"},
      {"A.object? accessible/keep_clear", Accessible},
      {"A.object? accessible/keep_clear ,? D space?", Accessible},
      {"A.object? keep_clear/accessible ,? space D", Accessible},
      {"A.object? accessible_from ,? B.side", Accessible},
      {"A.object? accessible_from ,? B.side ,? D space?", Accessible},
      {"A.object? accessible_from ,? B.side ,? space D", Accessible},
      {"A.object? accessible B.side D?", Accessible},
      {"A.object? accessible on/at_sides/next_to B.side D?", Accessible},
      {"A.object? accessible away_from B.side D?", Accessible},
      {"A.object? accessible_from ,? around", SpaceAt, "around"},
      {"A.object? accessible_from B.object", AccessibleFrom},
      {"accessible away_from B.object", AccessibleFrom},
      {"A.side facing B.object accessible/keep_clear", OfMovers},
      {"A.object? accessible_from B.feature", AccessibleFrom},
      {"A.object? accessible to B.side", AccessToSide},
      {"A.object? accessible to B.object", AccessibleFrom},
      {"A.object? space? D? accessible ,? at_sides", SpaceAt, "sides"},
      {"A? accessible in_front", SpaceAt, "front"},
      {"A? space? in_front of? ,? D", SpaceAt, "front"},
      {"A? space D? space? ,? at_sides", SpaceAt, "sides"},
      {"A? space? D space? ,? at_sides", SpaceAt, "sides"},
      {"D space left_of B.object", SpaceAt, "left"},
      {"space D? left_of B.object", SpaceAt, "left"},
      {"D space right_of B.object", SpaceAt, "right"},
      {"space D? right_of B.object", SpaceAt, "right"},
      {"A.side keep_clear/accessible ,? D", Accessible},
      {"A? ,? D? space? keep_clear? in_front keep_clear?", SpaceAt, "front"},
      {"A? ,? space? D? space? in_front", SpaceAt, "front"},
      {"A? ,? space? D? space? behind", SpaceAt, "back"},
      {"A? ,? space D? at_sides", SpaceAt, "sides"},
      {"A? space? D? space? around B.side", SpaceAt, "named"},
      {"A? space D? around", SpaceAt, "around"},
      {"A? space? D? around D? space ,? D?", SpaceAt, "around"},
      {"A? space? ,? D? space? all_sides", SpaceAt, "all"},
      {"A? space? D? space? all_sides B.object", SpaceAt, "all"},
      {"A? space? D? space? all_sides that? not against/near/along/next_to B.wall", SpaceAt, "free_sides"},
      {"A? space? all_sides , D space?", SpaceAt, "all"},
      {"A? space? around B.side , D space?", SpaceAt, "named"},
      {"A? space? around B.object , D space?", SpaceAt, "around"},
      {"A? space? around B.object , D space? all_sides", SpaceAt, "all"},
      {"A.object? accessible space? D? on? B.side", SpaceAt, "named"},
      {"A? accessible/access_to/allow_access_to B.object away_from C.side", AccessFromSide},
      {"A? accessible/access_to/allow_access_to B.object ,? all_sides", SpaceAt, "all"},
      {"A.side not block", OfMovers},
      {"A.object? not block away_from B.side", AccessToSide},
      {"A? not block next_to B", OfMovers},
      {"not? C.vague not? in_front", SpaceAt, "front"},
      {"around B.object keep_clear/clear_of", SpaceAt, "around"},
      {"A? space D? around B.object keep_clear", SpaceAt, "around"},
      {"A? space D? in_front_of B.object keep_clear", SpaceAt, "front"},
      {"A? space D? behind B.object keep_clear", SpaceAt, "back"},
      {"A? space D? all_sides keep_clear", SpaceAt, "all"},
      {"A? space D? at_sides keep_clear", SpaceAt, "sides"},
      {"around B.object clear_of C", SpaceAt, "around"},
      {"A.side where B accessible/keep_clear", OfMovers},
      {"A.object? accessible all_sides", SpaceAt, "all"},
      {"A.object? accessible around", SpaceAt, "all"},
      {"A.object? accessible around ,? D space?", SpaceAt, "all"},
      {"A? space D? around B.object", SpaceAt, "around"},
      {"D space? around B.object", SpaceAt, "around"},
      {"D space? around", SpaceAt, "around"},
      {"space D? in_front_of B.object keep_clear?", SpaceAt, "front"},
      {"D space in_front_of B.object keep_clear?", SpaceAt, "front"},
      {"D in_front_of B.object keep_clear", SpaceAt, "front"},
      {"space D? behind B.object keep_clear?", SpaceAt, "back"},
      {"D space behind B.object keep_clear?", SpaceAt, "back"},
      {"A.object D space? behind B.object keep_clear?", SpaceAt, "back"},
      {"A.object space D? behind B.object keep_clear?", SpaceAt, "back"},
      {"D behind B.object keep_clear", SpaceAt, "back"},
      {"space D? foot_of B", SpaceAt, "front"},
      {"D space? foot_of B", SpaceAt, "front"},
      {"space D? on/at_sides/next_to/along/each_side_of B.side keep_clear?", SpaceAt, "named"},
      {"D space? on/at_sides/next_to/along/each_side_of B.side keep_clear?", SpaceAt, "named"},
      {"on/at_sides/next_to/along/each_side_of B.side keep_clear", SpaceAt, "named"},
      {"A space? D space? behind C.pronoun", SpaceAt, "back"},
      {"A space? D space? in_front_of C.pronoun", SpaceAt, "front"},
      {"space D? on/next_to/along/near B.object", SpaceAt, "named"},
      {"D space on/next_to/along B.object", SpaceAt, "named"},
      {"space D? each_side_of B.object", SpaceAt, "sides"},
      {"D space? each_side_of B.object", SpaceAt, "sides"},
      {"A.object space ,? D", SpaceAt, "named"},
      {"A.side D space?", SpaceAt, "named"},
      {"D space? on/next_to/along B.side", SpaceAt, "named"},
      {"A.side space D?", SpaceAt, "named"},
      {"A.object? space D? swing_open ,? C.feature?", SpaceAt, "named"},
      {"A? swing_open ,? not block/against/near/next_to C.object", SpaceAt, "named"},
      {"A? access_to/allow_access_to/accessible_from B.side", AccessToSide},
      {"nearest B D apart/away?", SpaceAt, "around"},
      {"space for around ,? D?", SpaceAt, "around"},
      {"space for C ,? on/at_sides/along/next_to B.side", SpaceAt, "named"},
      {"D space? B.side", SpaceAt, "named"},
      {"space D? B.side", SpaceAt, "named"},
      {"B.side of D", SpaceAt, "named"},
      {"space B.side of D", SpaceAt, "named"},
      {"A.side keep_clear/accessible next_to D", Accessible},
      {"behind B.object accessible/keep_clear ,? D?", SpaceAt, "back"},
      {"in_front_of B.object accessible/keep_clear ,? D?", SpaceAt, "front"},
      {"around B.object accessible ,? D?", SpaceAt, "around"},
      {"A.side not block B.object", OfMovers},
      {", behind", MoreSpace, "back"},
      {", in_front", MoreSpace, "front"},
      {", at_sides", MoreSpace, "sides"},
      {"D space? around B.side", SpaceAt, "named"},
      {"A.vague accessible", Unreachable},
      {"accessible_from A.vague", Unreachable},
      {"A swing_open", SpaceAt, "named"},
      {"swing_open", OpensFully},
      {"A? swing_open on/at_sides B.side", AccessToSide},
      {"A.object? space D? for/to swing_open ,? C.feature?", SpaceAt, "named"},
      {"space for? A swing_open", SpaceAt, "named"},
      {"A.object accessible ,? not block", Accessible},
      {"A? accessible , not block B.thing", AccessibleAndNotBlocking},
      {"A? accessible , not block B.feature", AccessibleAndNotBlocking},
      {"A.object? accessible ,? not block next_to C", Accessible},
  };
}

std::vector<Rule> PathRules() {
  return {
      {"A.side clear_of B.vague", OfMovers},
      {"A.side clear_of accessible/space/access_to", OfMovers},
      {"A.side clear_of", OfMovers},
      {"A.side clear_of B.group", OfMovers},
      {"A.side clear_of swing_open B.feature?", OfMovers},
      {"A? D? C.vague D? around B.object", PathAround, "around"},
      {"A? D? C.vague D? all_sides B.object", PathAround, "all"},
      {"A? not block C.vague around B.object", MovementAround},
  };
}

}  // namespace flair::translator
