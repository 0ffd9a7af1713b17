// SPDX-License-Identifier: GPL-3.0-or-later

#include <grpcpp/client_context.h>
#include <grpcpp/completion_queue.h>
#include <grpcpp/support/async_unary_call.h>

#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/time/time.h"
#include "flair/v1/language_service.grpc.pb.h"
#include "flair/v1/optimizer_service.grpc.pb.h"
#include "flair/v1/renderer_service.grpc.pb.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/workers/stage_workers.h"
#include "orchestrator/workers/worker_pool.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

// One request to one worker or, when that one is late, to a second one as well: the first answer counts, and the other
// call is cancelled. All calls of stages are idempotent by request id. Waits in the calling thread, which alone drives
// the calls. Used once.
template <typename Service, typename Request, typename Response>
class WorkerCall {
 public:
  using Method = std::unique_ptr<grpc::ClientAsyncResponseReaderInterface<Response>> (Service::StubInterface::*)(
      grpc::ClientContext*, const Request&, grpc::CompletionQueue*);

  // How the call to one worker ended, or goes on.
  struct Attempt {
    Place place;
    std::shared_ptr<Connection> connection;
    grpc::ClientContext context;
    std::unique_ptr<grpc::ClientAsyncResponseReaderInterface<Response>> reader;
    Response response;
    grpc::Status grpc_status;
    // Of an attempt that has ended.
    absl::Status status;
  };

  WorkerCall(WorkersOfStage& workers, Method method, const Request& request, runtime::CallContext& call)
      : workers_(workers), method_(method), request_(request), call_(call) {}

  // Calls the worker of `place` and, when it is late, one that is neither that nor `tried`. Returns the attempt that
  // counts; the place of the other is given back.
  Attempt& Run(Place place, std::set<WorkerId> tried) {
    place.request = Request::descriptor()->name();
    tried.insert(place.worker);
    const auto cancel = [this] { CancelAll(); };
    runtime::OnCancel guard(call_.cancellation(), cancel);
    absl::Duration patience = workers_.pool().Patience(place);
    Begin(std::move(place));
    Attempt* winner = nullptr;
    while (running_ > 0) {
      Attempt* ended = Next(running_ == 1 && winner == nullptr ? patience : absl::InfiniteDuration());
      if (ended == nullptr) {
        patience = kLookAgain;
        if (std::optional<Place> second = workers_.pool().TryTake(tried)) {
          second->request = attempts_.front().place.request;
          Begin(*std::move(second));
        }
      } else if (winner == nullptr && (VerdictOf(ended->status) == Verdict::kGood || running_ == 0)) {
        winner = ended;
        // To cancel what has ended is work too.
        if (running_ > 0) CancelAll();
      } else {
        const bool beaten = ended == &attempts_.front() && winner != nullptr && winner->status.ok();
        workers_.pool().End(
            ended->place, beaten ? Verdict::kBeaten : VerdictOf(ended->status),
            beaten ? absl::DeadlineExceededError("another worker, asked later, answered before it") : ended->status);
      }
    }
    events_.Shutdown();
    void* tag = nullptr;
    for (bool ok = false; events_.Next(&tag, &ok);) {
    }
    return winner == nullptr ? attempts_.front() : *winner;
  }

 private:
  // Between two looks whether a second worker has room.
  static constexpr absl::Duration kLookAgain = absl::Seconds(1);

  void Begin(Place place) {
    std::lock_guard lock(mutex_);
    Attempt& attempt = attempts_.emplace_back();
    attempt.place = std::move(place);
    attempt.connection = workers_.ConnectionTo(attempt.place.worker);
    if (attempt.connection == nullptr) {
      attempt.status = absl::UnavailableError("it has gone");
      return;
    }
    if (call_.deadline() != absl::InfiniteFuture()) attempt.context.set_deadline(absl::ToChronoTime(call_.deadline()));
    typename Service::StubInterface& stub = attempt.connection->template StubOf<Service>();
    attempt.reader = (stub.*method_)(&attempt.context, request_, &events_);
    attempt.reader->StartCall();
    attempt.reader->Finish(&attempt.response, &attempt.grpc_status, &attempt);
    ++running_;
    if (cancelled_) attempt.context.TryCancel();
  }

