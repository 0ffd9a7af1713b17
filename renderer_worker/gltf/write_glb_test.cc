// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "renderer_worker/drawing/testing/read_drawing.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/gltf/gltf.h"
#include "renderer_worker/gltf/testing/glb_files.h"

namespace flair::renderer {
namespace {

using ::testing::HasSubstr;

Scene SceneOf(const v1::SolvedLayout& layout) {
  static const ProceduralFurniture furniture;
  absl::StatusOr<Scene> scene = BuildScene(layout, furniture);
  EXPECT_TRUE(scene.ok()) << scene.status();
  return *std::move(scene);
}

std::string Written(const Scene& scene, const GlbMetadata& metadata = {}) {
  absl::StatusOr<std::string> glb = WriteGlb(scene, metadata);
  EXPECT_TRUE(glb.ok()) << glb.status();
  return glb.value_or("");
}

// One object with a triangle whose tip is at the middle of its front, lit by one lamp.
struct Pointer {
  v1::SolvedLayout layout;
  v1::Object object;
  Scene scene;

  explicit Pointer(double theta_rad) {
    object.set_id("arrow");
    object.set_name("arrow");
    object.set_width_m(1);
    object.set_depth_m(2);
    object.set_height_m(1);
    Mesh mesh;
    MeshPart part;
    part.positions = {{-0.5F, -1, 0}, {0.5F, -1, 0}, {0, 1, 0}};
    part.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    part.indices = {0, 1, 2};
    mesh.parts.push_back(part);
    SceneObject shown;
    shown.object = &object;
    shown.placement.set_object_id("arrow");
    shown.placement.set_x_m(3);
    shown.placement.set_y_m(4);
    shown.placement.set_z_m(0.5);
    shown.placement.set_theta_rad(theta_rad);
    shown.furnishing.mesh = std::make_shared<Mesh>(mesh);
    shown.furnishing.lights.push_back({.position = {0, 1, 0.25F}, .intensity_cd = 80});
    scene.layout = &layout;
    scene.objects.push_back(shown);
    scene.birdseye = {"birdseye", {0, 0, 5}, {1, 2, 0}, 1};
    scene.perspective = {"perspective", {5, 5, 1.5F}, {1, 2, 1}, 1};
  }
};

TEST(WriteGlb, TurnsObjectsAsTheirHeadingSays) {
  constexpr double kQuarter = std::numbers::pi / 2;
  struct Case {
    double theta_rad;
    Vec3 tip;  // in R, one metre ahead of (3, 4)
  };
  for (const Case& c : {Case{0, {3, 5, 0.5F}}, Case{kQuarter, {2, 4, 0.5F}}, Case{2 * kQuarter, {3, 3, 0.5F}},
                        Case{3 * kQuarter, {4, 4, 0.5F}}}) {
    const Pointer pointer(c.theta_rad);
    const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene));
    const tinygltf::Node* node = gltf::NodeNamed(model, "arrow");
    ASSERT_NE(node, nullptr);
    const Vec3 tip = gltf::WorldPositions(model, *node).at(2);
    EXPECT_NEAR(tip.x, c.tip.x, 1e-5) << c.theta_rad;
    EXPECT_NEAR(tip.y, c.tip.z, 1e-5) << c.theta_rad;
    EXPECT_NEAR(tip.z, -c.tip.y, 1e-5) << c.theta_rad;
  }
}

TEST(WriteGlb, FrontsOfMeshesLookAlongPlusZAndUpIsPlusY) {
  const Pointer pointer(1);
  const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene));
  const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
  EXPECT_THAT(gltf::Floats(model, primitive.attributes.at("POSITION")),
              ::testing::ElementsAre(0.5F, 0, -1, -0.5F, 0, -1, 0, 0, 1));
  EXPECT_THAT(gltf::Floats(model, primitive.attributes.at("NORMAL")),
              ::testing::ElementsAre(0, 1, 0, 0, 1, 0, 0, 1, 0));
}

