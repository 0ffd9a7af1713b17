// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <regex>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_id.h"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

v1::Artifact Graph() {
  v1::Artifact artifact;
  *artifact.mutable_layout_graph() = testing::BedroomGraph();
  artifact.add_made_from_ids(std::string(64, 'a'));
  artifact.set_options_digest(std::string(64, 'b'));
  artifact.mutable_producer()->set_program("flair-translator");
  artifact.mutable_producer()->set_method("grammar");
  artifact.mutable_producer()->set_version("2");
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  return artifact;
}

std::string Replaced(std::string text, const std::string& old_text, const std::string& new_text) {
  const size_t at = text.find(old_text);
  EXPECT_NE(at, std::string::npos) << old_text;
  return at == std::string::npos ? text : text.replace(at, old_text.size(), new_text);
}

// What stands in the line, counted from 1.
std::string LineOf(const std::string& text, int line) {
  size_t at = 0;
  for (int i = 1; i < line; ++i) at = text.find('\n', at) + 1;
  return text.substr(at, text.find('\n', at) - at);
}

// The line that a message names after the file's name.
int NamedLine(const absl::Status& status) {
  std::smatch match;
  const std::string message(status.message());
  return std::regex_search(message, match, std::regex("^graph[.a-z]*:([0-9]+): ")) ? std::stoi(match[1]) : 0;
}

absl::Status Refusal(const std::string& name, const std::string& bytes) {
  const absl::StatusOr<ArtifactFile> file = ParseArtifactFile(name, bytes);
  if (!file.ok()) return file.status();
  return file->whole.ok() ? file->good : file->whole;
}

TEST(ArtifactFile, EveryFormHoldsTheSameArtifactUnderAnyName) {
  const v1::Artifact graph = Graph();
  for (const std::string& bytes : {ArtifactBytes(graph), ToJson(graph), ToText(graph), ToJsonLine(graph)}) {
    for (const char* name : {"graph", "graph.txt"}) {
      const absl::StatusOr<ArtifactFile> file = ParseArtifactFile(name, bytes);
      ASSERT_TRUE(file.ok()) << file.status();
      EXPECT_TRUE(file->whole.ok() && file->good.ok()) << file->whole << file->good;
      EXPECT_FALSE(file->edited);
      EXPECT_EQ(ArtifactBytes(file->artifact), ArtifactBytes(graph));
    }
  }
}

TEST(ArtifactFile, AnEditedOneIsMadeFromTheOneItWasByHand) {
  const v1::Artifact graph = Graph();
  for (const std::string& text : {Replaced(ToJson(graph), "\"double bed\"", "\"oak bed\""),
                                  Replaced(ToText(graph), "\"double bed\"", "\"oak bed\"")}) {
    const absl::StatusOr<ArtifactFile> file = ParseArtifactFile("graph", text);
    ASSERT_TRUE(file.ok()) << file.status();
    const v1::Artifact& edited = file->artifact;
    EXPECT_TRUE(file->edited && IsEdited(edited) && file->whole.ok() && file->good.ok());
    EXPECT_EQ(file->stated_id, graph.id());
    EXPECT_EQ(edited.id(), orchestrator::ComputeArtifactId(edited));
    EXPECT_THAT(edited.made_from_ids(), ElementsAre(graph.id(), std::string(64, 'a')));
    EXPECT_EQ(edited.producer().version(), "of flair-translator, grammar, version 2");
    EXPECT_EQ(edited.producer().build() + edited.options_digest(), "");
    // Read again in any form it is what it is, and no longer new.
    for (const std::string& again : {ArtifactBytes(edited), ToJson(edited), ToText(edited)}) {
      EXPECT_EQ(ParseArtifactFile("graph", again)->artifact.id(), edited.id());
      EXPECT_FALSE(ParseArtifactFile("graph", again)->edited);
    }
  }
}

TEST(ArtifactFile, WithoutAnIdNobodyVouchesForItsProducer) {
  v1::Artifact graph = Graph();
  graph.clear_id();
  for (const std::string& bytes : {ArtifactBytes(graph), ToJson(graph), ToText(graph)}) {
    const absl::StatusOr<ArtifactFile> file = ParseArtifactFile("graph", bytes);
    ASSERT_TRUE(file.ok() && file->whole.ok()) << file.status();
    EXPECT_TRUE(file->edited);
    EXPECT_EQ(file->artifact.producer().method(), "edited by hand");
    EXPECT_THAT(file->artifact.made_from_ids(), ElementsAre(std::string(64, 'a')));
  }
}

