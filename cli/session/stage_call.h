// SPDX-License-Identifier: GPL-3.0-or-later
// Single stages, each run from its input artifact: in this process, or at an address.
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::cli {

// `address` empty: a worker in this process.
absl::StatusOr<v1::SolveResponse> CallSolve(const v1::SolveRequest& request, const std::string& address);
absl::StatusOr<v1::ResolveResponse> CallResolve(const v1::ResolveRequest& request, const std::string& address);

}  // namespace flair::cli