TEST(WriteGlb, LampsHangWhereTheirObjectsHaveThem) {
  const Pointer pointer(0);
  const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene));
  const tinygltf::Node* lamp = gltf::NodeNamed(model, "arrow light");
  ASSERT_NE(lamp, nullptr);
  EXPECT_THAT(lamp->translation, ::testing::ElementsAre(0, 0.25, 1));
  const int number = lamp->extensions.at("KHR_lights_punctual").Get("light").GetNumberAsInt();
  EXPECT_EQ(model.lights.at(static_cast<size_t>(number)).type, "point");
  EXPECT_NEAR(model.lights.at(static_cast<size_t>(number)).intensity, 80 * kLightScale, 1e-6);
}

TEST(WriteGlb, CamerasLookAtTheirTargets) {
  const Pointer pointer(0);
  const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene));
  for (const SceneCamera* camera : {&pointer.scene.birdseye, &pointer.scene.perspective}) {
    const tinygltf::Node* node = gltf::NodeNamed(model, camera->name);
    ASSERT_NE(node, nullptr);
    const Vec3 looks = gltf::Turned(node->rotation, {0, 0, -1});
    const Vec3 wanted = Normalized(camera->target - camera->eye);
    EXPECT_NEAR(looks.x, wanted.x, 1e-5);
    EXPECT_NEAR(looks.y, wanted.z, 1e-5);
    EXPECT_NEAR(looks.z, -wanted.y, 1e-5);
    EXPECT_GE(gltf::Turned(node->rotation, {0, 1, 0}).y, 0) << "upright";
  }
}

// A placed box's corner farthest along (x, y, z) in R, against the extreme of what was written.
TEST(WriteGlb, EveryObjectFillsItsBoxWithinATenthOfAMillimetre) {
  for (const std::string& name : SampleLayouts()) {
    const v1::SolvedLayout layout = ReadSample(name);
    const Scene scene = SceneOf(layout);
    const tinygltf::Model model = gltf::ReadModel(Written(scene));
    for (const SceneObject& shown : scene.objects) {
      const tinygltf::Node* node = gltf::NodeNamed(model, shown.object->id());
      ASSERT_NE(node, nullptr) << name << " " << shown.object->id();
      const double s = std::sin(shown.placement.theta_rad());
      const double c = std::cos(shown.placement.theta_rad());
      double across = 0, along = 0, low = 1e9, high = -1e9;
      for (const Vec3 g : gltf::WorldPositions(model, *node)) {
        const double dx = g.x - shown.placement.x_m();
        const double dy = -g.z - shown.placement.y_m();
        across = std::max(across, std::abs(dx * c + dy * s));
        along = std::max(along, std::abs(dy * c - dx * s));
        low = std::min<double>(low, g.y);
        high = std::max<double>(high, g.y);
      }
      SCOPED_TRACE(name + " " + shown.object->id());
      EXPECT_NEAR(across, shown.object->width_m() / 2, 1e-4);
      EXPECT_NEAR(along, shown.object->depth_m() / 2, 1e-4);
      EXPECT_NEAR(low, shown.placement.z_m(), 1e-4);
      EXPECT_NEAR(high, shown.placement.z_m() + shown.object->height_m(), 1e-4);
    }
  }
}

TEST(WriteGlb, FloorHasTheRoomsCorners) {
  const v1::SolvedLayout layout = ReadSample("l_shaped_studio");
  const tinygltf::Model model = gltf::ReadModel(Written(SceneOf(layout)));
  const tinygltf::Node* floor = gltf::NodeNamed(model, "floor");
  ASSERT_NE(floor, nullptr);
  const std::vector<Vec3> seen = gltf::WorldPositions(model, *floor);
  for (const v1::Point2& corner : layout.graph().room().floor().vertices()) {
    EXPECT_TRUE(std::any_of(seen.begin(), seen.end(),
                            [&](Vec3 g) { return std::hypot(g.x - corner.x_m(), -g.z - corner.y_m(), g.y) < 1e-4; }))
        << corner.x_m() << " " << corner.y_m();
  }
}

