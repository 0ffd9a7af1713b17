// SPDX-License-Identifier: GPL-3.0-or-later
// Servers of the chat protocol in processes of their own, so that what a benchmark measures of its process is the
// client alone.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "llm/client/chat.h"
#include "llm/http/http_request.h"
#include "llm/openai/openai_options.h"
#include "tests/fixtures/llm_server/scripted_server.h"
#include "tests/fixtures/programs.h"

namespace flair::testing {

// A scripted server in a process of its own, which ends with this one.
class LlmServerProcess {
 public:
  // `gate_count`: open the script's gate "all came" when told by OpenGate(), after so many requests came; 0 for none.
  LlmServerProcess(const Script& script, std::optional<TestCertificate> certificate, int gate_count);
  ~LlmServerProcess();

  int port() const { return port_; }
  // "https://127.0.0.1:PORT/v1", or http.
  const std::string& base_url() const { return base_url_; }
  void WaitForAll() const;
  void OpenGate() const;

 private:
  void Read(void* data, size_t size) const;

  int read_fd_ = -1;
  int write_fd_ = -1;
  int port_ = 0;
  std::string base_url_;
};

// nghttpx (Debian's nghttp2-proxy) before such a server: HTTP/2 over TLS.
class Http2Proxy {
 public:
  // Null when the program is not installed.
  static std::unique_ptr<Http2Proxy> Start(const LlmServerProcess& server, const TestCertificate& certificate);
  ~Http2Proxy();

  const std::string& base_url() const { return base_url_; }

 private:
  Http2Proxy() = default;

  std::string folder_;
  std::string base_url_;
  std::unique_ptr<Process> process_;
};

// About as long as the longest step of a room: 5,000 tokens of question, 1,000 of answer, a token a piece.
std::string LongText(size_t byte_count);
Script LongAnswers();
llm::ChatRequest LongQuestion();

llm::OpenAiOptions OptionsFor(const std::string& base_url, bool stream);
// Options that trust the certificate, which is written to a file; with them goes the file.
class Trust {
 public:
  explicit Trust(const std::optional<TestCertificate>& certificate);
  ~Trust();
  const llm::HttpOptions& options() const { return options_; }

 private:
  llm::HttpOptions options_;
};

// "VmRSS", "VmHWM" (in MB) or "Threads" of this process.
double OwnStatus(const std::string& field);

}  // namespace flair::testing
