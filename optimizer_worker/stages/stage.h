// SPDX-License-Identifier: GPL-3.0-or-later
// One stage of the solve: some objects are placed, all placed before stay where they are. Restarts are independent and
// numbered, so they can run on any thread or machine.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "optimizer_worker/solver/problem.h"
#include "optimizer_worker/solver/search.h"
#include "optimizer_worker/stages/solve_input.h"

namespace flair::optimizer {

// The stages, in the order in which they run.
enum class StageKind : int { kPrimary, kSecondary, kPolish, kTertiary };

// "primary", "secondary", "polish", "tertiary".
std::string_view StageName(StageKind kind);

struct StageSpec {
  StageKind kind = StageKind::kPrimary;
  // For kSecondary; -1 for the objects that belong to no zone.
  int zone = -1;
  // What is placed (or, in kPolish, moved), in order.
  std::vector<int> objects;
};

// Where everything stands that is placed.
struct PartialLayout {
  Layout layout;
  std::vector<char> placed;

  explicit PartialLayout(const Scene& scene);
  void Place(int object, const Pose<double>& pose);
};

// Where one restart ended.
struct RestartResult {
  int restart = 0;
  // Cost, and what bad walkability is worth.
  double score = 0;
  int64_t evaluations = 0;
  PartialLayout state;
};

// The objects of a stage: primaries; a zone's secondaries with the floor pieces among its tertiaries; all floor
// objects; tertiaries.
StageSpec MakeStage(const Scene& scene, StageKind kind, int zone = -1);

// Restarts that a stage gets: as many as the settings say, else by its kind and size. Those of the polish with higher
// numbers are its later rounds: they begin at a polished layout and are shorter.
int RestartsOf(const SolveSettings& settings, const StageSpec& stage);

// Branches of one solve that have no primaries to differ in begin their stages at multiples of this.
inline constexpr int kRestartsPerBranch = 10000;

// Seed of one restart.
uint64_t RestartSeed(const SolveSettings& settings, const StageSpec& stage, int restart);

// Runs restarts [first, first + count) on the settings' threads; results in order of restart. Pure: bit-identical for
// any number of threads and any split of the range. CANCELLED when the caller has gone. Only when the input has a time
// limit some may be missing, but never all.
absl::StatusOr<std::vector<RestartResult>> RunRestarts(const SolveInput& input, const StageSpec& stage,
                                                       const PartialLayout& before, int first, int count);

// Index of the best by (score, restart); `results` is not empty.
size_t BestOf(const std::vector<RestartResult>& results);

// All terms of a scene: the graph's edges and the whole-room terms, with their weights.
struct SceneCosts {
  std::vector<Term> terms;
  // Per edge: why it could not be bound; empty when it was.
  std::vector<std::string> dropped;
};

// Binds everything against the zones' present centres.
SceneCosts BindCosts(const SolveInput& input, std::span<const Vec2<double>> zone_centers);

// The same, where the zones are in a layout.
SceneCosts BindCosts(const SolveInput& input, const PartialLayout& state);

// Whether a stage counts a term at all: the balance of the room is the primaries' business, zones begin with the
// secondaries.
bool CountsIn(const Term& term, StageKind stage);

// The terms that a stage counts, among `costs`.
Problem MakeProblem(const SolveInput& input, const SceneCosts& costs, const StageSpec& stage,
                    const PartialLayout& before);

// What a search of the problem reads; null `walk_grid` where walking does not matter. Borrows all.
SearchInput SearchInputOf(const SolveInput& input, std::span<const Vec2<double>> zone_centers,
                          const evaluation::WalkGrid* walk_grid);

// Where the restarts of a stage run: on this process's threads, or spread over other optimizers as well.
class RestartRunner {
 public:
  virtual ~RestartRunner() = default;
  // As RunRestarts, whose results it must give bit for bit. Thread-safe.
  virtual absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                         const PartialLayout& before, int first, int count) const = 0;
};

// Runs them on the settings' threads.
class LocalRestartRunner final : public RestartRunner {
 public:
  absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                 const PartialLayout& before, int first, int count) const override {
    return RunRestarts(input, stage, before, first, count);
  }
};

// Objects that the user has pinned: they stand from the start, count in every cost, and no stage moves them.

// The layout before the first stage: the pinned objects only.
PartialLayout StartOf(const SolveInput& input);

// MakeStage without the pinned objects; what belongs to a group is placed with its leader.
StageSpec FreeStage(const SolveInput& input, StageKind kind, int zone = -1);

}  // namespace flair::optimizer
