// SPDX-License-Identifier: GPL-3.0-or-later
// The account of a layout that somebody else made.
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/optimizer_service.pb.h"
#include "optimizer_worker/solver/solver.h"

namespace flair::optimizer {

// Outcomes and metrics of given placements. INVALID_ARGUMENT names the field.
absl::StatusOr<v1::EvaluateResponse> EvaluateLayout(const v1::EvaluateRequest& request, const Solver& solver);

}  // namespace flair::optimizer
