// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/solver/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "room/geometry/pose.h"

namespace flair::optimizer {
namespace {

// Left by slides, so that rounding does not make touching an overlap.
constexpr double kAir_m = 5e-8;

// Turn from "back on the wall" to "this side on the wall".
double TurnOf(Side side) {
  switch (side) {
    case Side::kBack:
      return 0;
    case Side::kFront:
      return kPi;
    case Side::kLeft:
      return kPi / 2;
    case Side::kRight:
      return -kPi / 2;
  }
  return 0;
}

class Proposer {
 public:
  Proposer(const CandidateContext& context, int object, const CandidateDensity& density, Random& random,
           std::vector<Pose<double>>& out)
      : context_(context),
        scene_(context.scene),
        object_(scene_.objects[object]),
        footprint_(context.box != nullptr ? *context.box : object_.footprint),
        index_(object),
        density_(density),
        random_(random),
        out_(out) {}

  void Floor() {
    for (const Wall& wall : scene_.room.walls) {
      for (Side side : {Side::kBack, Side::kLeft, Side::kRight}) AlongWall(wall, side);
    }
    for (int partner : context_.partners) {
      if (IsPlaced(partner)) Beside(partner);
    }
    if (context_.box != nullptr) Middles();
    Spread(density_.floor_samples);
  }

  void Rug() {
    for (int partner : context_.partners) {
      if (IsPlaced(partner)) Under(partner);
    }
    Middles();
    Spread(density_.floor_samples / 2);
  }

  void Hanging() {
    for (const Wall& wall : scene_.room.walls) AlongWall(wall, Side::kBack);
  }

  void Ceiling() {
    for (int partner : context_.partners) {
      if (!IsPlaced(partner)) continue;
      const Pose<double>& p = context_.layout[partner];
      AtHeadings({p.x_m, p.y_m}, p.theta_rad, 2);
    }
    Middles();
    Spread(density_.floor_samples / 2);
  }

  void Surface() {
    for (int partner : context_.partners) {
      if (IsPlaced(partner)) OnTop(partner);
    }
    if (object_.host >= 0 && IsPlaced(object_.host)) OnTop(object_.host);
    if (!out_.empty()) return;
    for (int placed : context_.placed) {
      const Object& host = scene_.objects[placed];
      if (host.kind == ObjectKind::kFloor && !host.walk_over) OnTop(placed);
    }
  }

 private:
  bool IsPlaced(int object) const {
    return std::find(context_.placed.begin(), context_.placed.end(), object) != context_.placed.end();
  }

  void AtHeadings(const Vec2<double>& p, double theta, int quarters) {
    for (int k = 0; k < quarters; ++k) out_.push_back({p.x, p.y, theta + k * kPi / 2});
  }

  // One candidate with `side` on the wall, its middle `offset` along it; clamped so that it stays on the wall.
  void OnWall(const Wall& wall, Side side, double offset) {
    const double half = SideLength(footprint_, side) / 2;
    if (2 * half > wall.length_m + 1e-9) return;
    offset = std::clamp(offset, half, std::max(half, wall.length_m - half));
    const Vec2<double> p = wall.PointAt(offset) + (ExtentBehind(footprint_, side) / 2) * wall.inward_normal;
    out_.push_back({p.x, p.y, wall.BackHeading() + TurnOf(side)});
  }

  void AlongWall(const Wall& wall, Side side) {
    const double half = SideLength(footprint_, side) / 2;
    // What hangs anywhere on a wall as well hangs in its middle, not in a corner.
    if (object_.kind == ObjectKind::kWall) OnWall(wall, side, wall.length_m / 2);
    OnWall(wall, side, half);
    OnWall(wall, side, wall.length_m - half);
    OnWall(wall, side, wall.length_m / 2);
    for (const Opening& opening : scene_.room.openings) {
      if (&scene_.room.walls[opening.wall] != &wall) continue;
      OnWall(wall, side, opening.offset_m - half);
      OnWall(wall, side, opening.offset_m + opening.width_m + half);
      if (opening.kind == OpeningKind::kWindow) OnWall(wall, side, opening.offset_m + opening.width_m / 2);
    }
    for (int other : context_.placed) {
      if (other != index_ && scene_.objects[other].kind == object_.kind) BesideOnWall(wall, side, half, other);
    }
    for (int partner : context_.partners) {
      if (IsPlaced(partner)) OnWall(wall, side, wall.Offset(Center(context_.layout[partner])));
    }
    if (object_.kind == ObjectKind::kWall) {
      for (const Vec2<double>& center : context_.zone_centers) OnWall(wall, side, wall.Offset(center));
    }
    const int samples = side == Side::kBack ? density_.wall_samples : density_.wall_samples / 2;
    const double start = random_.Uniform();
    for (int k = 0; k < samples; ++k) OnWall(wall, side, (k + start) / samples * wall.length_m);
  }

