// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output/artifact_text.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <array>
#include <utility>

#include "absl/strings/str_join.h"
#include "absl/time/time.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "orchestrator/pipeline/stage.h"
#include "orchestrator/store/artifact_id.h"

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

std::string Finish(v1::Artifact artifact, const std::string& command, const std::string& build) {
  v1::Producer& producer = *artifact.mutable_producer();
  producer.set_program("flair");
  producer.set_method(command);
  producer.set_version("1");
  producer.set_build(build);
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  return ArtifactBytes(artifact);
}

constexpr std::array<std::pair<const char*, const char*>, 10> kFamilies = {{
    {"wall", "Objects at walls"},
    {"feature", "Objects and doors, windows, sockets"},
    {"space", "Objects in the room"},
    {"pair", "Two objects"},
    {"group", "Several objects"},
    {"rug", "Rugs"},
    {"surface", "Things on top of others"},
    {"on_wall", "Things that hang on walls"},
    {"ceiling", "Things that hang from the ceiling"},
    {"room", "Whole-room terms, which the optimizer adds itself"},
}};

std::string RangeText(const v1::ParameterSpec& parameter) {
  if (!parameter.has_min_number() && !parameter.has_max_number()) return "";
  return fmt::format("[{}, {}]{}", parameter.has_min_number() ? fmt::format("{:g}", parameter.min_number()) : "-inf",
                     parameter.has_max_number() ? fmt::format("{:g}", parameter.max_number()) : "inf",
                     parameter.unit().empty() ? "" : " " + parameter.unit());
}

std::string DefaultText(const v1::ParameterSpec& parameter) {
  if (parameter.required()) return "required";
  return parameter.has_default_value() ? ValueText(parameter.default_value()) : "-";
}

std::string TypeMarkdown(const v1::ConstraintType& type) {
  std::string text = fmt::format("### {}\n\n{}\n\n{}\n", type.name(), type.summary(), type.doc());
  if (type.aliases_size() > 0) text += fmt::format("\nAlso read as: `{}`.\n", absl::StrJoin(type.aliases(), "`, `"));
  std::vector<std::vector<std::string>> rows;
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    rows.push_back({"`" + parameter.name() + "`", EnumInWords(parameter.kind()), DefaultText(parameter),
                    RangeText(parameter), parameter.doc()});
  }
  text += "\n" + MarkdownTable({"parameter", "kind", "default", "range", "meaning"}, rows);
  if (!type.phrase().empty()) text += fmt::format("\nTold as \"{}\".\n", type.phrase());
  if (!type.shortfall().empty()) text += fmt::format("Missed: \"{}\".\n", type.shortfall());
  for (const v1::CallExample& example : type.examples()) {
    text += fmt::format("\n> {}  \n> `{}`\n", example.sentence(), CallText(type.name(), example.arguments()));
  }
  return text + "\n";
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
  constexpr const char* kStems[] = {"",
                                    "brief",
                                    "room",
                                    "zones",
                                    "objects",
                                    "style",
                                    "constraints_raw",
                                    "constraints",
                                    "graph",
                                    "layout",
                                    "",
                                    "",
                                    "constraints_completed"};  // by kind
  return static_cast<size_t>(kind) < std::size(kStems) ? kStems[kind] : "";
}

std::string StageOf(v1::ArtifactKind kind) {
  for (const orchestrator::Stage& stage : orchestrator::Stages()) {
    if (stage.output == kind) return std::string(stage.name);
  }
  return "";
}

std::string KindName(v1::ArtifactKind kind) { return EnumInWords(kind); }

std::string LayoutArtifactBytes(const v1::SolvedLayout& layout, const std::string& command, const std::string& build) {
  v1::Artifact artifact;
  *artifact.mutable_solved_layout() = layout;
  return Finish(std::move(artifact), command, build);
}

std::string GraphArtifactBytes(const v1::LayoutGraph& graph, const std::string& command, const std::string& build) {
  v1::Artifact artifact;
  *artifact.mutable_layout_graph() = graph;
  return Finish(std::move(artifact), command, build);
}

std::string ValueText(const v1::ArgumentValue& value) {
  switch (value.value_case()) {
    case v1::ArgumentValue::kText:
      return value.text();
    case v1::ArgumentValue::kTexts:
      return fmt::format("[{}]", fmt::join(value.texts().items(), ", "));
    case v1::ArgumentValue::kNumber:
      return fmt::format("{:g}", value.number());
    case v1::ArgumentValue::kFlag:
      return value.flag() ? "true" : "false";
    case v1::ArgumentValue::VALUE_NOT_SET:
      break;
  }
  return "?";
}

std::string CallText(const std::string& type, const google::protobuf::RepeatedPtrField<v1::Argument>& arguments) {
  std::string text;
  for (const v1::Argument& argument : arguments) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", argument.name(), ValueText(argument.value()));
  }
  return fmt::format("{}({})", type, text);
}

std::string CallText(const v1::ConstraintEdge& edge) {
  const std::string weight = edge.weight() == 1 ? "" : fmt::format(" x {:g}", edge.weight());
  return CallText(edge.type(), edge.arguments()) + weight;
}

double SecondsOf(const google::protobuf::Duration& duration) {
  return static_cast<double>(duration.seconds()) + 1e-9 * duration.nanos();
}

std::string LocalTimeText(const google::protobuf::Timestamp& time) {
  return absl::FormatTime("%Y-%m-%d %H:%M:%S", absl::FromUnixSeconds(time.seconds()), absl::LocalTimeZone());
}

std::string CatalogMarkdown(const v1::ConstraintCatalog& catalog) {
  std::string text = fmt::format(
      "# Constraints\n\nWhat `{}` understands. Written by `flair catalog --markdown`; a test fails when it is stale.\n"
      "Costs are zero exactly where the sentence is true. Lengths are metres, angles radians unless said "
      "otherwise.\n\n",
      catalog.library());
  for (const auto& [family, title] : kFamilies) {
    text += fmt::format("## {}\n\n", title);
    for (const v1::ConstraintType& type : catalog.types()) {
      if (type.family() == family) text += TypeMarkdown(type);
    }
  }
  return text;
}

std::string TypeText(const v1::ConstraintType& type) {
  std::string text = fmt::format("{}: {}\n\n{}\n\n", type.name(), type.summary(), type.doc());
  if (type.aliases_size() > 0) text += fmt::format("also read as {}\n\n", absl::StrJoin(type.aliases(), ", "));
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    text += fmt::format("  {:<18} {:<8} {:<10} {:<12} {}\n", parameter.name(), EnumInWords(parameter.kind()),
                        DefaultText(parameter), RangeText(parameter), parameter.doc());
  }
  for (const v1::CallExample& example : type.examples()) {
    text += fmt::format("\n  \"{}\"\n  {}\n", example.sentence(), CallText(type.name(), example.arguments()));
  }
  return text;
}

std::string CatalogOverview(const v1::ConstraintCatalog& catalog) {
  std::string text;
  for (const v1::ConstraintType& type : catalog.types()) {
    if (!type.built_in()) text += fmt::format("{:<18} {}\n", type.name(), type.summary());
  }
  return text;
}

}  // namespace flair::cli
