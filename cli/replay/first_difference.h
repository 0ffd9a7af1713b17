// SPDX-License-Identifier: GPL-3.0-or-later
// Where two messages part, by fields; for what that means, see flair diff.
#pragma once

#include <google/protobuf/message.h>

#include <optional>
#include <string>
#include <vector>

namespace flair::cli {

struct FieldDifference {
  // Such as "placements[2].x_m".
  std::string path;
  // Both values, long ones cut short; "none" where there is none.
  std::string first;
  std::string second;
  // How many fields differ in all, this one included. A message that only one side has counts as one.
  int field_count = 0;

  // "placements[2].x_m: 1.2 -> 1.24".
  std::string InWords() const;
};

// The first field, in the order of the numbers of fields, in which two messages of one type differ; nothing when they
// are equal. `aside` names fields of the messages themselves that are looked at only when all others are equal, such as
// a copy of an input.
std::optional<FieldDifference> FirstDifference(const google::protobuf::Message& first,
                                               const google::protobuf::Message& second,
                                               const std::vector<std::string>& aside = {});

}  // namespace flair::cli
