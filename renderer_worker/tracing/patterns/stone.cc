// SPDX-License-Identifier: GPL-3.0-or-later
// Stone: flags and rubble where `pattern_size_m` is that of stones, clouded and veined surfaces where it is metres.
#include "renderer_worker/tracing/patterns/noise.h"
#include "renderer_worker/tracing/patterns/pattern.h"

namespace flair::renderer {
namespace {

// Clouds, and veins where two folds of noise meet.
Vec3 Veined(const Material& m, Vec2 uv, float filter, float contrast) {
  const float size = std::max(m.pattern_size_m, 0.05F);
  const Vec2 warped{uv.x + 0.3F * size * FractalNoise(uv, size * 0.5F, 3, filter, 71),
                    uv.y + 0.3F * size * FractalNoise(uv, size * 0.5F, 3, filter, 73)};
  const float clouds = FractalNoise(warped, size * 0.3F, 6, filter, 79);
  const float fold = std::abs(FractalNoise(warped, size * 0.45F, 4, filter, 83));
  const float vein = 1 - Step(0.0F, 0.035F, fold);
  const float share = std::clamp(0.35F + 0.9F * clouds + contrast * vein, 0.0F, 1.0F);
  return Lerp(m.colour, m.second_colour, share);
}

}  // namespace

Vec3 StoneColour(const Material& m, Vec2 uv, float filter) {
  const float size = m.pattern_size_m;
  if (size >= 1 || size < 0.08F) return Veined(m, uv, filter, size >= 1 ? 0.0F : 0.5F);
  // Stones are the cells round scattered points; the joint is where the two nearest are equally far.
  const float x = uv.x / size, y = uv.y / size;
  const int i = FloorOf(x), k = FloorOf(y);
  float nearest = 1e9F, second = 1e9F;
  int stone_i = 0, stone_k = 0;
  for (int a = i - 1; a <= i + 1; ++a) {
    for (int b = k - 1; b <= k + 1; ++b) {
      const float px = static_cast<float>(a) + 0.15F + 0.7F * CellValue(a, b, 101);
      const float py = static_cast<float>(b) + 0.15F + 0.7F * CellValue(a, b, 103);
      const float distance = std::sqrt((px - x) * (px - x) + (py - y) * (py - y));
      if (distance < nearest) {
        second = nearest, nearest = distance, stone_i = a, stone_k = b;
      } else {
        second = std::min(second, distance);
      }
    }
  }
  const float edge = (second - nearest) * size / 2;
  const float tone = 0.8F + 0.4F * CellValue(stone_i, stone_k, 107);
  const float grain = FractalNoise(uv, size * 0.5F, 6, filter, static_cast<uint32_t>(stone_i * 31 + stone_k) + 109U);
  const Vec3 stone = m.colour * (tone + 0.35F * grain);
  const float rounded = 1 - 0.25F * (1 - Step(0.0F, 0.04F, edge));
  return Lerp(stone * rounded, m.second_colour * 0.7F, LineCover(edge, 0.016F, filter));
}

}  // namespace flair::renderer
