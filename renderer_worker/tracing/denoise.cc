// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/denoise.h"

#include <algorithm>
#include <cmath>

namespace flair::renderer {
namespace {

constexpr int kRounds = 5;
constexpr float kKernel[3] = {0.375F, 0.25F, 0.0625F};  // B3 spline: distances 0, 1, 2

// What a pixel's neighbours are judged by.
struct Guide {
  Vec3 position;
  float reach = 0;  // how far off the plane a neighbour at one pixel may be, metres; 0: not lit
  Vec3 normal;
  int instance = 0;
};

// Variance of a pixel as the mean of its surroundings: a few samples alone say little.
float SteadyVariance(const std::vector<Lit>& lit, const std::vector<Guide>& guides, int width, int height, int x,
                     int y) {
  float sum = 0, weight = 0;
  const Guide& here = guides[static_cast<size_t>(y) * width + x];
  for (int b = std::max(0, y - 1); b <= std::min(height - 1, y + 1); ++b) {
    for (int a = std::max(0, x - 1); a <= std::min(width - 1, x + 1); ++a) {
      const size_t at = static_cast<size_t>(b) * width + a;
      if (guides[at].instance != here.instance) continue;
      sum += lit[at].variance;
      weight += 1;
    }
  }
  return weight > 0 ? sum / weight : 0;
}

// Close to exp(-x) for x >= 0, and cheap.
float Falloff(float x) {
  const float y = std::max(0.0F, 1 - x * 0.25F);
  const float y2 = y * y;
  return y2 * y2;
}

void SmoothPixel(const std::vector<Lit>& from, const std::vector<Guide>& guides, int width, int height, int x, int y,
                 int step, float tolerance, Lit& to) {
  const size_t here = static_cast<size_t>(y) * width + x;
  const Guide& guide = guides[here];
  const Lit& centre = from[here];
  if (guide.reach <= 0) {
    to = centre;
    return;
  }
  const float luminance = Luminance(centre.irradiance);
  const float inverse = 1 / tolerance, plane = 1 / (guide.reach * static_cast<float>(step));
  Vec3 irradiance, gloss;
  float variance = 0, weight = 0;
  for (int j = -2; j <= 2; ++j) {
    const int b = y + j * step;
    if (b < 0 || b >= height) continue;
    for (int i = -2; i <= 2; ++i) {
      const int a = x + i * step;
      if (a < 0 || a >= width) continue;
      const size_t there = static_cast<size_t>(b) * width + a;
      const Guide& other = guides[there];
      if (other.instance != guide.instance || other.reach <= 0) continue;
      const float cosine = Dot(guide.normal, other.normal);
      if (cosine < 0.5F) continue;
      const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4, c16 = c8 * c8;
      const float off = std::abs(Dot(guide.normal, other.position - guide.position)) * plane;
      const float differs = std::abs(Luminance(from[there].irradiance) - luminance) * inverse;
      const float w = kKernel[std::abs(i)] * kKernel[std::abs(j)] * c16 * Falloff(off + differs);
      irradiance = irradiance + from[there].irradiance * w;
      gloss = gloss + from[there].gloss * w;
      variance += from[there].variance * w * w;
      weight += w;
    }
  }
  const float scale = 1 / weight;
  to = {irradiance * scale, variance * scale * scale, gloss * scale};
}

}  // namespace

absl::Status SmoothLight(int width, int height, float pixel_rad, const std::vector<Seen>& seen, const Workers& workers,
                         std::vector<Lit>& lit) {
  std::vector<Guide> guides(seen.size());
  absl::Status status = ForEach(workers, height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const size_t at = static_cast<size_t>(y) * width + x;
      const Seen& s = seen[at];
      Guide& guide = guides[at];
      guide.instance = s.lit_instance;
      if (s.lit_instance == -1) continue;
      guide.position = s.position;
      guide.normal = s.normal;
      guide.reach = std::max(1e-4F, s.distance * pixel_rad * 1.5F);
    }
  });
  if (!status.ok()) return status;
  std::vector<Lit> other(lit.size());
  std::vector<float> tolerance(lit.size());
  for (int round = 0; round < kRounds; ++round) {
    status = ForEach(workers, height, [&](int y) {
      for (int x = 0; x < width; ++x) {
        const size_t at = static_cast<size_t>(y) * width + x;
        const float spread = std::sqrt(SteadyVariance(lit, guides, width, height, x, y));
        const float tolerance_here = 3.0F * spread + 0.01F * Luminance(lit[at].irradiance) + 1e-4F;
        SmoothPixel(lit, guides, width, height, x, y, 1 << round, tolerance_here, other[at]);
      }
    });
    if (!status.ok()) return status;
    std::swap(lit, other);
  }
  return absl::OkStatus();
}

}  // namespace flair::renderer
