// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/connection.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/dispatch.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/http/read.hpp>
#include <chrono>
#include <utility>

#include "studio/gateway/connect_protocol.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

namespace asio = boost::asio;
namespace http = boost::beast::http;

// Read at a time, of bodies.
constexpr size_t kReadBytes = 64 * 1024;
// What a refused browser may still send before the connection is cut, so that it reads why.
constexpr absl::Duration kLinger = absl::Seconds(2);

// Errors of what was sent, not of the connection.
std::optional<Reply> ReplyTo(const boost::system::error_code& error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow) {
    return TextReply(431, "The headers are too long.\n");
  }
  if (error == http::error::body_limit) {
    return ErrorReply(413, absl::ResourceExhaustedError("the request is too large"));
  }
  const bool of_http = error.category() == http::make_error_code(http::error::bad_method).category();
  if (!of_http || error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
  return TextReply(400, "This is no HTTP/1.1.\n");
}

}  // namespace

Connection::Connection(asio::ip::tcp::socket socket, Shared& shared)
    : socket_(std::move(socket), shared.tls.get()),
      deadline_(socket_.get_executor()),
      shared_(shared),
      buffer_(shared.limits.header_bytes + kReadBytes) {
  Error ignored;
  socket_.socket().set_option(asio::ip::tcp::no_delay(true), ignored);
}

void Connection::Start() {
  asio::dispatch(socket_.get_executor(), [self = shared_from_this()] {
    if (!self->socket_.has_tls()) return self->AwaitRequest(self->shared_.limits.header_timeout);
    self->SetDeadline(self->shared_.limits.header_timeout);
    self->socket_.AsyncHandshake([self](Error error) {
      if (error || self->state_ == State::kClosed) return self->Close();
      self->AwaitRequest(self->shared_.limits.header_timeout);
    });
  });
}

void Connection::Stop() {
  asio::post(socket_.get_executor(), [self = shared_from_this()] {
    self->stopping_ = true;
    if (self->state_ == State::kStream) self->EndStream(absl::UnavailableError("the studio is stopping"));
    if (self->state_ == State::kIdle || self->state_ == State::kReading || self->state_ == State::kLingering) {
      self->Close();
    }
  });
}

void Connection::Abort() {
  asio::post(socket_.get_executor(), [self = shared_from_this()] { self->Close(); });
}

void Connection::AwaitRequest(absl::Duration patience) {
  held_request_ = {};
  held_answer_ = {};
  if (stopping_) return Close();
  state_ = State::kIdle;
  SetDeadline(patience);
  if (watching_) return;
  if (buffer_.size() > 0) return ReadHead();
  Watch();
}

// Waits for the next request, and for the end of the browser while a call is under way.
void Connection::Watch() {
  watching_ = true;
  socket_.async_read_some(buffer_.prepare(shared_.limits.header_bytes),
                          [self = shared_from_this()](Error error, size_t size) {
                            self->watching_ = false;
                            if (error) return self->Close();
                            if (self->state_ == State::kLingering) return self->Watch();
                            self->buffer_.commit(size);
                            if (self->state_ == State::kIdle) return self->ReadHead();
                            if (self->state_ == State::kUnary || self->state_ == State::kStream) self->WatchCall();
                          });
}

// Requests that are sent before the answer are thrown away, because behind them the end of the browser could not be
// seen; the answer is the last one of its connection then. Browsers send none.
void Connection::WatchCall() {
  const bool is_last_chunk = state_ == State::kStream && stream_end_.has_value();
  if (is_last_chunk && buffer_.size() > 0) return;
  if (buffer_.size() > 0) unread_ = true;
  buffer_.clear();
  Watch();
}

void Connection::ReadHead() {
  state_ = State::kReading;
  SetDeadline(shared_.limits.header_timeout);
  parser_.emplace();
  parser_->header_limit(shared_.limits.header_bytes);
  parser_->body_limit(static_cast<uint64_t>(shared_.limits.upload_bytes));
  http::async_read_header(socket_, buffer_, *parser_,
                          [self = shared_from_this()](Error error, size_t) { self->OnHead(error); });
}

void Connection::OnHead(Error error) {
  if (state_ == State::kClosed) return;
  std::optional<Reply> reply;
  if (error) {
    reply = ReplyTo(error);
    if (!reply.has_value()) return Close();
    unread_ = true;
  } else {
    reply = AnswerWithoutBody();
    if (!reply.has_value()) return ReadBody();
    // What follows could be the body of what was refused.
    if (!parser_->is_done()) unread_ = true;
    reply->head_only = parser_->get().method() == http::verb::head;
  }
  Send(*std::move(reply));
}