TEST(ArtifactFile, AFaultIsToldWithTheLineItStandsIn) {
  v1::Artifact graph = Graph();
  graph.mutable_layout_graph()->mutable_object_list()->mutable_objects(1)->set_width_m(-1);
  graph.mutable_layout_graph()->mutable_edges(0)->set_weight(1000);
  for (const std::string& text : {ToJson(graph), ToText(graph)}) {
    const absl::Status status = Refusal("graph", text);
    EXPECT_TRUE(absl::IsInvalidArgument(status));
    EXPECT_THAT(std::string(status.message()),
                AllOf(HasSubstr("layout_graph.object_list.objects[1].width_m: -1 is outside (0, 20]\ngraph:"),
                      HasSubstr("layout_graph.edges[0].weight: 1000 is outside (0, 100]")));
    EXPECT_THAT(LineOf(text, NamedLine(status)), HasSubstr("-1")) << status;
  }
  EXPECT_THAT(std::string(Refusal("graph.pb", ArtifactBytes(graph)).message()), HasSubstr("corrupt"));
}

TEST(ArtifactFile, WhatDoesNotFitAFieldIsToldInItsLine) {
  const std::string json = ToJson(Graph());
  const std::tuple<const char*, const char*, const char*> faults[] = {
      {"\"width_m\"", "\"widht_m\"", "Opening has no field \"widht_m\" (did you mean width_m?); it has id, kind"},
      {"\"OBJECT_KIND_FLOOR\"", "\"FLOOR\"", ".kind: is \"FLOOR\"; expected one of OBJECT_KIND_FLOOR, "},
      {"\"double bed\"", "7", ".name: is 7; expected text"},
      {"\"height_m\": 3", "\"height_m\": \"tall\"", "room.height_m: is \"tall\"; expected a number"},
      {"\"height_m\": 3", "\"heightM\": \"0x3\"", "room.height_m: is \"0x3\"; expected a number"},
  };
  for (const auto& [right, wrong, told] : faults) {
    const std::string text = Replaced(json, right, wrong);
    const absl::Status status = Refusal("graph.json", text);
    EXPECT_TRUE(absl::IsInvalidArgument(status));
    EXPECT_THAT(std::string(status.message()), HasSubstr(told));
    EXPECT_THAT(LineOf(text, NamedLine(status)), HasSubstr(wrong)) << status;
  }
  const std::string text = Replaced(ToText(Graph()), "width_m", "widht_m");
  EXPECT_THAT(LineOf(text, NamedLine(Refusal("graph.textproto", text))), HasSubstr("widht_m"));
  const std::string twice = Replaced(json, "\"height_m\": 3", "\"height_m\": 3, \"heightM\": 5");
  EXPECT_EQ(Refusal("graph.json", twice).message(), "graph.json: \"heightM\" stands twice in one object; keep one");
}

TEST(ArtifactFile, BrokenJsonIsToldInItsLine) {
  const std::string json = ToJson(Graph());
  const std::string text = Replaced(json, "\"double bed\"", "double bed");
  EXPECT_THAT(LineOf(text, NamedLine(Refusal("graph.json", text))), HasSubstr("double bed"));
  const absl::Status cut = Refusal("graph.json", json.substr(0, json.size() / 2));
  EXPECT_THAT(std::string(cut.message()), HasSubstr("ends too early: "));
}

TEST(ArtifactFile, CutOffAndChangedBytesAreCorrupt) {
  const std::string bytes = ArtifactBytes(Graph());
  for (size_t size = 70; size < bytes.size(); size += 131) {
    const absl::Status status = Refusal("graph.pb", bytes.substr(0, size));
    EXPECT_TRUE(absl::IsDataLoss(status)) << size;
    EXPECT_THAT(std::string(status.message()), StartsWith("graph.pb: corrupt: ")) << size;
  }
  EXPECT_EQ(Refusal("graph.pb", bytes.substr(0, bytes.size() - 9)).message(),
            fmt::format("graph.pb: corrupt: cut off after {} bytes; at least 9 are missing", bytes.size() - 9));
  for (size_t at = 66; at < bytes.size(); at += 97) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    EXPECT_TRUE(absl::IsDataLoss(Refusal("graph.pb", changed))) << at;
  }
}

