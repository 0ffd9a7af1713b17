// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/trace_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "renderer_worker/scene/testing/sample_rooms.h"

namespace flair::renderer {
namespace {

v1::SolvedLayout FurnishedRoom() {
  v1::SolvedLayout layout = LShapedRoom();
  AddObject(layout, "desk", 4.2, 1.0, 0.4);
  AddObject(layout, "bed", 5, 4, 1.57);
  AddObject(layout, "lamp", 1, 1.5, 3);
  return layout;
}

TracedView Traced(const Scene& scene, const SceneCamera& camera, const TraceOptions& options) {
  absl::StatusOr<TracedView> view = TraceView(scene, camera, options);
  EXPECT_TRUE(view.ok()) << view.status();
  return view.ok() ? *std::move(view) : TracedView();
}

TraceOptions Small(int samples = 2) {
  TraceOptions options;
  options.width_px = 96;
  options.height_px = 80;
  options.sample_count = samples;
  return options;
}

float MeanLuminance(const TracedView& view, bool of_room_only = true) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < view.colour.size(); ++i) {
    if (of_room_only && view.instance[i] == 0) continue;
    sum += 0.2126 * view.colour[i].x + 0.7152 * view.colour[i].y + 0.0722 * view.colour[i].z;
    count += 1;
  }
  return count > 0 ? static_cast<float>(sum / count) : 0;
}

// The point in room frame R that pixel (x, y) shows, by nothing but the annotations and the depth.
Vec3 PointOf(const TracedView& view, int x, int y) {
  const v1::CameraParameters& c = view.annotations.camera();
  const double z = view.depth_m[static_cast<size_t>(y) * view.width_px + x];
  const double p[3] = {(x + 0.5 - c.center_x_px()) / c.focal_x_px() * z,
                       (y + 0.5 - c.center_y_px()) / c.focal_y_px() * z, z};
  const auto& m = c.camera_from_room();
  double at[3] = {};
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i)
      at[k] += m[4 * i + k] * (p[i] - m[4 * i + 3]);  // the inverse of a turn is its transpose
  }
  return {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
}

TEST(TraceView, DepthAndCameraLeadBackToTheObjects) {
  const v1::SolvedLayout layout = FurnishedRoom();
  const Scene scene = *BuildScene(layout, BoxFurniture());
  for (const SceneCamera& camera : {scene.birdseye, scene.perspective}) {
    const TracedView view = Traced(scene, camera, Small());
    int checked = 0;
    for (int y = 0; y < view.height_px; ++y) {
      for (int x = 0; x < view.width_px; ++x) {
        const int id = view.instance[static_cast<size_t>(y) * view.width_px + x];
        if (id < 1 || id > 3) continue;
        const v1::Instance& instance = view.annotations.instances(id - 1);
        const Vec3 at = PointOf(view, x, y);
        const double dx = at.x - instance.placement().x_m(), dy = at.y - instance.placement().y_m();
        const double c = std::cos(instance.placement().theta_rad()), s = std::sin(instance.placement().theta_rad());
        const double u = dx * c + dy * s, v = dy * c - dx * s;
        // On the box's surface: within it, and at one of its faces.
        const double off = std::max({std::abs(u) - instance.width_m() / 2, std::abs(v) - instance.depth_m() / 2,
                                     at.z - instance.height_m(), -static_cast<double>(at.z)});
        EXPECT_NEAR(off, 0, 0.005) << instance.subject_id();
        ++checked;
      }
    }
    EXPECT_GT(checked, 100) << camera.name;
  }
}

TEST(TraceView, AnnotationsAgreeWithTheInstanceChannel) {
  const v1::SolvedLayout layout = FurnishedRoom();
  const Scene scene = *BuildScene(layout, BoxFurniture());
  const TracedView view = Traced(scene, scene.birdseye, Small());
  ASSERT_EQ(view.annotations.instances_size(), static_cast<int>(scene.objects.size() + scene.shell.size()));
  for (const v1::Instance& instance : view.annotations.instances()) {
    int64_t count = 0;
    int left = 1000, right = -1, top = 1000, bottom = -1;
    for (int i = 0; i < view.width_px * view.height_px; ++i) {
      if (view.instance[i] != instance.instance_id()) continue;
      ++count;
      left = std::min(left, i % view.width_px);
      right = std::max(right, i % view.width_px + 1);
      top = std::min(top, i / view.width_px);
      bottom = std::max(bottom, i / view.width_px + 1);
      EXPECT_EQ(view.object_class[i], instance.class_id());
    }
    EXPECT_EQ(instance.visible_pixel_count(), count) << instance.subject_id();
    EXPECT_EQ(instance.has_pixel_box(), count > 0);
    if (count == 0) continue;
    EXPECT_EQ(instance.pixel_box().left(), left);
    EXPECT_EQ(instance.pixel_box().right(), right);
    EXPECT_EQ(instance.pixel_box().top(), top);
    EXPECT_EQ(instance.pixel_box().bottom(), bottom);
  }
  EXPECT_EQ(view.annotations.instances(0).subject_id(), "desk");
  EXPECT_GT(view.annotations.instances(0).visible_pixel_count(), 20);
}

