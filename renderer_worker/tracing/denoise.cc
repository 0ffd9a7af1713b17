// SPDX-License-Identifier: GPL-3.0-or-later
// Planes instead of pixels, and loops along rows without branches: the compiler makes vectors of them.
#include "renderer_worker/tracing/denoise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "renderer_worker/tracing/plane.h"

namespace flair::renderer {
namespace {

constexpr int kRounds = 5;
constexpr int kBlock = 256;  // pixels whose sums stay in the nearest cache
constexpr std::array<float, 5> kKernel = {0.0625F, 0.25F, 0.375F, 0.25F, 0.0625F};  // B3 spline
constexpr float kFirstSpreads = 12;  // between near neighbours nearly everything is noise
constexpr float kSpreads = 4;        // differences of so many standard deviations are noise
constexpr float kRelative = 0.012F;  // as are those of this share

// Planes of floats in one piece. Each begins at another place of a page: planes in step would drive each other out of
// the processor's cache.
class Planes {
 public:
  Planes(int plane_count, size_t size) : stride_((size + 1023) / 1024 * 1024 + 80), values_(plane_count * stride_) {}
  float* operator[](int plane) { return &values_[plane * stride_]; }
  const float* operator[](int plane) const { return &values_[plane * stride_]; }
  void Clear() { std::fill(values_.begin(), values_.end(), 0.0F); }

