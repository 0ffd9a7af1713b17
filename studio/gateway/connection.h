// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <memory>
#include <optional>
#include <string>

#include "studio/gateway/admission.h"
#include "studio/gateway/browser_socket.h"
#include "studio/gateway/byte_budget.h"
#include "studio/gateway/calls.h"
#include "studio/gateway/method_table.h"
#include "studio/gateway/site.h"

namespace flair::studio {

// What all connections of a gateway share; outlives them.
struct Shared {
  GatewayLimits limits;
  Site site;
  MethodTable methods;
  std::unique_ptr<Admission> admission;
  // nullptr: plain HTTP.
  std::unique_ptr<boost::asio::ssl::context> tls;
  ByteBudget budget;
  std::atomic<int> streams = 0;
};

// A browser's connection: one request and its answer after the other. Its socket has a strand, on which everything of
// it runs; calls tell it there. A read is always under way, also during a call, which ends when the browser has gone.
// Lives as long as anything of it is under way.
class Connection final : public std::enable_shared_from_this<Connection> {
 public:
  Connection(boost::asio::ip::tcp::socket socket, Shared& shared);

  // Reads the first request, after the handshake of TLS.
  void Start();
  // From any thread: ends a stream with UNAVAILABLE; otherwise ends after the answer that is awaited, or at once.
  void Stop();
  // From any thread: ends at once.
  void Abort();

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;
  using Error = boost::system::error_code;

  // Requests (connection.cc).
  void AwaitRequest(absl::Duration patience);
  void Watch();
  void WatchCall();
  void ReadHead();
  void OnHead(Error error);
  std::optional<Reply> AnswerWithoutBody();
  std::optional<Reply> CheckCall();
  void ReadBody();
  void Send(Reply reply);
  void OnSent(bool close);
  void Linger();
  void SetDeadline(absl::Duration patience);
  void Close();

  // Calls (connection_calls.cc).
  void CallMethod();
  void CallUnary(grpc::ByteBuffer request, absl::Duration timeout);
  void OnUnaryDone(absl::StatusOr<grpc::ByteBuffer> response);
  void CallStream(grpc::ByteBuffer request, std::optional<absl::Duration> timeout);
  void OnStreamMessage(grpc::ByteBuffer message);
  void EndStream(const absl::Status& status);
  void SendChunk(std::string_view envelope);
  void OnChunkSent(bool last);
  void CancelCall();

  enum class State { kIdle, kReading, kUnary, kStream, kSending, kLingering, kClosed };

  BrowserSocket socket_;
  boost::asio::steady_timer deadline_;
  Shared& shared_;
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;
  State state_ = State::kIdle;
  bool watching_ = false;
  bool stopping_ = false;
  // The answer came before the whole request, or what was sent after it was thrown away.
  bool unread_ = false;

  const Method* method_ = nullptr;
  // Of the request and of the answer.
  ByteBudget::Held held_request_;
  ByteBudget::Held held_answer_;
  std::shared_ptr<UnaryCall> unary_;
  std::shared_ptr<StreamCall> stream_;
  // Of what is being sent.
  Reply reply_;
  std::string head_;
  std::string chunk_;
  bool sending_chunk_ = false;
  // The last envelope waits for the chunk that is being sent; then there is nothing after it.
  std::optional<std::string> stream_end_;
};

}  // namespace flair::studio
