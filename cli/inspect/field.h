// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "absl/status/statusor.h"

namespace flair::cli {

// A part of a message. Valid as long as the message.
struct FieldView {
  const google::protobuf::Message* parent = nullptr;
  const google::protobuf::FieldDescriptor* field = nullptr;
  int index = -1;  // of a list's item; -1 for a whole field
};

// The part that a path names, such as solved_layout.placements[3].theta_rad. Items of lists are named by number, from 0
// on, or by id: objects[desk]. What begins with a field of the artifact's content may leave out the content's name.
// INVALID_ARGUMENT names the part of the path that is wrong and what exists there.
absl::StatusOr<FieldView> FindField(const google::protobuf::Message& message, const std::string& path);

enum class FieldFormat { kText, kJson };

// The part as text: a number, a word, a message as protobuf text, a list with an item a line (messages: one after the
// other, with an empty line between); or all of it as JSON. Bytes are as they are as text, base64 in JSON.
std::string FieldText(const FieldView& view, FieldFormat format);

}  // namespace flair::cli