  // Shoulder to shoulder with a neighbour that stands near the wall.
  void BesideOnWall(const Wall& wall, Side side, double half, int other) {
    double low = 1e9, high = -1e9, near = 1e9;
    for (const Vec2<double>& corner : Corners(scene_.objects[other].footprint, context_.layout[other])) {
      low = std::min(low, wall.Offset(corner));
      high = std::max(high, wall.Offset(corner));
      near = std::min(near, wall.Height(corner));
    }
    if (near > ExtentBehind(footprint_, side)) return;
    if (low - half >= half - 1e-6) OnWall(wall, side, low - half);
    if (high + half <= wall.length_m - half + 1e-6) OnWall(wall, side, high + half);
  }

  // Each own side at each side of the partner.
  void Beside(int partner) {
    const Footprint& theirs = scene_.objects[partner].footprint;
    const Frame<double> frame = FrameOf(context_.layout[partner]);
    for (Side at : kSides) {
      const SideEdge<double> edge = EdgeOf(theirs, frame, at);
      const double length = SideLength(theirs, at);
      const Vec2<double> along = (1 / std::max(length, 1e-9)) * (edge.second - edge.first);
      for (Side own : kSides) {
        const double slack = (length - SideLength(footprint_, own)) / 2;
        // Heading with the side `own` towards the partner: its back would look against the edge's normal.
        const double theta = HeadingOf(edge.outward_normal) + TurnOf(own);
        const auto place = [&](double shift, double gap) {
          const double away = gap + ExtentBehind(footprint_, own) / 2;
          const Vec2<double> p = edge.Middle() + shift * along + away * edge.outward_normal;
          out_.push_back({p.x, p.y, theta});
        };
        place(0, 0);
        place(slack, 0);
        place(-slack, 0);
        place(0, 0.4);
        place(0, 0.8);
        for (int k = 0; k < density_.partner_samples; ++k) {
          place(random_.Uniform(-1, 1) * (std::abs(slack) + 0.3), random_.Uniform(0, 2.0));
        }
      }
    }
  }

  // A rug's centre under the partner, and pulled forward by parts of both depths.
  void Under(int partner) {
    const Pose<double>& pose = context_.layout[partner];
    const Frame<double> frame = FrameOf(pose);
    const double half = scene_.objects[partner].footprint.depth_m / 2;
    AtHeadings(frame.center, pose.theta_rad, 2);
    for (double forward : {half / 2, half, half + footprint_.depth_m / 4, half + footprint_.depth_m / 2,
                           half + footprint_.width_m / 2}) {
      AtHeadings(frame.ToRoom(0, forward), pose.theta_rad, 2);
    }
  }

  void OnTop(int host) {
    const Pose<double>& pose = context_.layout[host];
    const Frame<double> frame = FrameOf(pose);
    const Footprint& top = scene_.objects[host].footprint;
    for (int turn = 0; turn < 4; ++turn) {
      const bool sideways = turn % 2 == 1;
      const double w = sideways ? footprint_.depth_m : footprint_.width_m;
      const double d = sideways ? footprint_.width_m : footprint_.depth_m;
      const double u = std::max(0.0, (top.width_m - w) / 2), v = std::max(0.0, (top.depth_m - d) / 2);
      for (double a : {0.0, -0.5, 0.5, -1.0, 1.0}) {
        for (double b : {0.0, -0.5, 0.5, -1.0, 1.0}) {
          const Vec2<double> p = frame.ToRoom(a * u, b * v);
          out_.push_back({p.x, p.y, pose.theta_rad + turn * kPi / 2});
        }
      }
      for (int k = 0; k < 4; ++k) {
        const Vec2<double> p = frame.ToRoom(random_.Uniform(-u, u), random_.Uniform(-v, v));
        out_.push_back({p.x, p.y, pose.theta_rad + turn * kPi / 2});
      }
    }
  }

  void Middles() {
    const BoundingBox box = BoundsOf(scene_.room.floor);
    AtHeadings(box.Center(), 0, 2);
    AtHeadings(Centroid(scene_.room.floor), 0, 2);
    for (const Vec2<double>& center : context_.zone_centers) {
      if (center.x < 1e3) AtHeadings(center, 0, 2);
    }
  }

  void Spread(int samples) {
    const BoundingBox box = BoundsOf(scene_.room.floor);
    PlaneSequence sequence(random_);
    for (int k = 0; k < samples; ++k) {
      double x = 0, y = 0;
      sequence.Next(x, y);
      const Vec2<double> p{box.min.x + x * box.width_m(), box.min.y + y * box.height_m()};
      if (Contains(scene_.room.floor, p))
        AtHeadings(p, 0, object_.kind == ObjectKind::kFloor && !object_.walk_over ? 4 : 2);
    }
  }

