// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/patterns/pattern.h"

#include <algorithm>

namespace flair::renderer {
namespace {

Vec3 Clamped(Vec3 c) { return {std::clamp(c.x, 0.0F, 1.0F), std::clamp(c.y, 0.0F, 1.0F), std::clamp(c.z, 0.0F, 1.0F)}; }

// Coordinates that a room has; meshes of others may hold anything.
float InRoom(float value) { return value > -1e4F && value < 1e4F ? value : 0.0F; }

Vec3 Colour(const Material& material, Vec2 uv, float filter) {
  switch (material.pattern) {
    case Pattern::kPlain:
      return material.colour;
    case Pattern::kWood:
      return WoodColour(material, uv, filter);
    case Pattern::kPlanks:
      return PlanksColour(material, uv, filter);
    case Pattern::kHerringbone:
      return HerringboneColour(material, uv, filter);
    case Pattern::kTiles:
      return TilesColour(material, uv, filter);
    case Pattern::kBricks:
      return BricksColour(material, uv, filter);
    case Pattern::kStone:
      return StoneColour(material, uv, filter);
    case Pattern::kCarpet:
      return CarpetColour(material, uv, filter);
    case Pattern::kFabric:
      return FabricColour(material, uv, filter);
    case Pattern::kWallpaper:
      return WallpaperColour(material, uv, filter);
  }
  return material.colour;
}

}  // namespace

Vec3 PatternColour(const Material& material, Vec2 uv_m, float filter_m) {
  return Clamped(Colour(material, {InRoom(uv_m.x), InRoom(uv_m.y)}, filter_m));
}

Vec3 MeanPatternColour(const Material& material) {
  if (material.pattern == Pattern::kPlain) return PatternColour(material, {}, 1);
  constexpr int kPerSide = 12;
  Vec3 sum;
  for (int i = 0; i < kPerSide; ++i) {
    for (int k = 0; k < kPerSide; ++k) {
      sum = sum + PatternColour(material, {static_cast<float>(i) * 0.317F, static_cast<float>(k) * 0.271F}, 0.01F);
    }
  }
  return sum * (1.0F / (kPerSide * kPerSide));
}

}  // namespace flair::renderer
