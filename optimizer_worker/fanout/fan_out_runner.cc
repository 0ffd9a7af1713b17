// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/fan_out_runner.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "fmt/format.h"
#include "optimizer_worker/stages/placements.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {

namespace {

// Pieces per taker: enough that the last ones end at about the same time.
constexpr int kPiecesPerTaker = 4;
constexpr int kLargestPiece = 32;
// How often a taker that waits looks whether the caller has gone.
constexpr std::chrono::milliseconds kGlance(20);

bool SameBits(const RestartResult& a, const RestartResult& b, const std::vector<int>& objects) {
  const auto bits = [](double value) { return std::bit_cast<uint64_t>(value); };
  if (bits(a.score) != bits(b.score) || a.evaluations != b.evaluations) return false;
  return std::all_of(objects.begin(), objects.end(), [&](int object) {
    const Pose<double>&p = a.state.layout[object], &q = b.state.layout[object];
    return bits(p.x_m) == bits(q.x_m) && bits(p.y_m) == bits(q.y_m) && bits(p.theta_rad) == bits(q.theta_rad);
  });
}

// What a peer answered, checked: it is a stranger.
absl::StatusOr<std::vector<RestartResult>> ReadOutcomes(const SolveInput& input, const StageSpec& stage,
                                                        const PartialLayout& before, const RangePlan::Range& range,
                                                        const v1::SolveRestartsResponse& response) {
  if (response.outcomes_size() != range.count) {
    return absl::InternalError(fmt::format("{} outcomes for {} restarts", response.outcomes_size(), range.count));
  }
  std::vector<RestartResult> results;
  for (int i = 0; i < range.count; ++i) {
    const v1::RestartOutcome& outcome = response.outcomes(i);
    RestartResult result{range.first + i, outcome.cost(), outcome.evaluation_count(), before};
    if (outcome.restart() != result.restart || !std::isfinite(result.score)) {
      return absl::InternalError(
          fmt::format("outcome {} is of restart {}, not {}", i, outcome.restart(), result.restart));
    }
    PartialLayout moved(input.scene);
    RETURN_IF_ERROR(ReadPlacements(input, outcome.placements(), moved));
    for (int object : stage.objects) {
      if (!moved.placed[object]) return absl::InternalError(fmt::format("outcome {} lacks an object", i));
      result.state.Place(object, moved.layout[object]);
    }
    results.push_back(std::move(result));
  }
  return results;
}

// One Run: the plan, what has come in, and those who work on it.
class Gathering {
 public:
  Gathering(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int first, int count,
            int range_size, int own_takers)
      : input_(input),
        stage_(stage),
        before_(before),
        first_(first),
        plan_(first, count, range_size, own_takers),
        slots_(count) {}

  // Takes pieces until there are none left.
  void WorkHere(int taker) {
    for (std::optional<RangePlan::Range> range; (range = Next(taker));) {
      std::vector<RestartResult> results;
      for (int i = 0; i < range->count && !Over(); ++i) {
        absl::StatusOr<std::vector<RestartResult>> one = RunRestarts(input_, stage_, before_, range->first + i, 1);
        if (!one.ok()) return GiveUp(*range, taker);
        results.push_back(std::move(one->front()));
      }
      if (static_cast<int>(results.size()) < range->count) return GiveUp(*range, taker);
      Finish(*range, taker, std::move(results));
    }
  }

