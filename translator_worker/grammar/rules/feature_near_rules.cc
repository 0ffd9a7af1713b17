// SPDX-License-Identifier: GPL-3.0-or-later
// Doors, windows and sockets that are near a piece or have to be got at from it.
#include "translator_worker/grammar/rules/gaps.h"
#include "translator_worker/grammar/rules/near.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"

namespace flair::translator {
namespace {

// "A socket should be within 1 m", "the door is at least 1 m away": of what is spoken of.
void FeatureWithin(const Match& match, std::string_view, Composer& composer) {
  for (const Target& target : composer.Targets(*match.b, {})) {
    for (const Placed& mover : composer.topic()) {
      if (target.name == "door" && composer.HasDoors(mover)) {
        KeepSpace({mover}, match.distance, composer);  // its own
        continue;
      }
      match.distance->max_m ? NearOne(mover, target, match.distance, composer)
                            : KeepAway(mover, target, match.distance, composer);
    }
  }
  if (composer.topic().empty()) composer.Refuse("unknown_sentence", "nothing says of what it is so far");
}

// "Sockets should be available within 1 m of the station".
void FeatureWithinOf(const Match& match, std::string_view, Composer& composer) {
  for (const Target& target : composer.Targets(*match.b, {})) {
    for (const Placed& mover : composer.Movers(match.a)) {
      match.distance->max_m ? NearOne(mover, target, match.distance, composer)
                            : KeepAway(mover, target, match.distance, composer);
    }
  }
}

// "Access to sockets" wants them near, "access to the door" wants it free.
void AccessToFeature(const Match& match, std::string_view, Composer& composer) {
  const Reference& first = match.b->references.front();
  if (first.name == "socket" || !composer.HasFeature(first.name)) {
    Near(match, "", composer);
    return;
  }
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("clear_of_feature").Text("object", composer.id(mover)).Text("feature", first.name)});
  }
}

}  // namespace

std::vector<Rule> FeatureNearRules() {
  return {
      {"B.feature D of/near/away_from A.object", FeatureWithinOf},
      {"B.feature D to A.object", FeatureWithinOf},
      {"B.feature near/next_to A.object", Near},
      {"B.feature near/next_to A.object accessible/keep_clear", Near},
      {"B.feature near", Near},
      {"B.feature behind/near/next_to A.pronoun", Near},
      {"B.feature D", FeatureWithin},
      {"B.feature at_sides considered?", Near},
      {"A? access_to B.feature", AccessToFeature},
      {"A? accessible access_to? B.feature", Near},
      {"A? on/along B.feature", Near},
      {"B.feature considered", Near},
      {"B.feature accessible_from A.object", Near},
      {"B.feature head_of/foot_of/left_of/right_of/to_side A.object", Near},
  };
}

}  // namespace flair::translator
