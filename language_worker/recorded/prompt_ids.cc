// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/prompt_ids.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "language_worker/recorded/object_names.h"

namespace flair::language {

PromptIds::PromptIds(const std::vector<const v1::Object*>& objects, std::vector<PromptObjects> listed)
    : listed_(std::move(listed)), places_(objects.size()) {
  // Prompts round to centimetres.
  const auto near = [](double a, double b) { return std::abs(a - b) < 0.006; };
  std::vector<size_t> used(listed_.size(), 0);
  for (size_t i = 0; i < objects.size(); ++i) {
    const v1::Object& object = *objects[i];
    for (size_t g = 0; g < listed_.size(); ++g) {
      const PromptObjects& group = listed_[g];
      if (used[g] == group.ids.size() || group.zone_id != object.zone_id() ||
          NameKey(group.ids[0]) != NameKey(object.name()) || !near(group.width_m, object.width_m()) ||
          !near(group.depth_m, object.depth_m())) {
        continue;
      }
      places_[i] = {static_cast<int>(g), group.ids[used[g]++]};
      break;
    }
  }
}

std::vector<std::string> PromptIds::NamesOf(const std::vector<int>& objects) const {
  std::vector<size_t> counts(listed_.size(), 0);
  for (const int object : objects) {
    const Place& place = places_[static_cast<size_t>(object)];
    if (place.group >= 0) ++counts[static_cast<size_t>(place.group)];
  }
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const int object : objects) {
    const Place& place = places_[static_cast<size_t>(object)];
    if (place.group < 0) continue;
    const PromptObjects& group = listed_[static_cast<size_t>(place.group)];
    const bool whole = counts[static_cast<size_t>(place.group)] == group.ids.size();
    const std::string& name = whole ? group.group : place.id;
    if (seen.insert(name).second) names.push_back(name);
  }
  return names;
}

}  // namespace flair::language