// Nothing for a call, whose body is wanted.
std::optional<Reply> Connection::AnswerWithoutBody() {
  const auto& head = parser_->get().base();
  if (head.version() != 11) return TextReply(505, "The studio speaks HTTP/1.1.\n");
  if (std::optional<Reply> reply = shared_.admission->Answer(head); reply.has_value()) return reply;
  if (head.method() == http::verb::post) return CheckCall();
  if (head.method() != http::verb::get && head.method() != http::verb::head) {
    Reply reply = TextReply(405, "Only GET, HEAD and POST.\n");
    reply.headers.emplace_back("Allow", "GET, HEAD, POST");
    return reply;
  }
  return shared_.site.Get(PathOf(head), HeaderOf(head, "Accept-Encoding"), HeaderOf(head, "If-None-Match"));
}

std::optional<Reply> Connection::CheckCall() {
  const auto& head = parser_->get().base();
  method_ = shared_.methods.Find(PathOf(head));
  if (method_ == nullptr) return ErrorReply(404, absl::UnimplementedError("the studio has no such method"));
  const std::string_view type = method_->streams ? kStreamType : kUnaryType;
  if (!IsContentType(HeaderOf(head, "Content-Type"), type)) {
    return ErrorReply(415, InvalidArgument("{} takes Content-Type {}", method_->path, type));
  }
  const std::string_view version = HeaderOf(head, "Connect-Protocol-Version");
  if (!version.empty() && version != "1") {
    return ErrorReply(400, InvalidArgument("the studio speaks version 1 of the Connect protocol"));
  }
  const std::string_view encoding = HeaderOf(head, method_->streams ? "Connect-Content-Encoding" : "Content-Encoding");
  if (!encoding.empty() && encoding != "identity") {
    return ErrorReply(Unimplemented("the studio takes messages that are not compressed: identity"));
  }
  if (!parser_->content_length().has_value()) {
    return ErrorReply(411, InvalidArgument("a request needs its Content-Length"));
  }
  const auto length = static_cast<int64_t>(*parser_->content_length());
  if (length > method_->body_limit) {
    return ErrorReply(413, ResourceExhausted("the request has {} bytes, {} takes {} at most", length, method_->path,
                                             method_->body_limit));
  }
  std::optional<ByteBudget::Held> held = shared_.budget.Take(length);
  if (!held.has_value()) {
    return ErrorReply(ResourceExhausted("too many large requests at a time; try again when they are done"));
  }
  held_request_ = *std::move(held);
  return std::nullopt;
}

void Connection::ReadBody() {
  SetDeadline(shared_.limits.body_timeout);
  // curl waits for it before it sends a large body. What the browser does not read fits into the socket.
  if (HeaderOf(parser_->get().base(), "Expect") == "100-continue") {
    constexpr std::string_view kContinue = "HTTP/1.1 100 Continue\r\n\r\n";
    Error ignored;
    socket_.WriteSome(asio::buffer(kContinue), ignored);
  }
  http::async_read(socket_, buffer_, *parser_, [self = shared_from_this()](Error error, size_t) {
    if (self->state_ == State::kClosed) return;
    if (error) return self->Close();
    self->CallMethod();
  });
}

void Connection::Send(Reply reply) {
  state_ = State::kSending;
  SetDeadline(shared_.limits.write_timeout);
  reply_ = std::move(reply);
  if (parser_.has_value() && !parser_->get().keep_alive()) reply_.close = true;
  if (stopping_ || unread_) reply_.close = true;
  head_ = HeadOf(reply_);
  const std::string_view content = reply_.head_only ? std::string_view() : reply_.content();
  const std::array<asio::const_buffer, 2> buffers = {asio::buffer(head_), asio::buffer(content)};
  asio::async_write(socket_, buffers, [self = shared_from_this()](Error error, size_t) {
    if (self->state_ == State::kClosed) return;
    if (error) return self->Close();
    self->OnSent(self->reply_.close);
  });
}

void Connection::OnSent(bool close) {
  reply_ = {};
  parser_.reset();
  if (unread_ && !stopping_) return Linger();
  if (close) return Close();
  AwaitRequest(shared_.limits.idle_timeout);
}

// Closing a socket with bytes that nobody has read resets the connection, and the browser may lose the answer. So the
// rest is read, for a moment.
void Connection::Linger() {
  held_request_ = {};
  held_answer_ = {};
  state_ = State::kLingering;
  Error ignored;
  socket_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
  SetDeadline(kLinger);
  buffer_.clear();
  if (!watching_) Watch();
}

void Connection::SetDeadline(absl::Duration patience) {
  if (patience == absl::InfiniteDuration()) {
    deadline_.expires_at(std::chrono::steady_clock::time_point::max());
    return;
  }
  deadline_.expires_after(absl::ToChronoNanoseconds(patience));
  deadline_.async_wait([self = shared_from_this()](Error error) {
    // A handler that was already on its way when the deadline was moved comes too early.
    if (!error && self->deadline_.expiry() <= std::chrono::steady_clock::now()) self->Close();
  });
}

void Connection::Close() {
  if (state_ == State::kClosed) return;
  state_ = State::kClosed;
  CancelCall();
  deadline_.cancel();
  Error ignored;
  socket_.socket().close(ignored);
}

}  // namespace flair::studio
