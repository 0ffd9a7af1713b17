// SPDX-License-Identifier: GPL-3.0-or-later
// Package flair.v1 as the .proto files of this build have it, with their comments.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "google/protobuf/descriptor.h"

namespace flair::cli {

struct ProtocolFile {
  // What it is about, such as "The furnished room".
  std::string title;
  const google::protobuf::FileDescriptor* file;
};

// All files of the package in reading order: services as a brief meets them, then artifacts, then their parts; files
// that the order does not know come last. Read once, stays valid; safe to call from several threads.
std::span<const ProtocolFile> ProtocolFiles();

// Calls `visit` with every service, then every message, then every enum of a file.
template <typename Visit>
void ForEachDeclaration(const google::protobuf::FileDescriptor& file, const Visit& visit) {
  for (int i = 0; i < file.service_count(); ++i) visit(*file.service(i));
  for (int i = 0; i < file.message_type_count(); ++i) visit(*file.message_type(i));
  for (int i = 0; i < file.enum_type_count(); ++i) visit(*file.enum_type(i));
}

// A comment as paragraphs, each on one line.
std::vector<std::string> ParagraphsOf(const std::string& comment);

// The comment before a declaration.
template <typename Declaration>
std::vector<std::string> CommentOf(const Declaration& declaration) {
  google::protobuf::SourceLocation location;
  if (!declaration.GetSourceLocation(&location)) return {};
  return ParagraphsOf(location.leading_comments);
}

// What a field holds, such as "list of" "Wall", "optional" "double".
struct FieldType {
  std::string prefix;
  std::string name;
  // Whether `name` is a message or an enum of the package.
  bool is_ours = false;
};
FieldType TypeOf(const google::protobuf::FieldDescriptor& field);

// One of these, or nothing.
struct ProtocolEntry {
  const google::protobuf::Descriptor* message = nullptr;
  const google::protobuf::EnumDescriptor* enumeration = nullptr;
  const google::protobuf::ServiceDescriptor* service = nullptr;
  const google::protobuf::MethodDescriptor* method = nullptr;
};
// By its name without the package, in any case: "Room", "SolveOptions", "OptimizerService", "Solve".
ProtocolEntry FindInProtocol(std::string_view name);

// The protocol for a terminal.

// Every service with its calls, every other name with the first sentence about it.
std::string ProtocolOverview();

// One service, call, message or enum in full. NOT_FOUND names what there is.
absl::StatusOr<std::string> ProtocolEntryText(std::string_view name);

// All of package flair.v1 as a page in GitHub's Markdown: docs/protocol.md. Every name of the package is a link.
std::string ProtocolMarkdown();

}  // namespace flair::cli
