// SPDX-License-Identifier: GPL-3.0-or-later
// The balance of light: what the parts of the tracer promise each other.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/scene/testing/sample_rooms.h"
#include "renderer_worker/tracing/lighting.h"

namespace flair::renderer {
namespace {

Vec3 DirectionOf(Vec2 sample) {
  const float z = 1 - 2 * sample.x, radius = std::sqrt(std::max(0.0F, 1 - z * z));
  return {radius * std::cos(6.2831853F * sample.y), radius * std::sin(6.2831853F * sample.y), z};
}

// Where everything is white and the sky is the same from everywhere, nothing can be told from anything.
TEST(Light, WhiteThingsVanishInAWhiteFurnace) {
  v1::SolvedLayout layout = EmptyRoom(4, 4);
  AddObject(layout, "desk", 2, 2, 0.3);
  AddObject(layout, "bed", 2.4, 1.2, 1);
  Scene scene = *BuildScene(layout, BoxFurniture({1, 1, 1}));
  scene.shell.clear();
  const auto world = World::Make(scene, {});
  ASSERT_TRUE(world.ok()) << world.status();
  Lights lights;
  lights.open_sky = lights.uniform_sky = true;
  const auto radiosity = Radiosity::Solve(**world, lights, SpreadPoints(**world, 2000), {});
  ASSERT_TRUE(radiosity.ok());
  const SampleSeeds seeds(5);
  const Surroundings around;
  const PinholeCamera camera;
  double sum = 0;
  int count = 0;
  for (int i = 0; i < 400; ++i) {
    const PixelSamples random(seeds, i, 0, 1);
    const Vec3 eye = Vec3{2, 2, 0.4F} - DirectionOf(random.At(0, Purpose::kBounce)) * 5;
    const Vec2 aim = random.At(0, Purpose::kLight);
    const Seen seen = LookFrom(**world, lights, {}, eye, Normalized(Vec3{1.5F + aim.x, 1 + aim.y, 0.4F} - eye), 1e-3F);
    if (seen.lit_instance < 0) continue;
    const Setting setting{**world, lights, **radiosity, around, camera};
    const Vec3 light = IndirectLight(setting, seen, PixelSamples(seeds, i, 3, 64), 0, 64).light;
    EXPECT_NEAR(Luminance(light), 1, 0.12);
    sum += Luminance(light);
    ++count;
  }
  ASSERT_GT(count, 200);
  EXPECT_NEAR(sum / count, 1, 0.02);
}

// Light of a ball on a plane: intensity times cosine over distance squared, over pi.
TEST(Light, FallsWithTheSquareOfTheDistance) {
  Lights lights;
  lights.balls.push_back({{0, 0, 2}, {3, 3, 3}, 0.02F});
  for (const float x : {0.0F, 1.0F, 3.0F}) {
    const LightChoice choice(lights, {x, 0, 0}, {0, 0, 1});
    double sum = 0;
    const SampleSeeds seeds(1);
    const PixelSamples random(seeds, 0, 0, 64);
    for (int i = 0; i < 64; ++i) {
      sum += choice.Sample(random.At(i, Purpose::kLight).x, random.At(i, Purpose::kPlaceOnLight)).irradiance.x / 64;
    }
    const double distance2 = x * x + 4;
    EXPECT_NEAR(sum, 3 * 2 / std::sqrt(distance2) / distance2 / 3.14159265, 0.003);
  }
}

// The form factor of a parallel rectangle seen from a point below its corner (Hottel).
TEST(Light, OfARectangleIsItsFormFactor) {
  Lights lights;
  RectLight rect;
  rect.corner = {0, 0, 1};
  rect.along = {1, 0, 0};
  rect.up = {0, 1, 0};
  rect.normal = {0, 0, -1};
  rect.area_m2 = 1;
  rect.radiance = {1, 1, 1};
  lights.rects.push_back(rect);
  const LightChoice choice(lights, {0, 0, 0}, {0, 0, 1});
  const SampleSeeds seeds(1);
  const PixelSamples random(seeds, 0, 0, 4096);
  double sum = 0;
  for (int i = 0; i < 4096; ++i) {
    sum += choice.Sample(random.At(i, Purpose::kLight).x, random.At(i, Purpose::kPlaceOnLight)).irradiance.x / 4096;
  }
  const double r2 = std::sqrt(2.0);
  EXPECT_NEAR(sum, 2 * (1 / r2 * std::atan(1 / r2)) / (2 * 3.14159265), 0.001);
}

// Which rays leave a room: those that pass a window's glass or the gap of a door, no others.
TEST(World, WallsHaveNoLeaks) {
  v1::SolvedLayout layout = LShapedRoom();
  layout.mutable_graph()->mutable_room()->mutable_openings()->DeleteSubrange(1, 1);  // the door is ajar
  const Scene scene = *BuildScene(layout, BoxFurniture());
  const RoomShape shape = *ShapeOf(layout.graph().room());
  const auto world = World::Make(scene, CutAwayFor(shape, {4, 1, 1}));
  ASSERT_TRUE(world.ok());
  const Lights lights = LightsOf(scene, false);
  const SampleSeeds seeds(9);
  const PixelSamples random(seeds, 0, 0, 20000);
  int through = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 direction = DirectionOf(random.At(i, Purpose::kBounce));
    if ((*world)->Feel({4, 1.2F, 1.3F}, direction).instance >= 0) continue;
    ++through;
    EXPECT_GE(lights.WindowThrough({4, 1.2F, 1.3F}, direction), 0);
  }
  EXPECT_GT(through, 100);
}

TEST(World, FewTreesAndManySeeTheSame) {
  const auto ball_room = [](int count) {
    v1::SolvedLayout layout = EmptyRoom(8, 8);
    for (int i = 0; i < count; ++i)
      AddObject(layout, "box_" + std::to_string(i), 0.8 + i % 6 * 1.25, 0.8 + i / 6 * 1.25, 0.1 * i);
    return layout;
  };
  const v1::SolvedLayout layout = ball_room(36);
  Scene scene = *BuildScene(layout, BoxFurniture());
  const auto flat = World::Make(scene, CutAwayFor(*ShapeOf(layout.graph().room()), scene.birdseye.eye));
  // The same room with so many triangles out of sight that meshes are shared.
  auto heavy = std::make_shared<Mesh>(*scene.objects[0].furnishing.mesh);
  while (static_cast<int64_t>(heavy->parts[0].indices.size()) < 3 * kMaxFlatTriangles) {
    std::vector<uint32_t>& indices = heavy->parts[0].indices;
    indices.insert(indices.end(), indices.begin(), indices.end());
  }
  scene.objects[0].furnishing.mesh = heavy;
  const auto shared = World::Make(scene, CutAwayFor(*ShapeOf(layout.graph().room()), scene.birdseye.eye));
  ASSERT_TRUE(flat.ok() && shared.ok());
  const SampleSeeds seeds(3);
  const PixelSamples random(seeds, 0, 0, 2000);
  int differ = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 aim = random.At(i, Purpose::kBounce);
    const Vec3 direction = Normalized(Vec3{aim.x * 8, aim.y * 8, 0.2F} - scene.birdseye.eye);
    const Hit a = (*flat)->Look(scene.birdseye.eye, direction, 0),
              b = (*shared)->Look(scene.birdseye.eye, direction, 0);
    ASSERT_EQ(a.instance < 0, b.instance < 0);
    if (a.instance < 0) continue;
    EXPECT_NEAR(a.distance, b.distance, 1e-3);
    // Where two surfaces meet either may be found.
    if (a.instance != b.instance) {
      ++differ;
      continue;
    }
    EXPECT_GT(Dot((*flat)->GeometricNormalAt(a, direction), (*shared)->GeometricNormalAt(b, direction)), 0.999F);
  }
  EXPECT_LE(differ, 10);
}

