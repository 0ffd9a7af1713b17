// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/protocol/protocol_text.h"

#include <vector>

#include "absl/status/status.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "cli/output/wrapped_text.h"
#include "cli/protocol/protocol.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::MethodDescriptor;
using google::protobuf::ServiceDescriptor;

constexpr size_t kLineLength = 100;

template <typename Declaration>
std::string Comment(const Declaration& declaration, size_t indent) {
  const std::string margin(indent, ' ');
  const std::string text = Wrapped(absl::StrJoin(CommentOf(declaration), " "), kLineLength, margin, indent);
  return text.empty() ? "" : absl::StrCat(margin, text, "\n");
}

template <typename Declaration>
std::string FirstSentence(const Declaration& declaration) {
  const std::string all = absl::StrJoin(CommentOf(declaration), " ");
  const size_t end = all.find(". ");
  return end == std::string::npos ? all : all.substr(0, end + 1);
}

std::string MessageText(const Descriptor& message) {
  std::string text = absl::StrCat("message ", message.name(), "\n", Comment(message, 2));
  for (int i = 0; i < message.field_count(); ++i) {
    const FieldDescriptor& field = *message.field(i);
    const FieldType type = TypeOf(field);
    const auto* const oneof = field.real_containing_oneof();
    absl::StrAppend(
        &text, "\n",
        fmt::format("  {} = {}: {}{}{}{}\n", field.name(), field.number(), type.prefix, type.prefix.empty() ? "" : " ",
                    type.name, oneof == nullptr ? "" : absl::StrCat(", one of ", oneof->name())),
        Comment(field, 6));
  }
  return text;
}

std::string EnumText(const EnumDescriptor& enumeration) {
  std::string text = absl::StrCat("enum ", enumeration.name(), "\n", Comment(enumeration, 2));
  for (int i = 0; i < enumeration.value_count(); ++i) {
    const auto& value = *enumeration.value(i);
    absl::StrAppend(&text, "\n", fmt::format("  {} = {}\n", value.name(), value.number()), Comment(value, 6));
  }
  return text;
}

std::string MethodText(const MethodDescriptor& method) {
  return absl::StrCat(fmt::format("{}({}) -> {}{}\n", method.name(), method.input_type()->name(),
                                  method.server_streaming() ? "stream of " : "", method.output_type()->name()),
                      Comment(method, 6));
}

std::string ServiceText(const ServiceDescriptor& service) {
  std::string text = absl::StrCat("service ", service.name(), "\n", Comment(service, 2));
  for (int i = 0; i < service.method_count(); ++i) absl::StrAppend(&text, "\n  ", MethodText(*service.method(i)));
  return text;
}

template <typename Declaration>
std::string OverviewLine(const Declaration& declaration) {
  return fmt::format("  {:<28} {}\n", declaration.name(), FirstSentence(declaration));
}

}  // namespace

std::string ProtocolOverview() {
  std::string text;
  for (const auto& [title, file] : ProtocolFiles()) {
    absl::StrAppend(&text, text.empty() ? "" : "\n", title, " (", file->name(), ")\n");
    for (int i = 0; i < file->service_count(); ++i) {
      const ServiceDescriptor& service = *file->service(i);
      text += OverviewLine(service);
      for (int k = 0; k < service.method_count(); ++k) text += OverviewLine(*service.method(k));
    }
    for (int i = 0; i < file->message_type_count(); ++i) text += OverviewLine(*file->message_type(i));
    for (int i = 0; i < file->enum_type_count(); ++i) text += OverviewLine(*file->enum_type(i));
  }
  return text;
}

absl::StatusOr<std::string> ProtocolEntryText(std::string_view name) {
  const ProtocolEntry entry = FindInProtocol(name);
  if (entry.service != nullptr) return ServiceText(*entry.service);
  if (entry.message != nullptr) return MessageText(*entry.message);
  if (entry.enumeration != nullptr) return EnumText(*entry.enumeration);
  if (entry.method == nullptr) {
    return absl::NotFoundError(
        fmt::format("\"{}\" is no service, call, message or enum of flair.v1; flair protocol lists them", name));
  }
  return absl::StrCat("call of ", entry.method->service()->name(), "\n  ", MethodText(*entry.method), "\n",
                      MessageText(*entry.method->input_type()), "\n", MessageText(*entry.method->output_type()));
}

}  // namespace flair::cli
