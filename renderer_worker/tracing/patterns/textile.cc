// SPDX-License-Identifier: GPL-3.0-or-later
// Carpet and cloth: `colour` and `second_colour` are those of the threads.
#include "renderer_worker/tracing/patterns/noise.h"
#include "renderer_worker/tracing/patterns/pattern.h"

namespace flair::renderer {

// Tufts, and the soft patches that feet leave in the pile.
Vec3 CarpetColour(const Material& m, Vec2 uv, float filter) {
  const float tuft = std::clamp(m.pattern_size_m, 0.004F, 0.03F);
  const float tufts = FractalNoise(uv, tuft, 2, filter, 131);
  const float pile = FractalNoise(uv, 0.5F, 3, filter, 137);
  return Lerp(m.colour, m.second_colour, std::clamp(0.3F + 0.9F * tufts + 0.25F * pile, 0.0F, 1.0F));
}

// Threads over and under, a little uneven.
Vec3 FabricColour(const Material& m, Vec2 uv, float filter) {
  const float thread = std::clamp(m.pattern_size_m, 0.002F, 0.02F);
  const float kept = Kept(thread, filter);
  const float slub =
      FractalNoise({uv.x, uv.y * 6}, 0.06F, 2, filter, 149) + FractalNoise({uv.x * 6, uv.y}, 0.06F, 2, filter, 151);
  float weave = 0.5F;
  if (kept > 0) {
    const int i = FloorOf(uv.x / thread), k = FloorOf(uv.y / thread);
    const float x = uv.x / thread - static_cast<float>(i) - 0.5F, y = uv.y / thread - static_cast<float>(k) - 0.5F;
    const float bulge = ((i + k) & 1) == 0 ? 1 - 4 * x * x : 1 - 4 * y * y;
    weave = 0.5F + kept * (0.75F - bulge);
  }
  return Lerp(m.colour, m.second_colour, std::clamp(weave * 0.6F + 0.2F * slub, 0.0F, 1.0F));
}

}  // namespace flair::renderer
