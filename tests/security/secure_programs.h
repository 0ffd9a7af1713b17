// SPDX-License-Identifier: GPL-3.0-or-later
// Flair's programs as somebody runs them whom others must not get at: mutual TLS among them, tokens at the
// orchestrator.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/fixtures/certificates.h"
#include "tests/fixtures/programs.h"
#include "worker_runtime/grpc/channel.h"

namespace flair::testing {

// "tokens { ... }" of a caller whose token is TOKEN.
std::string TokenEntry(const std::string& name, const std::string& token, const std::string& more = "");

// An optimizer that takes calls only of those whom its authority knows.
class SecureOptimizer {
 public:
  // `more` goes into its runtime.
  explicit SecureOptimizer(const std::string& more = "");

  const std::string& address() const { return program_.address(); }
  Process& process() { return program_.process(); }
  const std::filesystem::path& folder() const { return folder_.path(); }
  const CertificateAuthority& authority() const { return authority_; }
  // A caller as it should be.
  runtime::ChannelOptions Friend() const;

 private:
  TestFolder folder_;
  CertificateAuthority authority_;
  Identity identity_;
  Identity friend_;
  ServerProgram program_;
};

// All five. Callers of the orchestrator need a token, no certificate.
class SecurePrograms {
 public:
  // `tokens`: entries of the file.
  explicit SecurePrograms(const std::string& tokens, const std::string& log_level = "error");

  const std::string& orchestrator() const { return orchestrator_->address(); }
  const std::filesystem::path& folder() const { return folder_.path(); }
  std::string tokens_path() const { return folder_ / "tokens.textproto"; }
  const CertificateAuthority& authority() const { return authority_; }
  // One who calls the orchestrator with that token; with none when empty.
  runtime::ChannelOptions With(const std::string& token) const;
  // Flags of `flair` for the same.
  std::vector<std::string> Flags(const std::string& token_file) const;
  // All of them.
  std::vector<ServerProgram*> programs();

 private:
  TestFolder folder_;
  CertificateAuthority authority_;
  std::vector<std::unique_ptr<ServerProgram>> stages_;
  std::unique_ptr<ServerProgram> orchestrator_;
};

// Whether the server at `address` answers somebody who calls like that: OK, or why not. Patient.
absl::Status AskWho(const std::string& address, const runtime::ChannelOptions& options);

// Most memory that a process has had, MiB.
int PeakMib(const Process& process);

}  // namespace flair::testing
