// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/access/caller.h"

#include <fmt/format.h>

namespace flair::orchestrator {

absl::Status Caller::CheckOpenJobs(int64_t open, int64_t more) const {
  if (open_job_limit == 0 || open + more <= open_job_limit) return absl::OkStatus();
  return absl::ResourceExhaustedError(
      fmt::format("{} of your jobs wait or run, {} more would be over the limit of {} for \"{}\"; try again later",
                  open, more, open_job_limit, name));
}

absl::Status Caller::CheckOperator(std::string_view what) const {
  if (sees_all) return absl::OkStatus();
  return absl::PermissionDeniedError(fmt::format("{}: only for operators, which \"{}\" is not", what, name));
}

}  // namespace flair::orchestrator