  // The same by way of a peer; ends at its first failure. CANCELLED when nothing can be said about the peer.
  absl::Status WorkThere(int taker, PeerPool& pool, PeerOptimizer& peer, v1::SolveRestartsRequest request) {
    bool answered = false;
    while (!Over()) {
      // Held for the call only: other solves want the peer too.
      std::optional<PeerPool::Slot> slot = pool.WaitForSlot(peer, [this] { return Over() || Done(); });
      if (!slot) break;
      const std::optional<RangePlan::Range> range = TakeNow(taker);
      if (!range) {
        slot.reset();
        if (!WaitForChange()) break;
        continue;
      }
      request.set_first_restart(range->first);
      request.set_restart_count(range->count);
      const absl::StatusOr<v1::SolveRestartsResponse> response = peer.SolveRestarts(request, over_);
      absl::StatusOr<std::vector<RestartResult>> results =
          response.ok() ? ReadOutcomes(input_, stage_, before_, *range, *response) : response.status();
      if (!results.ok()) {
        const bool not_needed = Over();
        GiveUp(*range, taker);
        if (not_needed) break;
        return results.status();
      }
      Finish(*range, taker, *std::move(results));
      answered = true;
    }
    return answered ? absl::OkStatus() : absl::CancelledError("not needed any more");
  }

  // Somebody's answer differs from somebody else's. After all takers have ended.
  bool disagreed() const { return disagreed_; }

  // After all takers have ended.
  absl::StatusOr<std::vector<RestartResult>> Results() {
    if (!plan_.done()) {
      return absl::CancelledError(fmt::format("cancelled in stage {}", StageName(stage_.kind)));
    }
    std::vector<RestartResult> results;
    for (std::optional<RestartResult>& slot : slots_) results.push_back(*std::move(slot));
    return results;
  }

 private:
  bool Done() {
    const std::lock_guard lock(mutex_);
    return plan_.done();
  }
  bool Over() { return over_.cancelled() || input_.Cancelled(); }

  // Waits for something to do; nullopt when all is done or nobody waits for it.
  std::optional<RangePlan::Range> Next(int taker) {
    std::unique_lock lock(mutex_);
    while (!plan_.done() && !Over()) {
      if (std::optional<RangePlan::Range> range = plan_.Take(taker)) return range;
      changed_.wait_for(lock, kGlance);
    }
    lock.unlock();
    over_.Cancel();
    return std::nullopt;
  }

  std::optional<RangePlan::Range> TakeNow(int taker) {
    const std::lock_guard lock(mutex_);
    return plan_.Take(taker);
  }

  // False when all is done.
  bool WaitForChange() {
    std::unique_lock lock(mutex_);
    if (!plan_.done()) changed_.wait_for(lock, kGlance);
    return !plan_.done();
  }

  void Finish(const RangePlan::Range& range, int taker, std::vector<RestartResult> results) {
    bool done = false;
    {
      const std::lock_guard lock(mutex_);
      if (plan_.Finish(range, taker)) {
        for (RestartResult& result : results) slots_[static_cast<size_t>(result.restart - first_)] = std::move(result);
      } else {
        for (const RestartResult& result : results) {
          disagreed_ |= !SameBits(result, *slots_[static_cast<size_t>(result.restart - first_)], stage_.objects);
        }
      }
      done = plan_.done();
    }
    // Calls that are still out bring nothing new.
    if (done) over_.Cancel();
    changed_.notify_all();
  }

  void GiveUp(const RangePlan::Range& range, int taker) {
    {
      const std::lock_guard lock(mutex_);
      plan_.GiveUp(range, taker);
    }
    changed_.notify_all();
  }

  const SolveInput& input_;
  const StageSpec& stage_;
  const PartialLayout& before_;
  const int first_;
  std::mutex mutex_;
  std::condition_variable changed_;
  RangePlan plan_;
  std::vector<std::optional<RestartResult>> slots_;
  bool disagreed_ = false;
  runtime::Cancellation over_;
};

v1::SolveRestartsRequest RequestFor(const SolveInput& input, const v1::SolveOptions& options, const StageSpec& stage,
                                    const PartialLayout& before) {
  v1::SolveRestartsRequest request;
  request.set_request_id("fan-out");
  *request.mutable_layout_graph() = input.graph;
  *request.mutable_options() = options;
  request.set_stage(std::string(StageName(stage.kind)));
  if (stage.zone >= 0) request.set_zone_id(input.scene.zones[stage.zone].id);
  // The poses as they are: MakePlacements would tidy -0 and headings, which this process does not do.
  for (size_t i = 0; i < before.layout.size(); ++i) {
    if (!before.placed[i]) continue;
    v1::Placement& placement = *request.add_placements();
    placement.set_object_id(input.scene.objects[i].id);
    placement.set_x_m(before.layout[i].x_m);
    placement.set_y_m(before.layout[i].y_m);
    placement.set_theta_rad(before.layout[i].theta_rad);
  }
  return request;
}

}  // namespace

