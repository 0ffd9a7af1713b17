// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/trace_view.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr int kEdgeLooks = 6;
constexpr float kMostUnlike = 6;                                           // points of a surface about a look at it
constexpr float kSameTurn = 0.93F, kSameDepth = 0.02F, kSameGlow = 0.02F;  // of neighbours that show one surface
constexpr double kWhite = 1.0;          // what a white surface in mean light comes to
constexpr double kWhiteBalance = 0.65;  // how much of the light's colour is taken out
constexpr double kUsualAlbedo = 0.42;   // of a room in common colours
constexpr double kAdaptation = 0.35;    // how far the eye gets used to darker or lighter ones

// Light on bare ground beside the model, which its backdrop shall keep the colour of.
float BareGroundLight(const Lights& lights) {
  float sky = 0;
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    const float height = std::sqrt((static_cast<float>(i) + 0.5F) / kSteps);
    sky += Luminance(lights.SkyRadiance({std::sqrt(1 - height * height), 0, height})) / kSteps;
  }
  return sky + Luminance(lights.sun_irradiance) * std::max(0.0F, lights.sun_direction.z) / std::numbers::pi_v<float>;
}

// Sets those of the pixels [begin, end) of the row from `here` on that show something else than those from `there` on.
FLAIR_WIDE_VECTORS void MarkEdges(const Frame& frame, const TracedView& view, size_t here, size_t there, int begin,
                                  int end, int* edge) {
  const Planes& guides = frame.direct.guides;
  const Vec3 *a0 = frame.added.data() + here, *a1 = frame.added.data() + there;
  const float *l0 = guides[kInstance] + here, *l1 = guides[kInstance] + there;
  const float *x0 = guides[kNormalX] + here, *x1 = guides[kNormalX] + there;
  const float *y0 = guides[kNormalY] + here, *y1 = guides[kNormalY] + there;
  const float *z0 = guides[kNormalZ] + here, *z1 = guides[kNormalZ] + there;
  const float *d0 = view.depth_m.data() + here, *d1 = view.depth_m.data() + there;
  const int32_t *i0 = view.instance.data() + here, *i1 = view.instance.data() + there;
#pragma GCC ivdep
  for (int i = begin; i < end; ++i) {
    const int turned = x0[i] * x1[i] + y0[i] * y1[i] + z0[i] * z1[i] < kSameTurn ? 1 : 0;
    const int beside = std::fabs(d1[i] - d0[i]) > kSameDepth * d0[i] ? 1 : 0;
    const int other = (i0[i] != i1[i] ? 1 : 0) | (l0[i] != l1[i] ? 1 : 0);
    const int brighter = std::fabs(a1[i].y - a0[i].y) > kSameGlow ? 1 : 0;
    // What is beyond has no normal, and the ground no end.
    edge[i] |= other | brighter | ((i0[i] != 0 && l0[i] != -1 ? 1 : 0) & (turned | beside));
  }
}

// What falls on a surface, and what it mirrors to the eye.
struct Lit {
  Vec3 irradiance;
  Vec3 gloss;
};

// How little a point of a grid is like what is seen, in pixels: 0 where it is the same.
float Unlikeness(const LightGrid& grid, size_t at, const Seen& seen, float pixel) {
  const Planes& g = grid.guides;
  const Vec3 way = Vec3{g[kX][at], g[kY][at], g[kZ][at]} - seen.position;
  const float turn =
      g[kNormalX][at] * seen.normal.x + g[kNormalY][at] * seen.normal.y + g[kNormalZ][at] * seen.normal.z;
  return std::abs(Dot(way, seen.normal)) / pixel + 0.2F * Length(way) / pixel + 8 * (1 - turn);
}

// The point of a grid within [left, right] x [top, bottom] that shows the surface seen; -1 where none does.
int64_t SameSurface(const LightGrid& grid, const Seen& seen, float pixel, int left, int right, int top, int bottom) {
  int64_t found = -1;
  float least = kMostUnlike;
  const float instance = static_cast<float>(seen.lit_instance);
  for (int y = std::max(0, top); y <= std::min(grid.height - 1, bottom); ++y) {
    for (int x = std::max(0, left); x <= std::min(grid.width - 1, right); ++x) {
      const size_t at = static_cast<size_t>(y) * grid.width + x;
      if (grid.guides[kInstance][at] != instance) continue;
      const float differs = Unlikeness(grid, at, seen, pixel);
      if (differs < least) least = differs, found = static_cast<int64_t>(at);
    }
  }
  return found;
}

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

class Composer {
 public:
  Composer(const Setting& setting, const SampleSeeds& seeds, const Frame& frame, const TracedView& view)
      : setting_(setting),
        seeds_(seeds),
        frame_(frame),
        view_(view),
        bare_ground_(setting.surroundings.open ? BareGroundLight(setting.lights) : 1) {}

