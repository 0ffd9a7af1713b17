// SPDX-License-Identifier: GPL-3.0-or-later
// Changed fields of a message in words: the unit comes from the field's name.
#pragma once

#include <google/protobuf/message.h>

#include <optional>
#include <set>
#include <string>

#include "cli/diff/difference.h"

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

}  // namespace flair::cli
