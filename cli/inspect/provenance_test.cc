// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "cli/input/artifact_file.h"
#include "cli/inspect/inspection.h"
#include "cli/output/artifact_text.h"
#include "nlohmann/json.hpp"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/testing/temporary_folder.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

v1::Artifact WithId(v1::Artifact artifact) {
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  return artifact;
}

// A brief, a room and a graph in a folder, each made from what goes before.
class Provenance : public ::testing::Test {
 protected:
  Provenance() {
    v1::Artifact brief, room, graph;
    brief.mutable_brief()->set_text("A bedroom.");
    brief.mutable_brief()->set_seed(7);
    brief_ = WithId(brief);
    *room.mutable_room() = testing::BedroomRoom();
    room.add_made_from_ids(brief_.id());
    room.mutable_producer()->set_program("flair-language");
    room.mutable_producer()->set_configuration_digest(std::string(64, 'c'));
    room.add_model_calls()->set_model("scripted");
    room.mutable_model_calls(0)->set_prompt_version("3f9a41c2");
    room_ = WithId(room);
    *graph.mutable_layout_graph() = testing::BedroomGraph();
    graph.add_made_from_ids(room_.id());
    graph.add_made_from_ids(brief_.id());
    graph_ = WithId(graph);
    Write("brief.pb", ArtifactBytes(brief_));
    Write("room.pb", ArtifactBytes(room_));
  }
  void Write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_.path() + "/" + name, std::ios::binary) << bytes;
  }
  std::vector<ProvenanceStep> Find(const v1::Artifact& artifact) {
    ArtifactFinder finder(folder_.path() + "/graph.pb", *shelf_);
    return FindProvenance(artifact, finder);
  }

  const orchestrator::TemporaryFolder folder_;
  const std::unique_ptr<ArtifactShelf> shelf_ = MakeStoreShelf(folder_.path() + "/no_store");
  v1::Artifact brief_, room_, graph_;
};

TEST_F(Provenance, GoesBackToTheBriefWithEverythingOnce) {
  const std::vector<ProvenanceStep> steps = Find(graph_);
  EXPECT_EQ(ProvenanceLine(steps), "brief > room > graph");
  EXPECT_EQ(steps[2].place, "here");
  EXPECT_THAT(ProvenanceText(steps, ""),
              AllOf(HasSubstr("seed 7\n"), HasSubstr("configuration cccccccccccc\n"),
                    HasSubstr("1 call of scripted, prompts 3f9a41c2\n"), HasSubstr("from room, brief\n")));
  const nlohmann::json json = nlohmann::json::parse(ProvenanceJson(steps));
  EXPECT_EQ(json[0]["seeds"], nlohmann::json({7}));
  EXPECT_EQ(json[1]["prompt_versions"], nlohmann::json({"3f9a41c2"}));
  EXPECT_EQ(json[1]["configuration_digest"], std::string(64, 'c'));
  EXPECT_EQ(json[2]["made_from_ids"][0], json[1]["id"]);
}

TEST_F(Provenance, SaysWhatIsMissing) {
  std::filesystem::remove(folder_.path() + "/room.pb");
  const std::vector<ProvenanceStep> steps = Find(graph_);
  EXPECT_EQ(ProvenanceLine(steps), "brief > graph; 1 missing");
  EXPECT_THAT(ProvenanceText(steps, "not in the store"),
              AllOf(HasSubstr(room_.id().substr(0, 12) + "  MISSING: not in the store\n"),
                    HasSubstr("from " + room_.id().substr(0, 12) + " (missing), brief\n")));
}

TEST_F(Provenance, WhatIsNotWhatItSaysDoesNotCount) {
  std::string bytes = ArtifactBytes(room_);
  bytes[bytes.size() - 4] ^= 1;
  Write("room.pb", bytes);
  EXPECT_EQ(ProvenanceLine(Find(graph_)), "brief > graph; 1 missing");
}

TEST_F(Provenance, AnEditedArtifactGoesBackThroughTheOneItWas) {
  v1::Artifact edited = graph_;
  edited.mutable_layout_graph()->mutable_edges(0)->set_weight(2);
  MarkEdited(edited);
  Write("graph.pb", ArtifactBytes(graph_));
  EXPECT_EQ(ProvenanceLine(Find(edited)), "brief > room > graph > graph (edited)");
  // What was made from it finds it as the text that it was written as.
  Write("mine.json", ToJson(edited));
  v1::Artifact layout;
  layout.mutable_solved_layout()->add_stage_outcomes()->set_seed(11);
  layout.add_made_from_ids(edited.id());
  const std::vector<ProvenanceStep> steps = Find(WithId(layout));
  EXPECT_EQ(ProvenanceLine(steps), "brief > room > graph > graph (edited) > layout");
  EXPECT_EQ(steps[3].place, "mine.json");
  EXPECT_EQ(nlohmann::json::parse(ProvenanceJson(steps))[4]["seeds"], nlohmann::json({11}));
}

}  // namespace
}  // namespace flair::cli
