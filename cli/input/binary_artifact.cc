// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/binary_artifact.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/unknown_field_set.h>
#include <google/protobuf/wire_format_lite.h>

#include <optional>
#include <string_view>

#include "cli/input/artifact_form.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"

namespace flair::cli {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::internal::WireFormatLite;

// The digest of the bytes as they are, parts that are not known to this program included.
bool BytesHaveTheirId(const std::string& bytes) {
  const std::string_view id = LeadingId(bytes);
  return !id.empty() && runtime::Sha256Hex(std::string_view(bytes).substr(kLeadingIdBytes)) == id;
}

// How many bytes the field that the text ends in lacks; nothing when it does not end in a field.
std::optional<size_t> MissingBytes(const std::string& bytes) {
  google::protobuf::io::CodedInputStream stream(reinterpret_cast<const uint8_t*>(bytes.data()),
                                                static_cast<int>(bytes.size()));
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
std::string FindUnknown(const Message& message) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  if (const auto& unknown = reflection.GetUnknownFields(message); !unknown.empty()) {
    return fmt::format("field {}", unknown.field(0).number());
  }
  const google::protobuf::Descriptor& type = *message.GetDescriptor();
  for (int k = 0; k < type.field_count(); ++k) {
    const FieldDescriptor* field = type.field(k);
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const bool is_list = field->is_repeated();
    const int size = is_list ? reflection.FieldSize(message, field) : reflection.HasField(message, field) ? 1 : 0;
    for (int i = 0; i < size; ++i) {
      const Message& part =
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
  return absl::DataLossError(fmt::format(
      "{}: not a Flair artifact ({}); expected a .pb, .json or .textproto file that Flair wrote", name, why));
}

absl::Status Corrupt(const std::string& name, const std::string& bytes) {
  if (const std::optional<size_t> missing = MissingBytes(bytes)) {
    return absl::DataLossError(
        fmt::format("{}: corrupt: cut off after {} bytes; at least {} are missing", name, bytes.size(), *missing));
  }
  return absl::DataLossError(
      fmt::format("{}: corrupt: its {} bytes begin as an artifact and then are none", name, bytes.size()));
}

absl::Status Newer(const std::string& name, const v1::Artifact& artifact, const std::string& unknown) {
  const std::string& build = artifact.producer().build();
  return absl::InvalidArgumentError(
      fmt::format("{}: made by a newer Flair{}: it has parts that this one does not know ({}); read it with that one",
                  name, build.empty() ? "" : ", build " + build, unknown));
}

}  // namespace

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
