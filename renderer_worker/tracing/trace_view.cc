// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/trace_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/tracing/annotations.h"
#include "renderer_worker/tracing/compose.h"
#include "renderer_worker/tracing/denoise.h"
#include "renderer_worker/tracing/radiosity.h"
#include "renderer_worker/tracing/setting.h"
#include "renderer_worker/tracing/tile.h"

namespace flair::renderer {
namespace {

constexpr int kRadiosityPoints = 6000;
// Of smoothing: the last reaches 2^rounds points to each side.
constexpr int kDirectRounds = 4, kIndirectRounds = 4;

absl::Status CheckOptions(const TraceOptions& options) {
  for (const int size : {options.width_px, options.height_px}) {
    if (size < 16 || size > 8192)
      return absl::InvalidArgumentError(fmt::format("a picture {} px wide or high; [16, 8192]", size));
  }
  if (int64_t{options.width_px} * options.height_px > kMaxTracedPixels) {
    return absl::ResourceExhaustedError(fmt::format("a traced picture of {} x {} px; at most {} pixels",
                                                    options.width_px, options.height_px, kMaxTracedPixels));
  }
  if (options.sample_count < 1 || options.sample_count > 4096) {
    return absl::InvalidArgumentError(fmt::format("sample_count: {}; must be in [1, 4096]", options.sample_count));
  }
  if (options.thread_count < 1 || options.thread_count > 256) {
    return absl::InvalidArgumentError(fmt::format("thread_count: {}; must be in [1, 256]", options.thread_count));
  }
  return absl::OkStatus();
}

void Resize(const TraceOptions& options, TracedView& view) {
  const size_t count = static_cast<size_t>(options.width_px) * options.height_px;
  view.width_px = options.width_px;
  view.height_px = options.height_px;
  view.depth_m.resize(count);
  view.instance.resize(count);
  if (options.colour_only) return;
  view.normal.resize(count);
  view.albedo.resize(count);
  view.object_class.resize(count);
}

absl::Status Smooth(const Workers& workers, Frame& frame) {
  absl::Status status;
  {
    Planes scratch(kLightCount, frame.direct.size());
    status = SpreadSparks(workers, frame.direct, scratch);
    if (status.ok()) status = SmoothLight(workers, kDirectRounds, frame.direct, scratch);
    if (!status.ok()) return status;
  }
  Planes scratch(kLightCount, frame.indirect.size());
  status = SpreadSparks(workers, frame.indirect, scratch);
  if (status.ok()) status = SmoothLight(workers, kIndirectRounds, frame.indirect, scratch);
  if (status.ok()) status = SmoothGloss(workers, kIndirectRounds, frame.indirect, frame.gloss);
  return status;
}

absl::StatusOr<TracedView> Trace(const Scene& scene, const SceneCamera& scene_camera, const TraceOptions& options) {
  absl::StatusOr<RoomShape> shape = ShapeOf(scene.layout->graph().room());
  if (!shape.ok()) return shape.status();
  absl::StatusOr<PinholeCamera> camera = PinholeCamera::Make(scene_camera, options.width_px, options.height_px);
  if (!camera.ok()) return camera.status();
  const Workers workers{options.thread_count, options.check_alive};
  if (workers.check_alive) {
    if (absl::Status status = workers.check_alive(); !status.ok()) return status;
  }
  const CutAway cut = CutAwayFor(*shape, scene_camera.eye);
  absl::StatusOr<std::unique_ptr<World>> world = World::Make(scene, cut);
  if (!world.ok()) return world.status();
  Lights lights = LightsOf(scene, cut.ceiling);
  const std::vector<SurfacePoint> points = SpreadPoints(**world, kRadiosityPoints);
  if (!cut.ceiling) BalanceLights(**world, points, *shape, lights);
  absl::StatusOr<std::unique_ptr<Radiosity>> radiosity = Radiosity::Solve(**world, lights, points, workers);
  if (!radiosity.ok()) return radiosity.status();

  Surroundings surroundings;
  surroundings.open = cut.ceiling;
  // Where walls are gone before the eye, the picture goes on in the colour of those that are left.
  if (!cut.ceiling && !Inside(*shape, camera->eye.x, camera->eye.y)) surroundings.room = &*shape;
  if (!cut.ceiling) surroundings.backdrop = (*world)->MeanColourOf(kWallClass) * 0.8F;
  const Setting setting{**world, lights, **radiosity, surroundings, *camera};
  TracedView view;
  Resize(options, view);
  Frame frame(options.width_px, options.height_px);
  const int rounds = (options.sample_count + 3) / 4;
  const SampleSeeds seeds(Mix(static_cast<uint32_t>(options.seed) ^ Mix(static_cast<uint32_t>(options.seed >> 32))));
  absl::Status status = ForEach(workers, (options.height_px + kTileHeight - 1) / kTileHeight,
                                [&](int i) { TraceRows(setting, seeds, rounds, i * kTileHeight, frame, view); });
  if (status.ok()) status = Smooth(workers, frame);
  if (status.ok()) status = ComposeColour(setting, seeds, frame, workers, view);
  if (!status.ok()) return status;
  view.annotations = AnnotationsOf(scene, **world, *camera, view);
  return view;
}

}  // namespace

absl::StatusOr<TracedView> TraceView(const Scene& scene, const SceneCamera& camera, const TraceOptions& options) {
  if (absl::Status status = CheckOptions(options); !status.ok()) return status;
  try {
    return Trace(scene, camera, options);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("no memory for the picture");
  }
}

}  // namespace flair::renderer