 private:
  size_t stride_;
  Plane<float> values_;
};

// What a pixel's neighbours are judged by: position, normal (0 where nothing is lit), how far off the plane a neighbour
// at one pixel may be (inverse, 1/m), instance (a whole number).
enum Guide { kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kReach, kInstance, kGuideCount };

// What is smoothed, and what tells noise.
enum Light { kRed, kGreen, kBlue, kGlossRed, kGlossGreen, kGlossBlue, kVariance, kLuminance, kLightCount };

// Sums over a row's neighbours: kRed to kVariance as above.
enum Sum { kWeight = kVariance + 1, kGlossWeight, kTolerance, kSumCount };

// Pixels that are brighter than all their neighbours of one instance come down to the brightest of them. Gloss stays as
// it is: where few rays find a window, most of its light would be lost so.
void TameSparks(std::span<const Seen> seen, std::span<const Lit> lit, int width, int height, int y, Planes& to) {
  for (int x = 0; x < width; ++x) {
    const size_t here = static_cast<size_t>(y) * width + x;
    float brightest = 0;
    bool alone = true;
    for (int b = std::max(0, y - 1); b <= std::min(height - 1, y + 1); ++b) {
      for (int a = std::max(0, x - 1); a <= std::min(width - 1, x + 1); ++a) {
        const size_t there = static_cast<size_t>(b) * width + a;
        if (there == here || seen[there].lit_instance != seen[here].lit_instance) continue;
        alone = false;
        brightest = std::max(brightest, Luminance(lit[there].irradiance));
      }
    }
    Vec3 e = lit[here].irradiance;
    const float own = Luminance(e);
    if (!alone && own > brightest) e = e * (brightest / own);
    const Vec3 g = lit[here].gloss;
    to[kRed][here] = e.x, to[kGreen][here] = e.y, to[kBlue][here] = e.z;
    to[kGlossRed][here] = g.x, to[kGlossGreen][here] = g.y, to[kGlossBlue][here] = g.z;
    to[kVariance][here] = lit[here].variance;
    to[kLuminance][here] = Luminance(e);
  }
}

// Wider vectors where the processor has them; every operation rounds alike, so the result is the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FLAIR_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FLAIR_WIDE_VECTORS
#endif

// Adds the variance of the pixels `shift` away, where they are of the same instance.
FLAIR_WIDE_VECTORS void AddVariance(const float* instance, const float* variance, ptrdiff_t shift, int begin, int end,
                                    float* sum, float* weight) {
#pragma GCC ivdep
  for (int x = begin; x < end; ++x) {
    const float same = instance[x + shift] == instance[x] ? 1.0F : 0.0F;
    sum[x] += same * variance[x + shift];
    weight[x] += same;
  }
}

// Inverse of the difference of luminance that noise may make, from the mean variance of 17 pixels of 7 x 7: the few
// samples of one pixel may all have missed what makes its neighbours differ.
void Tolerances(const Planes& guides, const Planes& from, int width, int height, int y, int step, Planes& sums) {
  const size_t row = static_cast<size_t>(y) * width;
  float *inverse = sums[kTolerance], *sum = sums[kRed], *weight = sums[kGreen];
  const auto add = [&](int right, int below) {
    if (y + below < 0 || y + below >= height) return;
    AddVariance(guides[kInstance] + row, from[kVariance] + row, static_cast<ptrdiff_t>(below) * width + right,
                std::max(0, -right), std::min(width, width - right), sum, weight);
  };
  add(0, 0);
  for (const int below : {-3, -1, 1, 3}) {
    for (const int right : {-3, -1, 1, 3}) add(right, below);
  }
  const float* luminance = from[kLuminance] + row;
  const float spreads = step <= 2 ? kFirstSpreads : kSpreads;
  for (int x = 0; x < width; ++x) {
    inverse[x] = 1 / (spreads * std::sqrt(sum[x] / weight[x]) + kRelative * luminance[x] + 1e-4F);
    sum[x] = weight[x] = 0;
  }
}

// Adds the neighbours `shift` pixels right of and `rows` below the pixels [begin, end) of row y.
FLAIR_WIDE_VECTORS void AddNeighbours(const Planes& g, const Planes& from, size_t row, ptrdiff_t shift, int begin,
                                      int end, float kernel, float per_step, Planes& sums) {
  const size_t other = row + static_cast<size_t>(shift);
  const float *x0 = g[kX] + row, *y0 = g[kY] + row, *z0 = g[kZ] + row;
  const float *x1 = g[kX] + other, *y1 = g[kY] + other, *z1 = g[kZ] + other;
  const float *nx0 = g[kNormalX] + row, *ny0 = g[kNormalY] + row, *nz0 = g[kNormalZ] + row;
  const float *nx1 = g[kNormalX] + other, *ny1 = g[kNormalY] + other, *nz1 = g[kNormalZ] + other;
  const float *reach = g[kReach] + row, *i0 = g[kInstance] + row, *i1 = g[kInstance] + other;
  const float *l0 = from[kLuminance] + row, *l1 = from[kLuminance] + other, *v1 = from[kVariance] + other;
  const float *r = from[kRed] + other, *gr = from[kGreen] + other, *b = from[kBlue] + other;
  const float *gloss_r = from[kGlossRed] + other, *gloss_g = from[kGlossGreen] + other,
              *gloss_b = from[kGlossBlue] + other;
  float *sr = sums[kRed], *sg = sums[kGreen], *sb = sums[kBlue];
  float *tr = sums[kGlossRed], *tg = sums[kGlossGreen], *tb = sums[kGlossBlue];
  float *sv = sums[kVariance], *sw = sums[kWeight], *tw = sums[kGlossWeight];
  const float* inverse = sums[kTolerance];
#pragma GCC ivdep
  for (int i = begin; i < end; ++i) {
    const float cosine = nx0[i] * nx1[i] + ny0[i] * ny1[i] + nz0[i] * nz1[i];
    const float c1 = cosine > 0.5F ? cosine : 0.0F, c2 = c1 * c1, c4 = c2 * c2, c8 = c4 * c4;
    const float off = nx0[i] * (x1[i] - x0[i]) + ny0[i] * (y1[i] - y0[i]) + nz0[i] * (z1[i] - z0[i]);
    const float beside = std::fabs(off) * reach[i] * per_step;
    const float differs = std::fabs(l1[i] - l0[i]) * inverse[i] + beside;
    // Close to exp(-x), and cheap. Gloss is smooth by nature: only its surface's edges stop it.
    const float f1 = 1 - 0.25F * differs, f = f1 > 0.06F ? f1 : 0.0F, f2 = f * f;
    const float h1 = 1 - 0.25F * beside, h = h1 > 0.06F ? h1 : 0.0F, h2 = h * h;
    const float same = (i0[i] == i1[i] ? kernel : 0.0F) * c8 * c8;
    const float w = same * f2 * f2, v = same * h2 * h2;
    sr[i] += w * r[i];
    sg[i] += w * gr[i];
    sb[i] += w * b[i];
    tr[i] += v * gloss_r[i];
    tg[i] += v * gloss_g[i];
    tb[i] += v * gloss_b[i];
    sv[i] += w * w * v1[i];
    sw[i] += w;
    tw[i] += v;
  }
}

void SmoothRow(const Planes& guides, const Planes& from, int width, int height, int y, int step, Planes& to) {
  Planes sums(kSumCount, width);
  sums.Clear();
  Tolerances(guides, from, width, height, y, step, sums);
  const size_t row = static_cast<size_t>(y) * width;
  for (int block = 0; block < width; block += kBlock) {
    for (int j = -2; j <= 2; ++j) {
      if (y + j * step < 0 || y + j * step >= height) continue;
      for (int i = -2; i <= 2; ++i) {
        const int right = i * step;
        const int begin = std::max(block, -right), end = std::min({block + kBlock, width, width - right});
        if (begin >= end) continue;
        AddNeighbours(guides, from, row, static_cast<ptrdiff_t>(j) * step * width + right, begin, end,
                      kKernel[i + 2] * kKernel[j + 2], 1 / static_cast<float>(step), sums);
      }
    }
  }
  for (int x = 0; x < width; ++x) {
    const float weight = sums[kWeight][x], gloss_weight = sums[kGlossWeight][x];
    const float scale = weight > 0 ? 1 / weight : 0, gloss_scale = gloss_weight > 0 ? 1 / gloss_weight : 0;
    for (int k = kRed; k <= kBlue; ++k) to[k][row + x] = weight > 0 ? sums[k][x] * scale : from[k][row + x];
    for (int k = kGlossRed; k <= kGlossBlue; ++k) to[k][row + x] = sums[k][x] * gloss_scale;
    to[kVariance][row + x] = sums[kVariance][x] * scale * scale;
    to[kLuminance][row + x] = Luminance({to[kRed][row + x], to[kGreen][row + x], to[kBlue][row + x]});
  }
}

void FillGuides(std::span<const Seen> seen, float pixel_rad, size_t begin, size_t end, Planes& g) {
  for (size_t i = begin; i < end; ++i) {
    const Seen& s = seen[i];
    const bool lit = s.lit_instance != -1;
    const Vec3 position = lit ? s.position : Vec3{}, normal = lit ? s.normal : Vec3{};
    g[kX][i] = position.x, g[kY][i] = position.y, g[kZ][i] = position.z;
    g[kNormalX][i] = normal.x, g[kNormalY][i] = normal.y, g[kNormalZ][i] = normal.z;
    g[kReach][i] = lit ? 1 / std::max(1e-4F, s.distance * pixel_rad * 1.5F) : 0;
    g[kInstance][i] = static_cast<float>(s.lit_instance);
  }
}

}  // namespace

absl::Status SmoothLight(int width, int height, float pixel_rad, std::span<const Seen> seen, const Workers& workers,
                         std::span<Lit> lit) {
  Planes guides(kGuideCount, lit.size()), from(kLightCount, lit.size()), to(kLightCount, lit.size());
  absl::Status prepared = ForEach(workers, height, [&](int y) {
    const size_t row = static_cast<size_t>(y) * width;
    FillGuides(seen, pixel_rad, row, row + width, guides);
    TameSparks(seen, lit, width, height, y, from);
  });
  if (!prepared.ok()) return prepared;
  for (int round = 0; round < kRounds; ++round) {
    absl::Status status =
        ForEach(workers, height, [&](int y) { SmoothRow(guides, from, width, height, y, 1 << round, to); });
    if (!status.ok()) return status;
    std::swap(from, to);
  }
  return ForEach(workers, height, [&](int y) {
    const size_t row = static_cast<size_t>(y) * width;
    for (size_t i = row; i < row + width; ++i) {
      lit[i].irradiance = {from[kRed][i], from[kGreen][i], from[kBlue][i]};
      lit[i].gloss = {from[kGlossRed][i], from[kGlossGreen][i], from[kGlossBlue][i]};
    }
  });
}

}  // namespace flair::renderer