  // Means by row, then over rows, so that the order of the sum is always the same.
  absl::Status Expose(const runtime::Workers& workers) {
    struct Sums {
      double red = 0, green = 0, blue = 0, albedo = 0, count = 0;
    };
    const LightGrid& grid = frame_.indirect;
    std::vector<Sums> rows(grid.height);
    absl::Status status = runtime::ForEach(workers, grid.height, [&](int y) {
      for (int x = 0; x < grid.width; ++x) {
        const size_t at = static_cast<size_t>(y) * grid.width + x;
        if (grid.guides[kInstance][at] < 0) continue;
        const Vec3 light = LightAt(grid, at) + Direct(At(2 * x, 2 * y));
        rows[y].red += light.x;
        rows[y].green += light.y;
        rows[y].blue += light.z;
        rows[y].albedo += frame_.reflectance[at];
        rows[y].count += 1;
      }
    });
    if (!status.ok()) return status;
    Sums all;
    for (const Sums& row : rows) {
      all = {all.red + row.red, all.green + row.green, all.blue + row.blue, all.albedo + row.albedo,
             all.count + row.count};
    }
    const double light = 0.2126 * all.red + 0.7152 * all.green + 0.0722 * all.blue;
    if (all.count == 0 || !(light > 1e-9 * all.count)) return status;
    const double albedo = std::max(all.albedo / all.count, 0.01);
    const double exposure =
        kWhite * all.count / light * std::clamp(std::pow(kUsualAlbedo / albedo, kAdaptation), 0.75, 1.7);
    // Lamplight stays a little warm: the eye gets used to most of its colour, not to all.
    const auto gain = [&](double channel) {
      return static_cast<float>(exposure *
                                std::pow(std::clamp(light / std::max(channel, 1e-9), 0.5, 2.0), kWhiteBalance));
    };
    exposure_ = {gain(all.red), gain(all.green), gain(all.blue)};
    return status;
  }
  void Row(int y, std::span<Vec3> colour) const {
    const std::vector<int> edge = EdgesOf(y);
    for (int x = 0; x < view_.width_px; ++x) {
      const size_t at = At(x, y);
      colour[x] = edge[x] != 0 ? Edge(x, y)
                               : Radiance(static_cast<int>(frame_.direct.guides[kInstance][at]), frame_.paint[at],
                                          frame_.added[at], Between(x, y));
    }
  }

