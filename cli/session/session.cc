// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/session.h"

#include <grpcpp/channel.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdio>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <type_traits>

#include "absl/strings/match.h"
#include "absl/time/clock.h"
#include "cli/embedded/embedded_services.h"
#include "flair/v1/orchestrator_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

using OrchestratorStub = v1::OrchestratorService::StubInterface;
template <typename Request, typename Response>
using UnaryMethod = grpc::Status (OrchestratorStub::*)(grpc::ClientContext*, const Request&, Response*);
template <typename Request, typename Response>
using WatchMethod = std::unique_ptr<grpc::ClientReaderInterface<Response>> (OrchestratorStub::*)(grpc::ClientContext*,
                                                                                                 const Request&);

// A silence so short is not worth telling.
constexpr absl::Duration kToldAfter = absl::Seconds(5);

absl::Duration PauseBefore(int attempt) {
  return std::min(absl::Seconds(3), absl::Milliseconds(100) * static_cast<double>(1 << std::min(attempt, 10)));
}

// Unique enough to be the key of one wish of one process.
std::string NewRequestId() {
  std::random_device device;
  return fmt::format("cli-{:x}-{:x}{:08x}{:08x}", absl::ToUnixMicros(absl::Now()), getpid(), device(), device());
}

}  // namespace

bool WaitUnlessStopped(runtime::Cancellation& stop, absl::Duration time) {
  std::mutex mutex;
  std::condition_variable stopped;
  const runtime::OnCancel wake(stop, [&] {
    const std::lock_guard lock(mutex);
    stopped.notify_all();
  });
  std::unique_lock lock(mutex);
  return stopped.wait_for(lock, absl::ToChronoNanoseconds(time), [&] { return stop.cancelled(); });
}

struct Session::Calls {
  // Ends after the calls.
  std::unique_ptr<EmbeddedServices> services;
  const std::shared_ptr<grpc::Channel> channel;
  const std::string address;
  const std::unique_ptr<OrchestratorStub> stub = v1::OrchestratorService::NewStub(channel);
  runtime::Cancellation never = {};
  Limits limits = {.stop = &never};
  std::atomic<bool> answered = false;
  // The user knows that there is no answer at the moment.
  std::atomic<bool> told = false;

  // Says where nobody answered.
  absl::Status Explain(const absl::Status& status) const {
    if (limits.stop->cancelled()) return absl::CancelledError("interrupted");
    if (absl::IsUnimplemented(status)) {
      return Unimplemented(
          "the orchestrator at {} does not know this call: {}; use a flair-orchestrator of this version", address,
          status.message());
    }
    // Of whoever calls, not of a model or a file, for which these codes stand elsewhere.
    if (absl::IsUnauthenticated(status) || absl::IsPermissionDenied(status)) {
      return EndWith(kExitBadInput, std::string(status.message()));
    }
    // An orchestrator that answers may say itself that what it needs does not.
    return services != nullptr || !runtime::IsOfConnection(status) ? status : NoOrchestrator(status, address);
  }

  // Whether to call again after `status`, which may be that the other side `is_full`; waits before it says yes.
  // `silent_since` is when the first call failed.
  bool TryAgain(const absl::Status& status, bool is_full, absl::Time silent_since, int attempt) {
    const bool may_pass = absl::IsUnavailable(status) || absl::IsDeadlineExceeded(status) || is_full;
    const absl::Duration silent = absl::Now() - silent_since;
    const absl::Duration outage = runtime::IsOfConnection(status) ? absl::ZeroDuration() : limits.outage;
    if (!may_pass || !answered || silent > std::max(limits.patience, outage)) return false;
    if (!is_full && silent > kToldAfter && !told.exchange(true)) {
      fmt::print(stderr, "flair: {}; trying again\n", Explain(status).message());
    }
    return !WaitUnlessStopped(*limits.stop, PauseBefore(attempt));
  }

  // Whether the orchestrator, which has not even said hello, does so a little later.
  bool SaysHelloLater(const absl::Status& status, absl::Time until) const {
    if (!runtime::HandshakeTimedOut(status)) return false;
    fmt::print(stderr, "flair: {} is slow to answer; waiting for up to {} s\n", address,
               absl::ToInt64Seconds(limits.answer_within));
    return channel->WaitForConnected(absl::ToChronoTime(until));
  }

