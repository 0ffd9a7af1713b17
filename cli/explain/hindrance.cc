// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/hindrance.h"

#include <algorithm>
#include <cmath>

#include "cli/explain/layout_note.h"
#include "evaluation/metrics/measures.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "room/geometry/polygon.h"
#include "room/geometry/pose.h"

namespace flair::cli {
namespace {

// As satisfied as the optimizer takes a call to be.
constexpr double kHolds = 1e-3;
// Where places are looked for, and how many of them are tried.
constexpr double kGrid_m = 0.12, kNear = 0.06, kFinest_m = 2e-3;
constexpr size_t kMostPlaces = 60;

struct Tried {
  Pose<double> pose;
  double value = 0;
};

}  // namespace

Hindrances::Hindrances(const v1::SolvedLayout& layout, const Scene& scene, const PartialLayout& where)
    : layout_(layout), scene_(scene), where_(where), linked_(scene, layout.graph()) {
  // What is asked of zones moves with everything in them: no single piece is in its way.
  const std::vector<Vec2<double>> centers(scene.zones.size(), Vec2<double>{1e6, 1e6});
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    auto cost = optimizer::Bind(edge, {scene, centers, &linked_});
    costs_.push_back(cost.ok() ? *std::move(cost) : nullptr);
  }
}

double Hindrances::ValueOf(int edge, const Layout& layout) const {
  std::vector<Pose<double>> poses;
  for (const int object : costs_[static_cast<size_t>(edge)]->objects()) {
    poses.push_back(layout[static_cast<size_t>(object)]);
  }
  return costs_[static_cast<size_t>(edge)]->Value(poses);
}

// Poses of the object, everything else as it is, at which the call holds.
std::vector<Pose<double>> Hindrances::PlacesFor(int edge, int object) const {
  Layout layout = where_.layout;
  Pose<double>& pose = layout[static_cast<size_t>(object)];
  std::vector<double> headings = {pose.theta_rad};
  for (const Wall& wall : scene_.room.walls) {
    const double heading = wall.BackHeading();
    const auto alike = [&](double other) { return std::cos(other - heading) > 0.999; };
    if (std::ranges::none_of(headings, alike)) headings.push_back(heading);
  }
  const BoundingBox box = BoundsOf(scene_.room.floor);
  std::vector<Tried> near;
  for (const double heading : headings) {
    for (double x = box.min.x; x <= box.max.x; x += kGrid_m) {
      for (double y = box.min.y; y <= box.max.y; y += kGrid_m) {
        pose = {x, y, heading};
        if (const double value = ValueOf(edge, layout); value < kNear) near.push_back({pose, value});
      }
    }
  }
  const Pose<double>& now = where_.layout[static_cast<size_t>(object)];
  std::ranges::stable_sort(near, {}, [&](const Tried& tried) {
    return std::pair(std::max(tried.value, kHolds), std::hypot(tried.pose.x_m - now.x_m, tried.pose.y_m - now.y_m));
  });
  if (near.size() > kMostPlaces) near.resize(kMostPlaces);
  std::vector<Pose<double>> places;
  for (Tried& tried : near) {
    for (double step_m = kGrid_m / 2; step_m > kFinest_m && tried.value > kHolds;) {
      const double before = tried.value;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        pose = {tried.pose.x_m + dx * step_m, tried.pose.y_m + dy * step_m, tried.pose.theta_rad};
        if (const double value = ValueOf(edge, layout); value < tried.value) tried = {pose, value};
      }
      if (tried.value >= before) step_m /= 2;
    }
    if (tried.value <= kHolds) places.push_back(tried.pose);
  }
  return places;
}

