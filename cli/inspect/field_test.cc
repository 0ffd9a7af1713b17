// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/inspect/inspection.h"
#include "flair/v1/artifact.pb.h"
#include "nlohmann/json.hpp"
#include "tests/fixtures/bedroom.h"

namespace flair::cli {
namespace {

using ::testing::HasSubstr;

v1::Artifact FieldGraph() {
  v1::Artifact artifact;
  *artifact.mutable_layout_graph() = testing::BedroomGraph();
  artifact.add_made_from_ids("first");
  return artifact;
}

std::string Text(const std::string& path, FieldFormat format = FieldFormat::kText) {
  const v1::Artifact graph = FieldGraph();
  const absl::StatusOr<FieldView> view = FindField(graph, path);
  return view.ok() ? FieldText(*view, format) : std::string(view.status().message());
}

TEST(Field, ItemsAreFoundByNumberAndById) {
  const v1::Artifact graph = FieldGraph();
  for (int i = 0; i < graph.layout_graph().object_list().objects_size(); ++i) {
    const v1::Object& object = graph.layout_graph().object_list().objects(i);
    const std::string path = "layout_graph.object_list.objects[";
    EXPECT_EQ(Text(path + std::to_string(i) + "].id"), object.id() + "\n");
    EXPECT_EQ(Text(path + object.id() + "].name"), object.name() + "\n");
    EXPECT_EQ(Text("object_list.objects[" + object.id() + "].name"), object.name() + "\n");
  }
  EXPECT_EQ(Text("made_from_ids[0]"), "first\n");
}

TEST(Field, EveryPathOfAMessageGivesWhatIsThere) {
  EXPECT_EQ(Text("room.height_m"), "3\n");
  EXPECT_EQ(Text("room.height_m", FieldFormat::kJson), "3\n");
  EXPECT_THAT(Text("room.walls"), HasSubstr("name: \"south\"\n\nname: \"east\"\n"));
  EXPECT_EQ(nlohmann::json::parse(Text("room.walls", FieldFormat::kJson))[1]["name"], "east");
  EXPECT_EQ(nlohmann::json::parse(Text("room.walls[1]", FieldFormat::kJson))["name"], "east");
  EXPECT_EQ(Text("options_digest", FieldFormat::kJson), "\"\"\n");
}

TEST(Field, AWrongPathNamesThePartAndWhatExistsThere) {
  EXPECT_THAT(Text("layout_graph.objetc_list.objects"),
              HasSubstr("--field layout_graph.objetc_list: LayoutGraph has no field \"objetc_list\" (did you mean "
                        "object_list?); it has room, zone_plan"));
  EXPECT_THAT(Text("object_list.objects[99]"), HasSubstr("layout_graph.object_list.objects[99]: there are "));
  EXPECT_THAT(Text("object_list.objects[bde].name"),
              HasSubstr("no item has the id \"bde\" (did you mean bed?); there are "));
  EXPECT_THAT(Text("object_list.objects.name"), HasSubstr("is a list of "));
  EXPECT_THAT(Text("room.height_m.x"), HasSubstr("room.height_m: is a number; it has no parts"));
  EXPECT_THAT(Text("room[0]"), HasSubstr("layout_graph.room: is not a list"));
  EXPECT_THAT(Text("solved_layout"), HasSubstr("is not set; set are made_from_ids, layout_graph"));
  for (const char* path : {"", ".", "room.", "room..x", "room[", "room[]", "room]x", "[0]"}) {
    EXPECT_THAT(Text(path), HasSubstr("a path is such as")) << path;
  }
}

}  // namespace
}  // namespace flair::cli
