// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace flair::orchestrator {

// Who makes a call, and what they may do. As made: anybody, on a server without tokens, who may do everything.
struct Caller {
  // What their jobs and batches are kept under (Job.owner); empty on a server without tokens.
  std::string name;
  // Sees and does everything, whoever owns it.
  bool sees_all = true;
  // Jobs that may wait or run at once; no limit of their own when 0.
  int64_t open_job_limit = 0;

  // Whether something of `owner` is there for them. What is not is NOT_FOUND, in the words for what does not exist.
  bool MaySee(std::string_view owner) const { return sees_all || owner == name; }

  // For ListFilter.owner.
  std::optional<std::string> OwnerFilter() const { return sees_all ? std::nullopt : std::optional(name); }

  // What their request id is known by to the queue: two callers may use the same one and do not meet.
  std::string RequestKey(const std::string& request_id) const {
    return name.empty() ? request_id : name + "/" + request_id;
  }

  // OK when `more` jobs may be added to `open` ones of theirs (WorkQueue::CountOpen), else RESOURCE_EXHAUSTED.
  absl::Status CheckOpenJobs(int64_t open, int64_t more) const;

  // OK for those who see everything, else PERMISSION_DENIED, naming `what`, such as "GetCluster".
  absl::Status CheckOperator(std::string_view what) const;
};

}  // namespace flair::orchestrator
