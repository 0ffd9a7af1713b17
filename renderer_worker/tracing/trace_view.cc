// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/tracing/trace_view.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <vector>

#include "renderer_worker/scene/room_shape.h"
#include "renderer_worker/tracing/lighting.h"
#include "renderer_worker/tracing/lights.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {

constexpr int kTileHeight = 4;

namespace {

// What an instance takes of the picture.
struct Extent {
  int64_t count = 0;
  int left = std::numeric_limits<int>::max(), top = std::numeric_limits<int>::max(), right = 0, bottom = 0;
};

void CountPixels(const TracedView& view, v1::ViewAnnotations& annotations) {
  std::vector<Extent> extents(annotations.instances_size());
  for (int y = 0; y < view.height_px; ++y) {
    for (int x = 0; x < view.width_px; ++x) {
      const int id = view.instance[static_cast<size_t>(y) * view.width_px + x];
      if (id <= 0) continue;
      Extent& e = extents[id - 1];
      ++e.count;
      e = {e.count, std::min(e.left, x), std::min(e.top, y), std::max(e.right, x + 1), std::max(e.bottom, y + 1)};
    }
  }
  for (size_t i = 0; i < extents.size(); ++i) {
    if (extents[i].count == 0) continue;
    v1::Instance& instance = *annotations.mutable_instances(static_cast<int>(i));
    instance.set_visible_pixel_count(extents[i].count);
    v1::PixelBox& box = *instance.mutable_pixel_box();
    box.set_left(extents[i].left);
    box.set_top(extents[i].top);
    box.set_right(extents[i].right);
    box.set_bottom(extents[i].bottom);
  }
}

// Camera and instances of a view whose planes are filled in.
v1::ViewAnnotations AnnotationsOf(const Scene& scene, const World& world, const PinholeCamera& camera,
                                  const TracedView& view) {
  v1::ViewAnnotations annotations;
  *annotations.mutable_camera() = camera.Parameters();
  for (size_t i = 0; i < world.instances().size(); ++i) {
    v1::Instance& instance = *annotations.add_instances();
    instance.set_instance_id(world.instances()[i].instance_id);
    instance.set_class_id(world.instances()[i].class_id);
    if (i >= scene.objects.size()) {
      const ShellPart& part = scene.shell[i - scene.objects.size()];
      instance.set_class_name(std::string(NameOf(part.kind)));
      instance.set_subject_id(part.id);
      continue;
    }
    const SceneObject& object = scene.objects[i];
    instance.set_class_name(object.furnishing.class_name);
    instance.set_subject_id(object.object->id());
    instance.set_name(object.object->name());
    *instance.mutable_placement() = object.placement;
    instance.set_width_m(object.object->width_m());
    instance.set_depth_m(object.object->depth_m());
    instance.set_height_m(object.object->height_m());
  }
  CountPixels(view, annotations);
  return annotations;
}

// Tiles of two blocks side by side: what is known of their pixels stays in the nearest cache until light has been
// gathered.

constexpr int kTileWidth = kMostRaysTogether;
static_assert(kTileHeight == kBlockSide && kTileWidth % kBlockSide == 0);

// `pixels`: the distance of the grid's points, in pixels.
void FillGuides(const Seen& s, float pixel_rad, float pixels, size_t at, Planes& guides) {
  const bool lit = s.lit_instance != -1;
  const Vec3 position = lit ? s.position : Vec3{}, normal = lit ? s.normal : Vec3{};
  guides[kX][at] = position.x, guides[kY][at] = position.y, guides[kZ][at] = position.z;
  guides[kNormalX][at] = normal.x, guides[kNormalY][at] = normal.y, guides[kNormalZ][at] = normal.z;
  guides[kReach][at] = lit ? 1 / std::max(1e-4F, s.distance * pixel_rad * 1.5F * pixels) : 0;
  guides[kInstance][at] = static_cast<float>(s.lit_instance);
}

void FillLight(const LightMean& light, size_t at, Planes& planes) {
  planes[kRed][at] = light.light.x, planes[kGreen][at] = light.light.y, planes[kBlue][at] = light.light.z;
  planes[kVariance][at] = light.variance;
  planes[kLuminance][at] = Luminance(light.light);
}

class Tile {
 public:
  Tile(const Setting& setting, int column, int row)
      : setting_(setting),
        column_(column),
        row_(row),
        width_(std::min(kTileWidth, setting.camera.width_px - column)),
        height_(std::min(kTileHeight, setting.camera.height_px - row)) {}