  // The attempt that ended next; null when none did within `patience`.
  Attempt* Next(absl::Duration patience) {
    void* tag = nullptr;
    bool ok = false;
    if (patience == absl::InfiniteDuration()) {
      events_.Next(&tag, &ok);
    } else if (events_.AsyncNext(&tag, &ok, std::chrono::system_clock::now() + absl::ToChronoNanoseconds(patience)) ==
               grpc::CompletionQueue::TIMEOUT) {
      return nullptr;
    }
    --running_;
    Attempt& attempt = *static_cast<Attempt*>(tag);
    attempt.status = runtime::FromGrpcStatus(attempt.grpc_status);
    // gRPC says of bytes that are no message only this.
    if (!ok && attempt.status.ok()) attempt.status = absl::InternalError("its answer is no message of this protocol");
    return &attempt;
  }

  void CancelAll() {
    std::lock_guard lock(mutex_);
    cancelled_ = true;
    for (Attempt& attempt : attempts_) attempt.context.TryCancel();
  }

  WorkersOfStage& workers_;
  const Method method_;
  const Request& request_;
  runtime::CallContext& call_;
  grpc::CompletionQueue events_;
  int running_ = 0;
  // Guards the list against CancelAll from other threads.
  std::mutex mutex_;
  bool cancelled_ = false;
  // Stays where it is as it grows.
  std::deque<Attempt> attempts_;
};

// Workers that one call may lose, or be refused by, before that is its answer: a request that ends every worker must
// not end them all.
constexpr size_t kTriedLimit = 3;

template <typename Service>
class Stage {
 public:
  explicit Stage(WorkersOfStage& workers) : workers_(workers) {}

  // Asks workers until one answers. A full one is no answer, nor is one that is not there; and what one alone says
  // against a request does not count while there is another one to ask. See docs/workers.md.
  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(std::unique_ptr<grpc::ClientAsyncResponseReaderInterface<Response>> (
                                   Service::StubInterface::*method)(grpc::ClientContext*, const Request&,
                                                                    grpc::CompletionQueue*),
                               const Request& request, StageCall& call) const {
    WorkerPool& pool = workers_.pool();
    std::set<WorkerId> tried = call.bad_answerers();
    absl::Status failure;
    while (true) {
      const absl::StatusOr<Place> place = pool.Take(tried, call);
      if (!place.ok()) return absl::IsUnavailable(place.status()) && !failure.ok() ? failure : place.status();
      WorkerCall<Service, Request, Response> worker_call(workers_, method, request, call);
      auto& attempt = worker_call.Run(*place, tried);
      const Verdict verdict = VerdictOf(attempt.status);
      if (verdict == Verdict::kFull || verdict == Verdict::kLost) {
        pool.End(attempt.place, verdict, attempt.status);
        if (verdict == Verdict::kFull) continue;
        failure = Explain(attempt);
        tried.insert(attempt.place.worker);
        if (tried.size() >= kTriedLimit) return failure;
        continue;
      }
      const bool refused = (verdict == Verdict::kGood || verdict == Verdict::kFailed) && !attempt.status.ok();
      while (refused && !absl::IsAborted(attempt.status) && tried.size() < kTriedLimit) {
        tried.insert(attempt.place.worker);
        const std::optional<Place> witness = pool.TakeWitness(attempt.place, tried);
        if (!witness.has_value()) break;
        WorkerCall<Service, Request, Response> second_call(workers_, method, request, call);
        auto& second = second_call.Run(*witness, tried);
        if (second.status.ok()) {
          pool.End(attempt.place, Verdict::kFailed,
                   Internal("it refuses what another worker answers: {}", attempt.status.message()));
          return Answered(second, call);
        }
        const Verdict second_verdict = VerdictOf(second.status);
        pool.End(second.place, second_verdict, second.status);
        if (second_verdict == Verdict::kGood || second_verdict == Verdict::kFailed) break;
        tried.insert(second.place.worker);
      }
      if (attempt.status.ok()) return Answered(attempt, call);
      pool.End(attempt.place, verdict, attempt.status);
      return attempt.status;
    }
  }

