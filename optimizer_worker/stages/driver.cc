// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/driver.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "optimizer_worker/stages/floor_stages.h"
#include "optimizer_worker/stages/patterns.h"
#include "worker_runtime/executor/executor.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

// How many of the best, distinct primary layouts are furnished to the end; with variants so many more than asked for.
constexpr size_t kBeam = 3;
// With groups the best so many of those with and of those without; of no more floor objects than this.
constexpr size_t kBeamOfEach = 2, kMostOneByOne = 60;
// What one order must lack less than the other to be preferred for that alone, and not by the score: half a missed
// call.
constexpr double kWorthAnOrder = 0.5;
constexpr size_t kSpareVariants = 2;
// Primary layouts nearer than this (sum over objects) are the same when only one layout is wanted.
constexpr double kSame_m = 0.3;
// With variants the primaries get up to this many times their restarts, until enough layouts differ.
constexpr int kMostBatches = 8;
// The polish of the layout that wins goes on for up to so many rounds, and ends when so many in a row gain less than
// this. A round takes time with the square of the objects: of more than this many, fewer.
constexpr int kMostRounds = 8, kMostRoundObjects = 80;
constexpr int kVainRounds = 2;
constexpr double kWorthAnother = 0.01;

double DistanceOf(const StageSpec& stage, const PartialLayout& a, const PartialLayout& b) {
  double sum = 0;
  for (int object : stage.objects) {
    sum += Distance(Center(a.layout[object]), Center(b.layout[object])) +
           (1 - std::cos(a.layout[object].theta_rad - b.layout[object].theta_rad));
  }
  return sum;
}

SolveInput WithoutGroups(const SolveInput& input) {
  SolveInput alone = input;
  alone.groups = {};
  alone.settings.groups = false;
  return alone;
}

}  // namespace

// The account of a stage that ended with `results`, of which `taken` was taken.
void Driver::Record(Branch& branch, const StageSpec& stage, const std::vector<RestartResult>& results, size_t taken,
                    absl::Time started) const {
  v1::StageOutcome& outcome = branch.outcomes.emplace_back();
  outcome.set_stage(std::string(StageName(stage.kind)));
  if (stage.zone >= 0) outcome.set_zone_id(input_.scene.zones[stage.zone].id);
  outcome.set_restart_count(static_cast<int>(results.size()));
  outcome.set_best_restart(results[taken].restart - branch.first_restart);
  int64_t evaluations = 0;
  for (const RestartResult& result : results) evaluations += result.evaluations;
  outcome.set_evaluation_count(evaluations);
  outcome.set_seed(static_cast<int64_t>(RestartSeed(input_.settings, stage, branch.first_restart)));
  outcome.set_cost(results[taken].score);
  outcome.set_stopped_early(static_cast<int>(results.size()) < RestartsOf(input_.settings, stage) ||
                            input_.OutOfTime());
  branch.durations.push_back(absl::Now() - started);
  branch.state = results[taken].state;
  branch.score = results[taken].score;
}

absl::StatusOr<std::vector<Branch>> Driver::Primaries(const StageSpec& stage) const {
  const absl::Time started = absl::Now();
  const PartialLayout before = StartOf(input_);
  const size_t wanted = wants_variants() ? input_.settings.variant_count + kSpareVariants : kBeam;
  const auto differ = [&](const PartialLayout& a, const PartialLayout& b) {
    return wants_variants() ? DifferVisibly(stage.objects, a.layout, b.layout) : DistanceOf(stage, a, b) >= kSame_m;
  };
  std::vector<RestartResult> results;
  std::vector<size_t> chosen;
  const int count = RestartsOf(input_.settings, stage);
  const bool may_add = wants_variants() && input_.settings.max_restarts == 0;
  for (int batch = 0; batch < (may_add ? kMostBatches : 1); ++batch) {
    ASSIGN_OR_RETURN(std::vector<RestartResult> more, runner_.Run(input_, stage, before, batch * count, count));
    std::move(more.begin(), more.end(), std::back_inserter(results));
    chosen = BestDistinct(
        results.size(), wanted, [&](size_t i) { return results[i].score; },
        [&](size_t a, size_t b) { return differ(results[a].state, results[b].state); });
    if (chosen.size() == wanted || input_.OutOfTime()) break;
  }
  std::vector<Branch> branches;
  for (size_t taken : chosen) {
    Record(branches.emplace_back(Branch{before, 0, {}, {}}), stage, results, taken, started);
  }
  return branches;
}

