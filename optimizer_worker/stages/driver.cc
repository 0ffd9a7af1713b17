// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/driver.h"

#include <algorithm>
#include <cmath>

namespace flair::optimizer {
namespace {

// How many of the best, distinct primary layouts are furnished to the end.
constexpr size_t kBeam = 3;
// Primary layouts nearer than this (sum over objects) are the same.
constexpr double kSame_m = 0.3;

double DistanceOf(const StageSpec& stage, const PartialLayout& a, const PartialLayout& b) {
  double sum = 0;
  for (int object : stage.objects) {
    sum += Distance(Center(a.layout[object]), Center(b.layout[object])) +
           (1 - std::cos(a.layout[object].theta_rad - b.layout[object].theta_rad));
  }
  return sum;
}

// Up to `count` results that differ visibly, best first.
std::vector<size_t> DistinctBest(const StageSpec& stage, const std::vector<RestartResult>& results, size_t count) {
  std::vector<size_t> order(results.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return results[a].score < results[b].score; });
  std::vector<size_t> kept;
  for (size_t i : order) {
    if (kept.size() == count) break;
    const bool known = std::any_of(kept.begin(), kept.end(), [&](size_t k) {
      return DistanceOf(stage, results[i].state, results[k].state) < kSame_m;
    });
    if (!known) kept.push_back(i);
  }
  return kept;
}

}  // namespace

int Driver::RestartsOf(const StageSpec& stage) const {
  return input_.settings.max_restarts > 0 ? input_.settings.max_restarts : DefaultRestarts(stage);
}

// The account of a stage that ended with `results`, of which `taken` was taken.
void Driver::Record(Branch& branch, const StageSpec& stage, const std::vector<RestartResult>& results, size_t taken,
                    absl::Time started) const {
  v1::StageOutcome& outcome = branch.outcomes.emplace_back();
  outcome.set_stage(std::string(StageName(stage.kind)));
  if (stage.zone >= 0) outcome.set_zone_id(input_.scene.zones[stage.zone].id);
  outcome.set_restart_count(static_cast<int>(results.size()));
  outcome.set_best_restart(results[taken].restart);
  int64_t evaluations = 0;
  for (const RestartResult& result : results) evaluations += result.evaluations;
  outcome.set_evaluation_count(evaluations);
  outcome.set_seed(static_cast<int64_t>(RestartSeed(input_.settings, stage, 0)));
  outcome.set_cost(results[taken].score);
  branch.durations.push_back(absl::Now() - started);
  branch.state = results[taken].state;
  branch.score = results[taken].score;
}

absl::StatusOr<std::vector<Branch>> Driver::Primaries() const {
  const StageSpec stage = MakeStage(input_.scene, StageKind::kPrimary);
  std::vector<Branch> branches;
  if (stage.objects.empty()) {
    branches.push_back({PartialLayout(input_.scene), 0, {}, {}});
    return branches;
  }
  const absl::Time started = absl::Now();
  absl::StatusOr<std::vector<RestartResult>> results =
      runner_.Run(input_, stage, PartialLayout(input_.scene), 0, RestartsOf(stage));
  if (!results.ok()) return results.status();
  for (size_t taken : DistinctBest(stage, *results, kBeam)) {
    Branch& branch = branches.emplace_back(Branch{PartialLayout(input_.scene), 0, {}, {}});
    Record(branch, stage, *results, taken, started);
  }
  return branches;
}

absl::Status Driver::Extend(Branch& branch, StageKind kind, int zone) const {
  const StageSpec stage = MakeStage(input_.scene, kind, zone);
  if (stage.objects.empty()) return absl::OkStatus();
  const absl::Time started = absl::Now();
  absl::StatusOr<std::vector<RestartResult>> results = runner_.Run(input_, stage, branch.state, 0, RestartsOf(stage));
  if (!results.ok()) return results.status();
  const double floor_score = branch.score;
  Record(branch, stage, *results, BestOf(*results), started);
  if (kind == StageKind::kTertiary) branch.score = floor_score;
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Branch>> Driver::Run() const {
  absl::StatusOr<std::vector<Branch>> branches = Primaries();
  if (!branches.ok()) return branches.status();
  for (Branch& branch : *branches) {
    for (int zone = 0; zone < static_cast<int>(input_.scene.zones.size()); ++zone) {
      if (absl::Status status = Extend(branch, StageKind::kSecondary, zone); !status.ok()) return status;
    }
    if (absl::Status status = Extend(branch, StageKind::kSecondary, -1); !status.ok()) return status;
    if (absl::Status status = Extend(branch, StageKind::kPolish, -1); !status.ok()) return status;
  }
  std::stable_sort(branches->begin(), branches->end(),
                   [](const Branch& a, const Branch& b) { return a.score < b.score; });
  if (absl::Status status = Extend(branches->front(), StageKind::kTertiary, -1); !status.ok()) return status;
  return branches;
}

}  // namespace flair::optimizer
