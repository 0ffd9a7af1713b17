// SPDX-License-Identifier: GPL-3.0-or-later
// What a sheet of several plans shows, free of messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/renderer_service.pb.h"
#include "renderer_worker/drawing/plan.h"

namespace flair::renderer {

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

}  // namespace flair::renderer