absl::StatusOr<std::vector<Branch>> Driver::Starts() const {
  const StageSpec stage = FreeStage(input_, StageKind::kPrimary);
  if (!stage.objects.empty()) return Primaries(stage);
  // No primary may move. What variants there are differ in what else stands on the floor.
  std::vector<Branch> branches(1, Branch{StartOf(input_), 0, {}, {}});
  if (!wants_variants() || LeadingObjects(input_).empty()) return branches;
  branches.resize(2 * input_.settings.variant_count, branches.front());
  // Far enough apart that no two branches share a restart.
  for (size_t i = 0; i < branches.size(); ++i) branches[i].first_restart = static_cast<int>(i) * kRestartsPerBranch;
  return branches;
}

absl::Status Driver::AddOneByOne(std::vector<Branch>& starts) const {
  if (input_.groups.all.empty() || wants_variants() || input_.OutOfTime() ||
      FreeStage(input_, StageKind::kPolish).objects.size() > kMostOneByOne) {
    return absl::OkStatus();
  }
  const SolveInput alone = WithoutGroups(input_);
  ASSIGN_OR_RETURN(std::vector<Branch> more, Driver(alone, runner_).Starts());
  for (std::vector<Branch>* branches : {&starts, &more}) {
    if (branches->size() > kBeamOfEach) branches->resize(kBeamOfEach, branches->front());
  }
  for (Branch& branch : more) {
    branch.one_by_one = true;
    starts.push_back(std::move(branch));
  }
  return absl::OkStatus();
}

absl::Status Driver::Extend(const SolveInput& input, Branch& branch, StageKind kind, int zone) const {
  const StageSpec stage = FreeStage(input, kind, zone);
  if (stage.objects.empty()) return absl::OkStatus();
  const absl::Time started = absl::Now();
  ASSIGN_OR_RETURN(std::vector<RestartResult> results,
                   runner_.Run(input, stage, branch.state, branch.first_restart, RestartsOf(input_.settings, stage)));
  const double floor_score = branch.score;
  Record(branch, stage, results, BestOf(results), started);
  if (kind == StageKind::kTertiary) branch.score = floor_score;
  return absl::OkStatus();
}

// The floor. One that `may_give_up` does so when time is up.
absl::Status Driver::Furnish(const SolveInput& input, Branch& branch, bool may_give_up, bool& gave_up) const {
  std::vector<std::pair<StageKind, int>> steps;
  for (int zone = 0; zone < static_cast<int>(input.scene.zones.size()); ++zone) {
    steps.emplace_back(StageKind::kSecondary, zone);
  }
  steps.emplace_back(StageKind::kSecondary, -1);
  steps.emplace_back(StageKind::kPolish, -1);
  for (const auto& [kind, zone] : steps) {
    gave_up = may_give_up && input.OutOfTime();
    if (gave_up) return absl::OkStatus();
    if (kind == StageKind::kPolish) branch.unpolished = branch.state;
    RETURN_IF_ERROR(Extend(input, branch, kind, zone));
  }
  return absl::OkStatus();
}

template <typename Work>
absl::Status Driver::ForBranches(std::vector<Branch>& branches, size_t first, size_t count, const Work& work) const {
  // The branches share the threads; each has what is left over for its own restarts.
  SolveInput input = input_;
  input.settings.threads = std::max(1, input_.settings.threads / static_cast<int>(count));
  std::vector<absl::Status> statuses(count);
  RETURN_IF_ERROR(runtime::ForEach({input_.settings.threads, {}}, static_cast<int>(count),
                                   [&](int i) { statuses[i] = work(input, branches[first + i], first + i); }));
  for (absl::Status& status : statuses) {
    if (!status.ok()) return std::move(status);
  }
  return absl::OkStatus();
}