  template <typename Request, typename Response>
  absl::StatusOr<Response> Ask(UnaryMethod<Request, Response> method, const Request& request) {
    const absl::Time start = absl::Now();
    for (int attempt = 0;; ++attempt) {
      runtime::CallContext call;
      const runtime::OnCancel cancel(*limits.stop, [&call] { call.cancellation().Cancel(); });
      const absl::Time end = absl::Now() + limits.answer_within;
      auto response = runtime::UnaryRequest(*stub, method, request, call, end);
      if (!answered && SaysHelloLater(response.status(), end)) {
        response = runtime::UnaryRequest(*stub, method, request, call, end);
      }
      if (response.ok()) {
        answered = true;
        told = false;
        return response;
      }
      if (runtime::TurnedAway(response.status())) answered = true;
      // A full queue is waited for elsewhere, and longer.
      const bool is_full =
          absl::IsResourceExhausted(response.status()) && !std::is_same_v<Request, v1::AddToBatchRequest>;
      if (!TryAgain(response.status(), is_full, start, attempt)) return Explain(response.status());
    }
  }

  // Of a job, which may not be there.
  template <typename Request, typename Response>
  absl::StatusOr<Response> OfJob(UnaryMethod<Request, Response> method, const std::string& id) {
    Request request;
    request.set_job_id(id);
    absl::StatusOr<Response> response = Ask(method, request);
    if (!absl::IsNotFound(response.status())) return response;
    return NotFound("{}: no such job {}; flair jobs lists them", id,
                    services != nullptr ? "in the store " + DefaultStorePath() : "at " + address);
  }

  template <typename Request, typename Response>
  absl::StatusOr<v1::Batch> OfBatch(UnaryMethod<Request, Response> method, const std::string& id) {
    Request request;
    request.set_batch_id(id);
    ASSIGN_OR_RETURN(auto response, Ask(method, request));
    return std::move(*response.mutable_batch());
  }

  // The first `count` items of a list that comes in pages.
  template <typename Item, typename Request, typename Response>
  absl::StatusOr<std::vector<Item>> List(UnaryMethod<Request, Response> method,
                                         const google::protobuf::RepeatedPtrField<Item>& (Response::*items)() const,
                                         int count) {
    std::vector<Item> all;
    Request request;
    do {
      request.set_page_size(std::min(1000, count - static_cast<int>(all.size())));
      ASSIGN_OR_RETURN(const Response response, Ask(method, request));
      all.insert(all.end(), (response.*items)().begin(), (response.*items)().end());
      request.set_page_token(response.next_page_token());
    } while (!request.page_token().empty() && static_cast<int>(all.size()) < count);
    return all;
  }

  // Reads what `method` streams, from where it was when the connection breaks, until it ends or `see` returns nothing;
  // otherwise that returns the sequence number.
  template <typename Request, typename Response, typename See>
  absl::Status Follow(WatchMethod<Request, Response> method, Request request, runtime::Cancellation& enough,
                      const See& see) {
    absl::Time silent_since = absl::InfiniteFuture();
    for (int attempt = 0;; ++attempt) {
      grpc::ClientContext context;
      const runtime::OnCancel cancel(*limits.stop, [&context] { context.TryCancel(); });
      const runtime::OnCancel end(enough, [&context] { context.TryCancel(); });
      const auto reader = ((*stub).*method)(&context, request);
      Response response;
      while (reader->Read(&response)) {
        answered = true;
        told = false;
        attempt = 0;
        silent_since = absl::InfiniteFuture();
        if (const std::optional<int64_t> sequence = see(response)) {
          request.set_after_sequence(*sequence);
          continue;
        }
        context.TryCancel();
        (void)reader->Finish();
        return absl::OkStatus();
      }
      const absl::Status status = runtime::FromGrpcStatus(reader->Finish(), context);
      if (status.ok() || enough.cancelled()) return absl::OkStatus();
      if (silent_since == absl::InfiniteFuture()) silent_since = absl::Now();
      if (!TryAgain(status, absl::IsResourceExhausted(status), silent_since, attempt)) return Explain(status);
    }
  }
};

Session::Session(std::unique_ptr<Calls> calls) : calls_(std::move(calls)) {}

