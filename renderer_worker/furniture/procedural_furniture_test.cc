// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/procedural_furniture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <thread>

#include "renderer_worker/furniture/classes.h"

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

struct Extents {
  double width, depth, height;
};

constexpr Extents kSizes[] = {{0.5, 0.5, 0.9}, {1.6, 0.6, 0.8},    {0.9, 2.1, 0.5}, {0.4, 0.05, 0.6},
                              {1.2, 1.2, 2.2}, {0.05, 0.05, 0.05}, {6, 6, 6},       {6, 0.05, 2},
                              {0.05, 6, 0.3},  {3, 2, 0.01},       {0.2, 0.2, 3}};

v1::Object Sized(std::string_view name, const Extents& size) {
  v1::Object object;
  object.set_name(std::string(name));
  object.set_width_m(size.width), object.set_depth_m(size.depth), object.set_height_m(size.height);
  return object;
}

v1::ObjectStyle Styled(const std::string& material, int red, int green, int blue) {
  v1::ObjectStyle style;
  style.set_material(material);
  style.mutable_colour()->set_red(red), style.mutable_colour()->set_green(green),
      style.mutable_colour()->set_blue(blue);
  return style;
}

MadePiece Made(std::string_view name, const v1::Object& object, const v1::ObjectStyle* style = nullptr) {
  absl::StatusOr<MadePiece> made = MakePiece(name, object, style);
  EXPECT_TRUE(made.ok()) << made.status().message();
  return made.ok() ? *std::move(made) : MadePiece();
}

// Words that choose other shapes of a class, besides its own name.
constexpr std::string_view kManners[] = {"", "round gothic velvet", "modern metal storage", "canopy abstract shoe"};

// Calls `check` for every class, size and manner.
void ForAll(const std::function<void(const std::string& label, const MadePiece&, const v1::Object&)>& check) {
  const v1::ObjectStyle style = Styled("velvet and brass", 90, 120, 60);
  for (const FurnitureClass& each : Furniture().furniture()) {
    const std::string& name = each.name();
    for (const Extents& size : kSizes) {
      for (const std::string_view manner : kManners) {
        const v1::Object object = Sized(std::string(manner) + " " + std::string(name), size);
        const std::string label = object.name() + " " + std::to_string(size.width) + " x " +
                                  std::to_string(size.depth) + " x " + std::to_string(size.height);
        check(label, Made(name, object, manner.empty() ? nullptr : &style), object);
      }
    }
  }
}

size_t TriangleCount(const Mesh& mesh) {
  size_t count = 0;
  for (const MeshPart& part : mesh.parts) count += part.indices.size() / 3;
  return count;
}

TEST(MakePiece, EveryClassHasAMesh) {
  for (const FurnitureClass& each : Furniture().furniture()) EXPECT_TRUE(HasMesh(each.mesh())) << each.name();
  EXPECT_FALSE(HasMesh("whatchamacallit"));
}

