// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "renderer_worker/scene/vector.h"

namespace flair::renderer {

// A hash of 32 bits in which every bit of the result depends on every bit of the argument.
inline uint32_t Mix(uint32_t x) {
  x ^= x >> 16;
  x *= 0x21f0aaadU;
  x ^= x >> 15;
  x *= 0xd35a2d97U;
  return x ^ (x >> 15);
}

inline uint32_t ReverseBits(uint32_t x) {
  x = (x << 16) | (x >> 16);
  x = ((x & 0x00ff00ffU) << 8) | ((x & 0xff00ff00U) >> 8);
  x = ((x & 0x0f0f0f0fU) << 4) | ((x & 0xf0f0f0f0U) >> 4);
  x = ((x & 0x33333333U) << 2) | ((x & 0xccccccccU) >> 2);
  return ((x & 0x55555555U) << 1) | ((x & 0xaaaaaaaaU) >> 1);
}

// Owen's scrambling by a hash of all higher bits (Laine and Karras 2011, as Burley 2020 improved it).
inline uint32_t OwenScramble(uint32_t x, uint32_t seed) {
  x = ReverseBits(x);
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return ReverseBits(x);
}

inline uint32_t SpreadBits(uint32_t x) {
  x &= 0xffffU;
  x = (x | (x << 8)) & 0x00ff00ffU;
  x = (x | (x << 4)) & 0x0f0f0f0fU;
  x = (x | (x << 2)) & 0x33333333U;
  return (x | (x << 1)) & 0x55555555U;
}

// Points of the plane's (0, 2)-sequence of Sobol, numbered along the picture's Z-curve so that pixels which are
// smoothed together complement each other (Ahmed and Wonka 2020). A function of its arguments alone.
class PixelSamples {
 public:
  PixelSamples(int x, int y, int sample_count, uint32_t seed)
      : first_((SpreadBits(static_cast<uint32_t>(x)) | (SpreadBits(static_cast<uint32_t>(y)) << 1)) *
               static_cast<uint32_t>(sample_count)),
        seed_(seed) {}

  // Both in [0, 1). `dimension` numbers what the point is for.
  Vec2 At(int sample, int dimension) const {
    const uint32_t seed = Mix(seed_ + 0x9e3779b9U * static_cast<uint32_t>(dimension + 1));
    const uint32_t index = OwenScramble(first_ + static_cast<uint32_t>(sample), seed);
    uint32_t second = 0;
    for (uint32_t rest = index, v = 1U << 31; rest != 0; rest >>= 1, v ^= v >> 1) {
      if ((rest & 1) != 0) second ^= v;
    }
    const uint32_t x = OwenScramble(ReverseBits(index), Mix(seed ^ 0x68bc21ebU));
    const uint32_t y = OwenScramble(second, Mix(seed ^ 0x02e5be93U));
    constexpr float kUnit = 0x1p-24F;
    return {static_cast<float>(x >> 8) * kUnit, static_cast<float>(y >> 8) * kUnit};
  }

 private:
  uint32_t first_;
  uint32_t seed_;
};

// Two unit vectors that are right-angled to `n` (unit) and to each other (Duff et al. 2017).
inline void Basis(Vec3 n, Vec3& s, Vec3& t) {
  const float sign = std::copysign(1.0F, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
  s = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  t = {b, sign + n.y * n.y * a, -n.y};
}

// A direction about `n`, as likely as its cosine.
inline Vec3 CosineDirection(Vec3 n, Vec2 sample) {
  const float radius = std::sqrt(sample.x), angle = 2 * std::numbers::pi_v<float> * sample.y;
  Vec3 s, t;
  Basis(n, s, t);
  return s * (radius * std::cos(angle)) + t * (radius * std::sin(angle)) + n * std::sqrt(std::max(0.0F, 1 - sample.x));
}

// Uniform over the unit disc, neighbours stay neighbours.
inline Vec2 DiscPoint(Vec2 sample) {
  const float radius = std::sqrt(sample.x), angle = 2 * std::numbers::pi_v<float> * sample.y;
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

inline float Luminance(Vec3 c) { return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z; }

}  // namespace flair::renderer
