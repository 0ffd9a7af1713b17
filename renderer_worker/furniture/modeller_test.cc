// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/modeller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <tuple>

namespace flair::renderer {
namespace {

// A shape that fills [-0.5, 0.5] x [-0.4, 0.4] x [0, 0.8], so that fitting leaves it as it is.
struct Case {
  std::string name;
  std::function<void(Modeller&, const Material&)> add;
  float volume;  // by hand, m3
  float tolerance;
};

const std::array<Vec2, 6> kArrow{{{-0.5F, -0.2F}, {0, -0.2F}, {0, -0.4F}, {0.5F, 0}, {0, 0.4F}, {-0.5F, 0.2F}}};

std::vector<Case> Shapes() {
  return {
      {"box",
       [](Modeller& m, const Material& a) {
         m.Box(a, {-0.5F, -0.4F, 0}, {0.5F, 0.4F, 0.8F}, 0.01F);
       },
       0.64F, 0.002F},
      {"sharp box",
       [](Modeller& m, const Material& a) {
         m.Box(a, {0.5F, 0.4F, 0}, {-0.5F, -0.4F, 0.8F}, 0);
       },
       0.64F, 1e-4F},
      {"cushion",
       [](Modeller& m, const Material& a) {
         m.Cushion(a, {-0.5F, -0.4F, 0}, {0.5F, 0.4F, 0.8F}, 0.05F);
       },
       0.64F, 0.02F},
      {"full cushion",
       [](Modeller& m, const Material& a) {
         m.Cushion(a, {-0.5F, -0.4F, 0}, {0.5F, 0.4F, 0.8F}, 0.05F, 0.05F);
       },
       0.56F, 0.06F},
      {"pillow",
       [](Modeller& m, const Material& a) {
         m.Pillow(a, {-0.5F, -0.4F, 0}, {0.5F, 0.4F, 0.8F});
       },
       0.42F, 0.08F},
      {"taper",
       [](Modeller& m, const Material& a) {
         m.Taper(a, {}, {0.25F, 0.2F}, {0, 0, 0.8F}, {0.5F, 0.4F});
       },
       0.3733F, 0.001F},
      {"slab", [](Modeller& m, const Material& a) { m.Slab(a, kArrow, 0, 0.8F, 0.005F); }, 0.8F * 0.45F, 0.01F},
      {"lathe",
       [](Modeller& m, const Material& a) {
         m.Lathe(a, {}, std::array<Vec2, 2>{{{0.5F, 0}, {0.5F, 0.8F}}}, 64, {1, 0.8F});
       },
       kPiFloat * 0.2F * 0.8F, 0.002F},
      {"cone",
       [](Modeller& m, const Material& a) {
         m.Lathe(a, {}, std::array<Vec2, 2>{{{0.5F, 0}, {0, 0.8F}}}, 64, {1, 0.8F});
       },
       kPiFloat * 0.2F * 0.8F / 3, 0.002F},
      {"ring",
       [](Modeller& m, const Material& a) {
         m.Ring(a, {}, std::array<Vec2, 4>{{{0.4F, 0}, {0.5F, 0}, {0.5F, 0.8F}, {0.4F, 0.8F}}}, 64, {1, 0.8F});
       },
       kPiFloat * 0.8F * (0.2F - 0.128F), 0.002F},
      {"sheet",
       [](Modeller& m, const Material& a) {
         m.Sheet(
             a, 4, 4,
             [](float u, float v) {
               return Vec3{u - 0.5F, 0.8F * v - 0.4F, 0.4F};
             },
             0.8F);
       },
       0.64F, 1e-3F},
  };
}

const MeshPart& OnlyPart(const Mesh& mesh) {
  EXPECT_EQ(mesh.parts.size(), 1U);
  return mesh.parts.front();
}

float VolumeOf(const MeshPart& part) {
  float volume = 0;
  for (size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    volume += Dot(part.positions[part.indices[i]],
                  Cross(part.positions[part.indices[i + 1]], part.positions[part.indices[i + 2]])) /
              6;
  }
  return volume;
}

// Every edge is walked as often one way as the other.
bool IsClosed(const MeshPart& part) {
  using Key = std::tuple<long, long, long>;
  const auto key = [](Vec3 p) {
    return Key{std::lround(p.x * 1e4F), std::lround(p.y * 1e4F), std::lround(p.z * 1e4F)};
  };
  std::map<std::pair<Key, Key>, int> balance;
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const Key a = key(part.positions[part.indices[i + k]]), b = key(part.positions[part.indices[i + (k + 1) % 3]]);
      balance[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](const auto& edge) { return edge.second == 0; });
}

Mesh Made(const Case& shape) {
  Modeller modeller;
  shape.add(modeller, {});
  return modeller.Filling(1, 0.8F, 0.8F, {});
}

TEST(Modeller, ShapesAreClosedAndTurnedOutwards) {
  for (const Case& shape : Shapes()) {
    const Mesh mesh = Made(shape);
    const MeshPart& part = OnlyPart(mesh);
    EXPECT_TRUE(IsClosed(part)) << shape.name;
    EXPECT_NEAR(VolumeOf(part), shape.volume, shape.tolerance) << shape.name;
  }
}

TEST(Modeller, NormalsAreUnitAndPointOutOfTheirTriangles) {
  for (const Case& shape : Shapes()) {
    const Mesh mesh = Made(shape);
    const MeshPart& part = OnlyPart(mesh);
    ASSERT_EQ(part.normals.size(), part.positions.size()) << shape.name;
    ASSERT_EQ(part.uvs.size(), part.positions.size()) << shape.name;
    for (const Vec3& n : part.normals) EXPECT_NEAR(Length(n), 1, 1e-4F) << shape.name;
    for (size_t i = 0; i < part.indices.size(); i += 3) {
      const uint32_t a = part.indices[i], b = part.indices[i + 1], c = part.indices[i + 2];
      const Vec3 face = Normalized(Cross(part.positions[b] - part.positions[a], part.positions[c] - part.positions[a]));
      for (const uint32_t k : {a, b, c})
        EXPECT_GT(Dot(face, part.normals[k]), 0.3F) << shape.name << " triangle " << i / 3;
    }
  }
}

// The first texture coordinate grows by a metre for each metre along the longest side of a box.
TEST(Modeller, TextureCoordinatesOfABoxAreMetresAlongItsLongestSide) {
  Modeller modeller;
  modeller.Box({}, {-1, -0.2F, 0}, {1, 0.2F, 0.1F}, 0);
  const Mesh mesh = modeller.Filling(2, 0.4F, 0.1F, {});
  const MeshPart& part = OnlyPart(mesh);
  for (size_t i = 0; i < part.positions.size(); ++i) {
    if (std::abs(part.normals[i].x) < 0.5F) EXPECT_NEAR(std::abs(part.uvs[i].x), 1, 1e-5F);
  }
}

TEST(Modeller, FramesNest) {
  Modeller modeller;
  modeller.In(Frame{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, [&] {
    modeller.In(Frame{{2, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, [&] {
      const Vec3 at = modeller.Placed({0, 1, 3});
      EXPECT_NEAR(at.x, 0, 1e-5F);
      EXPECT_NEAR(at.y, 2, 1e-5F);
      EXPECT_NEAR(at.z, 3, 1e-5F);
    });
  });
  EXPECT_EQ(modeller.Placed({1, 2, 3}), (Vec3{1, 2, 3}));
}

TEST(Modeller, WhatIsMadeIsStretchedToItsBoxAndPointsInsideMoveAlong) {
  Modeller modeller;
  modeller.Pillow({}, {2, 1, 2.5F}, {4, 5, 3.5F});
  std::array<Vec3, 1> inside{{{3, 3, 3}}};
  const Mesh mesh = modeller.Filling(0.2F, 4, 1, inside);
  Vec3 low{9, 9, 9}, high{-9, -9, -9};
  for (const Vec3& p : OnlyPart(mesh).positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  EXPECT_EQ(low, (Vec3{-0.1F, -2, 0}));
  EXPECT_EQ(high, (Vec3{0.1F, 2, 1}));
  EXPECT_NEAR(inside[0].x, 0, 1e-5F);
  EXPECT_NEAR(inside[0].z, 0.5F, 1e-5F);
}

TEST(Modeller, WhatHasNoVolumeIsLeftOut) {
  Modeller modeller;
  modeller.Box({}, {0, 0, 0}, {1, 1, 0});
  modeller.Lathe({}, {}, std::array<Vec2, 2>{{{0, 0}, {0, 1}}});
  modeller.Tube({}, {}, std::array{0.1F});
  modeller.Slab({}, std::array<Vec2, 2>{{{0, 0}, {1, 0}}}, 0, 1);
  modeller.Cushion({}, {0, 0, 0}, {1, 0, 1}, 0.1F);
  EXPECT_TRUE(modeller.Filling(1, 1, 1, {}).parts.empty());
}

}  // namespace
}  // namespace flair::renderer
