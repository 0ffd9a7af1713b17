// SPDX-License-Identifier: GPL-3.0-or-later
#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/unknown_field_set.h>
#include <google/protobuf/wire_format_lite.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "cli/input/artifact_file.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "room/validation/field.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using std::string_view_literals::operator""sv;

constexpr size_t kLookedAt = 4096;

// Text that people write: UTF-8 without control characters but white space, as far as it is looked at.
bool IsText(std::string_view bytes) {
  size_t end = std::min(bytes.size(), kLookedAt);
  // Not in the middle of a character.
  while (end > 0 && end < bytes.size() && (static_cast<unsigned char>(bytes[end]) & 0xC0) == 0x80) --end;
  const std::string_view begin = bytes.substr(0, end);
  const bool has_control = std::ranges::any_of(begin, [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') || byte == 0x7f;
  });
  return !has_control && validation::CharacterCount(begin) >= 0;
}

// A comment or a field's name, then ":" or "{".
bool BeginsAsProtobufText(std::string_view bytes) {
  const size_t start = bytes.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return false;
  if (bytes[start] == '#') return !bytes.substr(start).starts_with("#!");
  size_t at = start;
  while (at < bytes.size() && ((bytes[at] >= 'a' && bytes[at] <= 'z') || bytes[at] == '_')) ++at;
  const size_t next = bytes.find_first_not_of(" \t", at);
  return at > start && next != std::string_view::npos && (bytes[next] == ':' || bytes[next] == '{');
}

namespace pb = google::protobuf;
using pb::internal::WireFormatLite;

// The digest of the bytes as they are, parts that are not known to this program included.
bool BytesHaveTheirId(const std::string& bytes) {
  const std::string_view id = LeadingId(bytes);
  return !id.empty() && runtime::Sha256Hex(std::string_view(bytes).substr(kLeadingIdBytes)) == id;
}

// How many bytes the field that the text ends in lacks; nothing when it does not end in a field.
std::optional<size_t> MissingBytes(const std::string& bytes) {
  pb::io::CodedInputStream stream(reinterpret_cast<const uint8_t*>(bytes.data()), static_cast<int>(bytes.size()));
  while (const uint32_t tag = stream.ReadTag()) {
    if (WireFormatLite::GetTagWireType(tag) != WireFormatLite::WIRETYPE_LENGTH_DELIMITED) {
      if (!WireFormatLite::SkipField(&stream, tag)) return std::nullopt;
      continue;
    }
    uint32_t size = 0;
    if (!stream.ReadVarint32(&size)) return std::nullopt;
    const size_t rest = bytes.size() - static_cast<size_t>(stream.CurrentPosition());
    if (size > rest) return size - rest;
    if (!stream.Skip(static_cast<int>(size))) return std::nullopt;
  }
  return std::nullopt;
}

// "layout_graph.edges[3], field 17" of the first part that this program does not know; empty when it knows all.
std::string FindUnknown(const pb::Message& message) {
  const pb::Reflection& reflection = *message.GetReflection();
  if (const auto& unknown = reflection.GetUnknownFields(message); !unknown.empty()) {
    return fmt::format("field {}", unknown.field(0).number());
  }
  const pb::Descriptor& type = *message.GetDescriptor();
  for (int k = 0; k < type.field_count(); ++k) {
    const pb::FieldDescriptor* field = type.field(k);
    if (field->cpp_type() != pb::FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const bool is_list = field->is_repeated();
    const int size = is_list ? reflection.FieldSize(message, field) : reflection.HasField(message, field) ? 1 : 0;
    for (int i = 0; i < size; ++i) {
      const pb::Message& part =
          is_list ? reflection.GetRepeatedMessage(message, field, i) : reflection.GetMessage(message, field);
      const std::string found = FindUnknown(part);
      if (found.empty()) continue;
      const std::string here = is_list ? fmt::format("{}[{}]", field->name(), i) : field->name();
      return fmt::format("{}{}{}", here, found.starts_with("field ") ? ", " : ".", found);
    }
  }
  return "";
}

absl::Status NoArtifact(const std::string& name, const std::string& why) {
  return DataLoss("{}: not a Flair artifact ({}); expected a .pb, .json or .textproto file that Flair wrote", name,
                  why);
}

absl::Status Corrupt(const std::string& name, const std::string& bytes) {
  if (const std::optional<size_t> missing = MissingBytes(bytes)) {
    return DataLoss("{}: corrupt: cut off after {} bytes; at least {} are missing", name, bytes.size(), *missing);
  }
  return DataLoss("{}: corrupt: its {} bytes begin like an artifact but cannot be parsed", name, bytes.size());
}

absl::Status Newer(const std::string& name, const v1::Artifact& artifact, const std::string& unknown) {
  const std::string& build = artifact.producer().build();
  return InvalidArgument(
      "{}: made by a newer Flair{}: it has parts that this version does not know ({}); use the newer one", name,
      build.empty() ? "" : ", build " + build, unknown);
}

}  // namespace

