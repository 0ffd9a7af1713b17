// SPDX-License-Identifier: GPL-3.0-or-later
// For the tests of this folder: a client of a scripted server.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "llm/http/http_client.h"
#include "tests/fixtures/llm_server/scripted_server.h"

namespace flair::llm {

inline constexpr char kQuestion[] = R"({"model":"m","messages":[{"role":"user","content":"Where does the bed go?"}]})";

// A script of one exchange, which serves all requests.
inline flair::testing::Script One(const std::string& exchange) {
  return flair::testing::ReadScript(R"({"repeat_last": true, "exchanges": [)" + exchange + "]}");
}

inline HttpRequest Question(const std::string& address) {
  return {.url = address + "/v1/chat/completions",
          .headers = {{"Content-Type", "application/json"}, {"Authorization", "Bearer secret-key"}},
          .body = kQuestion};
}

class HttpClientTest : public ::testing::Test {
 protected:
  ~HttpClientTest() override { unlink(ca_path_.c_str()); }

  absl::StatusOr<HttpResponse> Ask(const std::string& address, const HttpOptions& options = {}) {
    HttpClient client(options);
    return client.Send(Question(address), call_);
  }

  // What a client with these timeouts makes of it.
  absl::StatusOr<HttpResponse> AskWithin(const std::string& address, HttpTimeouts timeouts) {
    return Ask(address, {.timeouts = timeouts});
  }

  HttpOptions Trusting(const flair::testing::TestCertificate& certificate) {
    std::ofstream(ca_path_) << certificate.certificate_pem;
    HttpOptions options;
    options.ca_path = ca_path_;
    return options;
  }

  const std::string ca_path_ = ::testing::TempDir() + "flair_http_ca_" + std::to_string(getpid()) + ".pem";
  runtime::CallContext call_;
};

}  // namespace flair::llm
