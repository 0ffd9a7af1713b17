// SPDX-License-Identifier: GPL-3.0-or-later
// Nearness and contact by position: near, next to, left of, behind, on each side of.
#include <string>

#include "translator_worker/grammar/rules/contact.h"
#include "translator_worker/grammar/rules/near.h"
#include "translator_worker/grammar/rules/rule.h"
#include "translator_worker/grammar/rules/space.h"

namespace flair::translator {
namespace {

// "Able to reach the basin from the couch": the basin is near the couch.
void NearReached(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.TargetObjects(*match.b, {})) {
    for (const Target& target : composer.Targets(*match.a, {mover})) NearOne(mover, target, nullptr, composer);
  }
}

// "From the sofa one can reach it".
void NearFrom(const Match& match, std::string_view, Composer& composer) {
  for (const Placed& mover : composer.TargetObjects(*match.b, {})) {
    for (const Target& target : composer.Targets(*match.c, {mover})) NearOne(mover, target, nullptr, composer);
  }
}

// "Closer to the door than the sofa": no call compares.
void Nearer(const Match&, std::string_view, Composer& composer) {
  composer.Refuse("not_expressible", "distances are not compared; say how far it may be from what");
}

// "No further from the stove than 1.5 m".
void NotFurther(const Match& match, std::string_view tag, Composer& composer) {
  const Distance most{std::nullopt, match.distance->Nominal(), false};
  Match near = match;
  near.distance = &most;
  Near(near, tag, composer);
}

// "Next to the cabinet on the left": at that side of the cabinet.
void NextToAtSide(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  std::vector<Placed> targets = composer.TargetObjects(*match.b, movers);
  const std::string& side = match.c->references.front().side;
  for (Placed& target : targets) target.side = side;
  if (side == "sides" || side.ends_with("both")) {
    Flank(movers, targets, composer);
    return;
  }
  for (const Placed& mover : movers) {
    if (composer.IsFloor(mover)) {
      Contact(mover, {RefKind::kObjects, targets, ""}, composer);
    } else {
      for (const Placed& target : targets) NearOne(mover, {RefKind::kObjects, {target}, ""}, nullptr, composer);
    }
  }
}

// "Close to the wall with its back".
void NearWallWithSide(const Match& match, std::string_view, Composer& composer) {
  for (Placed mover : composer.Movers(match.a)) {
    mover.side = match.c->references.front().side;
    for (const Target& target : composer.Targets(*match.b, {mover})) NearOne(mover, target, nullptr, composer);
  }
}

// "Two chairs at each table": the first two at the first.
void ShareOut(const std::vector<Placed>& movers, const std::vector<Placed>& targets, Composer& composer) {
  const size_t each = movers.size() / targets.size();
  for (size_t i = 0; i < movers.size(); ++i) {
    Contact(movers[i], {RefKind::kObjects, {targets[i / each]}, ""}, composer);
  }
}

void NextTo(const Match& match, std::string_view, Composer& composer) {
  if (composer.RefuseUnnamed(*match.b) || KeepsOwnSides(match.a, *match.b, composer)) return;
  const std::string& side = match.b->references.front().side;
  // "People stand at three sides of the bench" that is spoken of.
  if (match.a == nullptr && !side.empty() && composer.scope() == v1::SENTENCE_SCOPE_INTRA &&
      IsOwnPart(*match.b, composer)) {
    KeepSpace({{composer.topic().front().object, side}}, match.distance, composer);
    return;
  }
  std::vector<Placed> movers = composer.Movers(match.a);
  const bool several_sides = side == "sides" || side == "long_both" || side == "short_both" || side == "all";
  if (several_sides) movers = OneAtEach(match.a, composer);
  // "Three chairs along each long side of the table".
  if (several_sides && movers.size() > 1 && composer.IsFloor(movers.front())) {
    Flank(movers, composer.TargetObjects(*match.b, movers), composer);
    return;
  }
  for (const Target& target : composer.Targets(*match.b, movers)) {
    const size_t targets = target.objects.size();
    if (match.b->references.front().each && targets > 1 && movers.size() > targets && movers.size() % targets == 0) {
      ShareOut(movers, target.objects, composer);
      continue;
    }
    for (const Placed& mover : movers) {
      if (composer.IsWall(mover) || target.kind == RefKind::kWall) {
        NearOne(mover, target, match.distance, composer);
      } else {
        Contact(mover, target, composer);
      }
    }
  }
}

// Stands at a named side of the target; tag is that side.
void AtSide(const Match& match, std::string_view tag, Composer& composer) {
  const std::vector<Placed> movers = composer.Movers(match.a);
  const std::vector<Placed> targets = composer.TargetObjects(
      *match.b, match.a == nullptr && match.distance != nullptr ? std::vector<Placed>{} : movers);
  // "The chairs have 0.6 m behind them".
  const bool own = match.distance != nullptr && !movers.empty() && !targets.empty() &&
                   movers.front().object == targets.front().object;
  // "At least 0.6 m behind each chair": free space, when nobody else is spoken of.
  if (own || (match.a == nullptr && match.distance != nullptr && !match.distance->max_m)) {
    for (const Placed& other : targets) {
      // "Behind the chair" of a desk is in front of the desk.
      const bool at_subject = tag == "back" && composer.StandsAtSubject(other);
      composer.EmitFirst({Call("accessible")
                              .Text("object", composer.id(at_subject ? composer.subjects().front() : other))
                              .Texts("sides", {at_subject      ? "front"
                                               : tag == "side" ? "left"
                                                               : std::string(tag)})
                              .Number("min_clearance_m", match.distance->Nominal())});
    }
    return;
  }
  for (const Placed& mover : movers) {
    if (composer.IsTertiaryRug(mover) && tag == "front" && !targets.empty()) {
      if (!composer.rug_placed) {
        composer.EmitFirst(
            {Call("rug_under_forward").Text("rug", composer.id(mover)).Text("object", composer.id(targets.front()))});
      }
      composer.rug_placed = true;
    } else if (composer.IsSurface(mover)) {
      // "On the nightstand to the left of the bed": which nightstand.
      if (composer.IsOnTop(mover)) continue;
      // "On the right side of the desk": near that edge of its top.
      for (const Placed& other : targets) {
        Call call = Call("on_top_corner").Text("object", composer.id(mover)).Text("host", composer.id(other));
        if (tag == "back") call.Text("corner", "back_left");
        composer.EmitFirst({std::move(call)});
      }
    } else if (composer.IsWall(mover)) {
      for (const Placed& other : targets) {
        composer.EmitFirst({Call(tag == "back" ? "on_wall_above" : "on_wall_near")
                                .Text("object", composer.id(mover))
                                .Text("target", composer.id(other))});
      }
    } else {
      Beside(mover, targets, tag == "side" ? "left" : std::string(tag), composer);
      for (const Placed& other : targets) {
        if (match.distance != nullptr && match.distance->Nominal() > 0) {
          KeepDistance(mover, other, match.distance, composer);
        }
      }
    }
  }
}

// "At the end of the bed" is at its foot, of a counter at its left or right.
void AtFoot(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> targets = composer.TargetObjects(*match.b, composer.Movers(match.a));
  const bool has_foot = targets.empty() || composer.IsBed(targets.front()) || composer.IsSeat(targets.front());
  AtSide(match, has_foot ? "front" : "side", composer);
}

void OnEachSide(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> movers = OneAtEach(match.a, composer);
  Flank(movers, composer.TargetObjects(*match.b, movers), composer);
}

// "A nightstand on each side": all that bear the name.
Mention EachOfThem(const Mention& mention) {
  Mention all = mention;
  Reference& reference = all.references.front();
  if (all.references.size() > 1 || !(reference.any || reference.ordinal == 1)) return all;
  reference.any = false;
  reference.ordinal = 0;
  reference.each = true;
  return all;
}

// "The bed is flanked by nightstands", "each table has two chairs, one on either side".
void FlankedBy(const Match& match, std::string_view, Composer& composer) {
  const std::vector<Placed> centers = composer.Movers(match.a);
  Flank(composer.TargetObjects(EachOfThem(*match.b), centers), centers, composer);
}

// "On each side of the bed stands a nightstand".
void AtEachSideStands(const Match& match, std::string_view, Composer& composer) {
  const Mention movers = EachOfThem(*match.a);
  const std::vector<Placed> centers = composer.TargetObjects(*match.b, {});
  Flank(composer.TargetObjects(movers, centers), centers, composer);
}

}  // namespace

