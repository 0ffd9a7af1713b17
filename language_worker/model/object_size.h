// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/parts/furniture_index.h"
#include "llm/answers/fault.h"

namespace flair::language {

// Whether a name is that of something to walk over: "rug", "bath mat", "carpet runner".
bool IsRugName(std::string_view name);

// Extents of one object, metres.
struct ObjectSize {
  double width_m = 0;
  double depth_m = 0;
  double height_m = 0;
};

// "2.2 m x 0.6 m"
std::string FootprintText(const ObjectSize& size);

// What is odd about a size of that class, as a fault's text: more than 2.5 times as large as the class gets or as much
// smaller, as lengths in a wrong unit are; empty when nothing is, or the class is not known.
std::string OddSize(const ObjectSize& size, const hb::Furniture* furniture);

// What is wrong with the footprint of an object at a path of an answer: larger than the room in any turn, which is
// wrong, or odd for its class.
std::optional<llm::Fault> FootprintFault(const std::string& path, const ObjectSize& size, const FloorExtent& floor,
                                         const hb::Furniture* furniture);

// The object that an element of an answer describes: id, name, size no higher than the room, description, category.
template <typename Answer>
v1::Object DescribedObject(const Answer& answer, const std::string& id, const v1::Room& room,
                           const hb::Furniture* furniture) {
  v1::Object object;
  object.set_id(id);
  const std::string name = PlainName(answer.name());
  object.set_name(name.empty() ? answer.name() : name);
  object.set_width_m(answer.width_m());
  object.set_depth_m(answer.depth_m());
  object.set_height_m(std::min(answer.height_m(), room.height_m()));
  object.set_description(answer.description());
  object.set_requested(answer.requested());
  if (furniture != nullptr) {
    object.set_category(furniture->category());
    object.set_rim_sides_m(furniture->rim_sides_m());
    object.set_rim_ends_m(furniture->rim_ends_m());
  }
  return object;
}

}  // namespace flair::language