TEST(TraceView, ChannelsHoldWhatTheySay) {
  const v1::SolvedLayout layout = FurnishedRoom();
  const Scene scene = *BuildScene(layout, BoxFurniture({0.5F, 0.3F, 0.2F}));
  const TracedView view = Traced(scene, scene.birdseye, Small());
  for (size_t i = 0; i < view.colour.size(); ++i) {
    EXPECT_TRUE(std::isfinite(view.colour[i].x + view.colour[i].y + view.colour[i].z));
    if (view.instance[i] == 0) {
      EXPECT_EQ(view.depth_m[i], 0);
      EXPECT_EQ(view.normal[i], Vec3());
      EXPECT_EQ(view.albedo[i], Vec3());
      continue;
    }
    EXPECT_GT(view.depth_m[i], 0);
    EXPECT_NEAR(Length(view.normal[i]), 1, 1e-4);
    if (view.instance[i] <= 3) {
      EXPECT_EQ(view.albedo[i], (Vec3{0.5F, 0.3F, 0.2F}));
    }
  }
}

TEST(TraceView, GivesTheSameBytesForAnyNumberOfThreads) {
  const v1::SolvedLayout layout = FurnishedRoom();
  const Scene scene = *BuildScene(layout, BoxFurniture());
  TraceOptions options = Small(3);
  const TracedView one = Traced(scene, scene.perspective, options);
  for (const int threads : {2, 3, 7}) {
    options.thread_count = threads;
    const TracedView many = Traced(scene, scene.perspective, options);
    ASSERT_EQ(one.colour.size(), many.colour.size());
    EXPECT_EQ(std::memcmp(one.colour.data(), many.colour.data(), one.colour.size() * sizeof(Vec3)), 0);
    EXPECT_EQ(ToneMapped(one).rgb, ToneMapped(many).rgb);
  }
  options.seed = 7;
  EXPECT_NE(ToneMapped(Traced(scene, scene.perspective, options)).rgb, ToneMapped(one).rgb);
}

TEST(TraceView, NoRoomIsBlackOrBurntOut) {
  v1::SolvedLayout only_lamp = EmptyRoom(4, 4);
  AddObject(only_lamp, "lamp", 2, 2, 0);
  v1::SolvedLayout windowed = EmptyRoom(1.5, 1.5);
  AddWindow(windowed, "wall_1", 0.3, 0.8);
  for (const v1::SolvedLayout& layout : {EmptyRoom(1.5, 1.5), EmptyRoom(30, 30), only_lamp, windowed, LShapedRoom()}) {
    const Scene scene = *BuildScene(layout, BoxFurniture());
    for (const SceneCamera& camera : {scene.birdseye, scene.perspective}) {
      const TracedView view = Traced(scene, camera, Small());
      EXPECT_GT(MeanLuminance(view), 0.15F) << camera.name;
      EXPECT_LT(MeanLuminance(view), 1.0F) << camera.name;
    }
  }
}

TEST(TraceView, ALampLightsWhatIsNearIt) {
  v1::SolvedLayout layout = EmptyRoom(6, 4);
  AddObject(layout, "lamp", 1, 2, 0);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  // The eastern and the western half of the floor, from the middle of the southern wall.
  const SceneCamera camera{"test", {3, 0.2F, 1.6F}, {3, 3, 0}, 2.2F};
  const TracedView view = Traced(scene, camera, Small(8));
  double near = 0, far = 0;
  for (int y = 50; y < view.height_px; ++y) {
    for (int x = 0; x < view.width_px; ++x) {
      (x < view.width_px / 2 ? near : far) += view.colour[static_cast<size_t>(y) * view.width_px + x].y;
    }
  }
  EXPECT_GT(near, 1.3 * far);
}

TEST(TraceView, ALampThatHangsIsSeenFromAboveToo) {
  v1::SolvedLayout layout = EmptyRoom(4, 4);
  AddObject(layout, "pendant", 2, 2, 0);
  layout.mutable_graph()->mutable_object_list()->mutable_objects(0)->set_kind(v1::OBJECT_KIND_CEILING);
  layout.mutable_placements(0)->set_z_m(2);
  const auto seen = [&](bool from_above) {
    const Scene scene = *BuildScene(layout, BoxFurniture());
    const SceneCamera within{"test", {0.3F, 0.3F, 1.5F}, {2, 2, 2}, 1.2F};
    return Traced(scene, from_above ? scene.birdseye : within, Small()).annotations.instances(0).visible_pixel_count();
  };
  EXPECT_GT(seen(true), 100);
  EXPECT_GT(seen(false), 100);
  // What is flat below the ceiling goes with it.
  layout.mutable_graph()->mutable_object_list()->mutable_objects(0)->set_height_m(0.1);
  EXPECT_EQ(seen(true), 0);
  EXPECT_GT(seen(false), 20);
}