absl::StatusOr<std::vector<RestartResult>> FanOutRestartRunner::Run(const SolveInput& input, const StageSpec& stage,
                                                                    const PartialLayout& before, int first,
                                                                    int count) const {
  const bool worth_it = count >= kLeastRestarts && !options_.has_time_limit() && !stage.objects.empty();
  const std::vector<PeerOptimizer*> peers = worth_it ? pool_.Available() : std::vector<PeerOptimizer*>();
  if (peers.empty()) return RunRestarts(input, stage, before, first, count);

  const int own = std::max(1, std::min(input.settings.threads, count));
  const int takers = own + static_cast<int>(peers.size());
  const int range_size = std::clamp(count / (kPiecesPerTaker * takers), 1, kLargestPiece);
  Gathering gathering(input, stage, before, first, count, range_size, own);
  const v1::SolveRestartsRequest request = RequestFor(input, options_, stage, before);
  std::vector<std::thread> threads;
  for (int i = 1; i < own; ++i) threads.emplace_back([&gathering, i] { gathering.WorkHere(i); });
  for (size_t i = 0; i < peers.size(); ++i) {
    threads.emplace_back([&, i] {
      const absl::Status status = gathering.WorkThere(own + static_cast<int>(i), pool_, *peers[i], request);
      if (status.ok()) pool_.ReportSuccess(*peers[i]);
      if (!status.ok() && !absl::IsCancelled(status)) pool_.ReportFailure(*peers[i], status);
    });
  }
  gathering.WorkHere(0);
  for (std::thread& thread : threads) thread.join();
  if (!gathering.disagreed()) return gathering.Results();
  // A peer computes something else (another processor, another build) and nobody knows in which answers.
  const absl::Status disagreed = absl::InternalError("a restart that was run twice gave two results");
  for (const PeerOptimizer* peer : peers) pool_.ReportFailure(*peer, disagreed);
  return RunRestarts(input, stage, before, first, count);
}

RangePlan::RangePlan(int first, int count, int range_size, int own_takers) : own_takers_(own_takers) {
  for (int done = 0; done < count; done += range_size) {
    pieces_.push_back(
        {{static_cast<int>(pieces_.size()), first + done, std::min(range_size, count - done)}, {}, false});
  }
  unfinished_ = pieces_.size();
}

bool RangePlan::IsRunHere(const Piece& piece) const {
  return !piece.takers.empty() && *piece.takers.begin() < own_takers_;
}

std::optional<RangePlan::Range> RangePlan::Take(int taker) {
  for (size_t most_takers : {size_t{0}, size_t{1}}) {
    for (Piece& piece : pieces_) {
      if (piece.finished || piece.takers.size() > most_takers || piece.takers.count(taker) != 0) continue;
      piece.takers.insert(taker);
      return piece.range;
    }
  }
  if (taker >= own_takers_) return std::nullopt;
  for (Piece& piece : pieces_) {
    if (piece.finished || IsRunHere(piece)) continue;
    piece.takers.insert(taker);
    return piece.range;
  }
  return std::nullopt;
}

bool RangePlan::Finish(const Range& range, int taker) {
  Piece& piece = pieces_[static_cast<size_t>(range.index)];
  piece.takers.erase(taker);
  if (piece.finished) return false;
  piece.finished = true;
  --unfinished_;
  return true;
}

void RangePlan::GiveUp(const Range& range, int taker) { pieces_[static_cast<size_t>(range.index)].takers.erase(taker); }

}  // namespace flair::optimizer
