// SPDX-License-Identifier: GPL-3.0-or-later
// What several families make: contact at a side, one at each side, distances.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "translator_worker/grammar/frames.h"
#include "translator_worker/grammar/rules/shared.h"

namespace flair::translator {

namespace {

// The one side that the last call about the object names; empty when there is none.
std::string SideSpokenOf(const Composer& composer, const std::string& id) {
  for (size_t i = composer.calls().size(); i > 0; --i) {
    const Call& call = composer.calls()[i - 1];
    if (call.arguments.size() < 2 || call.arguments[0].value().text() != id) continue;
    const v1::Argument& second = call.arguments[1];
    if (second.name() == "side") return second.value().text();
  }
  return "";
}

}  // namespace

std::vector<std::string> SidesOf(Composer& composer, const Placed& placed) {
  const std::string& word = placed.side;
  if (word.empty()) return {};
  if (word == "front" || word == "back" || word == "left" || word == "right") return {word};
  const v1::Object& object = composer.object(placed.object);
  const bool wide = object.width_m() > object.depth_m();
  const std::vector<std::string> lateral = {"left", "right"};
  const std::vector<std::string> axial = {"front", "back"};
  const auto one = [&](const std::vector<std::string>& options) -> std::vector<std::string> {
    composer.Note("side_left_open",
                  fmt::format("either of several sides of {} is meant; {} was taken", object.id(), options[0]));
    return {options[0]};
  };
  if (word == "sides") return lateral;
  if (word == "other") {
    const std::string other = OppositeSide(SideSpokenOf(composer, object.id()));
    return other.empty() ? one(lateral) : std::vector<std::string>{other};
  }
  if (word == "side" || word == "lateral_one") return one(lateral);
  if (word == "axial") return axial;
  if (word == "opposite_two") {
    composer.Note("side_left_open",
                  fmt::format("which two sides of {} is open; left and right were taken", object.id()));
    return lateral;
  }
  if (word.rfind("length", 0) == 0) {
    const double length = std::atof(word.c_str() + word.find(':') + 1);
    const bool of_width = std::abs(length - object.width_m()) <= std::abs(length - object.depth_m());
    const std::vector<std::string>& pair = of_width ? axial : lateral;
    return word[6] == 's' ? pair : one(pair);
  }
  if (word == "long_both") return wide ? axial : lateral;
  if (word == "long_one") return one(wide ? axial : lateral);
  if (word == "short_both") return wide ? lateral : axial;
  if (word == "short_one") return one(wide ? lateral : axial);
  if (word == "all") return {"front", "back", "left", "right"};
  if (word == "three") return {"front", "left", "right"};
  if (word == "two_any") {
    composer.Note("side_left_open",
                  fmt::format("which two sides of {} is open; front and left were taken", object.id()));
    return {"front", "left"};
  }
  return {};
}

std::string OneSide(Composer& composer, const Placed& placed) {
  if (placed.side == "sides" || placed.side == "all" || placed.side == "side" || placed.side == "axial") return "";
  const std::vector<std::string> sides = SidesOf(composer, placed);
  // "A long side against a wall": of front and back the back.
  const bool open = placed.side == "long_one" || placed.side == "short_one";
  if (open && sides.size() == 1 && sides.front() == "front") return "back";
  if (placed.side == "long_both" || placed.side == "short_both" || sides.size() != 1) return "";
  return sides.front();
}

std::string OppositeSide(const std::string& side) {
  if (side == "left") return "right";
  if (side == "right") return "left";
  if (side == "front") return "back";
  return side == "back" ? "front" : "";
}

void LayRug(const char* type, const Placed& rug, const Placed& object, Composer& composer) {
  if (!composer.rug_placed) {
    composer.EmitFirst({Call(type).Text("rug", composer.id(rug)).Text("object", composer.id(object))});
  }
  composer.rug_placed = true;
}

bool LaidBeside(const Placed& mover, const Placed& other, Composer& composer) {
  if (!composer.IsTertiaryRug(mover) || !composer.IsFloor(other)) return false;
  LayRug("rug_under_forward", mover, other, composer);
  return true;
}

void Contact(const Placed& mover, const Target& target, Composer& composer) {
  if (target.kind == RefKind::kFeature) {
    composer.EmitFirst({Call("close_to_feature")
                            .Text("object", composer.id(mover))
                            .Text("feature", target.name)
                            .MaybeText("side", OneSide(composer, mover))});
    return;
  }
  if (composer.IsSurface(mover) && !target.objects.empty()) {
    // "on the nightstand next to the bed": the host says it.
    if (composer.calls().empty()) composer.Refuse("unknown_sentence", "say on what it stands");
    return;
  }
  if (target.objects.empty()) {
    composer.Refuse("unknown_sentence", "it can stand against a wall or an object");
    return;
  }
  for (const Placed& other : target.objects) {
    if (other.object == mover.object || LaidBeside(mover, other, composer)) continue;
    const bool lateral = other.side == "side" || other.side == "sides" || other.side == "lateral_one";
    std::string other_side = OneSide(composer, other);
    if (lateral) other_side = SidesOf(composer, other).front();
    std::string side = OneSide(composer, mover);
    if (mover.side == "side") side = lateral ? OppositeSide(other_side) : SidesOf(composer, mover).front();
    if (lateral && side.empty()) side = OppositeSide(other_side);
    composer.EmitFirst({Call("next_to")
                            .Text("object", composer.id(mover))
                            .Text("target", composer.id(other))
                            .MaybeText("object_side", side)
                            .MaybeText("target_side", other_side)});
  }
  composer.SetPair({mover}, target.objects);
}

void Beside(const Placed& mover, const std::vector<Placed>& targets, const std::string& target_side,
            Composer& composer) {
  for (const Placed& other : targets) {
    composer.EmitFirst({Call("next_to")
                            .Text("object", composer.id(mover))
                            .Text("target", composer.id(other))
                            .MaybeText("object_side", OneSide(composer, mover))
                            .MaybeText("target_side", target_side)});
  }
  composer.SetPair({mover}, targets);
}

std::vector<Placed> OneAtEach(const Mention* mention, Composer& composer) {
  if (mention == nullptr || mention->references.size() != 1 || mention->references.front().ordinal != 1)
    return composer.Movers(mention);
  Mention all = *mention;
  all.references.front().ordinal = 0;
  all.references.front().each = true;
  return composer.Movers(&all);
}

void Flank(const std::vector<Placed>& movers, const std::vector<Placed>& targets, Composer& composer) {
  for (const Placed& target : targets) {
    if (movers.size() > 2 && composer.IsFloor(movers.front())) {
      std::vector<std::string> ids;
      for (const Placed& mover : movers) ids.push_back(composer.id(mover));
      composer.EmitFirst({Call("surround").Text("center", composer.id(target)).Texts("objects", ids)});
      continue;
    }
    // "On opposite long sides of the table" are those two.
    const std::vector<std::string> named = SidesOf(composer, target);
    std::string side = named.size() == 2 ? named.front() : "left";
    for (const Placed& mover : movers) {
      if (composer.IsWall(mover)) {
        composer.Relate("on_wall_near", mover, target);
        continue;
      }
      // With its back or front to the table a chair stands as it likes.
      const bool lateral = side == "left" || side == "right";
      composer.EmitFirst({Call("next_to")
                              .Text("object", composer.id(mover))
                              .Text("target", composer.id(target))
                              .MaybeText("object_side", lateral ? OppositeSide(side) : "")
                              .Text("target_side", side)});
      side = OppositeSide(side);
    }
  }
  if (!movers.empty() && !targets.empty()) composer.SetPair(movers, targets);
}

void KeepDistance(const Placed& mover, const Placed& other, const Distance* distance, Composer& composer) {
  if (mover.object == other.object) return;
  const std::string& id = composer.id(mover);
  const std::string& target = composer.id(other);
  if (distance == nullptr) {
    composer.EmitFirst({Call("away_from").Text("object", id).Text("target", target)});
    return;
  }
  if (distance->Nominal() == 0) {
    composer.EmitFirst(
        {Call("next_to").Text("object", id).Text("target", target).MaybeText("target_side", OneSide(composer, other))});
    return;
  }
  if (distance->min_m) {
    composer.EmitFirst(
        {Call("away_from").Text("object", id).Text("target", target).Number("min_distance_m", *distance->min_m)});
  }
  // "0.5 m from the sofa" is kept clear; only a range or a limit also asks to be near.
  if (distance->max_m && !distance->exact) {
    composer.EmitFirst(
        {Call("near").Text("object", id).Text("target", target).Number("max_distance_m", *distance->max_m)});
  }
}

}  // namespace flair::translator
