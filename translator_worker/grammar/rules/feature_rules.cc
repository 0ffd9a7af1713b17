// SPDX-License-Identifier: GPL-3.0-or-later
// Keeping clear: not in front of windows, not blocking doors, not in the way of other objects.
#include "fmt/format.h"
#include "translator_worker/grammar/rules/keep_clear.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

Call AccessibleFront(const Placed& placed, Composer& composer) {
  std::vector<std::string> sides = SidesOf(composer, placed);
  if (sides.empty()) sides = {"front"};
  return Call("accessible").Text("object", composer.id(placed)).Texts("sides", sides);
}

}  // namespace

// "X does not block T": features stay free, objects stay accessible.
void NotBlock(const Match& match, std::string_view tag, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  for (const Target& target : composer.Targets(*match.b, movers, false)) {
    if (target.kind == RefKind::kFeature) {
      for (const Placed& mover : movers) {
        composer.EmitFirst({Call("clear_of_feature").Text("object", composer.id(mover)).Text("feature", target.name)});
      }
    } else if (target.kind == RefKind::kWall) {
      for (const Placed& mover : movers) {
        composer.EmitFirst({Call("not_against_wall").Text("object", composer.id(mover))});
      }
    } else if (match.b->references.front().kind == RefKind::kPronoun && !composer.last_feature.empty()) {
      for (const Placed& mover : movers) {
        composer.EmitFirst(
            {Call("clear_of_feature").Text("object", composer.id(mover)).Text("feature", composer.last_feature)});
      }
      continue;
    } else if (target.kind == RefKind::kZone) {
      composer.Refuse("not_about_layout", "a whole area cannot be kept clear; name the objects that are reached");
      continue;
    } else if (target.name == "others" || target.name == "all") {
      composer.Refuse("not_about_layout",
                      "\"access to other furniture\" names none; say which object's front stays accessible");
      continue;
    } else if (target.objects.empty()) {
      composer.Refuse("not_about_layout", "only doors, windows, sockets and objects can be kept clear");
    }
    if (!target.objects.empty()) composer.SetPair(movers, target.objects);
    for (const Placed& other : target.objects) {
      if (tag == "gap") {
        for (const Placed& mover : movers) {
          composer.EmitFirst({Call("away_from").Text("object", composer.id(mover)).Text("target", composer.id(other))});
        }
      } else {
        composer.EmitFirst({AccessibleFront(other, composer)});
      }
    }
  }
}

namespace {

// "Placed to allow access to the wardrobe"; after another fact it is that fact's reason.
void AllowAccess(const Match& match, std::string_view tag, Composer& composer) {
  if (!composer.calls().empty()) return;
  // Sockets are reached from near them; doors and windows are kept free.
  const Reference& first = match.b->references.front();
  if (first.kind == RefKind::kFeature && first.name == "socket" && composer.HasFeature("socket")) {
    for (const Placed& mover : composer.Movers(match.a)) {
      composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", first.name)});
    }
    return;
  }
  if (first.kind == RefKind::kZone) {
    composer.Refuse("not_about_layout", "access to an area cannot be asked for; name the objects that are reached");
    return;
  }
  NotBlock(match, tag, composer);
}

// "The door is kept clear": of every floor object of the topic, or of all when nobody is named.
void KeepClear(const Match& match, std::string_view, Composer& composer) {
  for (const Target& target : composer.Targets(*match.b, {})) {
    if (target.kind != RefKind::kFeature) {
      for (const Placed& other : target.objects) composer.EmitFirst({AccessibleFront(other, composer)});
      continue;
    }
    std::vector<Placed> movers = composer.topic();
    Mention all;
    all.references = {{.kind = RefKind::kGroup, .name = "all"}};
    if (movers.empty()) movers = composer.Movers(&all);
    for (const Placed& mover : movers) {
      composer.EmitFirst({Call("clear_of_feature").Text("object", composer.id(mover)).Text("feature", target.name)});
    }
  }
}

// "Doors can open freely": the room's, unless a piece with doors of its own is spoken of.
void DoorsOpen(const Match& match, std::string_view tag, Composer& composer) {
  // "0.6 m from wardrobe to bed, so that doors open": the figure serves it.
  if (composer.topic().empty() && !composer.calls().empty()) return;
  const std::vector<Placed>& topic = composer.topic();
  if (!topic.empty() && composer.HasDoors(topic.front())) {
    for (const Placed& placed : topic) composer.EmitFirst({AccessibleFront(placed, composer)});
  } else {
    KeepClear(match, tag, composer);
  }
}

// "Should not have its back towards the door": only of fronts anything can be asked.
void SideNotFacing(const Match& match, std::string_view tag, Composer& composer) {
  if (match.a->references.front().side == "back") {
    composer.Refuse("not_expressible", "no call keeps a back from a door or window; say what the front faces");
  } else {
    NotBlock(match, tag, composer);
  }
}

void Hide(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "what can be seen from where cannot be asked for; say what faces what");
}

// "The doors must not be obstructed": those of the wardrobe that is spoken of, else the room's.
void NotBlocked(const Match& match, std::string_view tag, Composer& composer) {
  const bool own = match.b->references.front().name == "door" && composer.scope() == v1::SENTENCE_SCOPE_INTRA &&
                   !composer.topic().empty() && composer.HasDoors(composer.topic().front());
  own ? DoorsOpen(match, tag, composer) : KeepClear(match, tag, composer);
}

