// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/sides.h"

#include <cmath>
#include <cstdlib>

#include "fmt/format.h"

namespace flair::translator {
namespace {

// The one side that the last call about the object names; empty when there is none.
std::string SideSpokenOf(const Composer& composer, const std::string& id) {
  for (size_t i = composer.calls().size(); i > 0; --i) {
    const Call& call = composer.calls()[i - 1];
    if (call.arguments.size() < 2 || call.arguments[0].value().text() != id) continue;
    const v1::Argument& second = call.arguments[1];
    if (second.name() == "side") return second.value().text();
    if (second.name() == "sides" && second.value().texts().items_size() == 1) return second.value().texts().items(0);
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

}  // namespace flair::translator
