// SPDX-License-Identifier: GPL-3.0-or-later
// Documents with all that they need: what flair studio and flair mcp have in common.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/input/service_flags.h"
#include "session/documents/documents.h"

namespace flair::cli {

class EmbeddedServices;
class Session;

// Whose services documents use.
struct DocumentFlags : Options {
  explicit DocumentFlags(CLI::App& command);
  std::string& orchestrator =
      Text("--orchestrator HOST:PORT", "Use the services of this orchestrator instead of the built-in ones");
  StageFlags stages{command()};
  LlmFlags llm{command()};
};

class OpenDocuments {
 public:
  // Over the orchestrator of the flags, which passes calls on to its workers, or, when there is none, over the services
  // of this process, with stages that run elsewhere and own ones. In the local store, so that every program sees the
  // same ones. Errors as CheckStageFlags, ReadDesignModel, Session::Open, EmbeddedServices::Start and
  // session::Documents::Open.
  static absl::StatusOr<std::unique_ptr<OpenDocuments>> Open(const DocumentFlags& flags);
  ~OpenDocuments();

  session::Documents& documents() { return *documents_; }
  const std::shared_ptr<grpc::Channel>& orchestrator() const { return channels_.orchestrator; }
  // Where they are kept.
  const std::string& folder() const { return folder_; }

 private:
  OpenDocuments(const OptionalLlm& llm, const StageChoice& stages);
  absl::StatusOr<session::Channels> StartServices(const OptionalLlm& llm);
  absl::StatusOr<session::Channels> ChooseModel(const v1::ModelChoice& choice);

  const OptionalLlm first_llm_;
  const StageChoice stages_;
  std::mutex mutex_;
  // Destroyed from the last to the first. Services that asked an earlier model go on with their jobs.
  std::vector<std::unique_ptr<EmbeddedServices>> embedded_;
  std::unique_ptr<Session> session_;
  session::Channels channels_;
  std::string folder_;
  std::unique_ptr<session::Documents> documents_;
};

// A descriptor that can be read once the process has been asked to end by ^C, SIGTERM or SIGHUP; from the first call on
// these do nothing else.
absl::StatusOr<int> StopDescriptor();

}  // namespace flair::cli