TEST(TraceView, WhatHangsOnAWallGoesWithIt) {
  v1::SolvedLayout layout = EmptyRoom(4, 4);
  AddObject(layout, "painting", 2, 0.3, 0);
  layout.mutable_graph()->mutable_object_list()->mutable_objects(0)->set_kind(v1::OBJECT_KIND_WALL);
  layout.mutable_placements(0)->set_z_m(1.2);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  const auto seen = [&](Vec3 eye) {
    return Traced(scene, {"test", eye, {2, 2, 1}, 1}, Small()).annotations.instances(0).visible_pixel_count();
  };
  EXPECT_GT(seen({2, 7, 6}), 20);     // from the north, above: its front
  EXPECT_EQ(seen({2, -3, 6}), 0);     // from the south the wall is cut down
  EXPECT_EQ(seen({2, -3, 1.5F}), 0);  // and from outside it
}

TEST(TraceView, AnEyeOutsideSeesOnlyWhatIsWithin) {
  const v1::SolvedLayout layout = EmptyRoom(4, 4);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  // South of the room and close to its corner: without its wall, the end of the western one would show.
  const TracedView view = Traced(scene, {"test", {0.4F, -0.8F, 1.5F}, {2, 3, 1.4F}, 1.2F}, Small());
  int within = 0;
  for (int y = 0; y < view.height_px; ++y) {
    for (int x = 0; x < view.width_px; ++x) {
      if (view.instance[static_cast<size_t>(y) * view.width_px + x] == 0) continue;
      const Vec3 at = PointOf(view, x, y);
      EXPECT_TRUE(at.x > -0.01F && at.y > -0.01F) << at.x << " " << at.y;
      ++within;
    }
  }
  EXPECT_GT(within, view.width_px * view.height_px / 2);
}

TEST(TraceView, StopsWhenNobodyWaits) {
  v1::SolvedLayout layout = EmptyRoom(20, 20);
  for (int i = 0; i < 5000; ++i) AddObject(layout, "box_" + std::to_string(i), 1 + i % 70 * 0.25, 1 + i / 70 * 0.25, i);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  TraceOptions options = Small(4096);
  options.width_px = options.height_px = 2048;
  int asked = 0;
  options.check_alive = [&asked] { return ++asked > 5 ? absl::CancelledError("nobody waits") : absl::OkStatus(); };
  EXPECT_EQ(TraceView(scene, scene.birdseye, options).status().code(), absl::StatusCode::kCancelled);
}

TEST(TraceView, ShowsFiveThousandObjects) {
  v1::SolvedLayout layout = EmptyRoom(20, 20);
  for (int i = 0; i < 5000; ++i) AddObject(layout, "box_" + std::to_string(i), 1 + i % 70 * 0.25, 1 + i / 70 * 0.25, i);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  const TracedView view = Traced(scene, scene.birdseye, Small(1));
  EXPECT_EQ(view.annotations.instances(4999).subject_id(), "box_4999");
}

TEST(TraceView, RefusesWhatCannotBe) {
  const v1::SolvedLayout layout = EmptyRoom(3, 3);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  const auto code = [&scene](const SceneCamera& camera, const TraceOptions& options) {
    return TraceView(scene, camera, options).status().code();
  };
  SceneCamera camera = scene.birdseye;
  camera.eye.x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(code(camera, Small()), absl::StatusCode::kInvalidArgument);
  camera = scene.birdseye;
  camera.target = {camera.eye.x, camera.eye.y, 0};
  EXPECT_EQ(code(camera, Small()), absl::StatusCode::kInvalidArgument);
  camera = scene.birdseye;
  camera.field_of_view_rad = 4;
  EXPECT_EQ(code(camera, Small()), absl::StatusCode::kInvalidArgument);
  EXPECT_EQ(code(scene.birdseye, Small(0)), absl::StatusCode::kInvalidArgument);
  TraceOptions options = Small();
  options.width_px = options.height_px = 8192;
  EXPECT_EQ(code(scene.birdseye, options), absl::StatusCode::kResourceExhausted);
}

TEST(TraceView, RefusesBrokenMeshes) {
  const v1::SolvedLayout layout = FurnishedRoom();
  Scene scene = *BuildScene(layout, BoxFurniture());
  auto broken = std::make_shared<Mesh>(*scene.objects[0].furnishing.mesh);
  broken->parts[0].indices[4] = 1000;
  scene.objects[0].furnishing.mesh = broken;
  EXPECT_EQ(TraceView(scene, scene.birdseye, Small()).status().code(), absl::StatusCode::kInvalidArgument);
}

TEST(ToneMapped, KeepsBlackAndWhiteAndOrder) {
  TracedView view;
  view.width_px = 5;
  view.height_px = 1;
  view.colour = {{0, 0, 0}, {0.2F, 0.2F, 0.2F}, {0.6F, 0.6F, 0.6F}, {1, 1, 1}, {100, 100, 100}};
  const std::vector<uint8_t> rgb = ToneMapped(view).rgb;
  EXPECT_EQ(rgb[0], 0);
  for (size_t i = 3; i < rgb.size(); i += 3) EXPECT_GT(rgb[i], rgb[i - 3]);
  EXPECT_GE(rgb[12], 250);
}

}  // namespace
}  // namespace flair::renderer
