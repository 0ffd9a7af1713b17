// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/no_orchestrator.h"

#include "fmt/format.h"

namespace flair::cli {

absl::Status NoOrchestrator(const absl::Status& status, const std::string& address) {
  if (!absl::IsUnavailable(status) && !absl::IsDeadlineExceeded(status)) return status;
  const std::string_view why(status.message().data(), status.message().size());
  return absl::UnavailableError(fmt::format(
      "no orchestrator answers at {}: {}{} Is flair-orchestrator running there? Without --orchestrator, flair "
      "uses this machine alone",
      address, why, why.ends_with('?') ? "" : "."));
}

}  // namespace flair::cli