  absl::StatusOr<std::optional<std::string>> Revision(StageCall& call) const { return workers_.pool().Revision(call); }

 private:
  // The call keeps its place until whoever asked says whether the answer is one.
  template <typename Attempt>
  auto Answered(Attempt& attempt, StageCall& call) const {
    call.SetAnswerer({attempt.place.revision, attempt.place.worker,
                      [&pool = workers_.pool(), place = attempt.place](const absl::Status& answer) {
                        pool.End(place, answer.ok() ? Verdict::kGood : Verdict::kFailed, answer);
                      }});
    return absl::StatusOr<decltype(attempt.response)>(std::move(attempt.response));
  }

  template <typename Attempt>
  absl::Status Explain(const Attempt& attempt) const {
    const std::string address = attempt.connection == nullptr ? "an address" : attempt.connection->address();
    const std::string message(attempt.status.message());
    if (absl::IsUnavailable(attempt.status)) {
      return Unavailable("{} worker at {} is not reachable: {}; start it or fix {}", workers_.stage(), address, message,
                         workers_.setting());
    }
    if (absl::IsUnimplemented(attempt.status)) {
      return Unimplemented(
          "{} worker at {}: the server there does not serve this call of {}{}; start one that does or fix {}",
          workers_.stage(), address, Service::service_full_name(), message.empty() ? "" : ": " + message,
          workers_.setting());
    }
    return attempt.status;
  }

  WorkersOfStage& workers_;
};

class GrpcStageClients final : public StageClients {
 public:
  explicit GrpcStageClients(const StageCallers& callers)
      : language_(callers.language),
        translator_(callers.translator),
        optimizer_(callers.optimizer),
        renderer_(callers.renderer) {}

#define FLAIR_ASK(stage, Service, Rpc)                                                          \
  absl::StatusOr<v1::Rpc##Response> Rpc(const v1::Rpc##Request& request, Call& call) override { \
    return stage.Ask(&v1::Service::StubInterface::PrepareAsync##Rpc, request, call);            \
  }
  FLAIR_ASK(language_, LanguageService, DescribeRoom)
  FLAIR_ASK(language_, LanguageService, PlanZones)
  FLAIR_ASK(language_, LanguageService, ListObjects)
  FLAIR_ASK(language_, LanguageService, ChooseStyle)
  FLAIR_ASK(language_, LanguageService, ListConstraints)
  FLAIR_ASK(language_, LanguageService, CleanConstraints)
  FLAIR_ASK(language_, LanguageService, CompleteConstraints)
  FLAIR_ASK(translator_, TranslatorService, Translate)
  FLAIR_ASK(optimizer_, OptimizerService, ListConstraintTypes)
  FLAIR_ASK(optimizer_, OptimizerService, Solve)
  FLAIR_ASK(optimizer_, OptimizerService, Evaluate)
  FLAIR_ASK(optimizer_, OptimizerService, Resolve)
  FLAIR_ASK(renderer_, RendererService, Render)
  FLAIR_ASK(renderer_, RendererService, ExportScene)
  FLAIR_ASK(renderer_, RendererService, DrawPlanParts)
#undef FLAIR_ASK

  absl::StatusOr<std::optional<std::string>> Revision(v1::ArtifactKind kind, Call& call) override {
    switch (kind) {
      case v1::ARTIFACT_KIND_BRIEF:
      case v1::ARTIFACT_KIND_REPORT:
        return "";
      case v1::ARTIFACT_KIND_LAYOUT_GRAPH:
        return translator_.Revision(call);
      case v1::ARTIFACT_KIND_SOLVED_LAYOUT:
        return optimizer_.Revision(call);
      case v1::ARTIFACT_KIND_PREVIEW:
        return renderer_.Revision(call);
      default:
        return language_.Revision(call);
    }
  }

 private:
  Stage<v1::LanguageService> language_;
  Stage<v1::TranslatorService> translator_;
  Stage<v1::OptimizerService> optimizer_;
  Stage<v1::RendererService> renderer_;
};

}  // namespace

std::unique_ptr<StageClients> MakeGrpcStageClients(const StageCallers& callers) {
  return std::make_unique<GrpcStageClients>(callers);
}

}  // namespace flair::orchestrator
