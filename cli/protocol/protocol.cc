// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/protocol/protocol.h"

#include <algorithm>
#include <cctype>

#include "absl/strings/ascii.h"
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

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::EnumDescriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::FileDescriptor;
using google::protobuf::FileDescriptorProto;
using google::protobuf::FileDescriptorSet;
using google::protobuf::ServiceDescriptor;

constexpr std::string_view kPackage = "flair.v1";

const FileDescriptorSet& DescriptorSet() {
  static const FileDescriptorSet set = [] {
    FileDescriptorSet read;
    read.ParseFromArray(kProtocolBytes, sizeof(kProtocolBytes));
    return read;
  }();
  return set;
}

const DescriptorPool& Pool() {
  static const DescriptorPool* const pool = [] {
    auto* const built = new DescriptorPool;  // to the end: descriptors point into it
    for (const FileDescriptorProto& file : DescriptorSet().file()) built->BuildFile(file);
    return built;
  }();
  return *pool;
}

std::vector<ProtocolFile> ReadFiles() {
  std::vector<ProtocolFile> files;
  for (const auto& [name, title] :
       nlohmann::json::parse(ProtocolReadingOrder()).get<std::vector<std::pair<std::string, std::string>>>()) {
    const FileDescriptor* const file = Pool().FindFileByName(fmt::format("flair/v1/{}.proto", name));
    if (file != nullptr) files.push_back({title, file});
  }
  for (const FileDescriptorProto& proto : DescriptorSet().file()) {
    const FileDescriptor* const file = Pool().FindFileByName(proto.name());
    const bool is_listed = std::ranges::find(files, file, &ProtocolFile::file) != files.end();
    if (proto.package() == kPackage && !is_listed) files.push_back({proto.name(), file});
  }
  return files;
}

using google::protobuf::MethodDescriptor;
using google::protobuf::OneofDescriptor;

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

constexpr std::string_view kIntroduction =
    "# Protocol\n\n"
    "Package `flair.v1`: what the servers are asked, what they answer, and the artifacts between them. Written from "
    "the\n"
    "comments in [protos/flair/v1](../protos/flair/v1) by `flair protocol --markdown`; a test fails when it is stale.\n"
    "`flair protocol NAME` prints one entry. How a server is put in a stage's place: "
    "[replace-a-stage.md](replace-a-stage.md).\n\n"
    "Metres and radians; x east, y north, z up. A field without \"optional\" that is not sent has its zero value; a "
    "field of\n"
    "message type may always be absent. In JSON and text the names are those given here.\n\n";

// As GitHub makes it from a heading.
std::string AnchorOf(std::string_view heading) {
  std::string anchor;
  for (const char c : heading) {
    if (c == ' ') anchor += '-';
    if (absl::ascii_isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_') {
      anchor += absl::ascii_tolower(static_cast<unsigned char>(c));
    }
  }
  return anchor;
}

std::string LinkTo(std::string_view text, std::string_view name) {
  return fmt::format("[{}](#{})", text, AnchorOf(name));
}

// Whether a word of a comment means a declaration, "SolveRequest", "Producer.build", rather than the thing, "Room".
bool IsReference(std::string_view word) {
  const std::string_view name = word.substr(0, word.find('.'));
  const ProtocolEntry entry = FindInProtocol(name);
  const std::string* exact = entry.message != nullptr       ? &entry.message->name()
                             : entry.enumeration != nullptr ? &entry.enumeration->name()
                             : entry.service != nullptr     ? &entry.service->name()
                                                            : nullptr;
  if (exact == nullptr || *exact != name) return false;
  return name.size() < word.size() ||
         std::ranges::count_if(name, [](unsigned char c) { return std::isupper(c) != 0; }) > 1;
}

// A comment's words with links, and with what Markdown would take for its own escaped.
std::string Inline(std::string_view comment) {
  std::string text;
  bool is_code = false;
  for (size_t i = 0; i < comment.size();) {
    size_t end = i;
    while (end < comment.size() && (absl::ascii_isalnum(static_cast<unsigned char>(comment[end])) ||
                                    comment[end] == '_' || comment[end] == '.')) {
      ++end;
    }
    while (end > i && comment[end - 1] == '.') --end;
    if (end > i) {
      const std::string_view word = comment.substr(i, end - i);
      text += !is_code && IsReference(word) ? LinkTo(word, word.substr(0, word.find('.'))) : std::string(word);
      i = end;
      continue;
    }
    const char c = comment[i++];
    if (c == '`') is_code = !is_code;
    if (c == '|' || (!is_code && (c == '*' || c == '<' || c == '_'))) text += '\\';
    text += c;
  }
  return text;
}

template <typename Declaration>
std::string Paragraphs(const Declaration& declaration) {
  std::string text;
  for (const std::string& paragraph : CommentOf(declaration)) absl::StrAppend(&text, Inline(paragraph), "\n\n");
  return text;
}

template <typename Declaration>
std::string OneLine(const Declaration& declaration) {
  return Inline(absl::StrJoin(CommentOf(declaration), " "));
}

std::string TypeCell(const FieldDescriptor& field) {
  const FieldType type = TypeOf(field);
  return absl::StrCat(type.prefix, type.prefix.empty() ? "" : " ",
                      type.is_ours ? LinkTo(type.name, type.name) : absl::StrCat("`", type.name, "`"));
}

std::string OneofText(const OneofDescriptor& oneof) {
  std::vector<std::string> names;
  for (int i = 0; i < oneof.field_count(); ++i) names.push_back(absl::StrCat("`", oneof.field(i)->name(), "`"));
  return fmt::format("\nAt most one of {} (`{}`): {}\n", absl::StrJoin(names, ", "), oneof.name(), OneLine(oneof));
}

