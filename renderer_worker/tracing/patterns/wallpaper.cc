// SPDX-License-Identifier: GPL-3.0-or-later
// Wallpaper: a damask of leaves in ogee rows, `colour` the ground, `second_colour` the figure, `pattern_size_m` the
// repeat.
#include "renderer_worker/tracing/patterns/noise.h"
#include "renderer_worker/tracing/patterns/pattern.h"

namespace flair::renderer {
namespace {

// Below 0 inside a figure about (0, 0) that is one unit wide and 1.5 high: a palmette of lobes on a stem.
float Figure(float x, float y) {
  const float side = std::abs(x);
  const float radius = std::sqrt(side * side + y * y * 0.5F), angle = std::atan2(y * 0.7F, side);
  const float lobes = 0.30F + 0.055F * std::cos(9 * angle) + 0.05F * std::sin(angle);
  const float heart = std::sqrt(side * side * 1.4F + (y + 0.06F) * (y + 0.06F)) - 0.11F;
  const float rim = std::abs(heart) - 0.022F;
  return std::max(radius - lobes, -rim);
}

// Distance to the ogee lines that frame the figures.
float Ogee(float x, float y) {
  const float wave = 0.25F + 0.21F * std::cos(2 * std::numbers::pi_v<float> * y);
  const float at = x - std::floor(x);
  return std::min(std::abs(at - wave), std::abs(at - (1 - wave)));
}

}  // namespace

Vec3 WallpaperColour(const Material& m, Vec2 uv, float filter) {
  const float repeat = std::max(m.pattern_size_m, 0.02F);
  const float x = uv.x / repeat, y = uv.y / (1.5F * repeat);
  // Every second row stands between the others.
  const int row = FloorOf(2 * y);
  const float shift = (row & 1) == 0 ? 0.0F : 0.5F;
  const float cx = x + shift - std::floor(x + shift) - 0.5F, cy = (2 * y - static_cast<float>(row) - 0.5F) * 1.1F;
  const float soft = std::max(0.012F, filter / repeat);
  const float figure = 1 - Step(-soft, soft, Figure(cx, cy));
  const float frame = 1 - Step(0.012F, 0.012F + soft, Ogee(x + 0.25F, y + 0.125F));
  const float kept = Kept(repeat * 0.15F, filter);
  const float share = 0.25F + kept * (0.75F * std::max(figure, 0.6F * frame) - 0.25F);
  const float paper = 1 + 0.03F * FractalNoise(uv, 0.01F, 2, filter, 167);
  return Lerp(m.colour, m.second_colour, share) * paper;
}

}  // namespace flair::renderer
