// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/protocol/protocol.h"

#include <algorithm>

#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "cli/output/text.h"
#include "cli/protocol/protocol_bytes.h"
#include "fmt/format.h"
#include "google/protobuf/descriptor.pb.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"

namespace flair {
std::string_view ProtocolReadingOrder();  // reading_order.json, embedded: file and title of each
}

namespace flair::cli {
namespace {

namespace pb = google::protobuf;

constexpr std::string_view kPackage = "flair.v1";

const pb::FileDescriptorSet& DescriptorSet() {
  static const pb::FileDescriptorSet set = [] {
    pb::FileDescriptorSet read;
    read.ParseFromArray(kProtocolBytes, sizeof(kProtocolBytes));
    return read;
  }();
  return set;
}

const pb::DescriptorPool& Pool() {
  static const pb::DescriptorPool* const pool = [] {
    auto* const built = new pb::DescriptorPool;  // to the end: descriptors point into it
    for (const pb::FileDescriptorProto& file : DescriptorSet().file()) built->BuildFile(file);
    return built;
  }();
  return *pool;
}

struct ProtocolFile {
  // What it is about, such as "The furnished room".
  std::string title;
  const pb::FileDescriptor* file;
};

// All files of the package in reading order: services as a brief meets them, then artifacts, then their parts.
std::vector<ProtocolFile> ReadFiles() {
  std::vector<ProtocolFile> files;
  for (const auto& [name, title] :
       nlohmann::json::parse(ProtocolReadingOrder()).get<std::vector<std::pair<std::string, std::string>>>()) {
    const pb::FileDescriptor* const file = Pool().FindFileByName(fmt::format("flair/v1/{}.proto", name));
    if (file != nullptr) files.push_back({title, file});
  }
  for (const pb::FileDescriptorProto& proto : DescriptorSet().file()) {
    const pb::FileDescriptor* const file = Pool().FindFileByName(proto.name());
    const bool is_listed = std::ranges::find(files, file, &ProtocolFile::file) != files.end();
    if (proto.package() == kPackage && !is_listed) files.push_back({proto.name(), file});
  }
  return files;
}

// Calls `visit` with every service, then every message, then every enum of a file.
template <typename Visit>
void ForEachDeclaration(const pb::FileDescriptor& file, const Visit& visit) {
  for (int i = 0; i < file.service_count(); ++i) visit(*file.service(i));
  for (int i = 0; i < file.message_type_count(); ++i) visit(*file.message_type(i));
  for (int i = 0; i < file.enum_type_count(); ++i) visit(*file.enum_type(i));
}

constexpr size_t kLineLength = 100;

// The comment before a declaration, on one line.
template <typename Declaration>
std::string CommentOf(const Declaration& declaration) {
  pb::SourceLocation location;
  if (!declaration.GetSourceLocation(&location)) return "";
  return absl::StrJoin(absl::StrSplit(location.leading_comments, absl::ByAnyChar(" \n"), absl::SkipEmpty()), " ");
}

template <typename Declaration>
std::string Comment(const Declaration& declaration, size_t indent) {
  const std::string margin(indent, ' ');
  const std::string text = Wrapped(CommentOf(declaration), kLineLength, margin, indent);
  return text.empty() ? "" : absl::StrCat(margin, text, "\n");
}

// What a field holds, such as "list of Wall", "optional double".
std::string TypeOf(const pb::FieldDescriptor& field) {
  const std::string prefix = field.is_repeated() ? "list of " : field.has_optional_keyword() ? "optional " : "";
  if (field.enum_type() != nullptr) return prefix + field.enum_type()->name();
  const pb::Descriptor* const message = field.message_type();
  if (message == nullptr) return prefix + field.type_name();
  return prefix + (message->file()->package() == kPackage ? message->name() : message->full_name());
}

std::string MessageText(const pb::Descriptor& message) {
  std::string text = absl::StrCat("message ", message.name(), "\n", Comment(message, 2));
  for (int i = 0; i < message.field_count(); ++i) {
    const pb::FieldDescriptor& field = *message.field(i);
    const auto* const oneof = field.real_containing_oneof();
    absl::StrAppend(&text, "\n",
                    fmt::format("  {} = {}: {}{}\n", field.name(), field.number(), TypeOf(field),
                                oneof == nullptr ? "" : absl::StrCat(", one of ", oneof->name())),
                    Comment(field, 6));
  }
  return text;
}

std::string EnumText(const pb::EnumDescriptor& enumeration) {
  std::string text = absl::StrCat("enum ", enumeration.name(), "\n", Comment(enumeration, 2));
  for (int i = 0; i < enumeration.value_count(); ++i) {
    const auto& value = *enumeration.value(i);
    absl::StrAppend(&text, "\n", fmt::format("  {} = {}\n", value.name(), value.number()), Comment(value, 6));
  }
  return text;
}

std::string MethodText(const pb::MethodDescriptor& method) {
  return absl::StrCat(fmt::format("{}({}) -> {}{}\n", method.name(), method.input_type()->name(),
                                  method.server_streaming() ? "stream of " : "", method.output_type()->name()),
                      Comment(method, 6));
}

std::string ServiceText(const pb::ServiceDescriptor& service) {
  std::string text = absl::StrCat("service ", service.name(), "\n", Comment(service, 2));
  for (int i = 0; i < service.method_count(); ++i) absl::StrAppend(&text, "\n  ", MethodText(*service.method(i)));
  return text;
}

template <typename Declaration>
std::string OverviewLine(const Declaration& declaration) {
  const std::string all = CommentOf(declaration);
  const size_t end = all.find(". ");
  return fmt::format("  {:<28} {}\n", declaration.name(), end == std::string::npos ? all : all.substr(0, end + 1));
}

// One of these, or nothing.
struct ProtocolEntry {
  const pb::Descriptor* message = nullptr;
  const pb::EnumDescriptor* enumeration = nullptr;
  const pb::ServiceDescriptor* service = nullptr;
  const pb::MethodDescriptor* method = nullptr;
};

// By its name without the package, in any case: "Room", "SolveOptions", "OptimizerService", "Solve".
ProtocolEntry FindInProtocol(std::string_view any_case) {
  struct {
    const absl::string_view name;
    ProtocolEntry found;
    void operator()(const pb::Descriptor& message) {
      if (absl::EqualsIgnoreCase(name, message.name())) found.message = &message;
    }
    void operator()(const pb::EnumDescriptor& enumeration) {
      if (absl::EqualsIgnoreCase(name, enumeration.name())) found.enumeration = &enumeration;
    }
    void operator()(const pb::ServiceDescriptor& service) {
      if (absl::EqualsIgnoreCase(name, service.name())) found.service = &service;
      for (int i = 0; i < service.method_count(); ++i) {
        if (absl::EqualsIgnoreCase(name, service.method(i)->name())) found.method = service.method(i);
      }
    }
  } search{{any_case.data(), any_case.size()}, {}};
  for (const auto& [title, file] : ReadFiles()) {
    ForEachDeclaration(*file, [&search](const auto& declaration) { search(declaration); });
  }
  return search.found;
}

}  // namespace

std::string ProtocolOverview() {
  std::string text;
  for (const auto& [title, file] : ReadFiles()) {
    absl::StrAppend(&text, text.empty() ? "" : "\n", title, " (", file->name(), ")\n");
    ForEachDeclaration(*file, [&text](const auto& declaration) {
      text += OverviewLine(declaration);
      if constexpr (std::is_same_v<decltype(declaration), const pb::ServiceDescriptor&>) {
        for (int i = 0; i < declaration.method_count(); ++i) text += OverviewLine(*declaration.method(i));
      }
    });
  }
  return text;
}

absl::StatusOr<std::string> ProtocolEntryText(std::string_view name) {
  const ProtocolEntry entry = FindInProtocol(name);
  if (entry.service != nullptr) return ServiceText(*entry.service);
  if (entry.message != nullptr) return MessageText(*entry.message);
  if (entry.enumeration != nullptr) return EnumText(*entry.enumeration);
  if (entry.method == nullptr) {
    return NotFound("\"{}\" is not a service, call, message or enum of flair.v1; flair protocol lists them", name);
  }
  return absl::StrCat("call of ", entry.method->service()->name(), "\n  ", MethodText(*entry.method), "\n",
                      MessageText(*entry.method->input_type()), "\n", MessageText(*entry.method->output_type()));
}

}  // namespace flair::cli
