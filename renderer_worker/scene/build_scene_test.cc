// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/scene/testing/sample_rooms.h"

namespace flair::renderer {
namespace {

using testing::HasSubstr;

Scene Built(const v1::SolvedLayout& layout) {
  absl::StatusOr<Scene> scene = BuildScene(layout, BoxFurniture());
  EXPECT_TRUE(scene.ok()) << scene.status();
  return *std::move(scene);
}

// Where a point falls in a square picture, both coordinates in [-1, 1] within it.
Vec2 InPicture(const SceneCamera& camera, Vec3 point) {
  const Vec3 forward = Normalized(camera.target - camera.eye), right = Normalized(Cross(forward, {0, 0, 1}));
  const Vec3 down = Cross(forward, right), way = point - camera.eye;
  const float scale = 1 / (Dot(way, forward) * std::tan(camera.field_of_view_rad / 2));
  return {Dot(way, right) * scale, Dot(way, down) * scale};
}

TEST(BuildScene, NormalsAreUnitAndAgreeWithTheirTriangles) {
  const v1::SolvedLayout layout = LShapedRoom();
  for (const ShellPart& part : Built(layout).shell) {
    for (const MeshPart& mesh : part.mesh.parts) {
      ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
      ASSERT_EQ(mesh.positions.size(), mesh.uvs.size());
      for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                   c = mesh.positions[mesh.indices[i + 2]];
        const Vec3 normal = mesh.normals[mesh.indices[i]];
        EXPECT_NEAR(Length(normal), 1, 1e-4) << part.id;
        EXPECT_GT(Dot(normal, Cross(b - a, c - a)), 0) << part.id << ", " << mesh.material.name;
      }
    }
  }
}

TEST(BuildScene, FloorHasTheRoomsAreaAndFacesUp) {
  const v1::SolvedLayout layout = LShapedRoom();
  const Scene scene = Built(layout);
  double area = 0;
  for (const MeshPart& mesh : scene.shell[0].mesh.parts) {
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
      const Vec3 a = mesh.positions[mesh.indices[i]];
      area += Cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a).z / 2;
    }
  }
  EXPECT_EQ(scene.shell[0].id, "floor");
  EXPECT_NEAR(area, 6 * 2.5 + 3 * 2.5, 1e-4);
}

TEST(BuildScene, WindowsAreWhereTheirOpeningsAre) {
  const v1::SolvedLayout layout = LShapedRoom();
  const Scene scene = Built(layout);
  ASSERT_EQ(scene.windows.size(), 1u);
  EXPECT_EQ(scene.windows[0].corner, (Vec3{2, 0, 0.9F}));
  EXPECT_NEAR(Length(scene.windows[0].along), 1.6, 1e-5);
  EXPECT_NEAR(scene.windows[0].up.z, 1.2, 1e-5);
  EXPECT_NEAR(scene.windows[0].inward.y, 1, 1e-5);
}

TEST(BuildScene, TheBirdseyeShowsTheWholeRoomWithAMargin) {
  for (const v1::SolvedLayout& layout : {LShapedRoom(), EmptyRoom(1.5, 1.5), EmptyRoom(30, 12)}) {
    const Scene scene = Built(layout);
    const RoomShape shape = *ShapeOf(layout.graph().room());
    const CutAway cut = CutAwayFor(shape, scene.birdseye.eye);
    EXPECT_TRUE(cut.ceiling);
    float most = 0;
    for (size_t i = 0; i < shape.walls.size(); ++i) {
      const float top = cut.walls[i] == WallCut::kWhole ? shape.height_m : kStubHeight_m;
      for (const float height : {0.0F, top}) {
        const Vec2 at = InPicture(scene.birdseye, shape.walls[i].axes.At(0, 0, height));
        most = std::max({most, std::abs(at.x), std::abs(at.y)});
      }
    }
    EXPECT_LT(most, 0.97F);
    EXPECT_GT(most, 0.75F);
  }
}

TEST(BuildScene, NoWallThatIsLeftHidesFloorFromTheBirdseye) {
  const v1::SolvedLayout layout = LShapedRoom();
  const Scene scene = Built(layout);
  const RoomShape shape = *ShapeOf(layout.graph().room());
  const CutAway cut = CutAwayFor(shape, scene.birdseye.eye);
  for (size_t i = 0; i < shape.walls.size(); ++i) {
    const bool behind = Dot(scene.birdseye.eye - shape.walls[i].axes.origin, shape.walls[i].axes.outward) > 0;
    EXPECT_EQ(cut.walls[i], behind ? WallCut::kStub : WallCut::kWhole) << shape.walls[i].name;
  }
}