double Driver::LackOf(const PartialLayout& state) const {
  double lack = DisorderOf(input_, state);
  std::vector<Pose<double>> poses;
  for (const Term& term : BindCosts(input_, state).terms) {
    const bool there = std::ranges::all_of(term.required, [&](int object) { return state.placed[object] != 0; });
    if (!there || (term.edge < 0 && !term.hard)) continue;
    poses.clear();
    for (int object : term.cost->objects()) poses.push_back(state.layout[object]);
    lack += term.Loss(term.cost->Value(poses));
  }
  return lack;
}

void Driver::KeepBetterOrder(std::vector<Branch>& branches) const {
  const Branch* best[2] = {nullptr, nullptr};
  for (const Branch& branch : branches) {
    const Branch*& kept = best[branch.one_by_one ? 1 : 0];
    if (kept == nullptr || branch.score < kept->score) kept = &branch;
  }
  if (best[0] == nullptr || best[1] == nullptr) return;
  const double gain = LackOf(best[0]->state) - LackOf(best[1]->state);
  const bool one_by_one = gain > kWorthAnOrder || (gain > -kWorthAnOrder && best[1]->score < best[0]->score);
  std::erase_if(branches, [&](const Branch& branch) { return branch.one_by_one != one_by_one; });
}

std::vector<Branch> Driver::Distinct(std::vector<Branch> branches) const {
  const std::vector<int> leading = LeadingObjects(input_);
  const size_t most = wants_variants() ? input_.settings.variant_count : branches.size();
  const std::vector<size_t> kept = BestDistinct(
      branches.size(), most, [&](size_t i) { return branches[i].score; },
      [&](size_t a, size_t b) {
        return !wants_variants() || DifferVisibly(leading, branches[a].state.layout, branches[b].state.layout);
      });
  std::vector<Branch> best;
  for (size_t i : kept) best.push_back(std::move(branches[i]));
  return best;
}

// Polishes all again with their leading objects held where they were: the polish may have led several to one layout.
absl::Status Driver::HoldApart(std::vector<Branch>& branches) const {
  const std::vector<int> leading = LeadingObjects(input_);
  return ForBranches(branches, 0, branches.size(), [&](const SolveInput& input, Branch& branch, size_t) {
    if (input.Cancelled()) return absl::CancelledError("cancelled in stage polish");
    const StageSpec stage = FreeStage(input, StageKind::kPolish);
    if (stage.objects.empty() || input.OutOfTime()) return absl::OkStatus();
    const absl::Time started = absl::Now();
    const RestartResult held = PolishHolding(input, branch.unpolished, leading, branch.first_restart);
    branch.outcomes.pop_back();
    branch.durations.pop_back();
    Record(branch, stage, {held}, 0, started);
    return absl::OkStatus();
  });
}

absl::Status Driver::PolishOn(Branch& branch) const {
  const StageSpec stage = FreeStage(input_, StageKind::kPolish);
  if (stage.objects.empty() || input_.settings.max_restarts > 0) return absl::OkStatus();
  const absl::Time started = absl::Now();
  v1::StageOutcome& outcome = branch.outcomes.back();
  const int most = std::clamp(kMostRoundObjects / static_cast<int>(stage.objects.size()), 1, kMostRounds);
  int next = RestartsOf(input_.settings, stage);
  for (int round = 0, in_vain = 0; round < most && in_vain < kVainRounds; ++round, ++next) {
    if (input_.OutOfTime()) {
      outcome.set_stopped_early(true);
      break;
    }
    ASSIGN_OR_RETURN(std::vector<RestartResult> results,
                     runner_.Run(input_, stage, branch.state, branch.first_restart + next, 1));
    RestartResult& result = results.front();
    const double gain = branch.score - result.score;
    in_vain = gain > kWorthAnother ? 0 : in_vain + 1;
    outcome.set_evaluation_count(outcome.evaluation_count() + result.evaluations);
    outcome.set_restart_count(next + 1);
    if (gain <= 0) continue;
    outcome.set_best_restart(next);
    outcome.set_cost(result.score);
    branch.score = result.score;
    branch.state = std::move(result.state);
  }
  branch.durations.back() += absl::Now() - started;
  return absl::OkStatus();
}

