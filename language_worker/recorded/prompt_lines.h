// SPDX-License-Identifier: GPL-3.0-or-later
// What the prompts of the language steps list, read back: a model that answers from a recording has to name objects and
// sentences by the ids that it is asked with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace flair::language {

// A line of GroupsText: equal objects.
struct PromptObjects {
  // One or more, in order.
  std::vector<std::string> ids;
  // Name of all of them; the id of a single one.
  std::string group;
  std::string zone_id;
  double width_m = 0;
  double depth_m = 0;
};

// An object in a prompt of the translation.
struct PromptObject {
  std::string id;
  std::string name;
  // Empty when it is in none.
  std::string zone_id;
  double width_m = 0;
  double depth_m = 0;
};

// A sentence in the cleaning prompt, or in one of the translation, with the objects of the heading above it.
struct PromptSentence {
  std::string id;
  std::vector<std::string> subject_ids;
  std::string text;
};

// A function in a prompt of the translation.
struct PromptFunction {
  std::string name;
  // The parameters that it cannot do without, in order.
  std::vector<std::string> needed;
};

// The lines of that form, in their order; others are passed over. Read any text.
std::vector<PromptObjects> ReadPromptObjects(std::string_view prompt);
std::vector<PromptObject> ReadTranslationObjects(std::string_view prompt);
std::vector<PromptSentence> ReadPromptSentences(std::string_view prompt);
std::vector<PromptFunction> ReadPromptFunctions(std::string_view prompt);

// "dining_chair_3" without its number.
std::string_view WithoutNumber(std::string_view id);

}  // namespace flair::language