  void Look() {
    for (int y = 0; y < height_; ++y) {
      std::array<Vec3, kTileWidth> ways;
      for (int x = 0; x < width_; ++x) {
        ways[x] = setting_.camera.Through(static_cast<float>(column_ + x) + 0.5F, static_cast<float>(row_ + y) + 0.5F);
      }
      LookFrom(setting_.world, setting_.lights, setting_.surroundings, setting_.camera.eye,
               std::span(ways).first(width_), setting_.pixel_rad(), std::span(seen_).subspan(y * kTileWidth, width_));
    }
  }
  // The planes that say what is seen.
  void FillView(TracedView& view) const {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const size_t at = PixelOf(x, y);
        const Seen& s = At(x, y);
        const bool any = s.instance >= 0;
        const Vec3 way =
            setting_.camera.Through(static_cast<float>(column_ + x) + 0.5F, static_cast<float>(row_ + y) + 0.5F);
        view.depth_m[at] = any ? s.distance * Dot(way, setting_.camera.forward) : 0;
        view.instance[at] = any ? setting_.world.instances()[s.instance].instance_id : 0;
        if (view.normal.empty()) continue;
        view.normal[at] = s.first_normal;
        view.albedo[at] = s.first_albedo;
        view.object_class[at] = any ? setting_.world.instances()[s.instance].class_id : 0;
      }
    }
  }
  void FillFrame(Frame& frame) const {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const size_t at = PixelOf(x, y);
        const Seen& s = At(x, y);
        FillGuides(s, setting_.pixel_rad(), 1, at, frame.direct.guides);
        frame.paint[at] = s.filter * s.albedo;
        frame.added[at] = s.added;
      }
    }
  }
  void GatherDirect(const SampleSeeds& seeds, int round_count, LightGrid& grid) const {
    for (int left = 0; left < width_; left += kBlockSide) {
      PixelBlock block{};
      for (int y = 0; y < height_; ++y) {
        for (int x = left; x < std::min(width_, left + kBlockSide); ++x) block[y * kBlockSide + x - left] = &At(x, y);
      }
      const BlockLight light = DirectLightOn(setting_, seeds, block, column_ + left, row_, round_count);
      for (int y = 0; y < height_; ++y) {
        for (int x = left; x < std::min(width_, left + kBlockSide); ++x) {
          FillLight(light[y * kBlockSide + x - left], PixelOf(x, y), grid.light);
        }
      }
    }
  }
  void GatherIndirect(const SampleSeeds& seeds, int round_count, Frame& frame) const {
    // Where the sky is open, these rays bring its light; within a room only that of other surfaces, which varies less.
    const int ray_count = setting_.lights.open_sky ? 2 * round_count : round_count;
    const int gloss_count = (round_count + 1) / 2;
    for (int y = 0; y < height_; y += 2) {
      for (int x = 0; x < width_; x += 2) {
        const Seen& s = At(x, y);
        const int column = (column_ + x) / 2, row = (row_ + y) / 2;
        const size_t at = static_cast<size_t>(row) * frame.indirect.width + column;
        FillGuides(s, setting_.pixel_rad(), 2, at, frame.indirect.guides);
        FillLight(IndirectLight(setting_, s, PixelSamples(seeds, column, row, ray_count), 0, ray_count), at,
                  frame.indirect.light);
        const Vec3 gloss = s.filter * Gloss(setting_, s, PixelSamples(seeds, column, row, gloss_count), 0, gloss_count);
        frame.gloss[0][at] = gloss.x, frame.gloss[1][at] = gloss.y, frame.gloss[2][at] = gloss.z;
        frame.reflectance[at] = Luminance(s.albedo + s.specular);
      }
    }
  }

 private:
  const Seen& At(int x, int y) const { return seen_[y * kTileWidth + x]; }
  size_t PixelOf(int x, int y) const {
    return static_cast<size_t>(row_ + y) * setting_.camera.width_px + static_cast<size_t>(column_ + x);
  }

  const Setting& setting_;
  int column_, row_, width_, height_;
  std::array<Seen, kTileWidth * kTileHeight> seen_;
};