void FillsItsBoxExactly(const std::string& label, const MadePiece& made, const v1::Object& object) {
  Vec3 low{99, 99, 99}, high{-99, -99, -99};
  for (const MeshPart& part : made.mesh.parts) {
    for (const Vec3& p : part.positions) {
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) << label;
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  EXPECT_NEAR(low.x, -object.width_m() / 2, 1e-4) << label;
  EXPECT_NEAR(high.x, object.width_m() / 2, 1e-4) << label;
  EXPECT_NEAR(low.y, -object.depth_m() / 2, 1e-4) << label;
  EXPECT_NEAR(high.y, object.depth_m() / 2, 1e-4) << label;
  EXPECT_NEAR(low.z, 0, 1e-4) << label;
  EXPECT_NEAR(high.z, object.height_m(), 1e-4) << label;
}

void TrianglesHaveAnAreaAndNormalsOnTheirOuterSide(const std::string& label, const MadePiece& made, const v1::Object& object) {
  float volume = 0;
  size_t turned = 0;
  for (const MeshPart& part : made.mesh.parts) {
    ASSERT_EQ(part.normals.size(), part.positions.size()) << label;
    ASSERT_EQ(part.uvs.size(), part.positions.size()) << label;
    ASSERT_EQ(part.indices.size() % 3, 0U) << label;
    for (const Vec3& n : part.normals) ASSERT_NEAR(Length(n), 1, 1e-3F) << label;
    for (const Vec2& uv : part.uvs) ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y)) << label;
    for (size_t i = 0; i < part.indices.size(); i += 3) {
      ASSERT_LT(std::max({part.indices[i], part.indices[i + 1], part.indices[i + 2]}), part.positions.size())
          << label;
      const Vec3 a = part.positions[part.indices[i]], b = part.positions[part.indices[i + 1]],
                 c = part.positions[part.indices[i + 2]];
      const Vec3 face = Cross(b - a, c - a);
      ASSERT_GT(Length(face), 0) << label;
      const Vec3 normal =
          part.normals[part.indices[i]] + part.normals[part.indices[i + 1]] + part.normals[part.indices[i + 2]];
      if (Dot(face, normal) <= 0) ++turned;
      volume += Dot(a, Cross(b, c)) / 6;
    }
  }
  EXPECT_GT(volume, 0) << label;
  // Bars and cloth that bend more tightly than they are thick overlap: a little in pieces of usual proportions, more
  // where a piece is squeezed flat.
  const double shortest = std::min({object.width_m(), object.depth_m(), object.height_m()});
  const double longest = std::max({object.width_m(), object.depth_m(), object.height_m()});
  const size_t allowed = longest > 8 * shortest || longest > 5 || longest < 0.1 ? 4 : 50;
  EXPECT_LE(turned, TriangleCount(made.mesh) / allowed) << label;
}

void MaterialsHaveTheirOwnNames(const std::string& label, const MadePiece& made, const v1::Object&) {
  std::set<std::string> names;
  for (const MeshPart& part : made.mesh.parts) {
    EXPECT_TRUE(names.insert(part.material.name).second) << label << ": " << part.material.name;
    EXPECT_GT(part.material.roughness, 0) << label;
    EXPECT_GT(part.material.opacity, 0) << label;
  }
}

void LightsShineFromWithinTheirBox(const std::string& label, const MadePiece& made, const v1::Object& object) {
  for (const LampLight& light : made.lights) {
    EXPECT_LE(std::abs(light.position.x), object.width_m() / 2 + 1e-4) << label;
    EXPECT_LE(std::abs(light.position.y), object.depth_m() / 2 + 1e-4) << label;
    EXPECT_GE(light.position.z, -1e-4) << label;
    EXPECT_LE(light.position.z, object.height_m() + 1e-4) << label;
    EXPECT_GT(light.intensity_cd, 0) << label;
    EXPECT_GT(light.radius_m, 0) << label;
  }
}

// In one pass over all pieces: making them takes longer than looking at them.
TEST(MakePiece, EveryPieceIsSoundAndSmall) {
  size_t total = 0, count = 0;
  ForAll([&](const std::string& label, const MadePiece& made, const v1::Object& object) {
    FillsItsBoxExactly(label, made, object);
    TrianglesHaveAnAreaAndNormalsOnTheirOuterSide(label, made, object);
    MaterialsHaveTheirOwnNames(label, made, object);
    LightsShineFromWithinTheirBox(label, made, object);
    EXPECT_GE(TriangleCount(made.mesh), 12U) << label;
    EXPECT_LE(TriangleCount(made.mesh), 8000U) << label;
    EXPECT_LE(made.mesh.parts.size(), 24U) << label;
    total += TriangleCount(made.mesh), ++count;
  });
  EXPECT_LE(total / count, 1500U);
}

TEST(MakePiece, LampsAndFiresShineAndOtherThingsDoNot) {
  const std::set<std::string_view> shining{"candles",    "cauldron", "ceiling_fan", "chandelier", "fireplace",
                                           "floor_lamp", "pendant",  "table_lamp",  "wall_lamp"};
  for (const FurnitureClass& each : Furniture().furniture()) {
    const std::string& name = each.name();
    const MadePiece made = Made(name, Sized(name, {0.4, 0.4, 0.5}));
    EXPECT_EQ(!made.lights.empty(), shining.contains(name)) << name;
  }
}

