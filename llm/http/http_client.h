// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "llm/http/http_request.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

// Sends requests to one server and waits for the answers; connections are kept and used again. Thread-safe: each thread
// that sends has a connection of its own.
class HttpClient {
 public:
  // `clock` is that of the calls' deadlines and outlives this.
  explicit HttpClient(HttpOptions options, const runtime::Clock& clock = runtime::SystemClock());
  ~HttpClient();

  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  // Cancelling the call, or its deadline, ends the wait at once and closes the connection. Redirects are not followed:
  // whatever status the server sends is the response. A connection that was kept from an earlier request and turns out
  // to be closed is replaced.
  //
  // Errors: UNAVAILABLE for a server that cannot be reached, a broken connection, and the timeouts; DEADLINE_EXCEEDED
  // and CANCELLED as the call's; INVALID_ARGUMENT for an address or header that cannot be sent; FAILED_PRECONDITION for
  // a certificate that is not trusted; DATA_LOSS for what is not HTTP, cannot be decompressed or is too long. No error
  // holds a header's value, a body, or the secret parts of an address.
  absl::StatusOr<HttpResponse> Send(const HttpRequest& request, runtime::CallContext& call);

 private:
  // A libcurl multi handle, which holds the connections that it opened.
  class Connections;

  std::unique_ptr<Connections> Borrow();
  void GiveBack(std::unique_ptr<Connections> connections);

  const HttpOptions options_;
  const runtime::Clock& clock_;
  std::mutex mutex_;
  // Those that no request uses, the last used at the end.
  std::vector<std::unique_ptr<Connections>> idle_;
};

}  // namespace flair::llm