// Looks at rows [row, row + kTileHeight) of the picture, as far as there are, gathers the light that falls on what they
// show, and fills their part of `frame` and of the view's planes but the colour. `row` is a multiple of kTileHeight.
void TraceRows(const Setting& setting, const SampleSeeds& seeds, int round_count, int row, Frame& frame,
               TracedView& view) {
  for (int column = 0; column < setting.camera.width_px; column += kTileWidth) {
    Tile tile(setting, column, row);
    tile.Look();
    tile.FillView(view);
    tile.FillFrame(frame);
    tile.GatherDirect(seeds, round_count, frame.direct);
    tile.GatherIndirect(seeds, round_count, frame);
  }
}

constexpr int kRadiosityPoints = 6000;
// Of smoothing: the last reaches 2^rounds points to each side.
constexpr int kDirectRounds = 4, kIndirectRounds = 4;

absl::Status CheckOptions(const TraceOptions& options) {
  for (const int size : {options.width_px, options.height_px}) {
    if (size < 16 || size > 8192) return InvalidArgument("a picture {} px wide or high; [16, 8192]", size);
  }
  if (int64_t{options.width_px} * options.height_px > kMaxTracedPixels) {
    return ResourceExhausted("a traced picture of {} x {} px; at most {} pixels", options.width_px, options.height_px,
                             kMaxTracedPixels);
  }
  if (options.sample_count < 1 || options.sample_count > 4096) {
    return InvalidArgument("sample_count: {}; must be in [1, 4096]", options.sample_count);
  }
  if (options.thread_count < 1 || options.thread_count > 256) {
    return InvalidArgument("thread_count: {}; must be in [1, 256]", options.thread_count);
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

absl::Status Smooth(const runtime::Workers& workers, Frame& frame) {
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
  ASSIGN_OR_RETURN(RoomShape shape, ShapeOf(scene.layout->graph().room()));
  ASSIGN_OR_RETURN(PinholeCamera camera, PinholeCamera::Make(scene_camera, options.width_px, options.height_px));
  const runtime::Workers workers{options.thread_count, options.check_alive};
  if (workers.check_alive) RETURN_IF_ERROR(workers.check_alive());
  const CutAway cut = CutAwayFor(shape, scene_camera.eye);
  ASSIGN_OR_RETURN(std::unique_ptr<World> world, World::Make(scene, cut));
  Lights lights = LightsOf(scene, cut.ceiling);
  const std::vector<SurfacePoint> points = SpreadPoints(*world, kRadiosityPoints);
  if (!cut.ceiling) BalanceLights(*world, points, shape, lights);
  ASSIGN_OR_RETURN(std::unique_ptr<Radiosity> radiosity, Radiosity::Solve(*world, lights, points, workers));

  Surroundings surroundings;
  surroundings.open = cut.ceiling;
  // Where walls are gone before the eye, the picture goes on in the colour of those that are left.
  if (!cut.ceiling && !Inside(shape, camera.eye.x, camera.eye.y)) surroundings.room = &shape;
  if (!cut.ceiling) surroundings.backdrop = (world)->MeanColourOf(kWallClass) * 0.8F;
  const Setting setting{*world, lights, *radiosity, surroundings, camera};
  TracedView view;
  Resize(options, view);
  Frame frame(options.width_px, options.height_px);
  const int rounds = (options.sample_count + 3) / 4;
  const SampleSeeds seeds(Mix(static_cast<uint32_t>(options.seed) ^ Mix(static_cast<uint32_t>(options.seed >> 32))));
  absl::Status status = runtime::ForEach(workers, (options.height_px + kTileHeight - 1) / kTileHeight, [&](int i) {
    TraceRows(setting, seeds, rounds, i * kTileHeight, frame, view);
  });
  if (status.ok()) status = Smooth(workers, frame);
  if (status.ok()) status = ComposeColour(setting, seeds, frame, workers, view);
  if (!status.ok()) return status;
  view.annotations = AnnotationsOf(scene, *world, camera, view);
  return view;
}

}  // namespace

absl::StatusOr<TracedView> TraceView(const Scene& scene, const SceneCamera& camera, const TraceOptions& options) {
  RETURN_IF_ERROR(CheckOptions(options));
  try {
    return Trace(scene, camera, options);
  } catch (const std::bad_alloc&) {
    return absl::ResourceExhaustedError("no memory for the picture");
  }
}

}  // namespace flair::renderer