// "With socket access": sockets are reached from near them, doors and windows are kept free.
void FeatureAccessible(const Match& match, std::string_view tag, Composer& composer) {
  const std::string& name = match.b->references.front().name;
  if (name == "door" && !composer.topic().empty() && composer.IsWalkIn(composer.topic().front())) {
    DoorsOpen(match, tag, composer);
    return;
  }
  if (name != "socket" || !composer.HasFeature(name) || match.b->references.size() > 1) {
    KeepClear(match, tag, composer);
    return;
  }
  for (const Placed& mover : composer.topic()) {
    composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", name)});
  }
}

void PowerAccess(const Match& match, std::string_view, Composer& composer) {
  if (!composer.HasFeature("socket")) {
    composer.Refuse("names_absent_feature", "the room has no socket");
    return;
  }
  for (const Placed& mover : composer.Movers(match.a)) {
    composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", "socket")});
  }
}

void UnderWindow(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.Movers(match.a)) {
    for (const Target& target : composer.Targets(*match.b, {})) {
      if (target.name == "window") {
        composer.EmitFirst({Call("under_window").Text("object", composer.id(mover)),
                            Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", "window")});
      } else {
        composer.EmitFirst({Call("close_to_feature").Text("object", composer.id(mover)).Text("feature", target.name)});
      }
    }
  }
}

void PathBetween(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_about_layout", "paths cannot be asked for; name two objects and the distance between them");
}

void NotBlockEachOther(const Match& match, std::string_view, Composer& composer) {
  std::vector<Placed> all = composer.Movers(match.a);
  if (all.size() < 2) all = composer.subjects();
  for (const Placed& placed : all) composer.EmitFirst({AccessibleFront(placed, composer)});
}

void OutOfSight(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "no call hides one thing from another; say what faces what");
}

void ViewBetween(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "lines of sight cannot be kept free; say what faces what");
}

}  // namespace

std::vector<Rule> FeatureRules() {
  return {
      {"A.side not facing/to B.feature", SideNotFacing},
      {"A? not block B", NotBlock},
      {"A? not block next_to B.feature", NotBlock},
      {"A? not where B.feature swing_open?", NotBlock},
      {"A? access_to/allow_access_to/accessible B not block", NotBlock},
      {"A? access_to/allow_access_to/accessible B keep_clear", NotBlock},
      {"A? not block B not block/accessible", NotBlock},
      {"A? not aligned ,? B.feature", NotBlock},
      {"not_aligned A.object? ,? B.feature", NotBlock},
      {"not B.feature not swing_open", KeepClear},
      {"A? not block C.vague to B.feature", NotBlock},
      {"A? power_access", PowerAccess},
      {"A? access_to power_access", PowerAccess},
      {"A? not_prevent access_to? B", NotBlock},
      {"A? not_prevent away_from ,? to? access_to? B", NotBlock},
      {"A? not_prevent B away_from? swing_open", NotBlock},
      {"A? not_prevent away_from to? swing_open B", NotBlock},
      {"A? not block B.object to C.object", ViewBetween},
      {"A? not block B or accessible/access_to/allow_access_to C", NotBlock},
      {"A? allow_access_to B", AllowAccess},
      {"A? not block ,? accessible/access_to/allow_access_to/accessible_from B", NotBlock},
      {"A? not block ,? B.feature swing_open", NotBlock},
      {"A? accessible when B.feature swing_open", NotBlock},
      {"A? not block B ,? swing_open", NotBlock},
      {"A? not block B accessible", NotBlock},
      {"A? not block B.object space", NotBlock, "gap"},
      {"A? not block C.vague between B", PathBetween},
      {"A? not block_view B.object", ViewBetween},
      {"A? not block_view B.feature", NotBlock},
      {"B.feature not block next_to A.object", NotBlock},
      {"B.feature not behind/under A.object", NotBlock},
      {"B.feature behind A.object accessible/keep_clear", NotBlock},
      {"A? not block B.feature to C.object", ViewBetween},
      {"B.feature swing_open", DoorsOpen},
      {"swing_open B.feature", DoorsOpen},
      {"B.feature swing_open not C.vague", DoorsOpen},
      {"B.feature swing_open not block A.group", DoorsOpen},
      {"B.feature swing_open not block/against/near/next_to A.object", NotBlock},
      {"A? not corner , B.feature", NotBlock},
      {"A? not block C.vague to B.object", NotBlock},
      {"A? not block accessible to B.object", NotBlock},
      {"A? not block both_ways accessible?", NotBlockEachOther},
      {"A? not block C.vague away_from/to B.feature", PathBetween},
      {"A? not block B.object away_from C", ViewBetween},
      {"B.feature on/under C keep_clear/accessible", KeepClear},
      {"A? clear_of B", NotBlock, "gap"},
      {"A? clear_of B.feature ,? swing_open", NotBlock},
      {"A? not in_front_of B.feature", NotBlock},
      {"A? not in_front_of/under/behind/on/above B.feature", NotBlock},
      {"A? not against/facing/opposite B.feature", NotBlock},
      {"A? not visible_from B", OutOfSight},
      {"A? not in_front_of/under/on/over or in_front_of/under/behind/on B.feature", NotBlock},
      {"B.feature keep_clear", KeepClear},
      {"B.feature not block", NotBlocked},
      {"B.feature accessible", FeatureAccessible},
      {"B.feature accessible near/next_to A.object", FeatureAccessible},
      {"B.feature accessible/accessible_from on/at_sides/next_to/near? A.side", FeatureAccessible},
      {"space in_front_of B.feature keep_clear?", KeepClear},
      {"keep_front_clear B keep_clear?", KeepClear},
      {"A? under B.feature", UnderWindow},
      {"A? below B.feature", UnderWindow},
      {"A? not hide B.feature", NotBlock},
      {"A? not? hide B away_from C", Hide},
      {"A? not? hide B?", Hide},
      {"C.vague of? next_to/away_from B.feature", OutOfSight},
  };
}

}  // namespace flair::translator
