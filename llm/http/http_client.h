// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::llm {

// What is sent and received over HTTP.

// A name and a value; the value may be a secret.
struct HttpHeader {
  std::string name;
  std::string value;
};

// A POST.
struct HttpRequest {
  // "http://..." or "https://...".
  std::string url;
  std::vector<HttpHeader> headers = {};
  std::string body = {};
};

struct HttpResponse {
  int status = 0;
  // Names in lower case, in the order received.
  std::vector<HttpHeader> headers;
  // Decompressed. Of an answer other than 2xx the first 64 KiB.
  std::string body;

  // Value of the first header of that name (in lower case); empty when there is none.
  std::string_view header(std::string_view name) const;
};

// All positive.
struct HttpTimeouts {
  // To connect, proxy and TLS included.
  absl::Duration connect = absl::Seconds(10);
  // Longest silence of the server: from the request to the first byte, and from one byte to the next.
  absl::Duration first_byte = absl::Seconds(120);
  // From Send to the last byte: less than half a stage's deadline (PipelineOptions).
  absl::Duration total = absl::Seconds(280);
};

// How requests to one server are made.
struct HttpOptions {
  HttpTimeouts timeouts = {};
  // PEM file of the certificates to trust; the system's when empty.
  std::string ca_path = {};
  // Such as "http://proxy:3128"; that of the environment (https_proxy, no_proxy ...) when empty. May hold a password.
  std::string proxy = {};
  // Longest body of a 2xx answer after decompression, bytes.
  int64_t body_byte_limit = 16 << 20;
};

// The address without user, password, query and fragment: what errors and names may show.
std::string PublicAddress(std::string_view url);

// OK, or INVALID_ARGUMENT when the header cannot be sent. Never shows its value.
absl::Status CheckHeader(const HttpHeader& header);

// OK, or INVALID_ARGUMENT when the address is no http(s) address, or a header cannot be sent. Never shows a value.
absl::Status CheckRequest(const HttpRequest& request);

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
