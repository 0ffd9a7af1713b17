// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "optimizer_worker/constraints/measure/hanging.h"
#include "optimizer_worker/constraints/whole_room.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// Left between neighbours, so that rounding does not make touching an overlap.
constexpr double kAir_m = 1e-7;
constexpr double kRounding_m = 1e-9;
// The room's edge counts to this: furniture may stand against a wall to the same.
constexpr double kEdge_m = 1e-7;

struct Range {
  double low = 1e300, high = -1e300;
  void Take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double Middle() const { return (low + high) / 2; }
  double Half() const { return (high - low) / 2; }
};

// What an object covers of two directions through `origin`.
struct Extent {
  Range u, v;
};

Extent ExtentOf(const Footprint& footprint, const Pose<double>& pose, const Frame<double>& frame) {
  Extent extent;
  for (const Vec2<double>& corner : Corners(footprint, pose)) {
    const Vec2<double> local = frame.ToObject(corner);
    extent.u.Take(local.x);
    extent.v.Take(local.y);
  }
  return extent;
}

// Keeps those within `least` and `most`, each once.
void Tidy(double least, double most, std::vector<double>& values) {
  std::erase_if(values, [&](double x) { return x < least - kRounding_m || x > most + kRounding_m; });
  std::sort(values.begin(), values.end());
  const auto same = [](double a, double b) { return b - a < kRounding_m; };
  values.erase(std::unique(values.begin(), values.end(), same), values.end());
}

// Middles of something `2 * half` long in `room` that touch its ends, stand at its quarters, or go with the others.
std::vector<double> MiddlesIn(const Range& room, double half, double wanted, std::span<const Range> others) {
  const double slack = room.Half() - half, middle = room.Middle();
  // What is larger than its place hangs over, but its middle lies on it.
  const double play = slack > -kRounding_m ? std::max(slack, 0.0) : room.Half();
  const double least = middle - play, most = middle + play;
  std::vector<double> middles = {middle, std::clamp(wanted, least, most)};
  if (slack > 0) middles.insert(middles.end(), {least, most, middle - slack / 2, middle + slack / 2});
  for (const Range& other : others) {
    middles.insert(middles.end(), {other.low - half - kAir_m, other.high + half + kAir_m, other.Middle()});
  }
  Tidy(least, most, middles);
  return middles;
}

bool InRoom(const SolveInput& input, const Footprint& footprint, const Pose<double>& pose) {
  const Box<double> box(footprint, FrameOf(pose));
  return input.keep_out.floor().SquaredExcess(box) <= kEdge_m * kEdge_m;
}

bool Fits(const Vec2<double>& half, const Extent& area, int turn) {
  const double along = turn % 2 == 0 ? half.x : half.y, across = turn % 2 == 0 ? half.y : half.x;
  return along <= area.u.Half() + kRounding_m && across <= area.v.Half() + kRounding_m;
}

// Along `frame`, within `area` of it, at every quarter turn.
void Along(const PlaceContext& context, int object, const Frame<double>& frame, double heading, const Extent& area,
           std::vector<Pose<double>>& places) {
  const Scene& scene = context.input.scene;
  const Footprint& footprint = scene.objects[object].footprint;
  std::vector<Range> others_u, others_v;
  for (int other : context.others) {
    if (scene.objects[other].kind != scene.objects[object].kind) continue;
    const Extent extent = ExtentOf(scene.objects[other].footprint, context.layout[other], frame);
    others_u.push_back(extent.u);
    others_v.push_back(extent.v);
  }
  if (context.carrier >= 0) {
    if (const std::optional<Footprint> below = OpeningBelow(scene, object, context.carrier)) {
      others_u.push_back({-below->width_m / 2, below->width_m / 2});
      others_v.push_back({-below->depth_m / 2, below->depth_m / 2});
    }
  }
  const Vec2<double> wanted = frame.ToObject(Center(context.wanted));
  const Vec2<double> half{footprint.width_m / 2, footprint.depth_m / 2};
  const bool fits = Fits(half, area, 0) || Fits(half, area, 1);
  // Its present heading and a quarter more: what matters here is how much room it takes.
  const int first = static_cast<int>(std::lround(WrapHeading(context.wanted.theta_rad - heading) / (kPi / 2)));
  for (int turn = first; turn < first + 2; ++turn) {
    // Nothing is turned so that it hangs over.
    if (fits && !Fits(half, area, turn)) continue;
    const double along = turn % 2 == 0 ? half.x : half.y, across = turn % 2 == 0 ? half.y : half.x;
    const std::vector<double> vs = MiddlesIn(area.v, across, wanted.y, others_v);
    for (double u : MiddlesIn(area.u, along, wanted.x, others_u)) {
      for (double v : vs) {
        const Vec2<double> p = frame.ToRoom(u, v);
        const Pose<double> pose{p.x, p.y, WrapHeading(heading + turn * kPi / 2)};
        if (InRoom(context.input, footprint, pose)) places.push_back(pose);
      }
    }
  }
}

