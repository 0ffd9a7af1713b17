// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/scene_state/write_scene_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/gltf/testing/glb_files.h"

namespace flair::renderer {
namespace {

using Json = nlohmann::json;

Scene SceneOf(const v1::SolvedLayout& layout) {
  static const ProceduralFurniture furniture;
  absl::StatusOr<Scene> scene = BuildScene(layout, furniture);
  EXPECT_TRUE(scene.ok()) << scene.status();
  return *std::move(scene);
}

Json StateOf(const Scene& scene) {
  absl::StatusOr<std::string> text = WriteSceneState(scene);
  EXPECT_TRUE(text.ok()) << text.status();
  return Json::parse(text.value_or("{}"));
}

TEST(WriteSceneState, HasTheVersionsAndUnitsThatTheBenchmarkReads) {
  const v1::SolvedLayout layout = ReadSample("vampire_bedroom");
  const Json state = StateOf(SceneOf(layout));
  EXPECT_EQ(state["format"], "sceneState");
  EXPECT_EQ(state["scene"]["version"], "scene@1.0.2");
  EXPECT_EQ(state["scene"]["unit"], 1.0);
  EXPECT_EQ(state["scene"]["up"], Json({0, 0, 1}));
  EXPECT_EQ(state["scene"]["arch"]["version"], "arch@1.0.2");
  EXPECT_EQ(state["scene"]["arch"]["scaleToMeters"], 1.0);
  EXPECT_EQ(state["scene"]["arch"]["coords2d"], Json({0, 1}));
}

TEST(WriteSceneState, WallsGoRoundTheFloorWithTheirOpeningsAsHoles) {
  for (const std::string& name : SampleLayouts()) {
    SCOPED_TRACE(name);
    const v1::SolvedLayout layout = ReadSample(name);
    const v1::Room& room = layout.graph().room();
    const Json state = StateOf(SceneOf(layout));
    const Json& elements = state["scene"]["arch"]["elements"];
    ASSERT_EQ(elements.size(), static_cast<size_t>(room.walls_size() + 1));
    EXPECT_EQ(elements[0]["type"], "Floor");
    EXPECT_TRUE(elements[0]["roomId"].is_string());
    const Json& floor = elements[0]["points"];
    ASSERT_EQ(floor.size(), static_cast<size_t>(room.floor().vertices_size()));
    size_t hole_count = 0;
    for (size_t i = 1; i < elements.size(); ++i) {
      const Json& wall = elements[i];
      EXPECT_EQ(wall["type"], "Wall");
      EXPECT_EQ(wall["points"][0], floor[i - 1]);
      EXPECT_EQ(wall["points"][1], floor[i % floor.size()]);
      EXPECT_NEAR(wall["height"].get<double>(), room.height_m(), 1e-9);
      const double length = std::hypot(wall["points"][1][0].get<double>() - wall["points"][0][0].get<double>(),
                                       wall["points"][1][1].get<double>() - wall["points"][0][1].get<double>());
      for (const Json& hole : wall["holes"]) {
        ++hole_count;
        EXPECT_TRUE(hole["type"] == "Door" || hole["type"] == "Window");
        for (const int axis : {0, 1}) {
          EXPECT_LT(hole["box"]["min"][axis].get<double>(), hole["box"]["max"][axis].get<double>());
        }
        EXPECT_GE(hole["box"]["min"][0].get<double>(), -1e-9);
        EXPECT_LE(hole["box"]["max"][0].get<double>(), length + 1e-9);
        EXPECT_LE(hole["box"]["max"][1].get<double>(), room.height_m() + 1e-9);
      }
    }
    EXPECT_EQ(hole_count, static_cast<size_t>(room.openings_size()));
  }
}

// The mesh of `model`, put where `transform` says: its corner farthest from the placement along each of O's axes.
std::array<double, 3> Reach(const tinygltf::Model& model, const Json& transform, const v1::Placement& p) {
  std::array<double, 3> reach{};
  for (const Vec3 g : gltf::WorldPositions(model, model.nodes.at(0))) {
    const std::array<double, 3> from = {g.x, g.y, g.z};
    std::array<double, 3> to{};
    for (size_t row = 0; row < 3; ++row) {
      to[row] = transform[12 + row].get<double>();
      for (size_t column = 0; column < 3; ++column) to[row] += transform[column * 4 + row].get<double>() * from[column];
    }
    const double dx = to[0] - p.x_m();
    const double dy = to[1] - p.y_m();
    reach[0] = std::max(reach[0], dx * std::cos(p.theta_rad()) + dy * std::sin(p.theta_rad()));
    reach[1] = std::max(reach[1], dy * std::cos(p.theta_rad()) - dx * std::sin(p.theta_rad()));
    reach[2] = std::max(reach[2], to[2] - p.z_m());
  }
  return reach;
}

TEST(WriteSceneState, TransformsPutTheMeshesWhereTheLayoutHasThem) {
  for (const std::string& name : SampleLayouts()) {
    const v1::SolvedLayout layout = ReadSample(name);
    const Scene scene = SceneOf(layout);
    const Json state = StateOf(scene);
    absl::StatusOr<std::vector<SceneStateFile>> files = SceneStateAssets(scene);
    ASSERT_TRUE(files.ok()) << files.status();
    ASSERT_EQ(files->size(), 2 * scene.objects.size());
    std::set<std::string> model_ids;
    for (size_t i = 0; i < scene.objects.size(); ++i) {
      const SceneObject& shown = scene.objects[i];
      SCOPED_TRACE(name + " " + shown.object->id());
      const Json& object = state["scene"]["object"][i];
      const std::string model_id = object["modelId"];
      EXPECT_TRUE(model_ids.insert(model_id).second);
      EXPECT_EQ(object["index"], i);
      ASSERT_EQ(std::count(model_id.begin(), model_id.end(), '.'), 1) << "SceneEval splits at the dot";
      const std::string model_name = model_id.substr(model_id.find('.') + 1);
      EXPECT_EQ((*files)[2 * i].path, model_name + "/" + model_name + ".glb");
      const Json annotations = Json::parse((*files)[2 * i + 1].bytes)["annotations"];
      EXPECT_EQ(annotations["category"], shown.object->name());
      EXPECT_TRUE(annotations.contains("description") && annotations.contains("materials"));
      ASSERT_EQ(object["transform"]["data"].size(), 16U);
      const std::array<double, 3> reach =
          Reach(gltf::ReadModel((*files)[2 * i].bytes), object["transform"]["data"], shown.placement);
      EXPECT_NEAR(reach[0], shown.object->width_m() / 2, 1e-4);
      EXPECT_NEAR(reach[1], shown.object->depth_m() / 2, 1e-4);
      EXPECT_NEAR(reach[2], shown.object->height_m(), 1e-4);
    }
  }
}

TEST(WriteSceneState, GivesTheSameBytesTwice) {
  const v1::SolvedLayout layout = ReadSample("l_shaped_studio");
  EXPECT_EQ(*WriteSceneState(SceneOf(layout)), *WriteSceneState(SceneOf(layout)));
}

TEST(WriteSceneState, RefusesPlacementsThatAreNoNumbersAndTextsThatAreNoUtf8) {
  const v1::SolvedLayout layout = ReadSample("cloakroom");
  Scene scene = SceneOf(layout);
  ASSERT_FALSE(scene.objects.empty());
  v1::Object odd = *scene.objects[0].object;
  odd.set_id("\xff");
  scene.objects[0].object = &odd;
  EXPECT_EQ(WriteSceneState(scene).status().code(), absl::StatusCode::kInternal);
  scene.objects[0].placement.set_theta_rad(std::numeric_limits<double>::infinity());
  EXPECT_EQ(WriteSceneState(scene).status().code(), absl::StatusCode::kInvalidArgument);
}

}  // namespace
}  // namespace flair::renderer