TEST(Sampling, SixteenPointsOfAPixelFillEveryGridOfSixteen) {
  const SampleSeeds seeds(42);
  for (const Purpose purpose : {Purpose::kLight, Purpose::kBounce}) {
    const PixelSamples random(seeds, 13, 7, 16);
    for (const auto& [columns, rows] : {std::pair{16, 1}, {4, 4}, {1, 16}, {8, 2}}) {
      std::vector<int> count(16);
      for (int i = 0; i < 16; ++i) {
        const Vec2 p = random.At(i, purpose);
        ++count[static_cast<int>(p.x * static_cast<float>(columns)) * rows +
                static_cast<int>(p.y * static_cast<float>(rows))];
      }
      EXPECT_THAT(count, testing::Each(1));
    }
  }
}

// A plane of two instances, seen from 3 m: noise of a tenth on the left one, none on the right one, ten times as light.
LightGrid HalfNoisy(int size) {
  LightGrid grid(size, size);
  for (int i = 0; i < size * size; ++i) {
    const bool right = i % size >= size / 2;
    const float noise = 0.1F * (2 * static_cast<float>(Mix(static_cast<uint32_t>(i)) >> 8) * 0x1p-24F - 1);
    const float light = right ? 10 : 1 + noise;
    const std::array<float, kGuideCount> guides = {0.01F * static_cast<float>(i % size),
                                                   0.01F * static_cast<float>(i / size),
                                                   0,
                                                   0,
                                                   0,
                                                   1,
                                                   70,
                                                   right ? 2.0F : 1.0F};
    for (int k = 0; k < kGuideCount; ++k) grid.guides[k][i] = guides[k];
    for (const int k : {kRed, kGreen, kBlue, kLuminance}) grid.light[k][i] = light;
    grid.light[kVariance][i] = right ? 0 : 0.0033F;
  }
  return grid;
}

