// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/object_list.pb.h"
#include "language_worker/recorded/prompt_lines.h"

namespace flair::language {

// How a prompt calls the recorded objects.
class PromptIds {
 public:
  // Matches by name, zone and size, equal ones in their order.
  PromptIds(const std::vector<const v1::Object*>& objects, std::vector<PromptObjects> listed);

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
