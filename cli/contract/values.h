// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of messages by path and what may be said of them, as Expect in protos/flair/checks/v1/checks.proto has it.
#pragma once

#include <google/protobuf/message.h>

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "flair/checks/v1/checks.pb.h"

namespace flair::contract {

// A field's value as text: a number, a word, a message as protobuf text on one line.
struct Value {
  std::string text;
  // A string or bytes, which stand in quotes in protobuf text.
  bool quoted = false;

  bool operator==(const Value&) const = default;
};
using Values = std::vector<Value>;

using Messages = std::vector<std::unique_ptr<google::protobuf::Message>>;

// Ends the program when the message has no such field: paths are this library's own.
const google::protobuf::FieldDescriptor& FieldOf(const google::protobuf::Message& message, std::string_view name);

// The values at the path. Messages and optional fields that are not set have none.
Values ValuesAt(const google::protobuf::Message& message, std::string_view path);
// The path begins with the brackets of a list, or means the last one.
Values ValuesAt(const Messages& answers, std::string_view path);

// The message at a path of names and numbers: "layout_graph.object_list.objects[0]". Made when it is not there.
google::protobuf::Message& PartOf(google::protobuf::Message& message, std::string_view path);
// The same, to read; the default message when it is not there.
const google::protobuf::Message& PartOf(const google::protobuf::Message& message, std::string_view path);

// Whether the values are so to those that are given; not for RELATION_VALID.
bool Holds(checks::v1::Relation relation, const std::vector<std::string>& got, const std::vector<std::string>& given);

}  // namespace flair::contract
