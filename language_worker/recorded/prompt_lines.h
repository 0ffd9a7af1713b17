// SPDX-License-Identifier: GPL-3.0-or-later
// What the prompts of the language steps list, read back: a model that answers from a recording has to name objects and
// sentences by the ids that it is asked with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"

namespace flair::language {

// A line of a prompt that lists objects: equal ones.
struct PromptObjects {
  // One or more, in order.
  std::vector<std::string> ids;
  // What all of them are called together; the id of a single one.
  std::string group;
  // As the prompt or, where it does not tell it, the id has it.
  std::string name;
  // Empty when they are in none.
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

// The lines of that form, in their order; others are passed over. Read any text. Objects: of the language steps
// ("- chair_1 to chair_4, together chair (dining): 0.45 x 0.5 x 0.9 m") and of the translation ("- chair_1, chair_2:
// "dining chair", 0.45 x 0.5, dining, on a wall").
std::vector<PromptObjects> ReadPromptObjects(std::string_view prompt);
std::vector<PromptSentence> ReadPromptSentences(std::string_view prompt);

// "dining_chair_3" without its number.
std::string_view WithoutNumber(std::string_view id);

// How a prompt calls the recorded objects.
class PromptIds {
 public:
  // Matches by name, zone and size, equal ones in their order; then, if `loosely`, by name alone: sizes may have been
  // mended.
  PromptIds(const std::vector<const v1::Object*>& objects, std::vector<PromptObjects> listed, bool loosely = false);

  // Empty when the prompt does not list the object.
  const std::string& IdOf(size_t object) const { return places_[object].id; }

  // Names that together mean these objects: a group's when it is meant whole, else ids; in the order of the objects.
  // Objects that the prompt does not list have none.
  std::vector<std::string> NamesOf(const std::vector<int>& objects) const;

 private:
  struct Place {
    int group = -1;
    std::string id;
  };

  std::vector<PromptObjects> listed_;
  std::vector<Place> places_;
};

}  // namespace flair::language
