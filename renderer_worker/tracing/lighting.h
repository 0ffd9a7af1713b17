// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>

#include "absl/status/status.h"
#include "renderer_worker/tracing/frame.h"
#include "renderer_worker/tracing/lights.h"
#include "renderer_worker/tracing/sampling.h"
#include "renderer_worker/tracing/trace_view.h"
#include "renderer_worker/tracing/world.h"
#include "worker_runtime/executor/executor.h"

namespace flair::renderer {

// What is around the room, for the camera.
struct Surroundings {
  bool open = false;  // a model on a table: the ground catches its shadow
  float ground_z = -kSlabThickness_m;
  const RoomShape* room = nullptr;     // of an eye outside its walls: what is before them is not seen
  Vec3 backdrop{0.80F, 0.79F, 0.77F};  // where the eye meets nothing, as it shall appear
};

// Looks from `eye` in `direction` (unit). `pixel_rad` is the angle of a pixel, which patterns are filtered by.
Seen LookFrom(const World& world, const Lights& lights, const Surroundings& surroundings, Vec3 eye, Vec3 direction,
              float pixel_rad);
// The same in up to kMostRaysTogether neighbouring directions.
void LookFrom(const World& world, const Lights& lights, const Surroundings& surroundings, Vec3 eye,
              std::span<const Vec3> directions, float pixel_rad, std::span<Seen> seen);

// Whether it sends back images rather than gloss.
inline bool IsMirror(const Material& material) { return material.metallic > 0.7F && material.roughness < 0.16F; }

// All that a picture is taken of, and from where.
struct Setting {
  const World& world;
  const Lights& lights;
  const Radiosity& radiosity;
  const Surroundings& surroundings;
  const PinholeCamera& camera;
  float pixel_rad() const { return 1 / camera.focal_px; }
};

// A mean of samples of what falls on a surface, over pi, and the variance of its luminance as such a mean.
struct LightMean {
  Vec3 light;
  float variance = 0;
};

// Samples of light, added up.
class LightSum {
 public:
  void Add(Vec3 light) {
    const float luminance = Luminance(light);
    sum_ = sum_ + light;
    luminance_ += luminance;
    squares_ += luminance * luminance;
    ++count_;
  }
  void Add(const LightSum& other) {
    sum_ = sum_ + other.sum_;
    luminance_ += other.luminance_;
    squares_ += other.squares_;
    count_ += other.count_;
  }
  int count() const { return count_; }
  // Of the luminance of one sample. A single one says nothing of it: as if it were as large as the value.
  float Variance() const {
    const float count = static_cast<float>(count_), mean = luminance_ / count;
    return count_ > 1 ? std::max(0.0F, squares_ / count - mean * mean) * count / (count - 1) : mean * mean;
  }
  // Of one sample at least.
  LightMean Mean() const {
    const float share = 1 / static_cast<float>(count_);
    return {sum_ * share, Variance() * share};
  }

 private:
  Vec3 sum_;
  float luminance_ = 0, squares_ = 0;
  int count_ = 0;
};

// What other surfaces and, where the room is open, the sky send to what is seen, by `count` samples from `first` on.
LightMean IndirectLight(const Setting& setting, const Seen& seen, const PixelSamples& random, int first, int count);

// Radiance that what is seen mirrors, roughly; 0 where it hardly shines.
Vec3 Gloss(const Setting& setting, const Seen& seen, const PixelSamples& random, int first, int count);

inline constexpr int kBlockSide = 4;

// A square of neighbouring pixels; null beyond the picture.
using PixelBlock = std::array<const Seen*, kBlockSide * kBlockSide>;
using BlockLight = std::array<LightMean, kBlockSide * kBlockSide>;

// What falls on the pixels of a block, whose first one is (column, row), straight from lamps, windows and the sun.
// `round_count` samples of the sun, half as many of the others, whose half shadows are wide; but only a quarter where
// those of all pixels of a surface agree whether light gets there.
BlockLight DirectLightOn(const Setting& setting, const SampleSeeds& seeds, const PixelBlock& block, int column, int row,
                         int round_count);

// `scratch` is memory for kLightCount planes like those of the grid.

// Points that are much brighter than all their neighbours of one instance, but for one, share their light with them:
// few samples found what all others missed, and smoothing would take it for something real. No light is lost.
absl::Status SpreadSparks(const runtime::Workers& workers, LightGrid& grid, Planes& scratch);

// Smooths the light of a grid, not its surfaces: an edge-stopping a-trous wavelet (Dammertz et al. 2010) in
// `round_count` rounds, steered by instance, normal, plane and, as in SVGF (Schied et al. 2017), by how much of a
// difference noise accounts for.
absl::Status SmoothLight(const runtime::Workers& workers, int round_count, LightGrid& grid, Planes& scratch);

// Smooths what the surfaces at the points of `grid` mirror; only their edges stop it.
absl::Status SmoothGloss(const runtime::Workers& workers, int round_count, const LightGrid& grid, Planes& gloss);

// Fills the colour of a view whose other planes are there: light times surfaces, edges looked at several times, exposed
// by how much light falls on what is seen.
absl::Status ComposeColour(const Setting& setting, const SampleSeeds& seeds, const Frame& frame,
                           const runtime::Workers& workers, TracedView& view);

}  // namespace flair::renderer