TEST(SmoothLight, LeavesEvenLightAndOtherInstancesAlone) {
  constexpr int kSize = 48;
  LightGrid grid = HalfNoisy(kSize);
  Planes scratch(kLightCount, grid.size());
  ASSERT_TRUE(SmoothLight({}, 4, grid, scratch).ok());
  for (int i = 0; i < kSize * kSize; ++i) {
    EXPECT_NEAR(grid.light[kRed][i], i % kSize >= kSize / 2 ? 10 : 1, 0.04);
  }
}

TEST(SmoothGloss, StaysOnItsSurface) {
  constexpr int kSize = 48;
  const LightGrid grid = HalfNoisy(kSize);
  Planes gloss(3, grid.size());
  for (int k = 0; k < 3; ++k) std::copy_n(grid.light[kRed], grid.size(), gloss[k]);
  ASSERT_TRUE(SmoothGloss({}, 4, grid, gloss).ok());
  for (int i = 0; i < kSize * kSize; ++i) EXPECT_NEAR(gloss[2][i], i % kSize >= kSize / 2 ? 10 : 1, 0.04);
}

TEST(SpreadSparks, SharesThemAndLosesNoLight) {
  LightGrid grid = HalfNoisy(8);
  Planes scratch(kLightCount, grid.size());
  const auto sum = [&grid] {
    double all = 0;
    for (size_t i = 0; i < grid.size(); ++i) all += grid.light[kRed][i];
    return all;
  };
  grid.light[kRed][9] = grid.light[kGreen][9] = grid.light[kBlue][9] = grid.light[kLuminance][9] = 50;
  const double before = sum();
  ASSERT_TRUE(SpreadSparks({}, grid, scratch).ok());
  EXPECT_LT(grid.light[kRed][9], 8);
  EXPECT_GT(grid.light[kRed][0], 6);
  EXPECT_LT(grid.light[kRed][3], 1.2F);  // out of its reach
  EXPECT_EQ(grid.light[kRed][15], 10);   // its neighbours are as bright
  EXPECT_NEAR(sum(), before, 1e-3);
}

