// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "flair/v1/translator_service.pb.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::orchestrator {

// One call of a stage: on the way there who may wait how long for it, on the way back who answered. One thread at a
// time makes calls under it.
class StageCall final : public runtime::CallContext {
 public:
  using CallContext::CallContext;
  ~StageCall() { Settle(absl::OkStatus()); }

  // Who answered: its Revision(), part of the key under which the answer is kept, since workers of several revisions
  // may serve a stage; its number, and where to say whether the answer was one.
  struct Answerer {
    std::optional<std::string> revision;
    int64_t worker = 0;
    std::function<void(const absl::Status&)> settle = nullptr;
  };

  // Nothing when it is not known.
  const std::optional<Answerer>& answerer() const { return answerer_; }

  // Says that the answer was no good although it came as one, so that its worker is called less; and by the next call
  // that is given bad_answerers(), not at all.
  void ReportBadAnswer(const absl::Status& why) {
    if (answerer_.has_value()) bad_answerers_.insert(answerer_->worker);
    Settle(why);
  }
  const std::set<int64_t>& bad_answerers() const { return bad_answerers_; }
  void set_bad_answerers(std::set<int64_t> workers) { bad_answerers_ = std::move(workers); }

  // For the clients. The answer before it was good.
  void SetAnswerer(Answerer answerer) {
    Settle(absl::OkStatus());
    answerer_ = std::move(answerer);
  }

 private:
  void Settle(const absl::Status& answer) {
    if (answerer_.has_value() && answerer_->settle != nullptr) std::exchange(answerer_->settle, nullptr)(answer);
  }

  std::optional<Answerer> answerer_;
  std::set<int64_t> bad_answerers_;
};

// What the pipeline asks of the stages, one function per RPC. Each waits for the answer, at most until the deadline of
// `call`, and stops when `call` is cancelled. Knows nothing of gRPC. Thread-safe.
class StageClients {
 public:
  virtual ~StageClients() = default;
  using Call = StageCall;

  virtual absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom(const v1::DescribeRoomRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::PlanZonesResponse> PlanZones(const v1::PlanZonesRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ListObjectsResponse> ListObjects(const v1::ListObjectsRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle(const v1::ChooseStyleRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ListConstraintsResponse> ListConstraints(const v1::ListConstraintsRequest& request,
                                                                      Call& call) = 0;
  virtual absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints(const v1::CleanConstraintsRequest& request,
                                                                        Call& call) = 0;
  // UNIMPLEMENTED of a language worker that completes nothing.
  virtual absl::StatusOr<v1::CompleteConstraintsResponse> CompleteConstraints(
      const v1::CompleteConstraintsRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::TranslateResponse> Translate(const v1::TranslateRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ListConstraintTypesResponse> ListConstraintTypes(
      const v1::ListConstraintTypesRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::SolveResponse> Solve(const v1::SolveRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::EvaluateResponse> Evaluate(const v1::EvaluateRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::RenderResponse> Render(const v1::RenderRequest& request, Call& call) = 0;
  // What only editors ask, between jobs.
  virtual absl::StatusOr<v1::ResolveResponse> Resolve(const v1::ResolveRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::ExportSceneResponse> ExportScene(const v1::ExportSceneRequest& request, Call& call) = 0;
  virtual absl::StatusOr<v1::DrawPlanPartsResponse> DrawPlanParts(const v1::DrawPlanPartsRequest& request,
                                                                  Call& call) = 0;

  // Tells the worker that a kind of artifact comes from apart from all that may answer otherwise (see WorkerService);
  // empty for what we make ourselves, nothing for workers that do not tell. Part of the key for re-use, so that no
  // worker gets the results of another one or of its own older version. Where workers of several revisions serve the
  // stage, one of these. UNIMPLEMENTED for a worker of another protocol.
  virtual absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind kind, Call& call) = 0;
};

// When a call of a stage is made again. UNAVAILABLE: a worker is down or was just lost; a few times, so that a restart
// is bridged and a worker that was never started is soon reported. RESOURCE_EXHAUSTED: a queue is full; until the
// deadline. Nothing else is made again.
struct BackoffPolicy {
  int unavailable_attempt_limit = 6;
  absl::Duration first_delay = absl::Milliseconds(100);
  double growth = 2.0;
  absl::Duration longest_delay = absl::Seconds(2);

  // How long to wait after the failure of attempt `attempt` (0 is the first) before the next; nothing when there is no
  // next. Spread by up to a half of itself, by `key`, so that callers that failed together do not come back together.
  std::optional<absl::Duration> DelayAfter(const absl::Status& failure, int attempt, const std::string& key) const;
};

// RESOURCE_EXHAUSTED as gRPC says it of messages over the limit; those never get smaller.
bool IsMessageTooLarge(const absl::Status& status);

// Waits; returns early when the call is cancelled. A function so that tests need not wait.
using Waiter = std::function<void(absl::Duration, runtime::CallContext&)>;
void WaitUnlessCancelled(absl::Duration duration, runtime::CallContext& call);

// What kind of failure ended a run, and whether another run may help.

// The same error, known to come from the orchestrator's own store and not from a worker; an outage when the store is
// away.
absl::Status OfStore(absl::Status status);

// The same error, because what a stage needs is not there, such as a worker: no run of the job has failed, it waits.
absl::Status OfOutage(absl::Status status);
bool IsOutage(const absl::Status& status);

// The kind of a failure of a stage; see FailureKind. `stage` as in JobEvent.stage.
v1::FailureKind KindOfFailure(const absl::Status& failure, std::string_view stage);

// Whether the same run, made later, may succeed: a worker, a model or a store that was down or slow.
bool MayPass(const absl::Status& failure, v1::FailureKind kind);

// How long a job waits after its `failure_count`-th failed run: 1 s, 4 s, 16 s, at most a minute; spread by up to a
// half of itself by `key`, so that jobs that failed together do not come back together.
absl::Duration DelayAfterFailure(int failure_count, const std::string& key);

}  // namespace flair::orchestrator
