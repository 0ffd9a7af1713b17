// SPDX-License-Identifier: GPL-3.0-or-later
// Changed fields of a message in words: the unit comes from the field's name.
#pragma once

#include <google/protobuf/message.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/diff/difference.h"
#include "cli/diff/pairing.h"

namespace flair::cli {

// "1.60 -> 1.80 m" for the field width_m; enough digits to tell the two apart. Radians are shown in degrees, shares in
// percent.
std::string NumberWords(const std::string& field, double a, double b);

// "width 1.60 -> 1.80 m, name "desk" -> "table""; nothing when no field differs. `detail` has each changed field by its
// path with its values in A and B. Fields of the message itself that are in `but` are not looked at.
struct FieldWords {
  std::string words;
  nlohmann::json detail;
};
std::optional<FieldWords> ChangedFields(const google::protobuf::Message& a, const google::protobuf::Message& b,
                                        const std::set<std::string>& but = {});

// A section of one message's own fields, each a change.
Section FieldsSection(const std::string& title, const google::protobuf::Message& a, const google::protobuf::Message& b,
                      const std::set<std::string>& but = {});

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
