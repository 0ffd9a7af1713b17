// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "renderer_worker/scene/mesh.h"

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
  x = __builtin_bswap32(x);
  x = ((x & 0x0f0f0f0fU) << 4) | ((x & 0xf0f0f0f0U) >> 4);
  x = ((x & 0x33333333U) << 2) | ((x & 0xccccccccU) >> 2);
  return ((x & 0x55555555U) << 1) | ((x & 0xaaaaaaaaU) >> 1);
}

// Owen's scrambling of a number whose bits are reversed, by a hash of all lower bits (Laine and Karras 2011, constants
// of Burley 2020).
inline uint32_t ScrambleReversed(uint32_t x, uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1;
  x ^= x * 0x05526c56U;
  return x ^ (x * 0x53a22864U);
}

// The second dimension of Sobol's sequence, bits reversed: Pascal's triangle modulo 2, a factor a line.
inline uint32_t SobolSecondReversed(uint32_t index) {
  index ^= (index >> 1) & 0x55555555U;
  index ^= (index >> 2) & 0x33333333U;
  index ^= (index >> 4) & 0x0f0f0f0fU;
  index ^= (index >> 8) & 0x00ff00ffU;
  return index ^ (index >> 16);
}

inline uint32_t SpreadBits(uint32_t x) {
  x &= 0xffffU;
  x = (x | (x << 8)) & 0x00ff00ffU;
  x = (x | (x << 4)) & 0x0f0f0f0fU;
  x = (x | (x << 2)) & 0x33333333U;
  return (x | (x << 1)) & 0x55555555U;
}

// What a sampled point is for; each has points of its own.
enum class Purpose { kLight, kPlaceOnLight, kSun, kBounce, kGloss, kMoreLight, kMorePlaces, kMoreSun, kCount };

// Scrambles of a picture.
class SampleSeeds {
 public:
  explicit SampleSeeds(uint32_t seed) {
    for (uint32_t i = 0; i < seeds.size(); ++i) {
      const uint32_t of_purpose = Mix(seed + 0x9e3779b9U * (i + 1));
      seeds[i] = {of_purpose, Mix(of_purpose ^ 0x68bc21ebU), Mix(of_purpose ^ 0x02e5be93U)};
    }
  }
  struct Triple {
    uint32_t order, x, y;
  };
  std::array<Triple, static_cast<size_t>(Purpose::kCount)> seeds;
};

// Points of the plane's (0, 2)-sequence of Sobol, numbered along the picture's Z-curve so that pixels which are
// smoothed together complement each other (Ahmed and Wonka 2020). A function of its arguments alone; borrows the seeds.
class PixelSamples {
 public:
  PixelSamples(const SampleSeeds& seeds, int x, int y, int sample_count)
      : seeds_(&seeds),
        first_((SpreadBits(static_cast<uint32_t>(x)) | (SpreadBits(static_cast<uint32_t>(y)) << 1)) *
               static_cast<uint32_t>(sample_count)) {}

  // Both in [0, 1).
  [[gnu::always_inline]] Vec2 At(int sample, Purpose purpose) const {
    const SampleSeeds::Triple& seed = seeds_->seeds[static_cast<size_t>(purpose)];
    const uint32_t index =
        ReverseBits(ScrambleReversed(ReverseBits(first_ + static_cast<uint32_t>(sample)), seed.order));
    const uint32_t x = ReverseBits(ScrambleReversed(index, seed.x));
    const uint32_t y = ReverseBits(ScrambleReversed(SobolSecondReversed(index), seed.y));
    constexpr float kUnit = 0x1p-24F;
    return {static_cast<float>(x >> 8) * kUnit, static_cast<float>(y >> 8) * kUnit};
  }

 private:
  const SampleSeeds* seeds_;
  uint32_t first_;
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

inline float FifthPower(float x) { return x * x * (x * x) * x; }

inline float Luminance(Vec3 c) { return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z; }

}  // namespace flair::renderer
