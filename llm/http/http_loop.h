// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "llm/http/http_request.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

// One thread that runs any number of HTTP requests and timers; connections are used again. Callbacks run in that
// thread. A process needs one, however many servers it talks to. Thread-safe.
class HttpLoop final : public runtime::Timer {
 public:
  // `clock` is that of the calls' deadlines.
  explicit HttpLoop(const runtime::Clock& clock = runtime::SystemClock());

  // As Stop().
  ~HttpLoop() override;

  HttpLoop(const HttpLoop&) = delete;
  HttpLoop& operator=(const HttpLoop&) = delete;

  Id RunAfter(absl::Duration delay, runtime::TimerCallback callback) override;
  void Hasten(Id id) override;

  // Ends every request and every timer with CANCELLED, and everything that is asked for later; returns when no callback
  // runs any more. Not from within a callback. What the callbacks use may be destroyed after it.
  void Stop();

 private:
  friend class HttpClient;
  class Impl;

  void Start(HttpRequest request, const HttpOptions& options, runtime::CallContext& call, HttpCallback done);

  const runtime::Clock& clock_;
  std::unique_ptr<Impl> impl_;
};

// Sends requests to one server over a loop, which must outlive it. Thread-safe.
class HttpClient {
 public:
  HttpClient(HttpLoop& loop, HttpOptions options);

  // Sends and returns at once. `done` is called exactly once, in the loop's thread or from within this call, and must
  // not block; `call` lives until then. Cancelling the call, or its deadline, closes the connection (over HTTP/2 the
  // stream). Redirects are not followed: whatever status the server sends is the response. A connection that was kept
  // from an earlier request and turns out to be closed is replaced without a word.
  //
  // Errors: UNAVAILABLE for a server that cannot be reached, a broken connection, and the timeouts; DEADLINE_EXCEEDED
  // and CANCELLED as the call's, CANCELLED also when the loop stops; INVALID_ARGUMENT for an address or header that
  // cannot be sent; FAILED_PRECONDITION for a certificate that is not trusted; DATA_LOSS for what is not HTTP, cannot
  // be decompressed or is too long. No error holds a header's value, a body, or the secret parts of an address.
  void Send(HttpRequest request, runtime::CallContext& call, HttpCallback done);

 private:
  HttpLoop& loop_;
  const HttpOptions options_;
};

}  // namespace flair::llm