absl::StatusOr<std::vector<Branch>> Driver::FurnishEnough(std::vector<Branch> starts) const {
  const size_t wanted = wants_variants() ? input_.settings.variant_count : 1;
  // All that differ are furnished, spares included: which one is best shows only at the end.
  std::vector<char> gave_up(starts.size(), 0);
  const absl::Status status =
      ForBranches(starts, 0, starts.size(), [&](const SolveInput& input, Branch& branch, size_t i) {
        bool gives_up = false;
        if (branch.one_by_one) {
          RETURN_IF_ERROR(Furnish(WithoutGroups(input), branch, i > 0, gives_up));
          branch.score += DisorderOf(input, branch.state);
        } else {
          RETURN_IF_ERROR(Furnish(input, branch, i > 0, gives_up));
        }
        gave_up[i] = gives_up;
        return absl::OkStatus();
      });
  if (!status.ok()) return status;
  std::vector<Branch> furnished;
  for (size_t i = 0; i < starts.size(); ++i) {
    if (!gave_up[i]) furnished.push_back(std::move(starts[i]));
  }
  const bool any_gave_up = furnished.size() < starts.size();
  KeepBetterOrder(furnished);
  std::vector<Branch> best = Distinct(furnished);
  if (best.size() < wanted && furnished.size() > best.size()) {
    RETURN_IF_ERROR(HoldApart(furnished));
    std::move(best.begin(), best.end(), std::back_inserter(furnished));
    best = Distinct(std::move(furnished));
  }
  if (any_gave_up && !best.front().outcomes.empty()) best.front().outcomes.back().set_stopped_early(true);
  if (!wants_variants()) {
    RETURN_IF_ERROR(PolishOn(best.front()));
  }
  const size_t complete = std::min(wanted, best.size());
  RETURN_IF_ERROR(ForBranches(best, 0, complete, [&](const SolveInput& input, Branch& branch, size_t) {
    branch.complete = true;
    return Extend(input, branch, StageKind::kTertiary, -1);
  }));
  return best;
}

absl::StatusOr<std::vector<Branch>> Driver::Run() const {
  ASSIGN_OR_RETURN(std::vector<Branch> starts, Starts());
  RETURN_IF_ERROR(AddOneByOne(starts));
  return FurnishEnough(std::move(starts));
}

namespace {

constexpr double kMoved_m = 0.5;
constexpr double kTurned_rad = kPi / 6;

}  // namespace

std::vector<int> LeadingObjects(const SolveInput& input) {
  std::vector<int> leading = FreeStage(input, StageKind::kPrimary).objects;
  if (!leading.empty()) return leading;
  leading = FreeStage(input, StageKind::kPolish).objects;
  std::erase_if(leading, [&](int object) { return input.scene.objects[object].role == ObjectRole::kTertiary; });
  return leading;
}

bool DifferVisibly(std::span<const int> objects, const Layout& a, const Layout& b) {
  return std::ranges::any_of(objects, [&](int object) {
    return Distance(Center(a[object]), Center(b[object])) > kMoved_m ||
           AngleBetween(a[object].theta_rad, b[object].theta_rad) > kTurned_rad;
  });
}

std::vector<size_t> BestDistinct(size_t count, size_t most, const std::function<double(size_t)>& score,
                                 const std::function<bool(size_t, size_t)>& differ) {
  std::vector<size_t> order(count);
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return score(a) < score(b); });
  std::vector<size_t> kept;
  for (size_t i : order) {
    if (kept.size() == most) break;
    if (std::ranges::all_of(kept, [&](size_t k) { return differ(i, k); })) kept.push_back(i);
  }
  return kept;
}

}  // namespace flair::optimizer