TEST(ArtifactFile, ANewerFlairIsNamedWhenTheBytesAreWhole) {
  v1::Artifact graph = Graph();
  graph.mutable_producer()->set_build("9.9-1-gabcdef");
  auto& object = *graph.mutable_layout_graph()->mutable_object_list()->mutable_objects(0);
  object.GetReflection()->MutableUnknownFields(&object)->AddVarint(99, 1);
  graph.set_id(orchestrator::ComputeArtifactId(graph));
  const absl::Status status = Refusal("graph.pb", ArtifactBytes(graph));
  EXPECT_TRUE(absl::IsInvalidArgument(status));
  EXPECT_THAT(std::string(status.message()), AllOf(HasSubstr("made by a newer Flair, build 9.9-1-gabcdef: "),
                                                   HasSubstr("(layout_graph.object_list.objects[0], field 99)")));
  v1::Artifact kind;
  kind.GetReflection()->MutableUnknownFields(&kind)->AddLengthDelimited(99)->assign("new");
  kind.set_id(orchestrator::ComputeArtifactId(kind));
  EXPECT_THAT(std::string(Refusal("new.pb", ArtifactBytes(kind)).message()), HasSubstr("newer Flair"));
}

TEST(ArtifactFile, OtherFilesAreCalledWhatTheyAre) {
  const std::pair<std::string, const char*> files[] = {
      {std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16), "a PNG picture"},
      {std::string("\x7f"
                   "ELF\2\1\1\0",
                   8),
       "a program"},
      {"%PDF-1.7\n", "a PDF document"},
      {"Dear Sir,\nplease find", "text"},
      {"", "the file is empty"},
      {std::string(100, '\xff'), "100 bytes cannot be parsed"}};
  for (const auto& [bytes, kind] : files) {
    for (const char* name : {"file", "file.pb", "file.json"}) {
      const absl::Status status = Refusal(name, bytes);
      EXPECT_FALSE(status.ok());
      if (std::string(name) == "file.json" && !bytes.empty() && (bytes[0] == 'D' || bytes[0] == '\xff')) continue;
      EXPECT_TRUE(absl::IsDataLoss(status)) << status;
      EXPECT_THAT(std::string(status.message()), AllOf(HasSubstr("not a Flair artifact"), HasSubstr(kind)));
    }
  }
}

TEST(ArtifactFile, AnArtifactWithoutContentSaysWhatItMayHold) {
  EXPECT_THAT(std::string(Refusal("a.json", "{}").message()), HasSubstr("without content; expected one of brief, "));
}

std::string FileWith(const std::string& bytes) {
  const std::string path = fmt::format("{}/brief_{}", ::testing::TempDir(), getpid());
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

v1::Brief Wanted() {
  v1::Brief brief;
  brief.set_text("A bedroom.");
  brief.set_seed(3);
  brief.mutable_zone_plan()->add_zones()->set_id("sleeping");
  brief.mutable_zone_plan()->mutable_zones(0)->set_name("sleeping");
  return brief;
}

TEST(ReadBrief, TakesTextJsonAndArtifacts) {
  v1::Artifact artifact;
  *artifact.mutable_brief() = Wanted();
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  for (const std::string& bytes : {ToText(Wanted()), ToJson(Wanted()), ToJson(artifact), ArtifactBytes(artifact)}) {
    const absl::StatusOr<v1::Brief> brief = ReadBrief("--brief", FileWith(bytes));
    ASSERT_TRUE(brief.ok()) << brief.status() << bytes;
    EXPECT_EQ(brief->SerializeAsString(), Wanted().SerializeAsString());
  }
}

TEST(ReadBrief, NamesFlagFilePlaceAndWhatIsRight) {
  EXPECT_EQ(ReadBrief("--brief", "/no/such/brief").status().message(), "--brief: /no/such/brief: no such file");
  for (const std::string bytes : {"txet: \"A bedroom.\"", "{\"txet\": \"A bedroom.\"}"}) {
    const absl::Status status = ReadBrief("--brief", FileWith(bytes)).status();
    EXPECT_EQ(status.code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(status.message()), ::testing::AllOf(HasSubstr("--brief: "), HasSubstr("txet"),
                                                                HasSubstr("should hold a Brief, such as: text: ")));
  }
}

TEST(ReadBrief, RefusesAnArtifactOfAnotherKind) {
  v1::Artifact artifact;
  *artifact.mutable_room() = testing::BedroomRoom();
  artifact.set_id(orchestrator::ComputeArtifactId(artifact));
  EXPECT_THAT(std::string(ReadBrief("--brief", FileWith(ArtifactBytes(artifact))).status().message()),
              HasSubstr("an artifact without a brief"));
}

}  // namespace

}  // namespace flair::cli
