// SPDX-License-Identifier: GPL-3.0-or-later
// Ways between pieces, how wide they are, and doors, windows and sockets that something stays away from.
#include "translator_worker/grammar/rules/gaps.h"
#include "translator_worker/grammar/rules/rule.h"

namespace flair::translator {
namespace {

// "A clear walkway between the sofa and the table" keeps them apart; between pieces that are not named it is a path.
void DistanceOrPathBetween(const Match& match, std::string_view tag, Composer& composer) {
  if (match.a != nullptr && match.c->references.front().name == "paths") {
    ApartFromEachOther(match, tag, composer);
    return;
  }
  const Reference& first = match.b->references.front();
  const bool several = first.kind == RefKind::kObjects && (first.plural || first.each) && first.candidates.size() > 1;
  const bool named = several || (match.b->references.size() > 1 && first.kind != RefKind::kGroup);
  if (named && match.c->references.front().name == "paths") {
    Between(match, tag, composer);
  } else {
    composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
  }
}

// "Walkways of at least 0.6 m": how wide ways are, wherever they lead. Of other vague things the figure is a space's.
void Ways(const Match& match, std::string_view tag, Composer& composer) {
  // "Opposite each other with an aisle of 1.2 m": between the two.
  const bool between =
      composer.scope() == v1::SENTENCE_SCOPE_INTER && !composer.calls().empty() && !composer.pair_targets().empty();
  if (match.c->references.front().name == "paths" && !between) {
    composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
  } else {
    BareDistance(match, tag, composer);
  }
}

// "No sockets nearby", "the door is at least 1 m away": from what is spoken of.
void FeatureAway(const Match& match, std::string_view, Composer& composer) {
  for (const Target& target : composer.Targets(*match.b, {}, false)) {
    const std::vector<Placed> movers = composer.Movers(match.a);
    for (const Placed& mover : movers) KeepAway(mover, target, match.distance, composer);
    if (movers.empty()) composer.Refuse("unknown_sentence", "nothing says what is kept away from it");
  }
}

}  // namespace

std::vector<Rule> WalkwayRules() {
  return {
      {"D? C.vague of? D? ,? between B", DistanceOrPathBetween},
      {"D? C.vague between B ,? D", DistanceOrPathBetween},
      {"A.group not between B", NothingBetween},
      {"A.list D? C.vague D? between B.pronoun", DistanceOrPathBetween},
      {"B.feature not near/next_to", FeatureAway},
      {"B.feature not near/next_to ,? D", FeatureAway},
      {"B.feature not near/next_to A.object", FeatureAway},
      {"B.feature away_from", FeatureAway},
      {"B.feature away_from/near D", FeatureAway},
      {"B.feature D apart/away", FeatureAway},
      {"B.feature D away_from A.thing", FeatureAway},
      {"across D C.vague?", ApartFromEachOther},
      {"B.feature apart/away", FeatureAway},
      {"B.feature away ,? D apart/away?", FeatureAway},
      {"C.vague of? ,? D space?", Ways},
      {"D of? space? C.vague", Ways},
  };
}

}  // namespace flair::translator
