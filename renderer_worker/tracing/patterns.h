// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// The colour of a material at texture coordinates in metres, as the mean over about `filter_m` (the width of a pixel on
// the surface): what is finer is blurred away instead of flickering. Linear RGB in [0, 1]. Pure; no pattern repeats.
Vec3 PatternColour(const Material& material, Vec2 uv_m, float filter_m);

// Its mean over a large surface.
Vec3 MeanPatternColour(const Material& material);

// The families, each in a file of its own.
Vec3 WoodColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 PlanksColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 HerringboneColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 TilesColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 BricksColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 StoneColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 CarpetColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 FabricColour(const Material& material, Vec2 uv_m, float filter_m);
Vec3 WallpaperColour(const Material& material, Vec2 uv_m, float filter_m);

}  // namespace flair::renderer
