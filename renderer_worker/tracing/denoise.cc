// SPDX-License-Identifier: GPL-3.0-or-later
// Planes instead of pixels, and loops along rows without branches: the compiler makes vectors of them.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/sampling.h"

namespace flair::renderer {
namespace {

constexpr int kBlock = 256;  // pixels whose sums stay in the nearest cache
// Across, of the first round and of the others, which are less wide: what they blend has been smoothed.
constexpr std::array<float, 5> kFirstKernel = {0.0625F, 0.25F, 0.375F, 0.25F, 0.0625F};  // B3 spline
constexpr std::array<float, 3> kKernel = {0.3F, 0.4F, 0.3F};
constexpr float kSpark = 1.5F;       // so many times as bright as all its neighbours but one
constexpr float kFirstSpreads = 12;  // between near neighbours nearly everything is noise
constexpr float kSpreads = 4;        // differences of so many standard deviations are noise
constexpr float kRelative = 0.012F;  // as are those of this share

// Sums over a row's neighbours: kRed to kVariance of Light, then these.
enum Sum { kWeight = kVariance + 1, kTolerance, kSumCount };

// Calls visit(at) for the points of the instance at (x, y) among those of the 3 x 3 about it.
template <typename Visit>
void AboutPoint(const LightGrid& grid, int x, int y, const Visit& visit) {
  const float* instance = grid.guides[kInstance];
  const float own = instance[static_cast<size_t>(y) * grid.width + x];
  for (int b = std::max(0, y - 1); b <= std::min(grid.height - 1, y + 1); ++b) {
    for (int a = std::max(0, x - 1); a <= std::min(grid.width - 1, x + 1); ++a) {
      const size_t at = static_cast<size_t>(b) * grid.width + a;
      if (instance[at] == own) visit(at);
    }
  }
}

// For each point of a row the share of its light that each of the 3 x 3 gets: 0 where it is no spark.
void FindSparks(const LightGrid& grid, int y, float* share) {
  const float* luminance = grid.light[kLuminance];
  for (int x = 0; x < grid.width; ++x) {
    const size_t here = static_cast<size_t>(y) * grid.width + x;
    float brightest = 0, second = 0, count = 0;
    AboutPoint(grid, x, y, [&](size_t there) {
      count += 1;
      if (there == here) return;
      second = std::max(second, std::min(brightest, luminance[there]));
      brightest = std::max(brightest, luminance[there]);
    });
    const float own = luminance[here];
    share[here] = count > 2 && own > kSpark * second ? (1 - second / own) / count : 0;
  }
}

void SpreadRow(const LightGrid& grid, const float* share, int y, Planes& to) {
  for (int x = 0; x < grid.width; ++x) {
    const size_t here = static_cast<size_t>(y) * grid.width + x;
    float count = 0, kept = 1;
    if (share[here] > 0) {
      AboutPoint(grid, x, y, [&](size_t) { count += 1; });
      kept = 1 - share[here] * count;
    }
    for (int k = kRed; k <= kBlue; ++k) to[k][here] = grid.light[k][here] * kept;
    AboutPoint(grid, x, y, [&](size_t there) {
      if (share[there] <= 0) return;
      for (int k = kRed; k <= kBlue; ++k) to[k][here] += grid.light[k][there] * share[there];
    });
    to[kVariance][here] = grid.light[kVariance][here];
    to[kLuminance][here] = Luminance({to[kRed][here], to[kGreen][here], to[kBlue][here]});
  }
}

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
void Tolerances(const LightGrid& grid, const Planes& from, int y, int step, Planes& sums) {
  const size_t row = static_cast<size_t>(y) * grid.width;
  float *inverse = sums[kTolerance], *sum = sums[kRed], *weight = sums[kGreen];
  const auto add = [&](int right, int below) {
    if (y + below < 0 || y + below >= grid.height) return;
    AddVariance(grid.guides[kInstance] + row, from[kVariance] + row, static_cast<ptrdiff_t>(below) * grid.width + right,
                std::max(0, -right), std::min(grid.width, grid.width - right), sum, weight);
  };
  add(0, 0);
  for (const int below : {-3, -1, 1, 3}) {
    for (const int right : {-3, -1, 1, 3}) add(right, below);
  }
  const float* luminance = from[kLuminance] + row;
  const float spreads = step <= 2 ? kFirstSpreads : kSpreads;
  for (int x = 0; x < grid.width; ++x) {
    inverse[x] = 1 / (spreads * std::sqrt(sum[x] / weight[x]) + kRelative * luminance[x] + 1e-4F);
    sum[x] = weight[x] = 0;
  }
}

// The guides of a row, from its first point on.
struct GuideRow {
  GuideRow(const Planes& g, size_t at)
      : x(g[kX] + at),
        y(g[kY] + at),
        z(g[kZ] + at),
        normal_x(g[kNormalX] + at),
        normal_y(g[kNormalY] + at),
        normal_z(g[kNormalZ] + at),
        reach(g[kReach] + at),
        instance(g[kInstance] + at) {}
  const float *x, *y, *z, *normal_x, *normal_y, *normal_z, *reach, *instance;
};

// What the surfaces of two points say of how much one counts for the other: a power of the normals' cosine, 0 between
// instances, and how far the other is off the plane of the first.
struct Likeness {
  float turn, beside;
};

[[gnu::always_inline]] inline Likeness LikenessOf(const GuideRow& a, const GuideRow& b, int i, float per_step) {
  const float cosine = a.normal_x[i] * b.normal_x[i] + a.normal_y[i] * b.normal_y[i] + a.normal_z[i] * b.normal_z[i];
  const float c1 = cosine > 0.5F ? cosine : 0.0F, c2 = c1 * c1, c4 = c2 * c2, c8 = c4 * c4;
  const float off =
      a.normal_x[i] * (b.x[i] - a.x[i]) + a.normal_y[i] * (b.y[i] - a.y[i]) + a.normal_z[i] * (b.z[i] - a.z[i]);
  return {a.instance[i] == b.instance[i] ? c8 * c8 : 0.0F, std::fabs(off) * a.reach[i] * per_step};
}

// Close to exp(-x), and cheap.
[[gnu::always_inline]] inline float Fading(float x) {
  const float f1 = 1 - 0.25F * x, f = f1 > 0.06F ? f1 : 0.0F, f2 = f * f;
  return f2 * f2;
}

// Adds the light of the points [begin, end) of row `there` to those of row `here`.
FLAIR_WIDE_VECTORS void AddLight(const Planes& guides, const Planes& from, size_t here, size_t there, int begin,
                                 int end, float kernel, float per_step, Planes& sums) {
  const GuideRow a(guides, here), b(guides, there);
  const float *l0 = from[kLuminance] + here, *l1 = from[kLuminance] + there, *v1 = from[kVariance] + there;
  const float *red = from[kRed] + there, *green = from[kGreen] + there, *blue = from[kBlue] + there;
  float *sr = sums[kRed], *sg = sums[kGreen], *sb = sums[kBlue], *sv = sums[kVariance], *sw = sums[kWeight];
  const float* inverse = sums[kTolerance];
#pragma GCC ivdep
  for (int i = begin; i < end; ++i) {
    const Likeness like = LikenessOf(a, b, i, per_step);
    const float w = kernel * like.turn * Fading(std::fabs(l1[i] - l0[i]) * inverse[i] + like.beside);
    sr[i] += w * red[i];
    sg[i] += w * green[i];
    sb[i] += w * blue[i];
    sv[i] += w * w * v1[i];
    sw[i] += w;
  }
}

// The same of what is mirrored, planes 0 to 2; plane 3 of the sums is the weight.
FLAIR_WIDE_VECTORS void AddGloss(const Planes& guides, const Planes& from, size_t here, size_t there, int begin,
                                 int end, float kernel, float per_step, Planes& sums) {
  const GuideRow a(guides, here), b(guides, there);
  const float *red = from[0] + there, *green = from[1] + there, *blue = from[2] + there;
  float *sr = sums[0], *sg = sums[1], *sb = sums[2], *sw = sums[3];
#pragma GCC ivdep
  for (int i = begin; i < end; ++i) {
    const Likeness like = LikenessOf(a, b, i, per_step);
    const float w = kernel * like.turn * Fading(like.beside);
    sr[i] += w * red[i];
    sg[i] += w * green[i];
    sb[i] += w * blue[i];
    sw[i] += w;
  }
}

// Adds the neighbours, `step` apart, of all points of row y.
void AddNeighbours(decltype(AddLight)& add, const LightGrid& grid, const Planes& from, int y, int step, Planes& sums) {
  const size_t row = static_cast<size_t>(y) * grid.width;
  const std::span<const float> kernel = step == 1 ? std::span<const float>(kFirstKernel) : kKernel;
  const int radius = static_cast<int>(kernel.size() / 2);
  for (int block = 0; block < grid.width; block += kBlock) {
    for (int j = -radius; j <= radius; ++j) {
      if (y + j * step < 0 || y + j * step >= grid.height) continue;
      for (int i = -radius; i <= radius; ++i) {
        const int right = i * step;
        const int begin = std::max(block, -right), end = std::min({block + kBlock, grid.width, grid.width - right});
        if (begin >= end) continue;
        const ptrdiff_t shift = static_cast<ptrdiff_t>(j) * step * grid.width + right;
        add(grid.guides, from, row, row + static_cast<size_t>(shift), begin, end,
            kernel[i + radius] * kernel[j + radius], 1 / static_cast<float>(step), sums);
      }
    }
  }
}

void SmoothLightRow(const LightGrid& grid, const Planes& from, int y, int step, Planes& to) {
  Planes sums(kSumCount, grid.width);
  sums.Clear();
  Tolerances(grid, from, y, step, sums);
  AddNeighbours(AddLight, grid, from, y, step, sums);
  const size_t row = static_cast<size_t>(y) * grid.width;
  for (int x = 0; x < grid.width; ++x) {
    const float weight = sums[kWeight][x], scale = weight > 0 ? 1 / weight : 0;
    for (int k = kRed; k <= kBlue; ++k) to[k][row + x] = weight > 0 ? sums[k][x] * scale : from[k][row + x];
    to[kVariance][row + x] = sums[kVariance][x] * scale * scale;
    to[kLuminance][row + x] = Luminance({to[kRed][row + x], to[kGreen][row + x], to[kBlue][row + x]});
  }
}

void SmoothGlossRow(const LightGrid& grid, const Planes& from, int y, int step, Planes& to) {
  Planes sums(4, grid.width);
  sums.Clear();
  AddNeighbours(AddGloss, grid, from, y, step, sums);
  const size_t row = static_cast<size_t>(y) * grid.width;
  for (int x = 0; x < grid.width; ++x) {
    const float weight = sums[3][x], scale = weight > 0 ? 1 / weight : 0;
    for (int k = 0; k < 3; ++k) to[k][row + x] = sums[k][x] * scale;
  }
}

}  // namespace

absl::Status SpreadSparks(const runtime::Workers& workers, LightGrid& grid, Planes& scratch) {
  Plane<float> share(grid.size());
  absl::Status status = runtime::ForEach(workers, grid.height, [&](int y) { FindSparks(grid, y, share.data()); });
  if (!status.ok()) return status;
  status = runtime::ForEach(workers, grid.height, [&](int y) { SpreadRow(grid, share.data(), y, scratch); });
  std::swap(grid.light, scratch);
  return status;
}

absl::Status SmoothLight(const runtime::Workers& workers, int round_count, LightGrid& grid, Planes& scratch) {
  absl::Status status;
  for (int round = 0; round < round_count && status.ok(); ++round) {
    status = runtime::ForEach(workers, grid.height,
                              [&](int y) { SmoothLightRow(grid, grid.light, y, 1 << round, scratch); });
    std::swap(grid.light, scratch);
  }
  return status;
}

absl::Status SmoothGloss(const runtime::Workers& workers, int round_count, const LightGrid& grid, Planes& gloss) {
  Planes to(3, grid.size());
  absl::Status status;
  for (int round = 0; round < round_count && status.ok(); ++round) {
    status = runtime::ForEach(workers, grid.height, [&](int y) { SmoothGlossRow(grid, gloss, y, 1 << round, to); });
    std::swap(gloss, to);
  }
  return status;
}

}  // namespace flair::renderer
