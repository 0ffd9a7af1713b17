// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/validate.h"

#include "fmt/format.h"
#include "room/validation/checks.h"

namespace flair {
namespace {

using validation::Field;
using validation::IdsOf;
using validation::Known;
using validation::NameSet;
using validation::Problems;

Problems Find(const google::protobuf::Message& message, const Known& known, std::string_view path) {
  Problems problems;
  validation::CheckMessage(message, known, Field(problems, std::string(path)));
  return problems;
}

absl::Status Run(const google::protobuf::Message& message, std::string_view path = "", const Known& known = {}) {
  return Find(message, known, path).ToStatus();
}

}  // namespace

absl::Status Validate(const v1::Brief& brief, std::string_view path) { return Run(brief, path); }
absl::Status Validate(const v1::Room& room, std::string_view path) { return Run(room, path); }
absl::Status Validate(const v1::ZonePlan& plan, std::string_view path) { return Run(plan, path); }
absl::Status Validate(const v1::ConstraintCatalog& catalog, std::string_view path) { return Run(catalog, path); }
absl::Status Validate(const v1::LayoutGraph& graph, std::string_view path) { return Run(graph, path); }
absl::Status Validate(const v1::SolvedLayout& layout, std::string_view path) { return Run(layout, path); }
absl::Status Validate(const v1::SolveOptions& options, std::string_view path) { return Run(options, path); }
absl::Status Validate(const v1::RenderOptions& options, std::string_view path) { return Run(options, path); }
absl::Status Validate(const v1::JobSpec& spec, std::string_view path) { return Run(spec, path); }
absl::Status Validate(const v1::Preview& preview, std::string_view path) { return Run(preview, path); }
absl::Status Validate(const v1::Report& report, std::string_view path) { return Run(report, path); }
absl::Status Validate(const v1::Artifact& artifact, std::string_view path) { return Run(artifact, path); }

std::vector<validation::Problem> FindProblems(const v1::Artifact& artifact) { return Find(artifact, {}, "").list(); }
std::vector<validation::Problem> FindProblems(const v1::Brief& brief) { return Find(brief, {}, "").list(); }
std::vector<validation::Problem> FindProblems(const v1::Room& room) { return Find(room, {}, "").list(); }

absl::Status Validate(const v1::ObjectList& list, std::string_view path) { return Run(list, path); }

absl::Status Validate(const v1::ObjectList& list, const v1::ZonePlan& plan, std::string_view path) {
  const NameSet zones = IdsOf(plan.zones());
  return Run(list, path, Known{.zones = &zones});
}

absl::Status Validate(const v1::StyleSheet& sheet, std::string_view path) { return Run(sheet, path); }

absl::Status Validate(const v1::StyleSheet& sheet, const v1::Room& room, const v1::ObjectList& objects,
                      std::string_view path) {
  const NameSet object_ids = IdsOf(objects.objects());
  const NameSet opening_ids = IdsOf(room.openings());
  return Run(sheet, path, Known{.objects = &object_ids, .openings = &opening_ids});
}

absl::Status Validate(const v1::ConstraintList& list, std::string_view path) { return Run(list, path); }

absl::Status Validate(const v1::ConstraintList& list, const v1::ObjectList& objects, std::string_view path) {
  const NameSet object_ids = IdsOf(objects.objects());
  return Run(list, path, Known{.objects = &object_ids});
}

absl::Status Validate(const v1::DescribeRoomRequest& request) { return Run(request); }
absl::Status Validate(const v1::PlanZonesRequest& request) { return Run(request); }
absl::Status Validate(const v1::ListObjectsRequest& request) { return Run(request); }
absl::Status Validate(const v1::ChooseStyleRequest& request) { return Run(request); }
absl::Status Validate(const v1::ListConstraintsRequest& request) { return Run(request); }
absl::Status Validate(const v1::CleanConstraintsRequest& request) { return Run(request); }
absl::Status Validate(const v1::TranslateRequest& request) { return Run(request); }
absl::Status Validate(const v1::SolveRequest& request) { return Run(request); }
absl::Status Validate(const v1::SolveRestartsRequest& request) { return Run(request); }
absl::Status Validate(const v1::EvaluateRequest& request) { return Run(request); }
absl::Status Validate(const v1::RenderRequest& request) { return Run(request); }
absl::Status Validate(const v1::ExportSceneRequest& request) { return Run(request); }
absl::Status Validate(const v1::CreateJobRequest& request) { return Run(request); }
absl::Status Validate(const v1::CreateBatchRequest& request) { return Run(request); }
absl::Status Validate(const v1::AddToBatchRequest& request) { return Run(request); }

absl::Status Validate(const v1::ComposeContactSheetRequest& request, int index) {
  Problems problems = Find(request, {}, "");
  const Field at(problems, "");
  if (index == 0 && !request.has_options()) at["options"].Reject("is not set; the first message holds it");
  if (index > 0 && !request.has_tile()) at["tile"].Reject("is not set; every message after the first holds one");
  return problems.ToStatus();
}

}  // namespace flair