std::string_view LeadingId(std::string_view bytes) {
  if (bytes.size() < kLeadingIdBytes || !bytes.starts_with("\x0a\x40"sv)) return {};
  const std::string_view id = bytes.substr(2, kLeadingIdBytes - 2);
  return orchestrator::IsArtifactId(id) ? id : std::string_view{};
}

ArtifactForm FormOf(const std::filesystem::path& path, std::string_view bytes) {
  if (!LeadingId(bytes).empty()) return ArtifactForm::kBinary;
  const std::string ending = path.extension().string();
  if (ending == ".json") return ArtifactForm::kJson;
  if (ending == ".textproto" || ending == ".txtpb" || ending == ".pbtxt") return ArtifactForm::kProtobufText;
  if (!IsText(bytes)) return ArtifactForm::kBinary;
  const size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '{') return ArtifactForm::kJson;
  return BeginsAsProtobufText(bytes) ? ArtifactForm::kProtobufText : ArtifactForm::kBinary;
}

std::string ForeignKind(std::string_view bytes) {
  constexpr std::pair<std::string_view, const char*> kKinds[] = {{"\x89PNG\r\n"sv, "a PNG picture"},
                                                                 {"\xff\xd8\xff"sv, "a JPEG picture"},
                                                                 {"II*\0"sv, "a TIFF picture"},
                                                                 {"MM\0*"sv, "a TIFF picture"},
                                                                 {"\x76\x2f\x31\x01"sv, "an OpenEXR picture"},
                                                                 {"GIF8"sv, "a GIF picture"},
                                                                 {"%PDF-"sv, "a PDF document"},
                                                                 {"glTF"sv, "a GLB model"},
                                                                 {"\x7f"
                                                                  "ELF"sv,
                                                                  "a program"},
                                                                 {"\x1f\x8b"sv, "compressed with gzip"},
                                                                 {"\x28\xb5\x2f\xfd"sv, "compressed with zstd"},
                                                                 {"\xfd"
                                                                  "7zXZ"sv,
                                                                  "compressed with xz"},
                                                                 {"PK\x03\x04"sv, "a ZIP archive"},
                                                                 {"SQLite format 3"sv, "an SQLite database"},
                                                                 {"<?xml"sv, "XML"},
                                                                 {"<svg"sv, "an SVG drawing"},
                                                                 {"<!DOCTYPE"sv, "a web page"},
                                                                 {"#!"sv, "a script"}};
  for (const auto& [begin, kind] : kKinds) {
    if (bytes.starts_with(begin)) return kind;
  }
  return LeadingId(bytes).empty() && !bytes.empty() && IsText(bytes) ? "text" : "";
}

absl::StatusOr<v1::Artifact> ParseBinaryArtifact(const std::string& name, const std::string& bytes) {
  if (bytes.empty()) return NoArtifact(name, "the file is empty");
  const bool begins_well = !LeadingId(bytes).empty();
  v1::Artifact artifact;
  if (!artifact.ParseFromString(bytes)) {
    if (begins_well) return Corrupt(name, bytes);
    const std::string kind = ForeignKind(bytes);
    return NoArtifact(name,
                      kind.empty() ? fmt::format("its {} bytes cannot be parsed", bytes.size()) : "it is " + kind);
  }
  const std::string unknown = FindUnknown(artifact);
  if (!unknown.empty() && BytesHaveTheirId(bytes)) return Newer(name, artifact, unknown);
  if (begins_well && (!unknown.empty() || artifact.content_case() == v1::Artifact::CONTENT_NOT_SET)) {
    return Corrupt(name, bytes);
  }
  if (!unknown.empty()) return NoArtifact(name, "it has unknown parts: " + unknown);
  if (artifact.content_case() == v1::Artifact::CONTENT_NOT_SET) return NoArtifact(name, "it has no content");
  return artifact;
}

bool IsWhole(const v1::Artifact& artifact, const std::string& bytes) {
  return BytesHaveTheirId(bytes) || artifact.id() == orchestrator::ComputeArtifactId(artifact);
}

}  // namespace flair::cli
