// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/draw_plan.h"

namespace flair::renderer {

// Plans of several layouts on one sheet, at one scale, with what became of each object. Pure: the same request gives
// the same bytes. Thread-safe. Errors as draw_plan.h; those of other layouts begin with "beside[i].".

// As DrawPlan; `labels` stays empty.
absl::StatusOr<DrawnPlan> DrawComparison(const v1::RenderRequest& request);

// As DrawPlanDocument.
absl::StatusOr<std::string> DrawComparisonDocument(const v1::RenderRequest& request, const DrawingMetadata& metadata);

}  // namespace flair::renderer
