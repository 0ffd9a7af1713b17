// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent and received over HTTP.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"

namespace flair::llm {

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
  // From Send to the last byte.
  absl::Duration total = absl::Seconds(300);
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

}  // namespace flair::llm
