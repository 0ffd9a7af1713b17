// SPDX-License-Identifier: GPL-3.0-or-later
// Runs restarts on this process's threads and on other optimizers at once.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/stages/stage.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::runtime {
struct ChannelOptions;
}  // namespace flair::runtime

namespace flair::optimizer {

class PeerOptimizer {
 public:
  virtual ~PeerOptimizer() = default;
  // For logs.
  virtual const std::string& name() const = 0;
  // OptimizerService.SolveRestarts; waits for the answer, which is not checked. CANCELLED soon after `cancellation` was
  // asked for. Thread-safe.
  virtual absl::StatusOr<v1::SolveRestartsResponse> SolveRestarts(const v1::SolveRestartsRequest& request,
                                                                  runtime::Cancellation& cancellation) = 0;
};

// Initial metadata of every answer to SolveRestarts: who computed it, in words. Peers must be equal in it, or a layout
// would depend on who took part.
inline constexpr char kProducerMetadata[] = "flair-producer";

// A peer at "HOST:PORT" (or another form that runtime::MakeChannel takes); connects on first use. A call ends after a
// minute at the latest, and is FAILED_PRECONDITION, naming both, when somebody else than `producer` answered.
// INVALID_ARGUMENT when the address has no such form. `clock` must outlive the peer.
absl::StatusOr<std::unique_ptr<PeerOptimizer>> MakeGrpcPeer(const std::string& address, const std::string& producer,
                                                            const runtime::Clock& clock,
                                                            const runtime::ChannelOptions& options);

// The peers of this optimizer, shared by its solves. A peer serves at most kMostSolves of them at a time. One that
// fails rests for a second, then two, four ... up to a minute; one success ends that. Thread-safe.
class PeerPool {
 public:
  static constexpr int kMostSolves = 2;

  // `clock` must outlive the pool. `remark` is told why a peer failed, one sentence each time, from several threads.
  PeerPool(
      std::vector<std::unique_ptr<PeerOptimizer>> peers, const runtime::Clock& clock,
      std::function<void(const std::string&)> remark = [](const std::string&) {});

  // Those that neither rest nor are busy, in the order given, for the caller to use until it returns each.
  std::vector<PeerOptimizer*> Borrow();
  void Return(const PeerOptimizer& peer);
  void ReportFailure(const PeerOptimizer& peer, const absl::Status& why);
  void ReportSuccess(const PeerOptimizer& peer);

 private:
  struct Entry {
    std::unique_ptr<PeerOptimizer> peer;
    int failures = 0;
    absl::Duration rests_until = absl::ZeroDuration();
    int solves = 0;
  };
  Entry& EntryOf(const PeerOptimizer& peer);

  const runtime::Clock& clock_;
  const std::function<void(const std::string&)> remark_;
  std::mutex mutex_;
  std::vector<Entry> peers_;
};

// Cuts the restarts into pieces that own threads and peers take one after the other. When there are none left, own
// threads repeat those that peers have not answered yet, so neither a dead nor a slow peer holds the solve up or fails
// it. Restarts do not depend on where they run, so the results are those of RunRestarts bit for bit. Fewer than
// kLeastRestarts are not worth the graph's way over the network, and neither is a solve with a time limit, which is a
// promise of this process alone: these run here.
class FanOutRestartRunner final : public RestartRunner {
 public:
  static constexpr int kLeastRestarts = 6;

  // `options` as they came with the request. Both are borrowed and must outlive the runner.
  FanOutRestartRunner(PeerPool& pool, const v1::SolveOptions& options) : pool_(pool), options_(options) {}
  absl::StatusOr<std::vector<RestartResult>> Run(const SolveInput& input, const StageSpec& stage,
                                                 const PartialLayout& before, int first, int count) const override;

 private:
  PeerPool& pool_;
  const v1::SolveOptions& options_;
};

}  // namespace flair::optimizer
