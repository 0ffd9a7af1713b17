// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "renderer_worker/scene/room_shape.h"

namespace flair::renderer {
namespace {

constexpr size_t kMaxBoxes = 80;

float Volume(const SightBox& box) { return box.half.x * box.half.y * box.half.z; }

// Where the way enters the box, `miss` when it does not up to there.
float Enter(const SightBox& box, Vec3 eye, Vec3 direction, float miss) {
  const Vec3 from = eye - box.centre;
  const float origin[] = {Dot(from, box.right), Dot(from, box.front), from.z};
  const float along[] = {Dot(direction, box.right), Dot(direction, box.front), direction.z};
  const float half[] = {box.half.x, box.half.y, box.half.z};
  float enter = 0, leave = miss;
  for (int k = 0; k < 3; ++k) {
    const float inverse = 1 / (std::abs(along[k]) > 1e-9F ? along[k] : 1e-9F);
    const float a = (-half[k] - origin[k]) * inverse, b = (half[k] - origin[k]) * inverse;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave ? enter : miss;
}

std::vector<SightBox> LeavesOf(const RoomShape& shape) {
  std::vector<SightBox> leaves;
  for (const ShapedWall& wall : shape.walls) {
    for (const ShapedOpening& opening : wall.openings) {
      const std::optional<Axes> axes = OpenLeafAxes(shape, wall, opening);
      if (!axes.has_value()) continue;
      SightBox leaf;
      const float width = opening.u1 - opening.u0;
      leaf.half = {width < 1.3F ? width / 2 : width / 4, 0.03F, (opening.w1 - opening.w0) / 2};  // wide ones have two
      leaf.centre = axes->At(leaf.half.x, 0, leaf.half.z);
      leaf.right = axes->along;
      leaf.front = axes->outward;
      leaves.push_back(leaf);
    }
  }
  return leaves;
}

constexpr float kBirdseyeFov_rad = 0.52F;
constexpr float kBirdseyeElevation_rad = 0.90F;
constexpr float kPerspectiveFov_rad = 1.13F;
constexpr float kEyeHeight_m = 1.5F;
constexpr float kMargin = 0.95F;  // share of the half picture that the room may fill

struct View {
  Vec3 right, down, forward;
};

View Looking(Vec3 forward) {
  const Vec3 right = Normalized(Cross(forward, {0, 0, 1}));
  return {right, Cross(forward, right), forward};
}

// Outer corners of the walls as a view from `eye_direction` shows them: uncut ones up to the ceiling.
std::vector<Vec3> Silhouette(const RoomShape& shape, const CutAway& cut) {
  std::vector<Vec3> points;
  for (size_t i = 0; i < shape.walls.size(); ++i) {
    const ShapedWall& wall = shape.walls[i];
    const float top = cut.walls[i] == WallCut::kWhole ? shape.height_m : 0.1F;
    for (const float u : {wall.outer_start, wall.outer_end}) {
      points.push_back(wall.axes.At(u, shape.wall_thickness_m, top));
      points.push_back(wall.axes.At(u, shape.wall_thickness_m, -kSlabThickness_m));
    }
  }
  return points;
}

// The eye nearest to the points from which all of them are within `tangent` of the axis, centred both ways.
Vec3 EyeThatSees(const std::vector<Vec3>& points, const View& view, float tangent) {
  float right = -1e9F, left = -1e9F, down = -1e9F, up = -1e9F;
  for (const Vec3& p : points) {
    const float x = Dot(p, view.right), y = Dot(p, view.down), z = Dot(p, view.forward) * tangent;
    right = std::max(right, x - z);
    left = std::max(left, -x - z);
    down = std::max(down, y - z);
    up = std::max(up, -y - z);
  }
  const float depth = -std::max(right + left, down + up) / (2 * tangent);
  return view.right * ((right - left) / 2) + view.down * ((down - up) / 2) + view.forward * depth;
}

float MainDirection(const RoomShape& shape) {
  const auto longest = std::ranges::max_element(
      shape.walls, [](const auto& a, const auto& b) { return a.length_m < b.length_m - 1e-4F; });
  return std::atan2(longest->axes.along.y, longest->axes.along.x);
}

// How much an object counts: large pieces more, but not in proportion.
double WeightOf(const SightBox& box) {
  return std::sqrt(4.0 * std::max({box.half.x * box.half.y, box.half.x * box.half.z, box.half.y * box.half.z})) + 0.1;
}

SceneCamera BirdseyeFrom(const RoomShape& shape, float azimuth) {
  const float up = std::sin(kBirdseyeElevation_rad), out = std::cos(kBirdseyeElevation_rad);
  const View view = Looking({-std::cos(azimuth) * out, -std::sin(azimuth) * out, -up});
  const float tangent = std::tan(kBirdseyeFov_rad / 2) * kMargin;
  CutAway cut{true, std::vector<WallCut>(shape.walls.size(), WallCut::kWhole)};
  Vec3 eye;
  // What is cut depends on where the eye is, and where the eye is on what is cut.
  for (int round = 0; round < 3; ++round) {
    eye = EyeThatSees(Silhouette(shape, cut), view, tangent);
    eye.z = std::max(eye.z, shape.height_m + 0.01F);
    cut = CutAwayFor(shape, eye);
  }
  const auto [low, high] = Bounds2(shape.floor);
  const float distance = std::max(1.0F, Dot(Vec3{(low.x + high.x) / 2, (low.y + high.y) / 2, 0} - eye, view.forward));
  return {"birdseye", eye, eye + view.forward * distance, kBirdseyeFov_rad};
}

double BirdseyeScore(const RoomShape& shape, const Sight& sight, const SceneCamera& camera) {
  const CutAway cut = CutAwayFor(shape, camera.eye);
  const Vec3 to_eye = Normalized(camera.eye - camera.target);
  double score = 0;
  for (int i = 0; i < static_cast<int>(sight.boxes().size()); ++i) {
    const SightBox& box = sight.boxes()[i];
    if (box.high) continue;
    const double share = sight.VisibleShare(i, camera.eye, cut, [](Vec3) { return true; });
    // The taller a piece, the more of the picture its bare back would be. What goes with its wall shows none.
    const double facing = box.GoneIn(cut) ? 0 : Dot(box.front, to_eye) * (0.4 + 0.5 * box.half.z);
    score += WeightOf(box) * (share + facing);
  }
  for (size_t i = 0; i < shape.walls.size(); ++i) {
    if (cut.walls[i] == WallCut::kWhole) score += 0.6 * static_cast<double>(shape.walls[i].openings.size());
  }
  return score;
}

// Eyes worth trying: inwards of and behind the boundary in sixteen directions from the middle, and in the doors.
std::vector<Vec3> EyesToTry(const RoomShape& shape, Vec3 middle, float height) {
  std::vector<Vec3> eyes;
  const float main = MainDirection(shape);
  for (int k = 0; k < 16; ++k) {
    const float azimuth = main + (static_cast<float>(k) + 0.5F) * kPiFloat / 8;
    const Vec3 out{std::cos(azimuth), std::sin(azimuth), 0};
    float boundary = 0;
    for (const ShapedWall& wall : shape.walls) {
      const float rate = Dot(out, wall.axes.outward);
      if (rate < 1e-4F) continue;
      const float distance = Dot(wall.axes.origin - middle, wall.axes.outward) / rate;
      const float along = Dot(middle + out * distance - wall.axes.origin, wall.axes.along);
      if (distance > 0 && along >= -1e-3F && along <= wall.length_m + 1e-3F) boundary = std::max(boundary, distance);
    }
    for (const float beyond : {-0.7F, -0.25F, 0.3F, 0.8F})
      eyes.push_back(middle + out * std::max(0.1F, boundary + beyond));
  }
  for (const ShapedWall& wall : shape.walls) {
    for (const ShapedOpening& opening : wall.openings) {
      if (opening.door()) eyes.push_back(wall.axes.At((opening.u0 + opening.u1) / 2, 0.5F, 0));
    }
  }
  for (Vec3& eye : eyes) eye.z = height;
  return eyes;
}

struct Spoiled {
  double close = 0;    // share of the picture that something right before the eye takes
  double outside = 0;  // share that is not of the room
};

Spoiled SpoiledShares(const RoomShape& shape, const Sight& sight, const SceneCamera& camera, const CutAway& cut) {
  constexpr int kRays = 14;
  constexpr float kClose_m = 2.0F;
  const View view = Looking(Normalized(camera.target - camera.eye));
  const float tangent = std::tan(camera.field_of_view_rad / 2);
  Spoiled spoiled;
  for (int i = 0; i < kRays; ++i) {
    for (int k = 0; k < kRays; ++k) {
      const float x = (2 * (static_cast<float>(i) + 0.5F) / kRays - 1) * tangent;
      const float y = (2 * (static_cast<float>(k) + 0.5F) / kRays - 1) * tangent;
      const Vec3 direction = Normalized(view.forward + view.right * x + view.down * y);
      const float distance = sight.FirstBox(camera.eye, direction, kClose_m, -1, cut);
      spoiled.close += std::pow(1 - distance / kClose_m, 1.5);
      if (std::isinf(WayIn(shape, camera.eye, direction))) spoiled.outside += 1;
    }
  }
  return {spoiled.close / (kRays * kRays), spoiled.outside / (kRays * kRays)};
}

double PerspectiveScore(const RoomShape& shape, const Sight& sight, const SceneCamera& camera) {
  const CutAway cut = CutAwayFor(shape, camera.eye);
  const View view = Looking(Normalized(camera.target - camera.eye));
  const float tangent = std::tan(camera.field_of_view_rad / 2) * 0.97F;
  const auto framed = [&](Vec3 point) {
    const Vec3 p = point - camera.eye;
    const float z = Dot(p, view.forward);
    return z > 0.3F && std::abs(Dot(p, view.right)) < z * tangent && std::abs(Dot(p, view.down)) < z * tangent;
  };
  double score = 0, most = 0.1;
  for (int i = 0; i < static_cast<int>(sight.boxes().size()); ++i) {
    const SightBox& box = sight.boxes()[i];
    const double weight = WeightOf(box);
    const double facing = Dot(box.front, Normalized(camera.eye - box.centre));
    score += weight * sight.VisibleShare(i, camera.eye, cut, framed) * (1 + 0.2 * facing);
    most += weight;
  }
  for (const ShapedWall& wall : shape.walls) {
    for (const ShapedOpening& opening : wall.openings) {
      const Vec3 at = wall.axes.At((opening.u0 + opening.u1) / 2, 0, (opening.w0 + opening.w1) / 2);
      const bool faces = Dot(camera.eye - at, wall.axes.outward) < -0.3F;
      if (faces && framed(at)) score += opening.door() ? 0.03 * most : 0.08 * most;
    }
  }
  const Spoiled spoiled = SpoiledShares(shape, sight, camera, cut);
  return score / most - 2.0 * spoiled.close - 8.0 * spoiled.outside;
}

}  // namespace

Sight::Sight(const RoomShape& shape, const std::vector<SceneObject>& objects)
    : shape_(shape), leaves_(LeavesOf(shape)) {
  for (const SceneObject& o : objects) {
    if (o.object->walk_over()) continue;
    const float theta = static_cast<float>(o.placement.theta_rad());
    SightBox box;
    box.half = Vec3{static_cast<float>(o.object->width_m()), static_cast<float>(o.object->depth_m()),
                    static_cast<float>(o.object->height_m())} *
               0.5F;
    box.centre = {static_cast<float>(o.placement.x_m()), static_cast<float>(o.placement.y_m()),
                  static_cast<float>(o.placement.z_m()) + box.half.z};
    box.right = {std::cos(theta), std::sin(theta), 0};
    box.front = {-std::sin(theta), std::cos(theta), 0};
    box.high = o.object->kind() == v1::OBJECT_KIND_CEILING;
    box.wall = o.wall;
    boxes_.push_back(box);
  }
  if (boxes_.size() > kMaxBoxes) {
    std::ranges::stable_sort(boxes_, [](const SightBox& a, const SightBox& b) { return Volume(a) > Volume(b); });
    boxes_.resize(kMaxBoxes);
  }
}

float Sight::FirstBox(Vec3 eye, Vec3 direction, float miss, int but, const CutAway& cut) const {
  float first = miss;
  for (int i = 0; i < static_cast<int>(boxes_.size()); ++i) {
    if (i != but && !boxes_[i].GoneIn(cut)) first = std::min(first, Enter(boxes_[i], eye, direction, first));
  }
  for (const SightBox& leaf : leaves_) first = std::min(first, Enter(leaf, eye, direction, first));
  return first;
}

bool Sight::WallBetween(Vec3 eye, Vec3 point, const CutAway& cut) const {
  for (size_t i = 0; i < shape_.walls.size(); ++i) {
    if (cut.walls[i] != WallCut::kWhole) continue;
    const ShapedWall& wall = shape_.walls[i];
    const float from = Dot(eye - wall.axes.origin, wall.axes.outward);
    const float to = Dot(point - wall.axes.origin, wall.axes.outward);
    // What hangs on a wall may reach into it.
    if (from > 0 ? to > -0.02F : to < 0.05F) continue;
    const Vec3 at = eye + (point - eye) * (from / (from - to));
    const float along = Dot(at - wall.axes.origin, wall.axes.along);
    if (along > 0 && along < wall.length_m && at.z < shape_.height_m) return true;
  }
  return false;
}

SceneCamera BirdseyeCamera(const RoomShape& shape, const Sight& sight) {
  const float main = MainDirection(shape);
  SceneCamera best;
  double best_score = -1e9;
  for (int quarter = 0; quarter < 4; ++quarter) {
    for (const float skew : {-0.22F, 0.22F}) {
      const SceneCamera camera = BirdseyeFrom(shape, main + (static_cast<float>(quarter) + 0.5F) * kPiFloat / 2 + skew);
      const double score = BirdseyeScore(shape, sight, camera);
      if (score > best_score + 1e-6) best = camera, best_score = score;
    }
  }
  return best;
}

SceneCamera PerspectiveCamera(const RoomShape& shape, const Sight& sight) {
  Vec3 middle;
  double total = 0;
  for (const ShapedWall& wall : shape.walls) {
    middle = middle + wall.axes.At(wall.length_m / 2, 0, 0) * wall.length_m;
    total += wall.length_m;
  }
  middle = middle * static_cast<float>(1 / total);
  const float height = std::min(kEyeHeight_m, shape.height_m - 0.3F);
  SceneCamera best{"perspective", {middle.x, middle.y, height}, {middle.x, middle.y + 1, height}, kPerspectiveFov_rad};
  double best_score = -1e9;
  for (const Vec3& eye : EyesToTry(shape, middle, height)) {
    Vec3 way = middle - eye;
    way.z = 0;
    if (Length(way) < 0.3F) continue;
    const Vec3 ahead = Normalized(way);
    for (const float turn : {-0.25F, 0.0F, 0.25F}) {
      const Vec3 forward{ahead.x * std::cos(turn) - ahead.y * std::sin(turn),
                         ahead.x * std::sin(turn) + ahead.y * std::cos(turn), -0.13F};
      const SceneCamera camera{"perspective", eye, eye + forward * std::max(1.0F, Length(way)), kPerspectiveFov_rad};
      const double score = PerspectiveScore(shape, sight, camera);
      if (score > best_score + 1e-6) best = camera, best_score = score;
    }
  }
  return best;
}

}  // namespace flair::renderer
