// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/protocol/protocol.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_split.h"
#include "cli/protocol/protocol_bytes.h"
#include "fmt/format.h"
#include "google/protobuf/descriptor.pb.h"

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

struct KnownFile {
  std::string_view file;
  std::string_view title;
};
constexpr KnownFile kReadingOrder[] = {
    {"language_service", "Service: language"},
    {"translator_service", "Service: translator"},
    {"optimizer_service", "Service: optimizer"},
    {"renderer_service", "Service: renderer"},
    {"orchestrator_service", "Service: orchestrator"},
    {"worker_service", "Service: worker"},
    {"artifact", "What is stored"},
    {"brief", "What is asked for"},
    {"room", "The empty room"},
    {"zone_plan", "Its zones"},
    {"object_list", "What is placed"},
    {"style_sheet", "How it looks"},
    {"constraint_list", "What is wanted, in sentences"},
    {"constraint_catalog", "What can be wanted: types of constraints"},
    {"layout_graph", "The problem: a graph of calls"},
    {"solved_layout", "The solution: a furnished room"},
    {"preview", "Pictures"},
    {"view_annotations", "What is seen in a picture"},
    {"report", "The account of a job"},
    {"job", "Jobs"},
    {"layout_edit", "Edits of a layout"},
    {"layout_metrics", "Measures of a layout"},
    {"placement", "Where an object is"},
    {"geometry", "Points and polygons"},
    {"provenance", "Who made it, and remarks"},
    {"model_call", "Calls of language models"},
};

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

// Where a file comes, from 0.
size_t PlaceOf(const FileDescriptor& file) {
  const auto* const found = std::find_if(std::begin(kReadingOrder), std::end(kReadingOrder), [&](const auto& entry) {
    return file.name() == fmt::format("flair/v1/{}.proto", entry.file);
  });
  return static_cast<size_t>(found - std::begin(kReadingOrder));
}

std::vector<ProtocolFile> ReadFiles() {
  std::vector<ProtocolFile> files;
  for (const FileDescriptorProto& proto : DescriptorSet().file()) {
    if (proto.package() != kPackage) continue;
    const FileDescriptor* const file = Pool().FindFileByName(proto.name());
    const size_t place = PlaceOf(*file);
    files.push_back({place < std::size(kReadingOrder) ? std::string(kReadingOrder[place].title) : proto.name(), file});
  }
  std::stable_sort(files.begin(), files.end(),
                   [](const ProtocolFile& a, const ProtocolFile& b) { return PlaceOf(*a.file) < PlaceOf(*b.file); });
  return files;
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

}  // namespace flair::cli
