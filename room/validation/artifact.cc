// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/checks.h"

namespace flair::validation {
namespace {

constexpr Range kShare{.least = 0, .most = 1};
constexpr Range kPercent{.least = 0, .most = 1e9};

void CheckContent(const v1::Artifact& artifact, const Field& at) {
  switch (artifact.content_case()) {
    case v1::Artifact::kBrief:
      return Check(artifact.brief(), at["brief"]);
    case v1::Artifact::kRoom:
      return Check(artifact.room(), at["room"]);
    case v1::Artifact::kZonePlan:
      return Check(artifact.zone_plan(), at["zone_plan"]);
    case v1::Artifact::kObjectList:
      return Check(artifact.object_list(), {}, at["object_list"]);
    case v1::Artifact::kStyleSheet:
      return Check(artifact.style_sheet(), {}, at["style_sheet"]);
    case v1::Artifact::kRawConstraintList:
      return Check(artifact.raw_constraint_list(), {}, at["raw_constraint_list"]);
    case v1::Artifact::kConstraintList:
      return Check(artifact.constraint_list(), {}, at["constraint_list"]);
    case v1::Artifact::kLayoutGraph:
      return Check(artifact.layout_graph(), at["layout_graph"]);
    case v1::Artifact::kSolvedLayout:
      return Check(artifact.solved_layout(), at["solved_layout"]);
    case v1::Artifact::kPreview:
      return Check(artifact.preview(), at["preview"]);
    case v1::Artifact::kReport:
      return Check(artifact.report(), at["report"]);
    case v1::Artifact::CONTENT_NOT_SET:
      at["content"].Reject("is not set");
  }
}

}  // namespace

void Check(const v1::Preview& preview, const Field& at) {
  at["view"].Enum(preview.view(), v1::PreviewView_IsValid(preview.view()));
  at["format"].Enum(preview.format(), v1::PreviewFormat_IsValid(preview.format()));
  const bool is_page = preview.format() == v1::PREVIEW_FORMAT_SVG || preview.format() == v1::PREVIEW_FORMAT_PDF;
  const double least = is_page ? 0 : 1;  // pages have no pixels
  at["width_px"].InRange(preview.width_px(), {.least = least, .most = 16384});
  at["height_px"].InRange(preview.height_px(), {.least = least, .most = 16384});
  if (preview.image().empty()) at["image"].Reject("is empty");
  const int matrix_size = preview.annotations().camera().camera_from_room_size();
  if (matrix_size != 0 && matrix_size != 16) {
    at["annotations"]["camera"]["camera_from_room"].Reject("has {} numbers; 16", matrix_size);
  }
}

void Check(const v1::Report& report, const Field& at) {
  const v1::LayoutMetrics& metrics = report.metrics();
  at["metrics"]["oob_percent"].InRange(metrics.oob_percent(), kPercent);
  at["metrics"]["oor_percent"].InRange(metrics.oor_percent(), kPercent);
  at["metrics"]["reachable_floor_share"].InRange(metrics.reachable_floor_share(), kShare);
  at["metrics"]["reachable_front_share"].InRange(metrics.reachable_front_share(), kShare);
  CheckDiagnostics(report.diagnostics(), at["diagnostics"]);
}

void Check(const v1::Artifact& artifact, const Field& at) {
  if (!artifact.id().empty()) at["id"].Digest(artifact.id());
  for (int i = 0; i < artifact.made_from_ids_size(); ++i) at["made_from_ids"][i].Digest(artifact.made_from_ids(i));
  if (!artifact.options_digest().empty()) at["options_digest"].Digest(artifact.options_digest());
  CheckContent(artifact, at);
}

}  // namespace flair::validation
