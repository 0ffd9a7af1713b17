// SPDX-License-Identifier: GPL-3.0-or-later
// A repair of some elements of an answer's lists, in the stead of one of the whole answer.
#pragma once

#include <google/protobuf/message.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "llm/answers/fault.h"

namespace flair::llm {

// Numbers of elements by the name of the root's list that they are in; none is empty.
using Elements = std::map<std::string, std::set<int>>;

// The elements in which all faults worth asking about are; nothing when one is in no element of the root's lists, as
// such an answer has to be asked for as a whole.
std::optional<Elements> FaultyElements(std::span<const Fault> faults, const google::protobuf::Message& answer);

// The first answer with these elements alone, as JSON: as the model wrote them where `written`, the JSON of its answer,
// has them, else as they were read.
std::string PartOf(const nlohmann::json& written, const google::protobuf::Message& answer, const Elements& elements);

// Faults with the numbers that elements have in PartOf; those in other elements are left out.
std::vector<Fault> NumberedInPart(std::span<const Fault> faults, const Elements& elements);

// What a repair of some elements has come to.
struct Merged {
  // The elements of the first answer that others have replaced.
  Elements replaced;
  // Faults of the replacements, with their numbers in the whole answer.
  std::vector<Fault> faults;
};

// Puts the elements of a repair, read with `faults`, in the place of those that it is of. They are known by what names
// an element (the text that its type begins with), else by their order when there are as many of them, or as many as
// in the whole answer. What cannot be placed changes nothing. Pure but for `answer`.
Merged MergeElements(const google::protobuf::Message& repair, std::span<const Fault> faults, const Elements& elements,
                     google::protobuf::Message& answer);

}  // namespace flair::llm
