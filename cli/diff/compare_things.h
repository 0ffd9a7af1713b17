// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/diff/field_words.h"
#include "cli/diff/matching.h"

namespace flair::cli {

// A section of things that were paired: what was added, removed, and which fields of the others changed. `name` is the
// subject of a thing, `facts` what is said of one that only one side has. An id that changed alone is no change.
template <typename List, typename Name, typename Facts>
Section CompareThings(const std::string& title, const List& a, const List& b, const std::vector<Pair>& pairs,
                      const Name& name, const Facts& facts, const std::set<std::string>& but = {}) {
  Section section{.title = title};
  for (const Pair& pair : pairs) {
    if (pair.a < 0 || pair.b < 0) {
      const auto& thing = pair.a < 0 ? b[pair.b] : a[pair.a];
      section.changes.push_back({pair.a < 0 ? Became::kAdded : Became::kRemoved, name(thing), facts(thing), {}});
    } else if (auto changed = ChangedFields(a[pair.a], b[pair.b], but)) {
      section.changes.push_back(
          {Became::kChanged, name(b[pair.b]), std::move(changed->words), std::move(changed->detail)});
    } else {
      ++section.same_count;
    }
  }
  return section;
}

inline void AddSection(Section section, std::vector<Section>& sections) {
  if (!section.changes.empty() || section.same_count > 0 || !section.note.empty()) {
    sections.push_back(std::move(section));
  }
}

}  // namespace flair::cli
