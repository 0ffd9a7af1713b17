// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json.hpp>

namespace flair::llm {

// A list whose elements are lines, "s1: words", as the objects that they stand for: the part before the colon is the
// type's first field, the rest the only element of its second. Marks of a list, quotes and brackets around the first
// part mean nothing. One text may hold all lines, and an object may have them by their first parts. Elements that are
// no texts stay. Pure; any value is good input.
nlohmann::json ListOfLines(const nlohmann::json& value, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
