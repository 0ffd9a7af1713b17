// SPDX-License-Identifier: GPL-3.0-or-later
// The one place that says whether a message is good. Every Validate returns OK or INVALID_ARGUMENT naming path, value
// and what would be right for the first five bad fields, such as
//   room.openings[2].width_m: 7.2 does not fit wall "north" (4 m from 0.5 m); at most 3.5
// `path` names the message where it is part of another. What is accepted is finite, in range, free of dangling
// references, and safe to compute with.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"

// Declared only: a user includes the messages that it has anyway.
namespace flair::v1 {
class AddToBatchRequest;
class Artifact;
class Brief;
class ChooseStyleRequest;
class CleanConstraintsRequest;
class ComposeContactSheetRequest;
class ConstraintCatalog;
class ConstraintList;
class CreateBatchRequest;
class CreateJobRequest;
class DescribeRoomRequest;
class EvaluateRequest;
class ExportSceneRequest;
class JobSpec;
class LayoutGraph;
class ListConstraintsRequest;
class ListObjectsRequest;
class ObjectList;
class PlanZonesRequest;
class Preview;
class RenderOptions;
class RenderRequest;
class Report;
class Room;
class SolveOptions;
class SolveRequest;
class SolveRestartsRequest;
class SolvedLayout;
class StyleSheet;
class TranslateRequest;
class ZonePlan;
}  // namespace flair::v1

namespace flair {

namespace validation {
// What is wrong with one field.
struct Problem {
  std::string path;  // "layout_graph.edges[3].weight"
  std::string text;  // "0 is outside (0, 100]"
};
}  // namespace validation

absl::Status Validate(const v1::Brief& brief, std::string_view path = "brief");
absl::Status Validate(const v1::Room& room, std::string_view path = "room");
absl::Status Validate(const v1::ZonePlan& plan, std::string_view path = "zone_plan");
absl::Status Validate(const v1::ConstraintCatalog& catalog, std::string_view path = "catalog");
// Complete problems: all references between their parts are followed.
absl::Status Validate(const v1::LayoutGraph& graph, std::string_view path = "layout_graph");
absl::Status Validate(const v1::SolvedLayout& layout, std::string_view path = "solved_layout");
absl::Status Validate(const v1::SolveOptions& options, std::string_view path = "options");
absl::Status Validate(const v1::RenderOptions& options, std::string_view path = "options");
absl::Status Validate(const v1::JobSpec& spec, std::string_view path = "spec");
absl::Status Validate(const v1::Preview& preview, std::string_view path = "preview");
absl::Status Validate(const v1::Report& report, std::string_view path = "report");
// Form and content; not whether the id is the digest of its bytes.
absl::Status Validate(const v1::Artifact& artifact, std::string_view path = "artifact");

// The same field by field, for those who say more than the path: all problems, paths from the message's own fields on.
std::vector<validation::Problem> FindProblems(const v1::Artifact& artifact);
std::vector<validation::Problem> FindProblems(const v1::Brief& brief);
std::vector<validation::Problem> FindProblems(const v1::Room& room);

// Parts that refer to others; without the others (first form) those references are not followed.
absl::Status Validate(const v1::ObjectList& list, std::string_view path = "object_list");
absl::Status Validate(const v1::ObjectList& list, const v1::ZonePlan& plan, std::string_view path = "object_list");
absl::Status Validate(const v1::StyleSheet& sheet, std::string_view path = "style_sheet");
absl::Status Validate(const v1::StyleSheet& sheet, const v1::Room& room, const v1::ObjectList& objects,
                      std::string_view path = "style_sheet");
absl::Status Validate(const v1::ConstraintList& list, std::string_view path = "constraint_list");
absl::Status Validate(const v1::ConstraintList& list, const v1::ObjectList& objects,
                      std::string_view path = "constraint_list");

// Requests, as services check them on arrival; paths start with the request's fields.
absl::Status Validate(const v1::DescribeRoomRequest& request);
absl::Status Validate(const v1::PlanZonesRequest& request);
absl::Status Validate(const v1::ListObjectsRequest& request);
absl::Status Validate(const v1::ChooseStyleRequest& request);
absl::Status Validate(const v1::ListConstraintsRequest& request);
absl::Status Validate(const v1::CleanConstraintsRequest& request);
absl::Status Validate(const v1::TranslateRequest& request);
absl::Status Validate(const v1::SolveRequest& request);
absl::Status Validate(const v1::SolveRestartsRequest& request);
absl::Status Validate(const v1::EvaluateRequest& request);
absl::Status Validate(const v1::RenderRequest& request);
absl::Status Validate(const v1::ExportSceneRequest& request);
// The message `index` of a stream: the first one holds options, every further one a tile.
absl::Status Validate(const v1::ComposeContactSheetRequest& request, int index);
absl::Status Validate(const v1::CreateJobRequest& request);
absl::Status Validate(const v1::CreateBatchRequest& request);
absl::Status Validate(const v1::AddToBatchRequest& request);

}  // namespace flair
