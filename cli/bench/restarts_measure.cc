// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "cli/bench/measures.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/stage.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

double MeanHitShare(const std::vector<RestartsMeasure>& measures) {
  std::vector<double> shares;
  for (const RestartsMeasure& room : measures) shares.push_back(room.HitShare());
  return Mean(shares);
}

}  // namespace

double RestartsMeasure::Best() const { return *std::min_element(scores.begin(), scores.end()); }

bool RestartsMeasure::Hits(size_t k) const {
  const double best = Best();
  return scores[k] <= best + std::max(1e-3, 0.01 * std::abs(best));
}

double RestartsMeasure::HitShare() const {
  size_t hits = 0;
  for (size_t k = 0; k < scores.size(); ++k) hits += Hits(k);
  return static_cast<double>(hits) / static_cast<double>(scores.size());
}

absl::StatusOr<RestartsMeasure> MeasureRestarts(const BenchProblem& problem, v1::SolveOptions options, int count) {
  options.set_thread_count(1);
  const optimizer::NloptSolver solver;
  const absl::StatusOr<optimizer::SolveInput> input =
      optimizer::MakeSolveInput(problem.graph, options, solver, nullptr);
  if (!input.ok()) return input.status();
  const optimizer::StageSpec stage = optimizer::MakeStage(input->scene, optimizer::StageKind::kPrimary);
  if (stage.objects.empty()) return absl::NotFoundError("the room has no primary objects");
  RestartsMeasure measure{problem.name, {}, {}};
  for (int k = 0; k < count; ++k) {
    const double started = ThreadCpu_s();
    const absl::StatusOr<std::vector<optimizer::RestartResult>> results =
        optimizer::RunRestarts(*input, stage, optimizer::PartialLayout(input->scene), k, 1);
    if (!results.ok()) return results.status();
    measure.cpu_s.push_back(ThreadCpu_s() - started);
    measure.scores.push_back(results->front().score);
  }
  return measure;
}

std::string RestartsTable(const std::vector<RestartsMeasure>& measures) {
  const TextTable rooms({"room", "best", "first hit", "hits %", "ms each"}, 28, 9);
  std::string text =
      "best       least cost of the primary stage over all restarts; first hit: number of the first one within 1 % of "
      "it\n"
      "hits       share of the restarts within 1 % of it; ms each: CPU time of one restart, mean\n\n" +
      rooms.Header();
  for (const RestartsMeasure& room : measures) {
    size_t first = 0;
    while (!room.Hits(first)) ++first;
    text += rooms.Row({room.name, fmt::format("{:.4f}", room.Best()), fmt::format("{}", first),
                       fmt::format("{:.1f}", 100 * room.HitShare()), fmt::format("{:.2f}", 1e3 * Mean(room.cpu_s))});
  }
  const TextTable curve({"restarts", "rooms at their best %", "mean cost above it", "median CPU ms"}, 8, 9);
  text += fmt::format("\n{}; {:.1f} % of single restarts reach the best\n\n", Counted(std::ssize(measures), "room"),
                      100 * MeanHitShare(measures));
  text += curve.Header();
  size_t most = 0;
  for (const RestartsMeasure& room : measures) most = std::max(most, room.scores.size());
  for (size_t count = 1; count / 2 < most; count *= 2) {
    // Of each room after its first restarts: whether one of them hit, and how far the best of them is above the best.
    std::vector<double> found, gaps, cpu_s;
    for (const RestartsMeasure& room : measures) {
      const auto end = static_cast<ptrdiff_t>(std::min(count, room.scores.size()));
      const auto best = std::min_element(room.scores.begin(), room.scores.begin() + end);
      found.push_back(room.Hits(static_cast<size_t>(best - room.scores.begin())) ? 1 : 0);
      gaps.push_back(*best - room.Best());
      cpu_s.push_back(std::accumulate(room.cpu_s.begin(), room.cpu_s.begin() + end, 0.0));
    }
    text += curve.Row({fmt::format("{}", std::min(count, most)), fmt::format("{:.1f}", 100 * Mean(found)),
                       fmt::format("{:.4f}", Mean(gaps)), fmt::format("{:.1f}", 1e3 * Quantile(cpu_s, 0.5))});
  }
  return text;
}

}  // namespace flair::cli