TEST(WriteGlb, ExtrasSayWhatEveryObjectIs) {
  const v1::SolvedLayout layout = ReadSample("vampire_bedroom");
  const Scene scene = SceneOf(layout);
  const tinygltf::Model model = gltf::ReadModel(Written(scene));
  for (const SceneObject& shown : scene.objects) {
    const tinygltf::Node* node = gltf::NodeNamed(model, shown.object->id());
    ASSERT_NE(node, nullptr);
    EXPECT_EQ(node->extras.Get("id").Get<std::string>(), shown.object->id());
    EXPECT_EQ(node->extras.Get("name").Get<std::string>(), shown.object->name());
    EXPECT_EQ(node->extras.Get("class").Get<std::string>(), shown.furnishing.class_name);
    EXPECT_NEAR(node->extras.Get("size").Get("width_m").GetNumberAsDouble(), shown.object->width_m(), 1e-6);
    EXPECT_NEAR(node->extras.Get("placement").Get("x_m").GetNumberAsDouble(), shown.placement.x_m(), 1e-6);
  }
}

TEST(WriteGlb, ExtrasTellTheSentencesAndVerdictsOfAnObject) {
  Pointer pointer(0);
  v1::Sentence& sentence = *pointer.layout.mutable_graph()->mutable_constraint_list()->add_sentences();
  sentence.set_id("s1");
  sentence.set_text("The arrow is against a wall.");
  for (const char* subject : {"arrow", "another"}) {
    v1::ConstraintEdge& edge = *pointer.layout.mutable_graph()->add_edges();
    edge.set_id(std::string("e_") + subject);
    edge.set_type("against_wall");
    edge.set_sentence_id("s1");
    v1::Argument& argument = *edge.add_arguments();
    argument.set_name("object");
    argument.mutable_value()->set_text(subject);
    v1::EdgeOutcome& outcome = *pointer.layout.add_edge_outcomes();
    outcome.set_edge_id(edge.id());
    outcome.set_status(v1::OUTCOME_STATUS_VIOLATED);
    outcome.set_reason("It is 0.4 m away.");
  }
  const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene));
  const tinygltf::Value& constraints = gltf::NodeNamed(model, "arrow")->extras.Get("constraints");
  ASSERT_EQ(constraints.ArrayLen(), 1U);
  const tinygltf::Value& only = constraints.Get(0);
  EXPECT_EQ(only.Get("id").Get<std::string>(), "e_arrow");
  EXPECT_EQ(only.Get("sentence").Get<std::string>(), "The arrow is against a wall.");
  EXPECT_EQ(only.Get("verdict").Get<std::string>(), "violated");
  EXPECT_EQ(only.Get("reason").Get<std::string>(), "It is 0.4 m away.");
}

TEST(WriteGlb, SaysWhereItComesFrom) {
  const Pointer pointer(0);
  const GlbMetadata metadata{"job-7", "A room for an arrow.", std::numeric_limits<int64_t>::max(), "abc123", "0.1-dev"};
  const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene, metadata));
  const tinygltf::Value& extras = model.asset.extras;
  EXPECT_EQ(model.asset.generator, "Flair 0.1-dev");
  EXPECT_EQ(extras.Get("job_id").Get<std::string>(), "job-7");
  EXPECT_EQ(extras.Get("brief").Get<std::string>(), "A room for an arrow.");
  EXPECT_EQ(extras.Get("seed").Get<std::string>(), "9223372036854775807");
  EXPECT_EQ(extras.Get("layout_digest").Get<std::string>(), "abc123");
}