// Who is in the way of the object there; nullopt where the room itself is.
std::optional<std::vector<std::string>> Hindrances::InTheWay(const PartialLayout& moved, int object) const {
  constexpr double kTouching_m = 0.015;
  std::vector<std::string> names;
  for (const v1::Finding& finding : evaluation::MeasureSolids({scene_, moved.layout, moved.placed}).findings) {
    const std::string& id = scene_.objects[static_cast<size_t>(object)].id;
    if ((finding.object_id() != id && finding.partner_id() != id) || finding.amount() < kTouching_m) continue;
    if (finding.kind() == v1::FINDING_KIND_OUTSIDE) return std::nullopt;
    const std::string& other = finding.object_id() == id ? finding.partner_id() : finding.object_id();
    if (const int piece = scene_.IndexOf(other); piece >= 0) names.push_back(NameForPeople(scene_, piece));
    for (const Opening& opening : scene_.room.openings) {
      if (opening.id == other) names.push_back(NameForPeople(scene_.room, opening));
    }
  }
  return names;
}

std::string Hindrances::Of(int edge, int object) const {
  if (costs_[static_cast<size_t>(edge)] == nullptr || object < 0) return "";
  const Object& what = scene_.objects[static_cast<size_t>(object)];
  const std::span<const int> objects = costs_[static_cast<size_t>(edge)]->objects();
  const auto is_placed = [&](int one) { return where_.placed[static_cast<size_t>(one)]; };
  if (what.walk_over || what.kind == ObjectKind::kSurface || what.kind == ObjectKind::kCeiling) return "";
  if (std::ranges::find(objects, object) == objects.end() || !std::ranges::all_of(objects, is_placed)) return "";
  PartialLayout moved = where_;
  // What stands on it, and what is put beside it, goes along.
  for (int i = 0; i < static_cast<int>(scene_.objects.size()); ++i) {
    if (i == object || !where_.placed[static_cast<size_t>(i)]) continue;
    const bool carried = CarrierOf(scene_, i, where_.layout, where_.placed) == object;
    if (carried || linked_.TieOf(object, i) > 0) moved.placed[static_cast<size_t>(i)] = false;
  }
  const Pose<double> now = where_.layout[static_cast<size_t>(object)];
  std::string words;
  double least = 1e300;
  for (const Pose<double>& place : PlacesFor(edge, object)) {
    moved.layout[static_cast<size_t>(object)] = place;
    const double away_m = std::hypot(place.x_m - now.x_m, place.y_m - now.y_m);
    const auto names = InTheWay(moved, object);
    if (!names || static_cast<double>(names->size()) * 100 + away_m >= least) continue;
    std::vector<std::string> broken;
    for (int e = 0; names->empty() && e < layout_.edge_outcomes_size(); ++e) {
      if (e != edge && BreaksAt(e, object, moved)) broken.push_back(Quoted(e));
    }
    const double burden = static_cast<double>(names->size() + broken.size()) * 100 + away_m;
    if (burden >= least) continue;
    least = burden;
    const bool several = names->size() > 1;
    words = !names->empty()
                ? fmt::format("{} {} in the way where it would hold", Joined(*names), several ? "are" : "is")
            : !broken.empty() ? fmt::format("where it would hold, {} would not", broken.front())
                              : "";
  }
  return words;
}

bool Hindrances::BreaksAt(int edge, int object, const PartialLayout& moved) const {
  if (layout_.edge_outcomes(edge).status() != v1::OUTCOME_STATUS_SATISFIED) return false;
  if (costs_[static_cast<size_t>(edge)] == nullptr) return false;
  const std::vector<int> named = optimizer::NamedObjects(layout_.graph().edges(edge), scene_);
  const auto stays = [&](int one) { return moved.placed[static_cast<size_t>(one)]; };
  if (std::ranges::find(named, object) == named.end() || !std::ranges::all_of(named, stays)) return false;
  return ValueOf(edge, moved.layout) > kHolds;
}

// The sentence of a call, in quotes; a call without one is "something that holds now".
std::string Hindrances::Quoted(int edge) const {
  const std::string& id = layout_.graph().edges(edge).sentence_id();
  for (const v1::Sentence& sentence : layout_.graph().constraint_list().sentences()) {
    if (!id.empty() && sentence.id() == id) return fmt::format("\"{}\"", WithoutStop(sentence.text()));
  }
  return "something that holds now";
}

}  // namespace flair::cli
