// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace flair::llm {

// The texts that one field may take, known only at run time: names of zones, objects, constraint types.
struct Choices {
  // In the order in which the model is shown them.
  std::vector<std::string> names;
  // Other words that certainly mean one of them; not shown.
  std::map<std::string, std::string> aliases;
};

// By full name of the field, such as "flair.model.v1.FloorObjectAnswer.zone".
using FieldChoices = std::map<std::string, Choices>;

// The choice that a text means: equal but for case, spaces, hyphens and underscores, a plural s, or an alias in that
// sense; nothing when there is none or it would be more than one.
std::optional<std::string> FindChoice(std::string_view text, const Choices& choices);

// Letters and digits of a text in lower case, bytes beyond ASCII as they are: what names are compared by.
std::string Bare(std::string_view text);

}  // namespace flair::llm