Session::Session(std::shared_ptr<grpc::Channel> channel, const std::string& address)
    : Session(
          std::unique_ptr<Calls>(new Calls{.services = nullptr, .channel = std::move(channel), .address = address})) {}

Session::~Session() = default;

absl::StatusOr<std::unique_ptr<Session>> Session::Open(const std::string& address, const OptionalLlm& llm,
                                                       const StageChoice& stages,
                                                       const config::v1::OrchestratorConfig& orchestrator) {
  if (address.empty()) {
    ASSIGN_OR_RETURN(std::unique_ptr<EmbeddedServices> services,
                     EmbeddedServices::Start(DefaultStorePath(), llm, stages, orchestrator));
    std::shared_ptr<grpc::Channel> channel = services->orchestrator();
    std::unique_ptr<Calls> calls(
        new Calls{.services = std::move(services), .channel = std::move(channel), .address = "this process"});
    return std::unique_ptr<Session>(new Session(std::move(calls)));
  }
  ASSIGN_OR_RETURN(const runtime::ChannelOptions options, OrchestratorConnection());
  ASSIGN_OR_RETURN(auto channel, runtime::MakeChannel(address, v1::OrchestratorService::service_full_name(), options));
  return std::make_unique<Session>(std::move(channel), address);
}

void Session::SetLimits(const Limits& limits) {
  calls_->limits = limits;
  if (limits.stop == nullptr) calls_->limits.stop = &calls_->never;
}

bool Session::stopped() const { return calls_->limits.stop->cancelled(); }
bool Session::embedded() const { return calls_->services != nullptr; }
const std::shared_ptr<grpc::Channel>& Session::channel() const { return calls_->channel; }
const std::string& Session::address() const { return calls_->address; }

absl::StatusOr<v1::Artifact> Session::GetArtifact(const std::string& id) {
  v1::GetArtifactRequest request;
  request.set_artifact_id(id);
  ASSIGN_OR_RETURN(auto response, calls_->Ask(&OrchestratorStub::GetArtifact, request));
  return std::move(*response.mutable_artifact());
}

absl::StatusOr<std::vector<std::string>> Session::FindIds(const std::string& prefix) {
  constexpr int kSearchedJobs = 1000;
  ASSIGN_OR_RETURN(const std::vector<v1::Job> jobs, ListJobs(kSearchedJobs));
  std::set<std::string> ids;
  for (const v1::Job& job : jobs) {
    for (const v1::ArtifactRef& ref : job.artifacts()) {
      if (ref.id().starts_with(prefix)) ids.insert(ref.id());
    }
  }
  return std::vector<std::string>(ids.begin(), ids.end());
}

absl::StatusOr<v1::Job> Session::CreateJob(const v1::JobSpec& spec) {
  v1::CreateJobRequest request;
  request.set_request_id(NewRequestId());
  *request.mutable_spec() = spec;
  ASSIGN_OR_RETURN(auto response, calls_->Ask(&OrchestratorStub::CreateJob, request));
  return response.job();
}

absl::StatusOr<v1::Job> Session::GetJob(const std::string& id) {
  ASSIGN_OR_RETURN(auto response, calls_->OfJob(&OrchestratorStub::GetJob, id));
  return response.job();
}

absl::StatusOr<v1::Job> Session::CancelJob(const std::string& id) {
  ASSIGN_OR_RETURN(auto response, calls_->OfJob(&OrchestratorStub::CancelJob, id));
  return response.job();
}

absl::StatusOr<v1::DeleteJobResponse> Session::DeleteJob(const std::string& id) {
  return calls_->OfJob(&OrchestratorStub::DeleteJob, id);
}

absl::StatusOr<std::vector<v1::Job>> Session::ListJobs(int count) {
  return calls_->List<v1::Job>(&OrchestratorStub::ListJobs, &v1::ListJobsResponse::jobs, count);
}

absl::Status Session::Watch(const std::string& id, const std::function<void(const v1::JobEvent&)>& see) {
  v1::WatchJobRequest request;
  request.set_job_id(id);
  return calls_->Follow(&OrchestratorStub::WatchJob, request, calls_->never,
                        [&](const v1::WatchJobResponse& response) -> std::optional<int64_t> {
                          see(response.event());
                          if (response.event().kind() == v1::JOB_EVENT_KIND_ENDED) return std::nullopt;
                          return response.event().sequence();
                        });
}