void InWholeRoom(const PlaceContext& context, int object, std::vector<Pose<double>>& places) {
  const BoundingBox box = BoundsOf(context.input.scene.room.floor);
  const Extent area{{box.min.x, box.max.x}, {box.min.y, box.max.y}};
  Along(context, object, FrameOf(Pose<double>()), 0, area, places);
}

// The middles along one wall, off its openings.
std::vector<double> OffsetsOn(const PlaceContext& context, int object, const HangingWall& place) {
  const SolveInput& input = context.input;
  const Footprint& footprint = input.scene.objects[object].footprint;
  const Wall& wall = place.wall;
  std::vector<Range> taken;
  for (const HangingWall::Interval& b : place.blocked) taken.push_back({b.start_m, b.end_m});
  for (int other : context.others) {
    Range range;
    double nearest = 1e300;
    for (const Vec2<double>& corner : Corners(input.scene.objects[other].footprint, context.layout[other])) {
      range.Take(wall.Offset(corner));
      nearest = std::min(nearest, wall.Height(corner));
    }
    if (nearest < footprint.depth_m) taken.push_back(range);
  }
  const double half = footprint.width_m / 2;
  const Range all{0, wall.length_m};
  std::vector<double> offsets = MiddlesIn(all, half, wall.Offset(Center(context.wanted)), taken);
  for (int partner : input.partners[object]) offsets.push_back(wall.Offset(Center(context.layout[partner])));
  Tidy(half, wall.length_m - half, offsets);
  std::erase_if(offsets, [&](double at) {
    return std::any_of(place.blocked.begin(), place.blocked.end(), [&](const HangingWall::Interval& b) {
      return at + half > b.start_m + kRounding_m && at - half < b.end_m - kRounding_m;
    });
  });
  return offsets;
}

std::vector<Pose<double>> OnWalls(const PlaceContext& context, int object) {
  const Scene& scene = context.input.scene;
  const Footprint& footprint = scene.objects[object].footprint;
  std::vector<Pose<double>> places;
  for (const HangingWall& place : HangingWalls(scene, object)) {
    const Wall& wall = place.wall;
    if (footprint.width_m > wall.length_m + kRounding_m) continue;
    for (double offset : OffsetsOn(context, object, place)) {
      const Vec2<double> p = wall.PointAt(offset) + (footprint.depth_m / 2) * wall.inward_normal;
      const Pose<double> pose{p.x, p.y, WrapHeading(wall.BackHeading())};
      if (InRoom(context.input, footprint, pose)) places.push_back(pose);
    }
  }
  return places;
}

}  // namespace

std::vector<Pose<double>> ExactPlaces(const PlaceContext& context, int object) {
  const Scene& scene = context.input.scene;
  std::vector<Pose<double>> places;
  switch (scene.objects[object].kind) {
    case ObjectKind::kWall:
      return OnWalls(context, object);
    case ObjectKind::kSurface: {
      if (context.carrier < 0) {
        InWholeRoom(context, object, places);
        return places;
      }
      const Footprint& top = scene.objects[context.carrier].footprint;
      const Pose<double>& host = context.layout[context.carrier];
      const Extent area{{-top.width_m / 2, top.width_m / 2}, {-top.depth_m / 2, top.depth_m / 2}};
      Along(context, object, FrameOf(host), host.theta_rad, area, places);
      return places;
    }
    case ObjectKind::kCeiling:
      InWholeRoom(context, object, places);
      return places;
    case ObjectKind::kFloor:
      break;
  }
  return places;
}

}  // namespace flair::optimizer