std::vector<Rule> NearRules() {
  return {
      {"A? near B.wall ,? C.side", NearWallWithSide},
      {"A? near/access_to next_to/on B.object", Near},
      {"A? near B D?", Near},
      {"C.vague near/accessible_from B.object", Near},
      {"A? not_further B than D", NotFurther},
      {"A? not further D away_from B", NotFurther},
      {"A? near B , D apart/away?", Near},
      {"A? near D? of B", Near},
      {"A? D of/near B", Near},
      {"A? access_to B.object", Near, "access"},
      {"A? near for next_to/near B", Near},
      {"nearby B", Near},
      {"A? space for B.object near/next_to", Near},
      {"A? next_to B", NextTo},
      {"A? next_to B ,? side_by_side", NextTo},
      {"A? along B.thing", NextTo},
      {"A? D? left_of B ,? D? apart/away?", AtSide, "left"},
      {"A? D? right_of B ,? D? apart/away?", AtSide, "right"},
      {"A? D? behind B ,? D? apart/away?", AtSide, "back"},
      {"A? foot_of B", AtSide, "front"},
      {"A? end_of B", AtFoot},
      {"A? head_of B", AtSide, "side"},
      {"A? D? to_side B", AtSide, "side"},
      {"A? each_side_of B", OnEachSide},
      {"A.object flanked_by B.object", FlankedBy},
      {"each_side_of B.object A.object", AtEachSideStands},
      {"A.object B.object ,? one_each_side", FlankedBy},
      {"A.object B.object ,? at_sides", FlankedBy},
      {"A.object B.object each_side_of C.pronoun", FlankedBy},
      {"A? next_to/near/against/each_side_of B.object ,? one_each_side", OnEachSide},
      {"A.object one_each_side of? B.object", OnEachSide},
      {"A? next_to B.object ,? on/next_to C.side", NextToAtSide},
      {"A? , each_side_of B", OnEachSide},
      {"A? on/next_to/at_sides B.side , of B", OnEachSide},
      {"A? reach B.object", Near, "access"},
      {"reach B.object away_from A.object", NearReached},
      {"away_from C.object ,? reach B.object", NearFrom},
      {"A? near B.feature than C", Nearer},
  };
}

}  // namespace flair::translator
