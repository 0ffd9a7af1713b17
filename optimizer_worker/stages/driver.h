// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a problem through the stages in order: primaries, secondaries zone by zone, polish, tertiaries. The best few
// primary layouts are furnished to the end, each by itself, and the best of those wins. Variants are the best that
// differ visibly.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/solved_layout.pb.h"
#include "optimizer_worker/stages/solve_input.h"
#include "optimizer_worker/stages/stage.h"

namespace flair::optimizer {

// An object that a layout does without.
struct LeftOut {
  int object = -1;
  // "no free place of 1.60 m x 0.90 m; ..."
  std::string reason;
};

// One way through the stages so far.
struct Branch {
  PartialLayout state;
  // Cost of the floor objects, and what bad walkability is worth.
  double score = 0;
  std::vector<v1::StageOutcome> outcomes;
  // Wall time per outcome.
  std::vector<absl::Duration> durations;
  // Every stage of it begins at this restart: how branches differ that have no primaries to differ in.
  int first_restart = 0;
  // Has all stages, tertiaries too.
  bool complete = false;
  // Furnished without groups, in the paper's order.
  bool one_by_one = false;
  std::vector<LeftOut> left_out = {};
  // Where everything stood before the polish.
  PartialLayout unpolished = state;
};

class Driver {
 public:
  // Borrows both; they must outlive it.
  Driver(const SolveInput& input, const RestartRunner& runner) : input_(input), runner_(runner) {}

  // The branches, best first. The first has all stages; with variants asked for all do, they differ visibly, and there
  // are as many as were asked for if so many were found. Never empty. CANCELLED when the caller has gone, and the
  // runner's errors. Branches run beside each other on the settings' threads; the result does not depend on how many.
  absl::StatusOr<std::vector<Branch>> Run() const;

 private:
  bool wants_variants() const { return input_.settings.variant_count > 1; }
  void Record(Branch& branch, const StageSpec& stage, const std::vector<RestartResult>& results, size_t taken,
              absl::Time started) const;
  // All ways to begin that are worth furnishing, best first.
  absl::StatusOr<std::vector<Branch>> Starts() const;
  // Adds starts without groups to those with them: where calls order the pieces better than a group or pattern can, the
  // paper's order wins. Not for variants, nor where many pieces would take it seconds.
  absl::Status AddOneByOne(std::vector<Branch>& starts) const;
  absl::StatusOr<std::vector<Branch>> Primaries(const StageSpec& stage) const;
  absl::Status Extend(const SolveInput& input, Branch& branch, StageKind kind, int zone) const;
  absl::Status Furnish(const SolveInput& input, Branch& branch, bool may_give_up, bool& gave_up) const;
  // Later rounds of the polish, while they gain: the seeds of one differ, and what one cannot mend another may. None
  // when the caller has said how many restarts there are to be.
  absl::Status PolishOn(Branch& branch) const;
  // Calls `work` for branches [first, first + count) of `branches`, beside each other.
  template <typename Work>
  absl::Status ForBranches(std::vector<Branch>& branches, size_t first, size_t count, const Work& work) const;
  absl::Status HoldApart(std::vector<Branch>& branches) const;
  // Furnishes `starts`, the best first, until enough of them differ.
  absl::StatusOr<std::vector<Branch>> FurnishEnough(std::vector<Branch> starts) const;
  // What a furnished floor lacks: calls, what collides, order. The whole-room terms of the score lead the search, but no
  // balance is worth a chair that is not at its table.
  double LackOf(const PartialLayout& state) const;
  // Leaves those that were furnished with groups, or those without, whichever lack less; where both lack about the same,
  // those of the better score.
  void KeepBetterOrder(std::vector<Branch>& branches) const;
  std::vector<Branch> Distinct(std::vector<Branch> branches) const;

  const SolveInput& input_;
  const RestartRunner& runner_;
};

// When two layouts of a problem differ so much that a person sees two.

// The objects that make the difference: the primaries that may move; all floor objects that may move when no primary
// may. Tertiaries make none.
std::vector<int> LeadingObjects(const SolveInput& input);

// Whether one of `objects` stands more than 0.5 m away or is turned by more than 30 degrees. Symmetric copies differ.
bool DifferVisibly(std::span<const int> objects, const Layout& a, const Layout& b);

// Of `count` things, up to `most` that are all different from each other; those of least score come first and are
// preferred, equal scores by number.
std::vector<size_t> BestDistinct(size_t count, size_t most, const std::function<double(size_t)>& score,
                                 const std::function<bool(size_t, size_t)>& differ);

}  // namespace flair::optimizer
