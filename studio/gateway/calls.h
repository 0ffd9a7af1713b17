// SPDX-License-Identifier: GPL-3.0-or-later
// Calls of methods by their bytes. They keep themselves until gRPC has told their end; what they tell comes on gRPC's
// threads. Cancel may be called at any time, on any thread.
#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/support/byte_buffer.h>
#include <grpcpp/support/client_callback.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "studio/gateway/method_table.h"

namespace flair::studio {

class UnaryCall final : public std::enable_shared_from_this<UnaryCall> {
 public:
  using Done = std::function<void(absl::StatusOr<grpc::ByteBuffer>)>;

  // Tells `done` once.
  static std::shared_ptr<UnaryCall> Start(const Method& method, grpc::ByteBuffer request, absl::Duration timeout,
                                          Done done);
  void Cancel() { context_.TryCancel(); }

 private:
  UnaryCall() = default;

  grpc::ClientContext context_;
  grpc::ByteBuffer request_;
  grpc::ByteBuffer response_;
};

// A call whose server streams. Messages come one at a time, each when it is asked for.
class StreamCall final : public grpc::ClientBidiReactor<grpc::ByteBuffer, grpc::ByteBuffer> {
 public:
  using Message = std::function<void(grpc::ByteBuffer)>;
  using End = std::function<void(absl::Status)>;

  // Without `timeout` it has no deadline. `end` comes once, and last.
  static std::shared_ptr<StreamCall> Start(const Method& method, grpc::ByteBuffer request,
                                           std::optional<absl::Duration> timeout, Message message, End end);
  // Asks for a message: the first, and another after each.
  void Next();
  // No more messages; the end comes.
  void Cancel();

 private:
  StreamCall(Message message, End end) : on_message_(std::move(message)), on_end_(std::move(end)) {}
  void OnReadDone(bool ok) override;
  void OnDone(const grpc::Status& status) override;

  const Message on_message_;
  const End on_end_;
  grpc::ClientContext context_;
  grpc::ByteBuffer request_;
  grpc::ByteBuffer read_;
  std::shared_ptr<StreamCall> self_;

  std::mutex mutex_;
  bool reading_ = false;
  bool cancelled_ = false;
  bool read_all_ = false;
};

}  // namespace flair::studio