// What straight light falls on a floor below a board, by blocks: as with as many samples everywhere, and few where all
// agree.
TEST(DirectLight, IsThatOfManySamplesInHalfShadows) {
  v1::SolvedLayout layout = EmptyRoom(4, 4);
  AddObject(layout, "desk", 2, 2, 0.3);
  const Scene scene = *BuildScene(layout, BoxFurniture());
  const auto world = World::Make(scene, CutAwayFor(*ShapeOf(layout.graph().room()), scene.birdseye.eye));
  ASSERT_TRUE(world.ok());
  Lights lights;
  lights.balls.push_back({{1, 2, 1.9F}, {3, 3, 3}, 0.2F});
  const Radiosity radiosity;
  const Surroundings around;
  const PinholeCamera camera;
  const Setting setting{**world, lights, radiosity, around, camera};
  const auto mean_at = [&](float x, int round_count) {
    double sum = 0;
    for (int n = 0; n < 40; ++n) {
      std::array<Seen, kBlockSide * kBlockSide> seen;
      PixelBlock block;
      for (size_t i = 0; i < seen.size(); ++i) {
        seen[i].lit_instance = 1;
        seen[i].position = {x + 0.002F * static_cast<float>(i % 4), 2 + 0.002F * static_cast<float>(i / 4), 1e-3F};
        seen[i].normal = {0, 0, 1};
        block[i] = &seen[i];
      }
      const SampleSeeds seeds(static_cast<uint32_t>(n));
      for (const LightMean& light : DirectLightOn(setting, seeds, block, 8, 16, round_count)) sum += light.light.x;
    }
    return sum / 640;
  };
  EXPECT_GT(mean_at(0.6F, 4), 0.1);  // in the light
  EXPECT_EQ(mean_at(2.2F, 4), 0);    // below the board
  const double half = mean_at(2.95F, 64);
  EXPECT_GT(mean_at(3.6F, 64), half);
  EXPECT_NEAR(mean_at(2.95F, 4), half, 0.03 * mean_at(3.6F, 64));
}

TEST(Patterns, AreColoursAndFadeToTheirMeanWhenSeenFromAfar) {
  for (const Pattern pattern :
       {Pattern::kPlain, Pattern::kWood, Pattern::kPlanks, Pattern::kHerringbone, Pattern::kTiles, Pattern::kBricks,
        Pattern::kStone, Pattern::kCarpet, Pattern::kFabric, Pattern::kWallpaper}) {
    Material material;
    material.colour = {0.6F, 0.4F, 0.2F};
    material.second_colour = {0.1F, 0.1F, 0.1F};
    material.pattern = pattern;
    double near = 0, far = 0;
    float lightest = 0, darkest = 1;
    for (int i = 0; i < 2000; ++i) {
      const Vec2 uv{static_cast<float>(i) * 0.0137F - 7, static_cast<float>(i) * 0.00619F - 3};
      const Vec3 fine = PatternColour(material, uv, 0.001F), coarse = PatternColour(material, uv, 5);
      for (const float v : {fine.x, fine.y, fine.z, coarse.x, coarse.y, coarse.z}) ASSERT_TRUE(v >= 0 && v <= 1);
      near += fine.y;
      far += coarse.y;
      lightest = std::max(lightest, fine.y);
      darkest = std::min(darkest, fine.y);
    }
    EXPECT_NEAR(near / 2000, far / 2000, 0.06) << static_cast<int>(pattern);
    const float contrast = pattern == Pattern::kPlain ? -1.0F : 0.03F;
    EXPECT_GT(lightest - darkest, contrast) << static_cast<int>(pattern);
    EXPECT_GE(PatternColour(material, {1e30F, std::nanf("")}, 0).x, 0);
  }
}

}  // namespace
}  // namespace flair::renderer
