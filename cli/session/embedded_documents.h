// SPDX-License-Identifier: GPL-3.0-or-later
// Documents over the services of this process: what flair studio and flair mcp have in common.
#pragma once

#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "cli/embedded/embedded_services.h"
#include "cli/input/service_flags.h"
#include "session/documents.h"

namespace flair::cli {

class EmbeddedDocuments {
 public:
  // In the local store, so that every program sees the same ones. Errors as EmbeddedServices::Start.
  static absl::StatusOr<std::unique_ptr<EmbeddedDocuments>> Open(const OptionalLlm& llm, const StageChoice& stages);

  EmbeddedServices& services() { return *services_; }
  session::Documents& documents() { return *documents_; }
  // Where they are kept.
  const std::string& folder() const { return folder_; }

 private:
  EmbeddedDocuments() = default;

  std::string folder_;
  // Documents go before the services that they call.
  std::unique_ptr<EmbeddedServices> services_;
  std::unique_ptr<session::Documents> documents_;
};

// A descriptor that can be read once the process has been asked to end by ^C, SIGTERM or SIGHUP; from the first call on
// these do nothing else.
absl::StatusOr<int> StopDescriptor();

}  // namespace flair::cli
