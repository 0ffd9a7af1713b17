// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/fanout/fan_out.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <thread>

#include "fmt/format.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::optimizer {
namespace {

constexpr absl::Duration kFirstRest = absl::Seconds(1), kLongestRest = absl::Minutes(1);
constexpr int kMostDoublings = 6;
// Pieces per thread or peer: enough that the last ones end at about the same time.
constexpr int kPiecesEach = 4;
constexpr int kLargestPiece = 32;

bool SameBits(const RestartResult& a, const RestartResult& b, const std::vector<int>& objects) {
  const auto bits = [](double value) { return std::bit_cast<uint64_t>(value); };
  if (bits(a.score) != bits(b.score) || a.evaluations != b.evaluations) return false;
  return std::ranges::all_of(objects, [&](int object) {
    const Pose<double>&p = a.state.layout[object], &q = b.state.layout[object];
    return bits(p.x_m) == bits(q.x_m) && bits(p.y_m) == bits(q.y_m) && bits(p.theta_rad) == bits(q.theta_rad);
  });
}

// Restarts [first, first + count).
struct Piece {
  int first = 0;
  int count = 0;
  bool taken = false;
  // By an own thread, which always comes back.
  bool taken_here = false;
  bool finished = false;
};

// What a peer answered, checked: it is a stranger.
absl::StatusOr<std::vector<RestartResult>> ReadOutcomes(const SolveInput& input, const StageSpec& stage,
                                                        const PartialLayout& before, const Piece& piece,
                                                        const v1::SolveRestartsResponse& response) {
  if (response.outcomes_size() != piece.count) {
    return Internal("{} outcomes for {} restarts", response.outcomes_size(), piece.count);
  }
  std::vector<RestartResult> results;
  for (int i = 0; i < piece.count; ++i) {
    const v1::RestartOutcome& outcome = response.outcomes(i);
    RestartResult result{piece.first + i, outcome.cost(), outcome.evaluation_count(), before};
    if (outcome.restart() != result.restart || !std::isfinite(result.score)) {
      return Internal("outcome {} is of restart {}, not {}", i, outcome.restart(), result.restart);
    }
    PartialLayout moved(input.scene);
    RETURN_IF_ERROR(ReadPlacements(input, outcome.placements(), moved));
    for (int object : stage.objects) {
      if (!moved.placed[object]) return Internal("outcome {} lacks an object", i);
      result.state.Place(object, moved.layout[object]);
    }
    results.push_back(std::move(result));
  }
  return results;
}

// One Run: its pieces and what has come in. Thread-safe.
class Gathering {
 public:
  Gathering(const SolveInput& input, const StageSpec& stage, const PartialLayout& before, int first, int count,
            int piece_size)
      : input_(input), stage_(stage), before_(before), first_(first), slots_(count) {
    for (int done = 0; done < count; done += piece_size) {
      pieces_.push_back({first + done, std::min(piece_size, count - done)});
    }
  }

  // Takes pieces until every unfinished one is run by an own thread.
  void WorkHere() {
    for (Piece* piece; !Over() && (piece = Take(true)) != nullptr;) {
      std::vector<RestartResult> results;
      for (int i = 0; i < piece->count && !Over(); ++i) {
        absl::StatusOr<std::vector<RestartResult>> one = RunRestarts(input_, stage_, before_, piece->first + i, 1);
        if (!one.ok()) return;
        results.push_back(std::move(one->front()));
      }
      if (static_cast<int>(results.size()) == piece->count) Finish(*piece, std::move(results));
    }
  }

  // The same by way of a peer; ends at its first failure. CANCELLED when nothing can be said about the peer.
  absl::Status WorkThere(PeerOptimizer& peer, v1::SolveRestartsRequest request) {
    bool answered = false;
    for (Piece* piece; !Over() && (piece = Take(false)) != nullptr;) {
      request.set_first_restart(piece->first);
      request.set_restart_count(piece->count);
      const absl::StatusOr<v1::SolveRestartsResponse> response = peer.SolveRestarts(request, over_);
      absl::StatusOr<std::vector<RestartResult>> results =
          response.ok() ? ReadOutcomes(input_, stage_, before_, *piece, *response) : response.status();
      if (!results.ok()) {
        if (Over()) break;
        GiveUp(*piece);
        return results.status();
      }
      Finish(*piece, *std::move(results));
      answered = true;
    }
    return answered ? absl::OkStatus() : absl::CancelledError("not needed any more");
  }

  // Ends the calls that are still out: nobody needs their answers.
  void End() { over_.Cancel(); }

  // The rest is for when all have ended. Whether somebody's answer differs from somebody else's:
  bool disagreed() const { return disagreed_; }
  absl::StatusOr<std::vector<RestartResult>> Results() {
    std::vector<RestartResult> results;
    for (std::optional<RestartResult>& slot : slots_) {
      if (!slot.has_value()) return absl::CancelledError(fmt::format("cancelled in stage {}", StageName(stage_.kind)));
      results.push_back(*std::move(slot));
    }
    return results;
  }

 private:
  bool Over() { return over_.cancelled() || input_.Cancelled(); }

