// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "evaluation/metrics/layout_view.h"
#include "flair/v1/report.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::evaluation {

// All measures of a layout; see overlap.h and routes.h for what they mean.
v1::LayoutMetrics MeasureLayout(const LayoutView& view);

// The same of a message, which is validated first.
absl::StatusOr<v1::LayoutMetrics> MeasureLayout(const v1::SolvedLayout& layout);

}  // namespace flair::evaluation