TEST(BuildScene, ThePerspectiveEyeStandsAtEyeHeightAndInNoPiece) {
  v1::SolvedLayout layout = LShapedRoom();
  AddObject(layout, "desk", 4, 0.4, 0);
  AddObject(layout, "bed", 5, 4, 1.57);
  const Scene scene = Built(layout);
  const Vec3 eye = scene.perspective.eye;
  EXPECT_NEAR(eye.z, 1.5, 1e-5);
  for (const SceneObject& object : scene.objects) {
    EXPECT_GT(std::hypot(eye.x - object.placement.x_m(), eye.y - object.placement.y_m()), 0.6);
  }
}

TEST(BuildScene, KnowsTheWallThatThingsHangOn) {
  v1::SolvedLayout layout = EmptyRoom(4, 3);
  AddObject(layout, "painting", 2, 0.3, 0);  // its back to the south wall, where a wall's list begins
  AddObject(layout, "shelf", 3.7, 1.5, 1.5707963);
  AddObject(layout, "vase", 3.7, 1.5, 0);
  AddObject(layout, "desk", 2, 0.3, 0);
  AddObject(layout, "screen", 2, 1.5, 0);
  auto& objects = *layout.mutable_graph()->mutable_object_list()->mutable_objects();
  for (const int i : {0, 1, 4}) objects[i].set_kind(v1::OBJECT_KIND_WALL);
  objects[2].set_kind(v1::OBJECT_KIND_SURFACE);
  objects[2].set_host_id("shelf");
  const Scene scene = Built(layout);
  EXPECT_EQ(scene.objects[0].wall, 0);
  EXPECT_EQ(scene.objects[1].wall, 1);
  EXPECT_EQ(scene.objects[2].wall, 1);
  EXPECT_EQ(scene.objects[3].wall, -1);  // stands on the floor
  EXPECT_EQ(scene.objects[4].wall, -1);  // far from all
}

TEST(RoomShape, TheWayInEndsAtTheInsideOfTheWall) {
  const v1::SolvedLayout layout = EmptyRoom(4, 3);
  const RoomShape shape = *ShapeOf(layout.graph().room());
  EXPECT_EQ(WayIn(shape, {1, 1, 1}, {0, 1, 0}), 0);
  EXPECT_NEAR(WayIn(shape, {1, -2, 1}, {0, 1, 0}), 2, 1e-5);
  EXPECT_NEAR(WayIn(shape, {5, -1, 1}, Normalized(Vec3{-1, 1, 0})), std::sqrt(2), 1e-5);
  EXPECT_TRUE(std::isinf(WayIn(shape, {1, -2, 1}, {1, 0, 0})));
  EXPECT_TRUE(std::isinf(WayIn(shape, {1, -2, 1}, Normalized(Vec3{0, 1, 2}))));  // over the ceiling
}

TEST(BuildScene, NamesWhatCannotBeShown) {
  v1::SolvedLayout layout = EmptyRoom(3, 3);
  AddObject(layout, "desk", std::numeric_limits<double>::quiet_NaN(), 1, 0);
  absl::StatusOr<Scene> scene = BuildScene(layout, BoxFurniture());
  EXPECT_EQ(scene.status().code(), absl::StatusCode::kInvalidArgument);
  EXPECT_THAT(std::string(scene.status().message()), HasSubstr("\"desk\""));
  layout.mutable_placements(0)->set_x_m(1);
  layout.mutable_graph()->mutable_object_list()->mutable_objects(0)->set_depth_m(0);
  EXPECT_THAT(std::string(BuildScene(layout, BoxFurniture()).status().message()), HasSubstr("objects[0]"));
  layout = EmptyRoom(3, 3);
  AddWindow(layout, "attic", 0, 1);
  EXPECT_THAT(std::string(BuildScene(layout, BoxFurniture()).status().message()), HasSubstr("openings[0].wall"));
  layout = EmptyRoom(3, 3);
  layout.mutable_graph()->mutable_room()->mutable_floor()->mutable_vertices(1)->set_y_m(
      std::numeric_limits<double>::infinity());
  EXPECT_THAT(std::string(BuildScene(layout, BoxFurniture()).status().message()), HasSubstr("floor.vertices[1]"));
  EXPECT_FALSE(BuildScene(v1::SolvedLayout(), BoxFurniture()).ok());
}

}  // namespace
}  // namespace flair::renderer