// Height of the mesh above the point (x, y); 0 where it has no triangle.
float HeightAt(const Mesh& mesh, float x, float y) {
  float highest = 0;
  for (const MeshPart& part : mesh.parts) {
    for (size_t i = 0; i < part.indices.size(); i += 3) {
      const Vec3 a = part.positions[part.indices[i]], b = part.positions[part.indices[i + 1]],
                 c = part.positions[part.indices[i + 2]];
      const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      if (std::abs(area) < 1e-12F) continue;
      const float u = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;
      const float v = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area;
      if (u >= 0 && v >= 0 && u + v <= 1) highest = std::max(highest, a.z + u * (b.z - a.z) + v * (c.z - a.z));
    }
  }
  return highest;
}

TEST(MakePiece, ThingsRestOnSeatsMattressesAndTops) {
  for (const auto& [name, size] :
       std::initializer_list<std::pair<const char*, Extents>>{{"bed", {1.6, 2.05, 1.1}},
                                                              {"bed", {0.9, 2, 0.5}},
                                                              {"sofa", {2, 0.9, 0.85}},
                                                              {"armchair", {0.85, 0.85, 1.2}},
                                                              {"daybed", {1.9, 0.85, 0.8}},
                                                              {"cot", {0.7, 1.3, 0.95}},
                                                              {"chair", {0.5, 0.5, 0.9}},
                                                              {"rocking_chair", {0.6, 0.9, 1}},
                                                              {"office_chair", {0.6, 0.6, 1.1}},
                                                              {"throne", {1, 0.9, 1.8}},
                                                              {"bench", {1.2, 0.4, 0.46}},
                                                              {"bench", {1.2, 0.5, 0.9}},
                                                              {"vanity", {1.1, 0.5, 1.4}},
                                                              {"desk", {1.4, 0.7, 0.75}},
                                                              {"sink", {1, 0.6, 1.1}}}) {
    const MadePiece made = Made(name, Sized(name, size));
    const float highest =
        HeightAt(made.mesh, 0.05F * static_cast<float>(size.width), 0.17F * static_cast<float>(size.depth));
    EXPECT_NEAR(highest, RestHeightOf(name, static_cast<float>(size.height)), 0.07F) << name;
  }
}

TEST(MakePiece, GivesTheSameBitsTwice) {
  for (const FurnitureClass& each : Furniture().furniture()) {
    const std::string& name = each.name();
    const v1::Object object = Sized(name, {0.7, 0.5, 0.9});
    const MadePiece once = Made(name, object), twice = Made(name, object);
    ASSERT_EQ(once.mesh.parts.size(), twice.mesh.parts.size()) << name;
    for (size_t i = 0; i < once.mesh.parts.size(); ++i) {
      EXPECT_EQ(once.mesh.parts[i].positions, twice.mesh.parts[i].positions) << name;
      EXPECT_EQ(once.mesh.parts[i].indices, twice.mesh.parts[i].indices) << name;
      EXPECT_EQ(once.mesh.parts[i].material, twice.mesh.parts[i].material) << name;
    }
  }
}

TEST(MakePiece, ExtentsThatAreNoneStillGiveAPiece) {
  for (const double extent :
       {0.0, -1.0, 1e-9, 1e12, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const MadePiece made = Made("sofa", Sized("sofa", {extent, extent, extent}));
    EXPECT_GT(TriangleCount(made.mesh), 0U) << extent;
    for (const MeshPart& part : made.mesh.parts) {
      for (const Vec3& p : part.positions) ASSERT_LE(Length(p), 2 * kLargestExtent_m) << extent;
    }
  }
}

TEST(MakePiece, AClassThatIsNoneIsABox) {
  const v1::Object object = Sized("thing", {0.5, 0.5, 0.5});
  EXPECT_EQ(Made("whatchamacallit", object).mesh.parts.front().positions,
            Made("box", object).mesh.parts.front().positions);
}

}  // namespace
}  // namespace flair::renderer