  const CandidateContext& context_;
  const Scene& scene_;
  const Object& object_;
  const Footprint& footprint_;
  const int index_;
  const CandidateDensity& density_;
  Random& random_;
  std::vector<Pose<double>>& out_;
};

// Whether the room goes round the corner where wall `before` ends and wall `after` begins.
bool IsReentrant(const Wall& before, const Wall& after) { return Cross(before.Along(), after.Along()) < -1e-6; }

}  // namespace

void ProposeCandidates(const CandidateContext& context, int object, const CandidateDensity& density, Random& random,
                       std::vector<Pose<double>>& out) {
  Proposer proposer(context, object, density, random, out);
  const Object& what = context.scene.objects[object];
  switch (what.kind) {
    case ObjectKind::kFloor:
      return what.walk_over ? proposer.Rug() : proposer.Floor();
    case ObjectKind::kWall:
      return proposer.Hanging();
    case ObjectKind::kCeiling:
      return proposer.Ceiling();
    case ObjectKind::kSurface:
      return proposer.Surface();
  }
}

void ProposeSlides(const CandidateContext& context, int object, const Pose<double>& pose, double way_m,
                   std::vector<Pose<double>>& out) {
  const Scene& scene = context.scene;
  const Frame<double> frame = FrameOf(pose);
  const double half_u = scene.objects[object].footprint.width_m / 2,
               half_v = scene.objects[object].footprint.depth_m / 2;
  // Free distance to the right, left, front and back.
  std::array<double, 4> free;
  free.fill(std::numeric_limits<double>::infinity());
  const auto see = [&](double low_u, double high_u, double low_v, double high_v) {
    const bool beside = high_v > -half_v && low_v<half_v, before = high_u> - half_u && low_u < half_u;
    if (beside && low_u >= 0) free[0] = std::min(free[0], low_u - half_u);
    if (beside && high_u <= 0) free[1] = std::min(free[1], -half_u - high_u);
    if (before && low_v >= 0) free[2] = std::min(free[2], low_v - half_v);
    if (before && high_v <= 0) free[3] = std::min(free[3], -half_v - high_v);
  };
  const auto see_all = [&](std::span<const Vec2<double>> points) {
    Vec2<double> low{1e9, 1e9}, high{-1e9, -1e9};
    for (const Vec2<double>& point : points) {
      const Vec2<double> local = frame.ToObject(point);
      low = {std::min(low.x, local.x), std::min(low.y, local.y)};
      high = {std::max(high.x, local.x), std::max(high.y, local.y)};
    }
    see(low.x, high.x, low.y, high.y);
  };
  for (int other : context.placed) {
    const Object& neighbour = scene.objects[other];
    if (other == object || neighbour.kind != ObjectKind::kFloor || neighbour.walk_over) continue;
    see_all(Corners(neighbour.footprint, context.layout[other]));
  }
  for (const Wall& wall : scene.room.walls) see_all(std::array<Vec2<double>, 2>{wall.start, wall.end});
  const std::array<Vec2<double>, 4> directions = {frame.right, -frame.right, frame.front, -frame.front};
  for (size_t k = 0; k < 4; ++k) {
    if (!(free[k] < 1e3)) continue;
    for (double slide : {free[k] - kAir_m, free[k] - way_m - kAir_m}) {
      if (std::abs(slide) < 1e-6 || slide < -way_m) continue;
      out.push_back({pose.x_m + slide * directions[k].x, pose.y_m + slide * directions[k].y, pose.theta_rad});
    }
  }
}

void ProposeSlidesOffCorners(const Room& room, const Footprint& footprint, const Pose<double>& pose, double way_m,
                             std::vector<Pose<double>>& out) {
  const Frame<double> frame = FrameOf(pose);
  for (size_t i = 0; i < room.walls.size(); ++i) {
    const Wall& wall = room.walls[i];
    if (!IsReentrant(room.walls[(i + room.walls.size() - 1) % room.walls.size()], wall)) continue;
    const Vec2<double> p = frame.ToObject(wall.start);
    const double u = std::abs(p.x) - footprint.width_m / 2, v = std::abs(p.y) - footprint.depth_m / 2;
    const double distance = std::sqrt(u * u + v * v);
    if (u <= 0 || v <= 0 || distance >= way_m) continue;
    const auto slide = [&](double along_u, double along_v) {
      const Vec2<double> to = frame.ToRoom(p.x > 0 ? -along_u : along_u, p.y > 0 ? -along_v : along_v);
      out.push_back({to.x, to.y, pose.theta_rad});
    };
    slide(std::sqrt(way_m * way_m - v * v) - u + kAir_m, 0);
    slide(0, std::sqrt(way_m * way_m - u * u) - v + kAir_m);
    const double more = (way_m - distance + kAir_m) / distance;
    slide(more * u, more * v);
  }
}

void ProposeNudges(const Pose<double>& pose, Random& random, std::vector<Pose<double>>& out) {
  const Frame<double> frame = FrameOf(pose);
  for (double reach : {0.4, 0.1, 0.02}) {
    for (int k = 0; k < 4; ++k) {
      const double step = reach * random.Uniform(0.3, 1.0) * (k % 2 == 0 ? 1 : -1);
      const Vec2<double> p = k < 2 ? frame.ToRoom(step, 0) : frame.ToRoom(0, step);
      out.push_back({p.x, p.y, pose.theta_rad});
    }
  }
  for (int turn = 1; turn < 4; ++turn) out.push_back({pose.x_m, pose.y_m, pose.theta_rad + turn * kPi / 2});
}

}  // namespace flair::optimizer
