// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/comparison/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "worker_runtime/status/status_macros.h"

namespace flair::renderer {
namespace {

constexpr double kSameM = 5e-4;

const v1::Object* ObjectOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.id() == id) return &object;
  }
  return nullptr;
}

std::optional<PlanObject> DrawnObject(const Plan& plan, const std::string& id) {
  const auto found = std::ranges::find(plan.objects, id, &PlanObject::id);
  return found == plan.objects.end() ? std::nullopt : std::optional<PlanObject>(*found);
}

ChangeKind KindOf(const v1::Object* before, const v1::Object* after) {
  if (before == nullptr) return ChangeKind::kAdded;
  if (after == nullptr) return ChangeKind::kRemoved;
  const bool is_resized = std::abs(before->width_m() - after->width_m()) > kSameM ||
                          std::abs(before->depth_m() - after->depth_m()) > kSameM;
  return is_resized ? ChangeKind::kResized : ChangeKind::kMoved;
}

// Whether a place in the one room means anything in the other: their extents share three quarters of both.
bool IsSameRoom(const Plan& a, const Plan& b) {
  const double shared =
      std::min(a.bounds_m.width(), b.bounds_m.width()) * std::min(a.bounds_m.height(), b.bounds_m.height());
  const auto area = [](const Box& box) { return box.width() * box.height(); };
  return shared >= 0.75 * (area(a.bounds_m) + area(b.bounds_m) - shared);
}

absl::StatusOr<PlanLayers> LayersOfComparison(const v1::RenderOptions& options) {
  absl::StatusOr<PlanLayers> layers = LayersOf(options);
  if (layers.ok()) layers->dimensions = false;
  return layers;
}

// The change at `path` between the first panel's layout and another's.
absl::StatusOr<PlanChange> ReadChange(const v1::ObjectChange& change, const std::string& path,
                                      const v1::SolvedLayout& before, const Plan& plan_before,
                                      const v1::SolvedLayout& after, const Plan& plan_after) {
  const v1::Object* was = ObjectOf(before, change.before_object_id());
  const v1::Object* is = ObjectOf(after, change.after_object_id());
  const auto missing = [&](const char* field, const std::string& id, const v1::Object* object) {
    if (id.empty() || object != nullptr) return absl::OkStatus();
    return absl::InvalidArgumentError(fmt::format("{}.{}: \"{}\" is not an object of its layout", path, field, id));
  };
  RETURN_IF_ERROR(missing("before_object_id", change.before_object_id(), was));
  RETURN_IF_ERROR(missing("after_object_id", change.after_object_id(), is));
  if (was == nullptr && is == nullptr) {
    return absl::InvalidArgumentError(path + ": names no object; before_object_id, after_object_id or both");
  }
  PlanChange read{.kind = KindOf(was, is), .name = is != nullptr ? is->name() : was->name(), .words = change.words()};
  if (read.name.empty()) read.name = is != nullptr ? is->id() : was->id();
  if (was != nullptr) read.before = DrawnObject(plan_before, was->id());
  if (is != nullptr) read.after = DrawnObject(plan_after, is->id());
  return read;
}

}  // namespace

absl::StatusOr<Comparison> ReadComparison(const v1::RenderRequest& request) {
  ASSIGN_OR_RETURN(const PlanLayers layers, LayersOfComparison(request.options()));
  ASSIGN_OR_RETURN(Plan first, ReadPlan(request.solved_layout(), layers));
  Comparison comparison{.title = first.title};
  comparison.panels.push_back({std::move(first), request.caption(), request.remark(), {}, {}});
  for (int i = 0; i < request.beside_size(); ++i) {
    const v1::ComparedLayout& other = request.beside(i);
    absl::StatusOr<Plan> plan = ReadPlan(other.solved_layout(), layers);
    if (!plan.ok()) {
      return absl::Status(plan.status().code(), fmt::format("beside[{}].{}", i, std::string(plan.status().message())));
    }
    ComparisonPanel panel{*std::move(plan), other.caption(), other.remark(), {}, {}};
    for (int j = 0; j < other.changes_size(); ++j) {
      ASSIGN_OR_RETURN(PlanChange change, ReadChange(other.changes(j), fmt::format("beside[{}].changes[{}]", i, j),
                                                     request.solved_layout(), comparison.panels.front().plan,
                                                     other.solved_layout(), panel.plan));
      change.number = ++comparison.change_count;
      if (change.kind == ChangeKind::kRemoved) comparison.panels.front().removed.push_back(change);
      if (!IsSameRoom(comparison.panels.front().plan, panel.plan)) change.before.reset();
      panel.changes.push_back(std::move(change));
    }
    comparison.panels.push_back(std::move(panel));
  }
  return comparison;
}

}  // namespace flair::renderer
