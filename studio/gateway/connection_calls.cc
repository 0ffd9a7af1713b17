// SPDX-License-Identifier: GPL-3.0-or-later
// The calls of a connection.
#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <iterator>
#include <utility>

#include "studio/gateway/connect_protocol.h"
#include "studio/gateway/connection.h"
#include "studio/gateway/json_messages.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

namespace asio = boost::asio;

struct Asked {
  grpc::ByteBuffer message;
  std::optional<absl::Duration> timeout;
};

absl::StatusOr<Asked> Read(const Method& method, std::string_view timeout, std::string_view body) {
  Asked asked;
  if (!timeout.empty()) {
    ASSIGN_OR_RETURN(asked.timeout, ParseTimeout(timeout));
  }
  if (method.streams) {
    ASSIGN_OR_RETURN(body, MessageOf(body));
  }
  ASSIGN_OR_RETURN(asked.message, BytesFromJson(method.request_type, body));
  return asked;
}

}  // namespace

void Connection::CallMethod() {
  auto& request = parser_->get();
  absl::StatusOr<Asked> asked = Read(*method_, HeaderOf(request.base(), "Connect-Timeout-Ms"), request.body());
  std::string().swap(request.body());
  SetDeadline(absl::InfiniteDuration());
  if (method_->streams) {
    state_ = State::kStream;
    head_ = StreamHead(kStreamType);
    WatchCall();
    if (!asked.ok()) return EndStream(asked.status());
    return CallStream(std::move(asked->message), asked->timeout);
  }
  if (!asked.ok()) return Send(ErrorReply(asked.status()));
  state_ = State::kUnary;
  WatchCall();
  CallUnary(std::move(asked->message),
            std::min(asked->timeout.value_or(absl::InfiniteDuration()), shared_.limits.call_timeout));
}

void Connection::CallUnary(grpc::ByteBuffer request, absl::Duration timeout) {
  unary_ = UnaryCall::Start(
      *method_, std::move(request), timeout, [self = shared_from_this()](absl::StatusOr<grpc::ByteBuffer> response) {
        const auto executor = self->socket_.get_executor();
        asio::post(executor,
                   [self, response = std::move(response)]() mutable { self->OnUnaryDone(std::move(response)); });
      });
}

void Connection::OnUnaryDone(absl::StatusOr<grpc::ByteBuffer> response) {
  unary_ = nullptr;
  if (state_ != State::kUnary) return;
  if (!response.ok()) return Send(ErrorReply(response.status()));
  absl::StatusOr<std::string> json = JsonFromBytes(method_->response_type, *response);
  if (!json.ok()) return Send(ErrorReply(json.status()));
  std::optional<ByteBudget::Held> held = shared_.budget.Take(static_cast<int64_t>(json->size()));
  if (!held.has_value()) return Send(ErrorReply(ResourceExhausted("too many large answers at a time; try again")));
  held_answer_ = *std::move(held);
  Send({.headers = {{"Content-Type", std::string(kUnaryType)}, {"Cache-Control", "no-store"}},
        .body = *std::move(json)});
}

void Connection::CallStream(grpc::ByteBuffer request, std::optional<absl::Duration> timeout) {
  if (shared_.streams.fetch_add(1) >= shared_.limits.streams) {
    --shared_.streams;
    return EndStream(ResourceExhausted("too many pages listen at a time; close some"));
  }
  stream_ = StreamCall::Start(
      *method_, std::move(request), timeout,
      [self = shared_from_this()](grpc::ByteBuffer message) {
        asio::post(self->socket_.get_executor(),
                   [self, message = std::move(message)]() mutable { self->OnStreamMessage(std::move(message)); });
      },
      [self = shared_from_this()](const absl::Status& status) {
        asio::post(self->socket_.get_executor(), [self, status] {
          --self->shared_.streams;
          self->stream_ = nullptr;
          if (self->state_ == State::kStream) self->EndStream(status);
        });
      });
  // The browser knows that it is heard before there is a message.
  SendChunk("");
}

void Connection::OnStreamMessage(grpc::ByteBuffer message) {
  if (state_ != State::kStream || stream_end_.has_value()) return;
  absl::StatusOr<std::string> json = JsonFromBytes(method_->response_type, message);
  if (!json.ok()) return EndStream(json.status());
  std::optional<ByteBudget::Held> held = shared_.budget.Take(static_cast<int64_t>(json->size()));
  if (!held.has_value()) return EndStream(ResourceExhausted("too many large answers at a time; try again"));
  held_answer_ = *std::move(held);
  SendChunk(Envelope(*json));
}

// Ends the stream before its time, or when its call has ended.
void Connection::EndStream(const absl::Status& status) {
  if (stream_end_.has_value()) return;
  stream_end_ = EndOfStream(status);
  if (stream_ != nullptr) stream_->Cancel();
  if (!sending_chunk_) SendChunk("");
}

// Sends what there is: the head, if it has not been sent yet, the envelope, and the end.
void Connection::SendChunk(std::string_view envelope) {
  sending_chunk_ = true;
  chunk_ = std::exchange(head_, "");
  const auto add = [this](std::string_view part) {
    fmt::format_to(std::back_inserter(chunk_), "{:x}\r\n{}\r\n", part.size(), part);
  };
  if (!envelope.empty()) add(envelope);
  const bool last = stream_end_.has_value();
  if (last) {
    add(*stream_end_);
    chunk_ += "0\r\n\r\n";
  }
  SetDeadline(shared_.limits.write_timeout);
  asio::async_write(socket_, asio::buffer(chunk_), [self = shared_from_this(), last](Error error, size_t) {
    if (self->state_ == State::kClosed) return;
    if (error) return self->Close();
    self->OnChunkSent(last);
  });
}

void Connection::OnChunkSent(bool last) {
  sending_chunk_ = false;
  std::string().swap(chunk_);
  held_answer_ = {};
  if (last) {
    stream_end_.reset();
    // A call that was ended from here may still tell its end, which must not meet the next.
    return OnSent(stopping_ || stream_ != nullptr || !parser_->get().keep_alive());
  }
  if (stream_end_.has_value()) return SendChunk("");
  SetDeadline(absl::InfiniteDuration());
  if (stream_ != nullptr) stream_->Next();
}

void Connection::CancelCall() {
  if (unary_ != nullptr) unary_->Cancel();
  if (stream_ != nullptr) stream_->Cancel();
}

}  // namespace flair::studio
