// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/procedural_furniture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace flair::renderer {
namespace {

v1::Object Chair(const std::string& id, double width = 0.5) {
  v1::Object object;
  object.set_id(id), object.set_name("dining chair");
  object.set_width_m(width), object.set_depth_m(0.5), object.set_height_m(0.9);
  return object;
}

TEST(ProceduralFurniture, EqualObjectsShareOneMesh) {
  const ProceduralFurniture source;
  std::vector<v1::Diagnostic> diagnostics;
  const Furnishing first = source.FurnishingOf(Chair("dining_chair_1"), nullptr, diagnostics);
  const Furnishing second = source.FurnishingOf(Chair("dining_chair_2"), nullptr, diagnostics);
  EXPECT_EQ(first.class_name, "chair");
  EXPECT_EQ(first.mesh, second.mesh);
  EXPECT_THAT(diagnostics, ::testing::IsEmpty());
}

TEST(ProceduralFurniture, ObjectsOfOtherSizeOrStyleDoNot) {
  const ProceduralFurniture source;
  std::vector<v1::Diagnostic> diagnostics;
  v1::ObjectStyle style;
  style.set_material("velvet");
  const Furnishing plain = source.FurnishingOf(Chair("a"), nullptr, diagnostics);
  EXPECT_NE(plain.mesh, source.FurnishingOf(Chair("a", 0.6), nullptr, diagnostics).mesh);
  EXPECT_NE(plain.mesh, source.FurnishingOf(Chair("a"), &style, diagnostics).mesh);
}

TEST(ProceduralFurniture, LightsComeWithASharedMeshToo) {
  const ProceduralFurniture source;
  std::vector<v1::Diagnostic> diagnostics;
  v1::Object lamp;
  lamp.set_name("floor lamp");
  lamp.set_width_m(0.4), lamp.set_depth_m(0.4), lamp.set_height_m(1.6);
  const Furnishing first = source.FurnishingOf(lamp, nullptr, diagnostics);
  EXPECT_EQ(source.FurnishingOf(lamp, nullptr, diagnostics).lights.size(), 1U);
  EXPECT_EQ(first.lights.size(), 1U);
}

TEST(ProceduralFurniture, AnswersManyThreadsWithTheSameMesh) {
  const ProceduralFurniture source;
  std::vector<std::shared_ptr<const Mesh>> meshes(8);
  std::vector<std::thread> threads;
  for (size_t i = 0; i < meshes.size(); ++i) {
    threads.emplace_back([&source, &meshes, i] {
      std::vector<v1::Diagnostic> diagnostics;
      meshes[i] = source.FurnishingOf(Chair("c"), nullptr, diagnostics).mesh;
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& mesh : meshes) EXPECT_EQ(mesh->parts.front().positions, meshes.front()->parts.front().positions);
}

TEST(ProceduralFurniture, ForgetsWhatNobodyHolds) {
  const ProceduralFurniture source;
  std::vector<v1::Diagnostic> diagnostics;
  std::weak_ptr<const Mesh> first = source.FurnishingOf(Chair("c"), nullptr, diagnostics).mesh;
  EXPECT_TRUE(first.expired());
}

}  // namespace
}  // namespace flair::renderer
