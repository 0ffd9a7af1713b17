// SPDX-License-Identifier: GPL-3.0-or-later
// Copies beside their originals.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "optimizer_worker/solver/separation.h"
#include "room/conversion/conversion.h"
#include "session/layouts/placing.h"

namespace flair::session {
namespace {

constexpr double kStep_m = 0.1, kFarthest_m = 4;
constexpr int kDirections = 16;

// A piece that an edit puts onto what it is a copy of.
struct Copy {
  v1::Placement* at;
  int object;  // of the scene
};

class Floor {
 public:
  Floor(Scene scene, const v1::SolvedLayout& layout) : scene_(std::move(scene)), keep_out_(scene_.room) {
    places_.resize(scene_.objects.size());
    placed_.resize(scene_.objects.size(), false);
    for (const v1::Placement& at : layout.placements()) {
      const int object = scene_.IndexOf(at.object_id());
      if (object >= 0) Put(object, at, {});
    }
  }

  const Scene& scene() const { return scene_; }

  void Put(int object, const v1::Placement& at, const Vec2<double>& by) {
    places_[object] = {at.x_m() + by.x, at.y_m() + by.y, at.theta_rad()};
    placed_[object] = true;
  }

  // Whether these would stand free, moved by so much.
  bool AreFree(const std::vector<Copy>& copies, const Vec2<double>& by) {
    for (const Copy& copy : copies) Put(copy.object, *copy.at, by);
    std::vector<int> standing;
    for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
      if (placed_[i] && IsSolid(scene_.objects[i])) standing.push_back(i);
    }
    constexpr double kTouching_m = 1e-6;
    const auto is_of_copy = [&](const optimizer::Violation& one) {
      return std::ranges::any_of(
          copies, [&](const Copy& copy) { return copy.object == one.object || copy.object == one.other; });
    };
    return std::ranges::none_of(optimizer::FindViolations(scene_, keep_out_, standing, places_, kTouching_m),
                                is_of_copy);
  }

  // The shortest way to where they all stand free.
  std::optional<Vec2<double>> WayToFree(const std::vector<Copy>& copies, double farthest_m = kFarthest_m) {
    // Along its own sides first: a copy belongs beside its original.
    const double theta_rad = copies.front().at->theta_rad();
    for (double far_m = 0; far_m <= farthest_m; far_m += kStep_m) {
      for (int i = 0; i < kDirections; ++i) {
        const double angle_rad = theta_rad + 2 * M_PI * i / kDirections;
        const Vec2<double> by{far_m * std::cos(angle_rad), far_m * std::sin(angle_rad)};
        if (AreFree(copies, by)) return by;
        if (far_m == 0) break;
      }
    }
    return std::nullopt;
  }

 private:
  const Scene scene_;
  const optimizer::KeepOut keep_out_;
  Layout places_;
  std::vector<char> placed_;
};

bool AreSame(const v1::Object& a, const v1::Object& b) {
  return a.name() == b.name() && a.kind() == b.kind() && a.width_m() == b.width_m() && a.depth_m() == b.depth_m();
}

// Where the edits put a copy, and what they add that stands on it.
std::vector<v1::Placement*> WithRiders(v1::Placement& host, EditList& edits) {
  std::vector<v1::Placement*> places = {&host};
  for (const v1::LayoutEdit& edit : edits) {
    const v1::Object& object = edit.add_object().object();
    if (!edit.has_add_object() || object.kind() != v1::OBJECT_KIND_SURFACE || object.host_id() != host.object_id()) {
      continue;
    }
    for (v1::LayoutEdit& move : edits) {
      if (move.has_move_object() && move.move_object().object_id() == object.id()) {
        places.push_back(move.mutable_move_object());
      }
    }
  }
  return places;
}

}  // namespace

void PutCopiesBeside(const v1::SolvedLayout& layout, EditList& edits) {
  v1::LayoutGraph graph = layout.graph();
  std::map<std::string, const v1::Object*> added;
  for (const v1::LayoutEdit& edit : edits) {
    if (!edit.has_add_object()) continue;
    const v1::Object& object = edit.add_object().object();
    const bool floor = object.kind() == v1::OBJECT_KIND_FLOOR && !object.walk_over();
    if (floor && added.emplace(object.id(), &object).second) *graph.mutable_object_list()->add_objects() = object;
  }
  if (added.empty()) return;
  absl::StatusOr<Scene> scene = SceneFromProto(graph);
  if (!scene.ok()) return;
  Floor floor(*std::move(scene), layout);
  std::vector<Copy> copies;
  for (v1::LayoutEdit& edit : edits) {
    if (!edit.has_move_object() || !added.contains(edit.move_object().object_id())) continue;
    v1::Placement& to = *edit.mutable_move_object();
    const v1::Object& object = *added[to.object_id()];
    for (const v1::Object& original : layout.graph().object_list().objects()) {
      if (!AreSame(original, object)) continue;
      const v1::Placement* const at = PlaceOf(layout, original.id());
      if (at == nullptr) continue;
      const Footprint size{object.width_m(), object.depth_m()};
      const auto box = [&](const v1::Placement& where) {
        return Box<double>(size, FrameOf(Pose<double>{where.x_m(), where.y_m(), where.theta_rad()}));
      };
      if (optimizer::Separate(box(to), box(*at)).gap_m >= 0) continue;
      copies.push_back({&to, floor.scene().IndexOf(object.id())});
      break;
    }
  }
  if (copies.empty()) return;
  const auto put = [&](const std::vector<Copy>& some, const Vec2<double>& by) {
    for (const Copy& copy : some) {
      for (v1::Placement* const at : WithRiders(*copy.at, edits)) {
        at->set_x_m(at->x_m() + by.x);
        at->set_y_m(at->y_m() + by.y);
      }
      floor.Put(copy.object, *copy.at, {});
    }
  };
  if (const auto way = floor.WayToFree(copies)) return put(copies, *way);
  for (const Copy& copy : copies) {
    if (const auto way = floor.WayToFree({copy})) put({copy}, *way);
  }
}

bool PutWhereFree(const v1::SolvedLayout& layout, double farthest_m,
                  google::protobuf::RepeatedPtrField<v1::Placement>& placements) {
  v1::SolvedLayout moved = layout;
  absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  if (!scene.ok() || !Place(moved, placements, "placements").ok()) return false;
  Floor floor(*std::move(scene), moved);
  for (v1::Placement& to : placements) {
    const int object = floor.scene().IndexOf(to.object_id());
    if (object < 0 || !IsSolid(floor.scene().objects[object])) return false;
    const auto way = floor.WayToFree({{&to, object}}, farthest_m);
    if (!way.has_value()) return false;
    to.set_x_m(to.x_m() + way->x);
    to.set_y_m(to.y_m() + way->y);
    floor.Put(object, to, {});
  }
  return true;
}

}  // namespace flair::session
