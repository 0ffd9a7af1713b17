// SPDX-License-Identifier: GPL-3.0-or-later
#include <mutex>
#include <utility>

#include "grpc/health/v1/health.pb.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/grpc/server.h"
#include "worker_runtime/grpc/server_call.h"

namespace flair::runtime {

using grpc::health::v1::HealthCheckRequest;
using grpc::health::v1::HealthCheckResponse;

// Calls keep it, and hold its mutex in all that they do: they may be told of a stop at any time.
struct HealthService::State {
  const std::set<std::string> names;
  std::mutex mutex;
  bool stopped = false;
  std::set<Call*> watchers;
};

class HealthService::Call final : public grpc::ServerBidiReactor<grpc::ByteBuffer, HealthCheckResponse> {
 public:
  Call(std::shared_ptr<State> state, bool watches) : state_(std::move(state)), watches_(watches) {
    StartRead(&message_);
  }

  // What has changed since it was last told. One message at a time is on its way.
  void Tell() {
    const auto status = state_->stopped ? HealthCheckResponse::NOT_SERVING
                        : is_known_     ? HealthCheckResponse::SERVING
                                        : HealthCheckResponse::SERVICE_UNKNOWN;
    if (writes_ || has_ended_ || status == answer_.status()) return;
    answer_.set_status(status);
    writes_ = true;
    StartWrite(&answer_);
  }

 private:
  void OnReadDone(bool ok) override {
    HealthCheckRequest request;
    const std::lock_guard lock(state_->mutex);
    if (!ok) return End(grpc::Status::CANCELLED);
    if (const absl::Status parsed = ParseShortMessage(message_, request); !parsed.ok()) {
      return End(ToGrpcStatus(parsed));
    }
    is_known_ = state_->names.contains(request.service());
    if (!watches_ && !is_known_) return End({grpc::StatusCode::NOT_FOUND, "service name unknown"});
    if (watches_) state_->watchers.insert(this);
    Tell();
  }
  void OnWriteDone(bool ok) override {
    const std::lock_guard lock(state_->mutex);
    writes_ = false;
    if (!ok || !watches_) return End(ok ? grpc::Status::OK : grpc::Status::CANCELLED);
    Tell();
  }
  void OnCancel() override {
    const std::lock_guard lock(state_->mutex);
    End(grpc::Status::CANCELLED);
  }
  void OnDone() override {
    {
      const std::lock_guard lock(state_->mutex);
      state_->watchers.erase(this);
    }
    delete this;
  }
  void End(const grpc::Status& status) {
    if (!std::exchange(has_ended_, true)) Finish(status);
  }

  const std::shared_ptr<State> state_;
  const bool watches_;
  bool is_known_ = false;
  bool writes_ = false;
  bool has_ended_ = false;
  grpc::ByteBuffer message_;
  HealthCheckResponse answer_;
};

HealthService::HealthService(std::set<std::string> names) : state_(new State{.names = std::move(names)}) {
  for (const bool watches : {false, true}) {
    using grpc::internal::RpcMethod;
    AddMethod(new grpc::internal::RpcServiceMethod(
        watches ? "/grpc.health.v1.Health/Watch" : "/grpc.health.v1.Health/Check", RpcMethod::BIDI_STREAMING, nullptr));
    using Handler = grpc::internal::CallbackBidiHandler<grpc::ByteBuffer, HealthCheckResponse>;
    MarkMethodRawCallback(
        watches, new Handler([this, watches](grpc::CallbackServerContext*) { return new Call(state_, watches); }));
  }
}

void HealthService::Stop() {
  const std::lock_guard lock(state_->mutex);
  state_->stopped = true;
  for (Call* watcher : state_->watchers) watcher->Tell();
}

}  // namespace flair::runtime
