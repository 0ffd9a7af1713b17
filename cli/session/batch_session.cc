// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/batch_session.h"

#include <algorithm>
#include <condition_variable>
#include <mutex>
#include <type_traits>

#include "absl/strings/match.h"
#include "absl/time/clock.h"
#include "cli/input/service_flags.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kAnswerWithin = absl::Seconds(60);
constexpr absl::Duration kFirstPause = absl::Milliseconds(100);
constexpr absl::Duration kLongestPause = absl::Seconds(3);

absl::Duration PauseBefore(int attempt) {
  return std::min(kLongestPause, kFirstPause * static_cast<double>(1 << std::min(attempt, 10)));
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

BatchSession::BatchSession(std::shared_ptr<grpc::Channel> channel, Options options, runtime::Cancellation& stop)
    : stub_(v1::OrchestratorService::NewStub(channel)), options_(std::move(options)), stop_(stop) {}

absl::Status BatchSession::Explain(const absl::Status& status) const {
  if (stop_.cancelled()) return absl::CancelledError("interrupted");
  if (absl::IsUnimplemented(status)) {
    return absl::UnimplementedError(
        fmt::format("the orchestrator at {} knows no such batches: {}; use a flair-orchestrator of this version",
                    options_.address, std::string(status.message())));
  }
  return options_.embedded ? status : NoOrchestrator(status, options_.address);
}

bool BatchSession::TryAgain(const absl::Status& status, bool is_full, absl::Time silent_since, int attempt) {
  const bool may_pass = absl::IsUnavailable(status) || absl::IsDeadlineExceeded(status) || is_full;
  if (!may_pass || !answered_ || absl::Now() - silent_since > options_.patience) return false;
  return !WaitUnlessStopped(stop_, PauseBefore(attempt));
}

template <typename Request, typename Response>
absl::StatusOr<Response> BatchSession::Ask(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                                        Response*),
                                           const Request& request) {
  const absl::Time start = absl::Now();
  for (int attempt = 0;; ++attempt) {
    runtime::CallContext call;
    const runtime::OnCancel cancel(stop_, [&call] { call.cancellation().Cancel(); });
    auto response = runtime::UnaryRequest(*stub_, method, request, call, absl::Now() + kAnswerWithin);
    if (response.ok()) answered_ = true;
    if (response.ok()) return response;
    // A full queue is waited for elsewhere, and longer.
    const bool is_full =
        absl::IsResourceExhausted(response.status()) && !std::is_same_v<Request, v1::AddToBatchRequest>;
    if (!TryAgain(response.status(), is_full, start, attempt)) return Explain(response.status());
  }
}

template <typename Request, typename Response>
absl::StatusOr<v1::Batch> BatchSession::AskOfBatch(grpc::Status (Stub::*method)(grpc::ClientContext*, const Request&,
                                                                                Response*),
                                                   const std::string& id) {
  Request request;
  request.set_batch_id(id);
  ASSIGN_OR_RETURN(auto response, Ask(method, request));
  return std::move(*response.mutable_batch());
}

absl::StatusOr<v1::Batch> BatchSession::CreateBatch(const std::string& request_id, const std::string& label) {
  v1::CreateBatchRequest request;
  request.set_request_id(request_id);
  request.set_label(label);
  request.set_open(true);
  ASSIGN_OR_RETURN(auto response, Ask(&Stub::CreateBatch, request));
  return std::move(*response.mutable_batch());
}

absl::StatusOr<v1::Batch> BatchSession::AddToBatch(const v1::AddToBatchRequest& request,
                                                   const std::function<void(const std::string& why)>& full) {
  for (int attempt = 0;; ++attempt) {
    auto response = Ask(&Stub::AddToBatch, request);
    if (response.ok()) return std::move(*response->mutable_batch());
    // What is too large for a message will be so for ever.
    const bool too_large = absl::StrContains(response.status().message(), "larger than max");
    if (!absl::IsResourceExhausted(response.status()) || too_large) return response.status();
    full(std::string(response.status().message()));
    if (WaitUnlessStopped(stop_, PauseBefore(attempt))) return absl::CancelledError("interrupted");
  }
}

absl::StatusOr<v1::Batch> BatchSession::GetBatch(const std::string& id) { return AskOfBatch(&Stub::GetBatch, id); }
absl::StatusOr<v1::Batch> BatchSession::PauseBatch(const std::string& id) { return AskOfBatch(&Stub::PauseBatch, id); }
absl::StatusOr<v1::Batch> BatchSession::ResumeBatch(const std::string& id) {
  return AskOfBatch(&Stub::ResumeBatch, id);
}
absl::StatusOr<v1::Batch> BatchSession::CancelBatch(const std::string& id) {
  return AskOfBatch(&Stub::CancelBatch, id);
}

absl::StatusOr<v1::DeleteBatchResponse> BatchSession::DeleteBatch(const std::string& id) {
  v1::DeleteBatchRequest request;
  request.set_batch_id(id);
  return Ask(&Stub::DeleteBatch, request);
}

absl::StatusOr<std::vector<v1::Batch>> BatchSession::ListBatches(int count) {
  std::vector<v1::Batch> batches;
  v1::ListBatchesRequest request;
  do {
    request.set_page_size(std::min(1000, count - static_cast<int>(batches.size())));
    ASSIGN_OR_RETURN(auto response, Ask(&Stub::ListBatches, request));
    batches.insert(batches.end(), response.batches().begin(), response.batches().end());
    request.set_page_token(response.next_page_token());
  } while (!request.page_token().empty() && static_cast<int>(batches.size()) < count);
  return batches;
}

absl::StatusOr<v1::RetryBatchResponse> BatchSession::RetryBatch(const v1::RetryBatchRequest& request) {
  return Ask(&Stub::RetryBatch, request);
}

absl::StatusOr<v1::GetClusterResponse> BatchSession::GetCluster() {
  return Ask(&Stub::GetCluster, v1::GetClusterRequest());
}

absl::StatusOr<v1::Artifact> BatchSession::GetArtifact(const std::string& id) {
  v1::GetArtifactRequest request;
  request.set_artifact_id(id);
  ASSIGN_OR_RETURN(auto response, Ask(&Stub::GetArtifact, request));
  return std::move(*response.mutable_artifact());
}

absl::Status BatchSession::WatchBatch(const std::string& id, int64_t after_sequence, runtime::Cancellation& enough,
                                      const std::function<bool(const v1::WatchBatchResponse&)>& see) {
  v1::WatchBatchRequest request;
  request.set_batch_id(id);
  request.set_after_sequence(after_sequence);
  absl::Time silent_since = absl::InfiniteFuture();
  for (int attempt = 0;; ++attempt) {
    grpc::ClientContext context;
    const runtime::OnCancel cancel(stop_, [&context] { context.TryCancel(); });
    const runtime::OnCancel end(enough, [&context] { context.TryCancel(); });
    const auto reader = stub_->WatchBatch(&context, request);
    v1::WatchBatchResponse response;
    while (reader->Read(&response)) {
      answered_ = true;
      attempt = 0;
      silent_since = absl::InfiniteFuture();
      request.set_after_sequence(response.sequence());
      if (see(response)) continue;
      context.TryCancel();
      (void)reader->Finish();
      return absl::OkStatus();
    }
    const absl::Status status = runtime::FromGrpcStatus(reader->Finish());
    if (status.ok() || enough.cancelled()) return absl::OkStatus();
    if (silent_since == absl::InfiniteFuture()) silent_since = absl::Now();
    if (!TryAgain(status, absl::IsResourceExhausted(status), silent_since, attempt)) return Explain(status);
  }
}

}  // namespace flair::cli