std::string Section(const Descriptor& message) {
  std::string text = fmt::format("### {}\n\n{}", message.name(), Paragraphs(message));
  if (message.field_count() == 0) return text + "Has no fields.\n\n";
  text += "| field | type | number | meaning |\n| --- | --- | --- | --- |\n";
  for (int i = 0; i < message.field_count(); ++i) {
    const FieldDescriptor& field = *message.field(i);
    absl::StrAppend(
        &text, fmt::format("| `{}` | {} | {} | {} |\n", field.name(), TypeCell(field), field.number(), OneLine(field)));
  }
  for (int i = 0; i < message.real_oneof_decl_count(); ++i) text += OneofText(*message.oneof_decl(i));
  return text + "\n";
}

std::string Section(const EnumDescriptor& enumeration) {
  std::string text = fmt::format("### {}\n\n{}| value | number | meaning |\n| --- | --- | --- |\n", enumeration.name(),
                                 Paragraphs(enumeration));
  for (int i = 0; i < enumeration.value_count(); ++i) {
    const auto& value = *enumeration.value(i);
    absl::StrAppend(&text, fmt::format("| `{}` | {} | {} |\n", value.name(), value.number(), OneLine(value)));
  }
  return text + "\n";
}

std::string Section(const ServiceDescriptor& service) {
  std::string text = fmt::format("### {}\n\n{}", service.name(), Paragraphs(service));
  for (int i = 0; i < service.method_count(); ++i) {
    const MethodDescriptor& method = *service.method(i);
    const std::string& request = method.input_type()->name();
    const std::string& response = method.output_type()->name();
    absl::StrAppend(
        &text, fmt::format("- **{}**: {} → {}{}<br>{}\n", method.name(), LinkTo(request, request),
                           method.server_streaming() ? "stream of " : "", LinkTo(response, response), OneLine(method)));
  }
  return text + "\n";
}

}  // namespace

std::span<const ProtocolFile> ProtocolFiles() {
  static const std::vector<ProtocolFile> files = ReadFiles();
  return files;
}

std::vector<std::string> ParagraphsOf(const std::string& comment) {
  std::vector<std::string> paragraphs;
  bool goes_on = false;
  for (absl::string_view line : absl::StrSplit(comment, '\n')) {
    line = absl::StripAsciiWhitespace(line);
    if (!line.empty() && goes_on) absl::StrAppend(&paragraphs.back(), " ", line);
    if (!line.empty() && !goes_on) paragraphs.emplace_back(line);
    goes_on = !line.empty();
  }
  return paragraphs;
}

FieldType TypeOf(const FieldDescriptor& field) {
  FieldType type;
  if (field.is_repeated()) type.prefix = "list of";
  if (field.has_optional_keyword()) type.prefix = "optional";
  const Descriptor* const message = field.message_type();
  const EnumDescriptor* const enumeration = field.enum_type();
  type.is_ours = enumeration != nullptr || (message != nullptr && message->file()->package() == kPackage);
  type.name = enumeration != nullptr ? enumeration->name()
              : message == nullptr   ? field.type_name()
              : type.is_ours         ? message->name()
                                     : message->full_name();
  return type;
}

ProtocolEntry FindInProtocol(std::string_view any_case) {
  struct {
    const absl::string_view name;
    ProtocolEntry found;
    void operator()(const Descriptor& message) {
      if (absl::EqualsIgnoreCase(name, message.name())) found.message = &message;
    }
    void operator()(const EnumDescriptor& enumeration) {
      if (absl::EqualsIgnoreCase(name, enumeration.name())) found.enumeration = &enumeration;
    }
    void operator()(const ServiceDescriptor& service) {
      if (absl::EqualsIgnoreCase(name, service.name())) found.service = &service;
      for (int i = 0; i < service.method_count(); ++i) {
        if (absl::EqualsIgnoreCase(name, service.method(i)->name())) found.method = service.method(i);
      }
    }
  } search{{any_case.data(), any_case.size()}, {}};
  for (const auto& [title, file] : ProtocolFiles()) {
    ForEachDeclaration(*file, [&search](const auto& declaration) { search(declaration); });
  }
  return search.found;
}

std::string ProtocolOverview() {
  std::string text;
  for (const auto& [title, file] : ProtocolFiles()) {
    absl::StrAppend(&text, text.empty() ? "" : "\n", title, " (", file->name(), ")\n");
    ForEachDeclaration(*file, [&text](const auto& declaration) {
      text += OverviewLine(declaration);
      if constexpr (std::is_same_v<decltype(declaration), const ServiceDescriptor&>) {
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

std::string ProtocolMarkdown() {
  std::string text(kIntroduction);
  text += "| chapter | what is in it |\n| --- | --- |\n";
  for (const auto& [title, file] : ProtocolFiles()) {
    std::vector<std::string> links;
    ForEachDeclaration(
        *file, [&links](const auto& declaration) { links.push_back(LinkTo(declaration.name(), declaration.name())); });
    absl::StrAppend(&text, fmt::format("| {} | {} |\n", LinkTo(title, title), absl::StrJoin(links, ", ")));
  }
  text += "\n";
  for (const auto& [title, file] : ProtocolFiles()) {
    const std::string name = file->name().substr(file->name().rfind('/') + 1);
    absl::StrAppend(&text, fmt::format("## {}\n\n[{}](../protos/{})\n\n", title, name, file->name()));
    ForEachDeclaration(*file, [&text](const auto& declaration) { text += Section(declaration); });
  }
  text.pop_back();
  return text;
}

}  // namespace flair::cli
