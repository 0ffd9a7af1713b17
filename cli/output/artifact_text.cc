// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/artifact_text.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include "orchestrator/pipeline/stage.h"

namespace flair::cli {
namespace {

std::string Json(const google::protobuf::Message& message, bool indent) {
  google::protobuf::util::JsonPrintOptions options;
  options.add_whitespace = indent;
  options.preserve_proto_field_names = true;
  std::string json;
  (void)google::protobuf::util::MessageToJsonString(message, &json, options);
  return json;
}

}  // namespace

std::string ArtifactBytes(const v1::Artifact& artifact) {
  std::string bytes;
  google::protobuf::io::StringOutputStream stream(&bytes);
  google::protobuf::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  artifact.SerializeToCodedStream(&coded);
  coded.Trim();
  return bytes;
}

std::string ToJson(const google::protobuf::Message& message) {
  std::string json = Json(message, true);
  if (json.empty() || json.back() != '\n') json += '\n';
  return json;
}

std::string ToJsonLine(const google::protobuf::Message& message) { return Json(message, false); }

std::string ToText(const google::protobuf::Message& message) {
  google::protobuf::TextFormat::Printer printer;
  printer.SetUseUtf8StringEscaping(true);
  std::string text;
  printer.PrintToString(message, &text);
  return text;
}

std::string FileStem(v1::ArtifactKind kind) {
  switch (kind) {
    case v1::ARTIFACT_KIND_BRIEF:
      return "brief";
    case v1::ARTIFACT_KIND_ROOM:
      return "room";
    case v1::ARTIFACT_KIND_ZONE_PLAN:
      return "zones";
    case v1::ARTIFACT_KIND_OBJECT_LIST:
      return "objects";
    case v1::ARTIFACT_KIND_STYLE_SHEET:
      return "style";
    case v1::ARTIFACT_KIND_RAW_CONSTRAINT_LIST:
      return "constraints_raw";
    case v1::ARTIFACT_KIND_CONSTRAINT_LIST:
      return "constraints";
    case v1::ARTIFACT_KIND_LAYOUT_GRAPH:
      return "graph";
    case v1::ARTIFACT_KIND_SOLVED_LAYOUT:
      return "layout";
    default:
      return "";
  }
}

std::string StageOf(v1::ArtifactKind kind) {
  for (const orchestrator::Stage& stage : orchestrator::Stages()) {
    if (stage.output == kind) return std::string(stage.name);
  }
  return "";
}

std::string KindName(v1::ArtifactKind kind) {
  constexpr const char* kPrefix = "ARTIFACT_KIND_";
  std::string name = v1::ArtifactKind_Name(kind).substr(std::string(kPrefix).size());
  for (char& c : name) c = c == '_' ? ' ' : static_cast<char>(c - 'A' + 'a');
  return name;
}

}  // namespace flair::cli
