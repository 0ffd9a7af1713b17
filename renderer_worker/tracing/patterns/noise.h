// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "renderer_worker/scene/vector.h"
#include "renderer_worker/tracing/sampling.h"

namespace flair::renderer {

// A number in [0, 1) for a cell of the plane.
inline float CellValue(int x, int y, uint32_t salt) {
  return static_cast<float>(
             Mix(static_cast<uint32_t>(x) * 0x8da6b343U + static_cast<uint32_t>(y) * 0xd8163841U + salt) >> 8) *
         0x1p-24F;
}

// Largest whole number not above `value`, for coordinates of a room.
inline int FloorOf(float value) { return static_cast<int>(std::floor(std::clamp(value, -1e8F, 1e8F))); }

inline float Smooth(float t) { return t * t * (3 - 2 * t); }

// 0 below `low`, 1 above `high`, smooth between.
inline float Step(float low, float high, float value) {
  return Smooth(std::clamp((value - low) / (high - low), 0.0F, 1.0F));
}

inline Vec3 Lerp(Vec3 a, Vec3 b, float share) { return a * (1 - share) + b * share; }

// Smooth noise in [0, 1] with features of size 1.
inline float Noise(float x, float y, uint32_t salt) {
  const int i = FloorOf(x), k = FloorOf(y);
  const float u = Smooth(x - static_cast<float>(i)), v = Smooth(y - static_cast<float>(k));
  const float low = CellValue(i, k, salt) * (1 - u) + CellValue(i + 1, k, salt) * u;
  const float high = CellValue(i, k + 1, salt) * (1 - u) + CellValue(i + 1, k + 1, salt) * u;
  return low * (1 - v) + high * v;
}

// How much is left of features of `size` when seen through a filter of width `filter`.
inline float Kept(float size, float filter) { return std::clamp(2 * size / std::max(filter, 1e-6F) - 1, 0.0F, 1.0F); }

// Noise of several sizes about 0, in [-1, 1], features of `size` and halves of it; what the filter swallows is left
// out.
inline float FractalNoise(Vec2 p, float size, int octaves, float filter, uint32_t salt) {
  float sum = 0, weight = 0.5F;
  for (int i = 0; i < octaves; ++i, size *= 0.5F, weight *= 0.5F) {
    const float kept = Kept(size, filter);
    if (kept <= 0) break;
    sum += kept * weight * (2 * Noise(p.x / size, p.y / size, salt + static_cast<uint32_t>(i) * 977U) - 1);
  }
  return sum;
}

// The share of a filter `filter` wide that lies in a line `line` wide, at `distance` from the line's middle.
inline float LineCover(float distance, float line, float filter) {
  const float half = std::max(filter, 1e-6F) / 2;
  const float low = std::max(-line / 2, distance - half), high = std::min(line / 2, distance + half);
  return std::clamp((high - low) / (2 * half), 0.0F, 1.0F);
}

}  // namespace flair::renderer
