// SPDX-License-Identifier: GPL-3.0-or-later
// Solves, measured: what one problem costs the solver and what comes out, for people and for programs.
#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/bench/problem.h"
#include "cli/output/text.h"
#include "flair/v1/layout_metrics.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::cli {

struct StageTally {
  int64_t restarts = 0;
  int64_t evaluations = 0;
  // CPU time of the threads that called; all of it when the solve has one thread.
  double cpu_s = 0;
};

inline constexpr std::array kStages = {optimizer::StageKind::kPrimary, optimizer::StageKind::kSecondary,
                                       optimizer::StageKind::kPolish, optimizer::StageKind::kTertiary};

// Runs restarts on this process's threads. Thread-safe.
class CountingRunner final : public optimizer::RestartRunner {
 public:
  absl::StatusOr<std::vector<optimizer::RestartResult>> Run(const optimizer::SolveInput& input,
                                                            const optimizer::StageSpec& stage,
                                                            const optimizer::PartialLayout& before, int first,
                                                            int count) const override;
  // In the order of kStages.
  std::array<StageTally, kStages.size()> Tallies() const;

 private:
  const optimizer::LocalRestartRunner local_;
  mutable std::mutex mutex_;
  mutable std::array<StageTally, kStages.size()> tallies_;
};

// How good a layout is.
struct Quality {
  v1::LayoutMetrics metrics;
  int held = 0;
  int missed = 0;
  // Calls that no term could be made of.
  int dropped = 0;
};

struct SolveMeasure {
  std::string name;
  // Of this process, all threads; medians over the repeats.
  double cpu_s = 0;
  double wall_s = 0;
  // Of all branches, in the order of kStages.
  std::array<StageTally, kStages.size()> stages;
  v1::SolvedLayout layout;
  Quality quality;
  // Of the layout that the problem came with, by the same measures.
  std::optional<Quality> recorded;

  int object_count() const { return layout.graph().object_list().objects_size(); }
  int64_t restart_count() const;
  int64_t evaluation_count() const;
  // Sum of the costs of a stage's outcomes, of the branch that won.
  double CostOf(optimizer::StageKind stage) const;
};

// Solves `repeats` (>= 1) times in this process. INTERNAL when the repeats do not give the same bytes.
absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats);

// One of the measures of a layout: its name in LayoutMetrics, and what people read.
struct MetricColumn {
  const char* name;
  const char* title;
  double (*of)(const v1::LayoutMetrics&);
  // Which end is good.
  bool less_is_better;
};

inline constexpr MetricColumn kMetrics[] = {
    {"oob_percent", "OOB, % of the room", [](const v1::LayoutMetrics& m) { return m.oob_percent(); }, true},
    {"oor_percent", "OOR, % of the room", [](const v1::LayoutMetrics& m) { return m.oor_percent(); }, true},
    {"deepest_overlap_m", "deepest overlap, m", [](const v1::LayoutMetrics& m) { return m.deepest_overlap_m(); }, true},
    {"reachable_floor_share", "reachable floor, share",
     [](const v1::LayoutMetrics& m) { return m.reachable_floor_share(); }, false},
    {"reachable_front_share", "reachable fronts, share",
     [](const v1::LayoutMetrics& m) { return m.reachable_front_share(); }, false},
    {"pathway_cost_m3", "pathway cost, m3", [](const v1::LayoutMetrics& m) { return m.pathway_cost_m3(); }, true},
};

// What the columns of SolveTable mean, a line each; ends in an empty line.
std::string SolveLegend();

// One line a room; `name_width` is that of the longest name.
TextTable SolveTable(size_t name_width);
std::vector<std::string> SolveCells(const SolveMeasure& measure);

// Medians and means over all rooms, the rooms that are worst by each measure, and, beside those of the recorded
// layouts, the measures over the rooms that have one. `memory_before_MiB` is what the process held before the first
// solve.
std::string SolveSummary(const std::vector<SolveMeasure>& measures, double memory_before_MiB);

// A file that could not be measured.
struct BenchFailure {
  std::string file;
  std::string reason;
};

// {"rooms": [...], "failures": [...], "summary": {...}}, indented, ending in a newline.
std::string SolveMeasuresToJson(const std::vector<SolveMeasure>& measures, const std::vector<BenchFailure>& failures,
                                double memory_before_MiB);

}  // namespace flair::cli
