// SPDX-License-Identifier: GPL-3.0-or-later
// The readers: graphs, scene texts.
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/stubs/logging.h>
#include <google/protobuf/text_format.h>
#include <google/protobuf/util/json_util.h>

#include <cmath>
#include <string>

#include "flair/v1/artifact.pb.h"
#include "room/conversion/conversion.h"
#include "room/text_format/scene_text.h"
#include "room/validation/validate.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

// What is accepted can be computed with: validation and conversion agree, and the scene has the graph's parts.
void UseGraph(const v1::LayoutGraph& graph) {
  const absl::Status good = Validate(graph);
  const absl::StatusOr<Scene> scene = SceneFromProto(graph);
  Require(!good.ok() || scene.ok(), "a valid graph becomes a scene");
  if (!good.ok()) {
    Require(absl::IsInvalidArgument(good), "a bad graph is INVALID_ARGUMENT");
    Require(!good.message().empty() && good.message().size() < 20000, "a refusal is a readable text");
    return;
  }
  Require(scene->objects.size() == static_cast<size_t>(graph.object_list().objects_size()), "every object is there");
  Require(std::isfinite(scene->room.floor.vertices.front().x), "the room is finite");
}

class Quiet final : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int, int, const std::string&) override {}
};

}  // namespace

void ReadGraph(std::string_view bytes) {
  // The parsers report every bad character to stderr by default.
  [[maybe_unused]] static const auto old_handler = google::protobuf::SetLogHandler(nullptr);
  v1::Artifact artifact;
  const std::string text(bytes);
  if (artifact.ParseFromString(text)) UseGraph(artifact.layout_graph());
  if (google::protobuf::util::JsonStringToMessage(text, &artifact).ok()) UseGraph(artifact.layout_graph());
  v1::LayoutGraph graph;
  Quiet quiet;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&quiet);
  parser.SetRecursionLimit(100);
  if (parser.ParseFromString(text, &graph)) UseGraph(graph);
}

void ReadSceneText(std::string_view bytes) {
  const absl::StatusOr<SceneText> text = ParseScene(bytes);
  if (!text.ok()) {
    Require(!text.status().message().empty(), "a refusal says why");
    return;
  }
  Require(text->layout.size() == text->scene.objects.size(), "every object has a pose");
}

}  // namespace flair::fuzz
