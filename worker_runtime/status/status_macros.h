// SPDX-License-Identifier: GPL-3.0-or-later
// Early returns for functions that return absl::Status or absl::StatusOr:
//   RETURN_IF_ERROR(store.Open(path));
//   ASSIGN_OR_RETURN(v1::Job job, store.GetJob(id));   // `auto job` where the type has a comma
// Header only; every folder may include it.
#pragma once

#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"

#define FLAIR_STATUS_JOIN_INNER(a, b) a##b
#define FLAIR_STATUS_JOIN(a, b) FLAIR_STATUS_JOIN_INNER(a, b)

// Returns the status of the expression from the surrounding function unless it is OK.
#define RETURN_IF_ERROR(...)                                                  \
  do {                                                                        \
    if (absl::Status flair_status = (__VA_ARGS__); !flair_status.ok()) {      \
      return flair_status;                                                    \
    }                                                                         \
  } while (false)

// Assigns the value of a StatusOr to `lhs`, a declaration or an existing variable, or returns its status.
#define ASSIGN_OR_RETURN(lhs, ...) \
  FLAIR_ASSIGN_OR_RETURN(FLAIR_STATUS_JOIN(flair_status_or_, __LINE__), lhs, __VA_ARGS__)
#define FLAIR_ASSIGN_OR_RETURN(result, lhs, ...)  \
  auto result = (__VA_ARGS__);                    \
  if (!result.ok()) return result.status();       \
  lhs = *std::move(result)