TEST(WriteGlb, EqualMeshesAreWrittenOnce) {
  Pointer pointer(0);
  SceneObject second = pointer.scene.objects.front();
  second.furnishing.mesh = std::make_shared<Mesh>(*second.furnishing.mesh);  // equal, not the same
  SceneObject third = second;
  auto other = std::make_shared<Mesh>(*second.furnishing.mesh);
  other->parts[0].material.roughness = 0.1F;
  third.furnishing.mesh = other;
  pointer.scene.objects.push_back(second);
  pointer.scene.objects.push_back(third);
  const tinygltf::Model model = gltf::ReadModel(Written(pointer.scene));
  EXPECT_EQ(model.meshes.size(), 2U);
  ASSERT_NE(gltf::NodeNamed(model, "arrow object 2"), nullptr);
  EXPECT_EQ(gltf::NodeNamed(model, "arrow object")->mesh, gltf::NodeNamed(model, "arrow")->mesh);
  EXPECT_NE(gltf::NodeNamed(model, "arrow object 2")->mesh, gltf::NodeNamed(model, "arrow")->mesh);
}

TEST(WriteGlb, GivesTheSameBytesTwice) {
  for (const std::string& name : SampleLayouts()) {
    const v1::SolvedLayout layout = ReadSample(name);
    EXPECT_EQ(Written(SceneOf(layout)), Written(SceneOf(layout))) << name;
  }
}

TEST(WriteGlb, WallsAndCeilingShowTheirInnerFacesOnly) {
  const v1::SolvedLayout layout = ReadSample("bare_hall");
  const tinygltf::Model model = gltf::ReadModel(Written(SceneOf(layout)));
  const tinygltf::Node* ceiling = gltf::NodeNamed(model, "ceiling");
  ASSERT_NE(ceiling, nullptr);
  for (const Vec3 g : gltf::WorldPositions(model, *ceiling)) EXPECT_NEAR(g.y, layout.graph().room().height_m(), 1e-4);
  for (const tinygltf::Primitive& primitive : model.meshes[static_cast<size_t>(ceiling->mesh)].primitives) {
    const std::vector<float> normals = gltf::Floats(model, primitive.attributes.at("NORMAL"));
    for (size_t i = 1; i < normals.size(); i += 3) EXPECT_EQ(normals[i], -1);
  }
}

TEST(WriteGlb, RefusesWhatIsNotSound) {
  const auto code = [](const Pointer& pointer, const GlbMetadata& metadata = {}) {
    return WriteGlb(pointer.scene, metadata).status();
  };
  {
    Pointer pointer(0);
    pointer.scene.objects[0].placement.set_x_m(std::nan(""));
    EXPECT_EQ(code(pointer).code(), absl::StatusCode::kInvalidArgument);
    EXPECT_THAT(std::string(code(pointer).message()), HasSubstr("arrow"));
  }
  const auto broken = [&](auto&& spoil) {
    Pointer pointer(0);
    auto mesh = std::make_shared<Mesh>(*pointer.scene.objects[0].furnishing.mesh);
    spoil(mesh->parts[0]);
    pointer.scene.objects[0].furnishing.mesh = mesh;
    return code(pointer).code();
  };
  EXPECT_EQ(broken([](MeshPart& part) { part.positions[1].y = std::nanf(""); }), absl::StatusCode::kInternal);
  EXPECT_EQ(broken([](MeshPart& part) { part.indices[2] = 3; }), absl::StatusCode::kInternal);
  EXPECT_EQ(broken([](MeshPart& part) { part.normals.pop_back(); }), absl::StatusCode::kInternal);
  EXPECT_EQ(broken([](MeshPart& part) { part.indices.pop_back(); }), absl::StatusCode::kInternal);
  EXPECT_EQ(code(Pointer(0), {.brief_text = "not UTF-8: \xff"}).code(), absl::StatusCode::kInternal);
}

}  // namespace
}  // namespace flair::renderer
