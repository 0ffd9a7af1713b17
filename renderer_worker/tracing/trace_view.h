// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

#include "absl/status/statusor.h"
#include "flair/v1/view_annotations.pb.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/frame.h"

namespace flair::renderer {

struct TraceOptions {
  int width_px = 1024;   // [16, 8192]; width times height at most kMaxTracedPixels
  int height_px = 1024;  // the same
  // Paths of light per pixel, [1, 4096]; a quarter of it, rounded up, is n. Up to n samples of the sun and half as many
  // of windows and lamps for each pixel, a quarter of n where neighbours agree whether light gets there. For every
  // second pixel of every second row 2n paths to the open sky and other surfaces (n within a room), and n / 2 of what a
  // surface mirrors.
  int sample_count = 16;
  int64_t seed = 0;
  bool colour_only = false;  // normal, albedo and object_class stay empty, which saves time
  int thread_count = 1;      // [1, 256]; changes who computes what, never the result
  // Asked now and then, from the calling thread only; its error ends the work. May be empty.
  std::function<absl::Status()> check_alive;
};

inline constexpr int64_t kMaxTracedPixels = int64_t{4096} * 4096;  // some 160 bytes each while at work

// A traced picture and what its pixels show. Planes run row by row from the upper-left corner. What a pixel shows at
// its centre is what counts for all planes but `colour`, which is the mean over the pixel.
struct TracedView {
  int width_px = 0;
  int height_px = 0;
  PixelVector<Vec3> colour;           // linear RGB (sRGB primaries), exposed: 1 is white
  PixelVector<float> depth_m;         // along the camera's axis (its z), metres; 0 where nothing is
  PixelVector<Vec3> normal;           // unit, room frame R, towards the camera; 0 where nothing is
  PixelVector<Vec3> albedo;           // linear RGB, share of the light that is reflected; 0 where nothing is
  PixelVector<int32_t> instance;      // v1::Instance.instance_id; 0 where nothing is
  PixelVector<int32_t> object_class;  // v1::Instance.class_id; 0 where nothing is
  v1::ViewAnnotations annotations;
};

// Takes a picture of the room: path-traced light (daylight through windows, lamps, the open sky where the ceiling is
// cut away), smoothed. A camera above the ceiling or outside a wall sees through it: the ceiling and walls that would
// hide the floor are cut away. The same bytes for the same scene, camera, size, sample_count and seed, whatever
// thread_count is. Thread-safe.
// INVALID_ARGUMENT: a camera or size that cannot be; RESOURCE_EXHAUSTED: more pixels or triangles than memory is meant
// for; else what check_alive said.
absl::StatusOr<TracedView> TraceView(const Scene& scene, const SceneCamera& camera, const TraceOptions& options);

// The picture for the screen: filmic curve, sRGB, 8 bits. The threads change nothing of it.
Pixels ToneMapped(const TracedView& view, int thread_count = 1);

}  // namespace flair::renderer