  // A piece that nobody runs; for an own thread then the oldest one that only a peer runs. Null when there is none.
  Piece* Take(bool here) {
    const std::lock_guard lock(mutex_);
    auto piece = std::ranges::find_if(pieces_, [](const Piece& p) { return !p.taken; });
    if (piece == pieces_.end() && here) {
      piece = std::ranges::find_if(pieces_, [](const Piece& p) { return !p.finished && !p.taken_here; });
    }
    if (piece == pieces_.end()) return nullptr;
    piece->taken = true;
    piece->taken_here = piece->taken_here || here;
    return &*piece;
  }

  void GiveUp(Piece& piece) {
    const std::lock_guard lock(mutex_);
    piece.taken = piece.finished || piece.taken_here;
  }

  void Finish(Piece& piece, std::vector<RestartResult> results) {
    std::unique_lock lock(mutex_);
    for (RestartResult& result : results) {
      std::optional<RestartResult>& slot = slots_[static_cast<size_t>(result.restart - first_)];
      if (slot.has_value()) {
        disagreed_ = disagreed_ || !SameBits(result, *slot, stage_.objects);
      } else {
        slot = std::move(result);
      }
    }
    piece.finished = true;
    const bool all = std::ranges::all_of(pieces_, [](const Piece& p) { return p.finished; });
    lock.unlock();
    if (all) End();
  }

  const SolveInput& input_;
  const StageSpec& stage_;
  const PartialLayout& before_;
  const int first_;
  std::mutex mutex_;
  std::vector<Piece> pieces_;
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
  if (!input.settings.groups) request.mutable_options()->set_groups(v1::GROUP_POLICY_OFF);
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

PeerPool::PeerPool(std::vector<std::unique_ptr<PeerOptimizer>> peers, const runtime::Clock& clock,
                   std::function<void(const std::string&)> remark)
    : clock_(clock), remark_(std::move(remark)) {
  for (std::unique_ptr<PeerOptimizer>& peer : peers) peers_.emplace_back().peer = std::move(peer);
}

PeerPool::Entry& PeerPool::EntryOf(const PeerOptimizer& peer) {
  return *std::ranges::find_if(peers_, [&](const Entry& entry) { return entry.peer.get() == &peer; });
}

std::vector<PeerOptimizer*> PeerPool::Borrow() {
  const std::lock_guard lock(mutex_);
  std::vector<PeerOptimizer*> borrowed;
  for (Entry& entry : peers_) {
    const bool rests = entry.failures > 0 && entry.rests_until > clock_.Elapsed();
    if (rests || entry.solves >= kMostSolves) continue;
    ++entry.solves;
    borrowed.push_back(entry.peer.get());
  }
  return borrowed;
}

void PeerPool::Return(const PeerOptimizer& peer) {
  const std::lock_guard lock(mutex_);
  --EntryOf(peer).solves;
}

void PeerPool::ReportFailure(const PeerOptimizer& peer, const absl::Status& why) {
  absl::Duration rest;
  {
    const std::lock_guard lock(mutex_);
    Entry& entry = EntryOf(peer);
    const int doublings = std::min(entry.failures++, kMostDoublings);
    rest = std::min(kLongestRest, kFirstRest * (1 << doublings));
    entry.rests_until = clock_.Elapsed() + rest;
  }
  remark_(fmt::format("peer {} is left out for {} s: {}; its restarts run elsewhere", peer.name(),
                      absl::ToInt64Seconds(rest), std::string(why.message())));
}

void PeerPool::ReportSuccess(const PeerOptimizer& peer) {
  const std::lock_guard lock(mutex_);
  EntryOf(peer).failures = 0;
}

absl::StatusOr<std::vector<RestartResult>> FanOutRestartRunner::Run(const SolveInput& input, const StageSpec& stage,
                                                                    const PartialLayout& before, int first,
                                                                    int count) const {
  const bool worth_it = count >= kLeastRestarts && !options_.has_time_limit() && !stage.objects.empty();
  const std::vector<PeerOptimizer*> peers = worth_it ? pool_.Borrow() : std::vector<PeerOptimizer*>();
  if (peers.empty()) return RunRestarts(input, stage, before, first, count);

  const int own = std::max(1, std::min(input.settings.threads, count));
  const int piece_size = std::clamp(count / (kPiecesEach * (own + static_cast<int>(peers.size()))), 1, kLargestPiece);
  Gathering gathering(input, stage, before, first, count, piece_size);
  const v1::SolveRestartsRequest request = RequestFor(input, options_, stage, before);
  std::vector<std::thread> here, there;
  for (PeerOptimizer* peer : peers) {
    there.emplace_back([&, peer] {
      const absl::Status status = gathering.WorkThere(*peer, request);
      if (status.ok()) pool_.ReportSuccess(*peer);
      if (!status.ok() && !absl::IsCancelled(status)) pool_.ReportFailure(*peer, status);
      pool_.Return(*peer);
    });
  }
  for (int i = 1; i < own; ++i) here.emplace_back([&gathering] { gathering.WorkHere(); });
  gathering.WorkHere();
  for (std::thread& thread : here) thread.join();
  gathering.End();
  for (std::thread& thread : there) thread.join();
  if (!gathering.disagreed()) return gathering.Results();
  // A peer computes something else (another processor, another build) and nobody knows in which answers.
  const absl::Status disagreed = absl::InternalError("a restart that was run twice gave two results");
  for (const PeerOptimizer* peer : peers) pool_.ReportFailure(*peer, disagreed);
  return RunRestarts(input, stage, before, first, count);
}

}  // namespace flair::optimizer
