// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/calls.h"

#include <grpc/support/time.h>

#include <utility>

#include "worker_runtime/grpc/client_call.h"

namespace flair::studio {
namespace {

gpr_timespec DeadlineOf(absl::Duration timeout) {
  return gpr_time_add(gpr_now(GPR_CLOCK_MONOTONIC),
                      gpr_time_from_millis(absl::ToInt64Milliseconds(timeout), GPR_TIMESPAN));
}

}  // namespace

std::shared_ptr<UnaryCall> UnaryCall::Start(const Method& method, grpc::ByteBuffer request, absl::Duration timeout,
                                            Done done) {
  std::shared_ptr<UnaryCall> call(new UnaryCall);
  call->request_ = std::move(request);
  call->context_.set_deadline(DeadlineOf(timeout));
  method.stub->UnaryCall(&call->context_, method.path, {}, &call->request_, &call->response_,
                         [call, done = std::move(done)](const grpc::Status& status) {
                           if (!status.ok()) return done(runtime::FromGrpcStatus(status));
                           done(std::move(call->response_));
                         });
  return call;
}

std::shared_ptr<StreamCall> StreamCall::Start(const Method& method, grpc::ByteBuffer request,
                                              std::optional<absl::Duration> timeout, Message message, End end) {
  std::shared_ptr<StreamCall> call(new StreamCall(std::move(message), std::move(end)));
  call->self_ = call;
  call->request_ = std::move(request);
  if (timeout.has_value()) call->context_.set_deadline(DeadlineOf(*timeout));
  method.stub->PrepareBidiStreamingCall(&call->context_, method.path, {}, call.get());
  // Reads are started from elsewhere too; until none comes any more.
  call->AddHold();
  call->StartWriteLast(&call->request_, {});
  call->StartCall();
  return call;
}

void StreamCall::Next() {
  {
    const std::lock_guard lock(mutex_);
    if (reading_ || read_all_) return;
    reading_ = true;
  }
  StartRead(&read_);
}

void StreamCall::Cancel() {
  {
    const std::lock_guard lock(mutex_);
    cancelled_ = true;
  }
  context_.TryCancel();
  // The end is told only when there is nothing left to read.
  Next();
}

void StreamCall::OnReadDone(bool ok) {
  bool cancelled = false;
  {
    const std::lock_guard lock(mutex_);
    cancelled = cancelled_;
    // Cancelled between two messages, it goes on reading to the end.
    reading_ = ok && cancelled;
    read_all_ = !ok;
  }
  if (!ok) return RemoveHold();
  if (cancelled) return StartRead(&read_);
  on_message_(std::exchange(read_, grpc::ByteBuffer()));
}

void StreamCall::OnDone(const grpc::Status& status) {
  const std::shared_ptr<StreamCall> self = std::exchange(self_, nullptr);
  on_end_(runtime::FromGrpcStatus(status));
}

}  // namespace flair::studio
