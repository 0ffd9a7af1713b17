// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/canvas.h"
#include "renderer_worker/drawing/draw_plan.h"
#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/drawing/sheet.h"

namespace flair::renderer {

// What a sheet of several plans shows, free of messages.

enum class ChangeKind { kMoved, kResized, kAdded, kRemoved };

// An object that is not what or where it was, with what is drawn of it: nothing when its layer is not, nor where it was
// in a room of another size.
struct PlanChange {
  ChangeKind kind = ChangeKind::kMoved;
  int number = 0;  // on the sheet, from 1
  std::string name;
  std::string words;
  std::optional<PlanObject> before = {};
  std::optional<PlanObject> after = {};
};

// One plan of the sheet.
struct ComparisonPanel {
  Plan plan;
  std::string caption;
  std::string remark;
  std::vector<PlanChange> changes;  // to marks in this plan
  std::vector<PlanChange> removed;  // of the first panel: what is not there any more in another one
};

struct Comparison {
  std::string title;
  std::vector<ComparisonPanel> panels = {};
  int change_count = 0;
};

// Reads a valid request with layouts beside its own. Errors as ReadPlan; INVALID_ARGUMENT for changes of objects that
// do not exist.
absl::StatusOr<Comparison> ReadComparison(const v1::RenderRequest& request);

// Plans of several layouts on one sheet, at one scale, with what became of each object. Pure: the same request gives
// the same bytes. Thread-safe. Errors as draw_plan.h; those of other layouts begin with "beside[i].".

// Where everything lies on the paper, in S.
struct ComparisonSheet {
  Sheet paper;                // its plan_mm is where the panels are
  std::vector<Sheet> panels;  // one each, all of one scale; side_mm is where the caption goes
  Box list_mm;                // of changes; without height when there are none
  Box foot_mm;                // scale and signs
};

// The way up and the rows of panels with which all plans are drawn largest, at the given or else at the largest common
// scale. INVALID_ARGUMENT when they fit at none.
absl::StatusOr<ComparisonSheet> ArrangeComparison(const Comparison& comparison, const v1::RenderOptions& options);

// As DrawPlan; `labels` stays empty.
absl::StatusOr<DrawnPlan> DrawComparison(const v1::RenderRequest& request);

// As DrawPlanDocument.
absl::StatusOr<std::string> DrawComparisonDocument(const v1::RenderRequest& request, const DrawingMetadata& metadata);

Rgb ColourOf(ChangeKind kind);

// Marks the panel's changes in its plan: outlines of what stands there now, dashed ones of where and how large it was,
// arrows between them. Numbers are drawn with the names.
void DrawMarks(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet);

// A small picture of the mark, for the legend.
void DrawMarkSign(Canvas& canvas, ChangeKind kind, const Box& box);

// The numbers of changes, each at its object, and the names of other things where there is room in them.
void DrawNames(Canvas& canvas, const ComparisonPanel& panel, const Sheet& sheet);

// The number of a change as it stands in the plan and in the list.
void DrawChangeNumber(Canvas& canvas, const PlanChange& change, Point centre_mm);

}  // namespace flair::renderer