 private:
  size_t At(int x, int y) const { return static_cast<size_t>(y) * view_.width_px + x; }
  Vec3 Direct(size_t at) const { return LightAt(frame_.direct, at); }
  static Vec3 LightAt(const LightGrid& grid, size_t at) {
    return {grid.light[kRed][at], grid.light[kGreen][at], grid.light[kBlue][at]};
  }
  Vec3 GlossAt(size_t at) const { return {frame_.gloss[0][at], frame_.gloss[1][at], frame_.gloss[2][at]}; }
  // Of the pixels of a row: whether what they show ends within them or beside.
  std::vector<int> EdgesOf(int y) const {
    std::vector<int> edge(view_.width_px);
    for (int b = std::max(0, y - 1); b <= std::min(view_.height_px - 1, y + 1); ++b) {
      for (int right = -1; right <= 1; ++right) {
        if (b == y && right == 0) continue;
        MarkEdges(frame_, view_, At(0, y), At(0, b) + static_cast<size_t>(static_cast<ptrdiff_t>(right)),
                  std::max(0, -right), std::min(view_.width_px, view_.width_px - right), edge.data());
      }
    }
    return edge;
  }
  // At a pixel all of whose neighbours show the same surface: the mean of the points about it.
  Lit Between(int x, int y) const {
    const LightGrid& grid = frame_.indirect;
    const size_t above = static_cast<size_t>(y / 2) * grid.width;
    const size_t below = static_cast<size_t>(std::min((y + 1) / 2, grid.height - 1)) * grid.width;
    const int left = x / 2, right = std::min((x + 1) / 2, grid.width - 1);
    Lit lit;
    for (const size_t at : {above + left, above + right, below + left, below + right}) {
      lit.irradiance = lit.irradiance + LightAt(grid, at);
      lit.gloss = lit.gloss + GlossAt(at);
    }
    return {Direct(At(x, y)) + lit.irradiance * 0.25F, lit.gloss * 0.25F};
  }
  // The light of the points about (x, y) that show the same surface; what one ray each finds where none does.
  Lit LitLike(const Seen& seen, int x, int y, const PixelSamples& random, int look) const {
    if (seen.lit_instance == -1) return {};
    const float pixel = std::max(seen.distance, 0.1F) / setting_.camera.focal_px;
    const int64_t direct = SameSurface(frame_.direct, seen, pixel, x - 1, x + 1, y - 1, y + 1);
    const int64_t indirect =
        SameSurface(frame_.indirect, seen, 2 * pixel, (x - 1) / 2, (x + 2) / 2, (y - 1) / 2, (y + 2) / 2);
    Lit lit;
    if (direct >= 0) {
      lit.irradiance = Direct(static_cast<size_t>(direct));
    } else {
      const LightChoice choice(setting_.lights, seen.position, seen.normal);
      lit.irradiance = DirectLight(setting_.world, choice, seen.position, random, look);
    }
    if (indirect >= 0) {
      lit.irradiance = lit.irradiance + LightAt(frame_.indirect, static_cast<size_t>(indirect));
      lit.gloss = GlossAt(static_cast<size_t>(indirect));
    } else {
      lit.irradiance = lit.irradiance + IndirectLight(setting_, seen, random, look, 1).light;
      // Of anything but metal, so few rays would find sparks.
      if (Luminance(seen.specular) > 0.1F) lit.gloss = seen.filter * Gloss(setting_, seen, random, look, 1);
    }
    return lit;
  }
  Vec3 Radiance(int lit_instance, Vec3 paint, Vec3 added, const Lit& lit) const {
    if (lit_instance == -2) {  // the ground: backdrop, darker where the model keeps light away
      return added * exposure_ + paint * std::min(1.0F, Luminance(lit.irradiance) / bare_ground_);
    }
    if (lit_instance == -1) return added;  // what is beyond appears as it is
    return (added + paint * lit.irradiance + lit.gloss) * exposure_;
  }
  Vec3 Edge(int x, int y) const {
    std::array<Vec3, kEdgeLooks> ways;
    for (int i = 0; i < kEdgeLooks; ++i) {
      const uint32_t number = static_cast<uint32_t>(i);
      const float column =
          static_cast<float>(x) + static_cast<float>((number * 3242174889U + 0x40000000U) >> 8) * 0x1p-24F;
      const float row = static_cast<float>(y) + (static_cast<float>(i) + 0.5F) / kEdgeLooks;
      ways[i] = setting_.camera.Through(column, row);
    }
    std::array<Seen, kEdgeLooks> looks;
    LookFrom(setting_.world, setting_.lights, setting_.surroundings, setting_.camera.eye, ways, setting_.pixel_rad(),
             looks);
    const PixelSamples random(seeds_, x, y, kEdgeLooks);
    Vec3 sum;
    for (int i = 0; i < kEdgeLooks; ++i) {
      const Seen& seen = looks[i];
      const Lit lit = LitLike(seen, x, y, random, i);
      const Vec3 radiance = Radiance(seen.lit_instance, seen.filter * seen.albedo, seen.added, lit);
      // Highlights are bounded before the mean, or they would leave steps along edges.
      const float most = std::max({radiance.x, radiance.y, radiance.z});
      sum = sum + (most > 1.5F ? radiance * (1.5F / most) : radiance);
    }
    return sum * (1.0F / kEdgeLooks);
  }

  const Setting& setting_;
  const SampleSeeds& seeds_;
  const Frame& frame_;
  const TracedView& view_;
  float bare_ground_;
  Vec3 exposure_{1, 1, 1};
};

}  // namespace

absl::Status ComposeColour(const Setting& setting, const SampleSeeds& seeds, const Frame& frame,
                           const runtime::Workers& workers, TracedView& view) {
  Composer composer(setting, seeds, frame, view);
  RETURN_IF_ERROR(composer.Expose(workers));
  view.colour.resize(frame.direct.size());
  const size_t width = static_cast<size_t>(view.width_px);
  return runtime::ForEach(workers, view.height_px, [&](int y) {
    composer.Row(y, std::span(view.colour).subspan(static_cast<size_t>(y) * width, width));
  });
}

Pixels ToneMapped(const TracedView& view, int thread_count) {
  Pixels pixels{view.width_px, view.height_px, {}};
  pixels.rgb.resize(3 * view.colour.size());
  const auto& table = SrgbTable();
  const absl::Status status = runtime::ForEach({thread_count, {}}, view.height_px, [&](int y) {
    const size_t row = static_cast<size_t>(y) * view.width_px;
    for (size_t i = row; i < row + view.width_px; ++i) {
      const Vec3 c = Filmic(view.colour[i]);
      uint8_t* rgb = &pixels.rgb[3 * i];
      for (const float v : {c.x, c.y, c.z}) *rgb++ = table[std::lround(4096 * std::sqrt(std::clamp(v, 0.0F, 1.0F)))];
    }
  });
  status.IgnoreError();  // nobody is asked whether to go on
  return pixels;
}

}  // namespace flair::renderer
