// SPDX-License-Identifier: GPL-3.0-or-later
// Doors, windows and sockets: kept clear, near, got at.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {
// "X does not block T": features stay free, objects stay accessible.
void NotBlock(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers, false)) {
    if (target.kind == RefKind::kFeature) {
      for (const Placed& mover : movers) {
        composer.RelateToFeature("clear_of_feature", mover, target.name);
      }
    } else if (target.kind == RefKind::kWall) {
      for (const Placed& mover : movers) {
        composer.Place("not_against_wall", mover);
      }
    } else if (match.b->references.front().kind == RefKind::kPronoun && !composer.last_feature.empty()) {
      for (const Placed& mover : movers) {
        composer.RelateToFeature("clear_of_feature", mover, composer.last_feature);
      }
      continue;
    } else if (target.name == "others" || target.name == "all") {
      composer.Refuse("not_about_layout",
                      "\"access to other furniture\" names none; say which object's front stays accessible");
      continue;
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
    for (const Placed& other : target.objects) {
      if (detail == "gap") {
        for (const Placed& mover : movers) {
          composer.Relate("away_from", mover, other);
        }
      } else {
        KeepFront(other, composer);
      }
    }
  }
}

namespace {

// "Placed to allow access to the wardrobe"; after another fact it is that fact's reason.
void AllowAccess(const Match& match, std::string_view detail, Composer& composer) {
  if (!composer.calls().empty()) return;
  // Sockets are reached from near them; doors and windows are kept free.
  const Reference& first = match.b->references.front();
  if (first.kind == RefKind::kFeature && first.name == "socket" && composer.HasFeature("socket")) {
    for (const Placed& mover : composer.Movers(match.a)) {
      composer.RelateToFeature("close_to_feature", mover, first.name);
    }
    return;
  }
  NotBlock(match, detail, composer);
}

// "The door is kept clear": of every floor object of the topic.
void KeepClear(const Match& match, std::string_view, Composer& composer) {
  for (const Target& target : composer.Targets(*match.b, {})) {
    if (target.kind != RefKind::kFeature) {
      for (const Placed& other : target.objects) KeepFront(other, composer);
      continue;
    }
    for (const Placed& mover : composer.topic()) {
      composer.RelateToFeature("clear_of_feature", mover, target.name);
    }
  }
}

// "Doors can open freely": the room's, unless a piece with doors of its own is spoken of.
void DoorsOpen(const Match& match, std::string_view detail, Composer& composer) {
  const std::vector<Placed>& topic = composer.topic();
  if (!topic.empty() && composer.HasDoors(topic.front())) {
    for (const Placed& placed : topic) KeepFront(placed, composer);
  } else {
    KeepClear(match, detail, composer);
  }
}

// "The doors must not be obstructed": those of the wardrobe that is spoken of, else the room's.
void NotBlocked(const Match& match, std::string_view detail, Composer& composer) {
  const bool own = match.b->references.front().name == "door" && composer.scope() == v1::SENTENCE_SCOPE_INTRA &&
                   !composer.topic().empty() && composer.HasDoors(composer.topic().front());
  own ? DoorsOpen(match, detail, composer) : KeepClear(match, detail, composer);
}

// "With socket access": sockets are reached from near them, doors and windows are kept free.
void FeatureAccessible(const Match& match, std::string_view detail, Composer& composer) {
  const std::string& name = match.b->references.front().name;
  if (name == "door" && !composer.topic().empty() && composer.IsAmong("walk-ins", composer.topic().front())) {
    DoorsOpen(match, detail, composer);
    return;
  }
  if (name != "socket" || !composer.HasFeature(name) || match.b->references.size() > 1) {
    KeepClear(match, detail, composer);
    return;
  }
  for (const Placed& mover : composer.topic()) {
    composer.RelateToFeature("close_to_feature", mover, name);
  }
}

void PowerAccess(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.RelateToFeature("close_to_feature", mover, "socket");
  }
}

void UnderWindow(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    for (const Target& target : composer.Targets(*match.b, {})) {
      if (target.name != "window") continue;
      composer.EmitFirst({Call("under_window").Text("object", composer.id(mover)),
                          Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", "window")});
    }
  }
}

void PathBetween(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
}

void OutOfSight(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "no call hides one thing from another; say what faces what");
}

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
}

// "Access to sockets" wants them near, "access to the door" wants it free.
void AccessToFeature(const Match& match, std::string_view, Composer& composer) {
  const Reference& first = match.b->references.front();
  if (first.name == "socket" || !composer.HasFeature(first.name)) {
    Near(match, "", composer);
    return;
  }
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.RelateToFeature("clear_of_feature", mover, first.name);
  }
}

}  // namespace

std::vector<Meaning> FeatureMeanings() {
  return {
      {"not_block", NotBlock},       {"allow_access", AllowAccess},     {"keep_clear", KeepClear},
      {"doors_open", DoorsOpen},     {"not_blocked", NotBlocked},       {"feature_accessible", FeatureAccessible},
      {"power_access", PowerAccess}, {"under_window", UnderWindow},     {"path_between", PathBetween},
      {"out_of_sight", OutOfSight},  {"feature_within", FeatureWithin}, {"access_to_feature", AccessToFeature},
  };
}

}  // namespace flair::translator