absl::StatusOr<v1::Batch> Session::CreateBatch(const std::string& request_id, const std::string& label) {
  v1::CreateBatchRequest request;
  request.set_request_id(request_id);
  request.set_label(label);
  request.set_open(true);
  ASSIGN_OR_RETURN(auto response, calls_->Ask(&OrchestratorStub::CreateBatch, request));
  return std::move(*response.mutable_batch());
}

absl::StatusOr<v1::Batch> Session::AddToBatch(const v1::AddToBatchRequest& request,
                                              const std::function<void(const std::string& why)>& full) {
  for (int attempt = 0;; ++attempt) {
    auto response = calls_->Ask(&OrchestratorStub::AddToBatch, request);
    if (response.ok()) return std::move(*response->mutable_batch());
    // What is too large for a message will be so for ever.
    const bool too_large = absl::StrContains(response.status().message(), "larger than max");
    if (!absl::IsResourceExhausted(response.status()) || too_large) return response.status();
    full(std::string(response.status().message()));
    if (WaitUnlessStopped(*calls_->limits.stop, PauseBefore(attempt))) return absl::CancelledError("interrupted");
  }
}

absl::StatusOr<v1::Batch> Session::GetBatch(const std::string& id) {
  return calls_->OfBatch(&OrchestratorStub::GetBatch, id);
}

absl::StatusOr<v1::Batch> Session::PauseBatch(const std::string& id) {
  return calls_->OfBatch(&OrchestratorStub::PauseBatch, id);
}

absl::StatusOr<v1::Batch> Session::ResumeBatch(const std::string& id) {
  return calls_->OfBatch(&OrchestratorStub::ResumeBatch, id);
}

absl::StatusOr<v1::Batch> Session::CancelBatch(const std::string& id) {
  return calls_->OfBatch(&OrchestratorStub::CancelBatch, id);
}

absl::StatusOr<v1::DeleteBatchResponse> Session::DeleteBatch(const std::string& id) {
  v1::DeleteBatchRequest request;
  request.set_batch_id(id);
  return calls_->Ask(&OrchestratorStub::DeleteBatch, request);
}

absl::StatusOr<std::vector<v1::Batch>> Session::ListBatches(int count) {
  return calls_->List<v1::Batch>(&OrchestratorStub::ListBatches, &v1::ListBatchesResponse::batches, count);
}

absl::StatusOr<v1::RetryBatchResponse> Session::RetryBatch(const v1::RetryBatchRequest& request) {
  return calls_->Ask(&OrchestratorStub::RetryBatch, request);
}

absl::StatusOr<v1::GetClusterResponse> Session::GetCluster() {
  return calls_->Ask(&OrchestratorStub::GetCluster, v1::GetClusterRequest());
}

absl::Status Session::WatchBatch(const std::string& id, int64_t after_sequence, runtime::Cancellation& enough,
                                 const std::function<bool(const v1::WatchBatchResponse&)>& see) {
  v1::WatchBatchRequest request;
  request.set_batch_id(id);
  request.set_after_sequence(after_sequence);
  return calls_->Follow(&OrchestratorStub::WatchBatch, request, enough,
                        [&](const v1::WatchBatchResponse& response) -> std::optional<int64_t> {
                          return see(response) ? std::optional(response.sequence()) : std::nullopt;
                        });
}

std::string StagesAway(const v1::GetClusterResponse& cluster) {
  std::map<std::string, std::string> away;
  std::set<std::string> served;
  for (const v1::OrchestratorStatus& orchestrator : cluster.orchestrators()) {
    for (const v1::WorkerStatus& worker : orchestrator.workers()) {
      if (worker.state() == v1::WORKER_STATE_GONE || worker.state() == v1::WORKER_STATE_BROKEN) {
        away[worker.stage()] = fmt::format("no {} worker works: {} is {}", worker.stage(), worker.address(),
                                           worker.state() == v1::WORKER_STATE_GONE ? "gone" : "broken");
      } else {
        served.insert(worker.stage());
      }
    }
  }
  std::string text;
  for (const auto& [stage, how] : away) {
    if (!served.contains(stage)) text += (text.empty() ? "" : "; ") + how;
  }
  return text;
}

}  // namespace flair::cli
