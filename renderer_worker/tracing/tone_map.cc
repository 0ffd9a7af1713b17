// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/tracing/parallel.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/trace_view.h"

namespace flair::renderer {
namespace {

// A filmic curve that leaves colours as they are up to a shoulder, then bends towards white and pales, as film does;
// after the PBR Neutral curve of Khronos (2024), with a gentler shoulder.
Vec3 Filmic(Vec3 c) {
  // Film's slope: shadows a little deeper, what is bright a little brighter.
  constexpr float kPivot = 0.30F, kSlope = 0.16F;
  const float luminance = std::clamp(Luminance(c), 1e-4F, 1.0F);
  c = c * std::pow(luminance / kPivot, kSlope * (1 - luminance));
  constexpr float kShoulder = 0.62F, kPaling = 0.12F;
  const float peak = std::max({c.x, c.y, c.z, 0.0F});
  if (peak <= kShoulder) return c;
  const float room = 1 - kShoulder;
  const float bent = 1 - room * room / (peak + room - kShoulder);
  const float pale = 1 - 1 / (kPaling * (peak - bent) + 1);
  return c * (bent / peak * (1 - pale)) + Vec3{bent, bent, bent} * pale;
}

float ToSrgb(float v) {
  v = std::clamp(v, 0.0F, 1.0F);
  return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
}

// 8-bit sRGB of 4096 steps of the square root, fine enough for every 8-bit step.
const std::array<uint8_t, 4097>& SrgbTable() {
  static const std::array<uint8_t, 4097> table = [] {
    std::array<uint8_t, 4097> made{};
    for (int i = 0; i <= 4096; ++i) {
      const float root = static_cast<float>(i) / 4096;
      made[i] = static_cast<uint8_t>(std::lround(255 * ToSrgb(root * root)));
    }
    return made;
  }();
  return table;
}

}  // namespace

Pixels ToneMapped(const TracedView& view, int thread_count) {
  Pixels pixels{view.width_px, view.height_px, {}};
  pixels.rgb.resize(3 * view.colour.size());
  const auto& table = SrgbTable();
  const absl::Status status = ForEach({thread_count, {}}, view.height_px, [&](int y) {
    const size_t row = static_cast<size_t>(y) * view.width_px;
    for (size_t i = row; i < row + view.width_px; ++i) {
      const Vec3 c = Filmic(view.colour[i]);
      uint8_t* rgb = &pixels.rgb[3 * i];
      for (const float v : {c.x, c.y, c.z}) {
        *rgb++ = table[std::lround(4096 * std::sqrt(std::clamp(v, 0.0F, 1.0F)))];
      }
    }
  });
  status.IgnoreError();  // nobody is asked whether to go on
  return pixels;
}

}  // namespace flair::renderer
