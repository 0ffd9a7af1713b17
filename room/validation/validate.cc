// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/validate.h"

#include "fmt/format.h"
#include "room/validation/checks.h"

namespace flair {
namespace {

using validation::Check;
using validation::Field;
using validation::Known;
using validation::NameSet;
using validation::Problems;

template <typename Message>
absl::Status Run(const Message& message, std::string_view path) {
  Problems problems;
  Check(message, Field(problems, std::string(path)));
  return problems.ToStatus();
}

template <typename Message>
absl::Status Run(const Message& message, const Known& known, std::string_view path) {
  Problems problems;
  Check(message, known, Field(problems, std::string(path)));
  return problems.ToStatus();
}

template <typename Message>
std::vector<validation::Problem> Find(const Message& message) {
  Problems problems;
  Check(message, Field(problems, ""));
  return problems.list();
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

std::vector<validation::Problem> FindProblems(const v1::Artifact& artifact) { return Find(artifact); }
std::vector<validation::Problem> FindProblems(const v1::Brief& brief) { return Find(brief); }
std::vector<validation::Problem> FindProblems(const v1::Room& room) { return Find(room); }

absl::Status Validate(const v1::ObjectList& list, std::string_view path) { return Run(list, Known{}, path); }

absl::Status Validate(const v1::ObjectList& list, const v1::ZonePlan& plan, std::string_view path) {
  const NameSet zones = validation::ZoneIds(plan);
  return Run(list, Known{.zones = &zones}, path);
}

absl::Status Validate(const v1::StyleSheet& sheet, std::string_view path) { return Run(sheet, Known{}, path); }

absl::Status Validate(const v1::StyleSheet& sheet, const v1::Room& room, const v1::ObjectList& objects,
                      std::string_view path) {
  const NameSet object_ids = validation::ObjectIds(objects);
  const NameSet opening_ids = validation::OpeningIds(room);
  return Run(sheet, Known{.objects = &object_ids, .openings = &opening_ids}, path);
}

absl::Status Validate(const v1::ConstraintList& list, std::string_view path) { return Run(list, Known{}, path); }

absl::Status Validate(const v1::ConstraintList& list, const v1::ObjectList& objects, std::string_view path) {
  const NameSet object_ids = validation::ObjectIds(objects);
  return Run(list, Known{.objects = &object_ids}, path);
}

namespace {

constexpr int kLongestRequestId = 128;

// The fields of a request.
class Fields {
 public:
  Field At(std::string_view name) { return Field(problems_, std::string(name)); }
  absl::Status Done() const { return problems_.ToStatus(); }

  template <typename Message>
  void Part(const Message& message, std::string_view name) {
    Check(message, At(name));
  }

  // The parts that requests of several RPCs have in common, in order; each refers to the ones before it.
  template <typename Request>
  void CommonParts(const Request& request) {
    At("request_id").Text(request.request_id(), 0, kLongestRequestId);
    NameSet zones, objects;
    Known known;
    if constexpr (requires { request.brief(); }) Part(request.brief(), "brief");
    if constexpr (requires { request.room(); }) Part(request.room(), "room");
    if constexpr (requires { request.zone_plan(); }) {
      zones = validation::ZoneIds(request.zone_plan());
      known.zones = &zones;
      Part(request.zone_plan(), "zone_plan");
    }
    if constexpr (requires { request.object_list(); }) {
      objects = validation::ObjectIds(request.object_list());
      Check(request.object_list(), known, At("object_list"));
      known.objects = &objects;
    }
    if constexpr (requires { request.constraint_list(); }) {
      Check(request.constraint_list(), known, At("constraint_list"));
    }
    if constexpr (requires { request.style_sheet(); }) Check(request.style_sheet(), known, At("style_sheet"));
    if constexpr (requires { request.catalog(); }) {
      if (request.has_catalog()) Part(request.catalog(), "catalog");
    }
    if constexpr (requires { request.model_options(); }) Part(request.model_options(), "model_options");
    if constexpr (requires { request.layout_graph(); }) Part(request.layout_graph(), "layout_graph");
    if constexpr (requires { request.solved_layout(); }) Part(request.solved_layout(), "solved_layout");
    if constexpr (requires { request.options(); }) Part(request.options(), "options");
    if constexpr (requires { request.placements(); }) {
      const NameSet placed = validation::ObjectIds(request.layout_graph().object_list());
      validation::CheckPlacements(request.placements(), {.objects = &placed}, At("placements"));
    }
  }

  void Specs(const google::protobuf::RepeatedPtrField<v1::JobSpec>& specs, int least, int most) {
    if (!At("specs").Count(specs.size(), least, most, "jobs")) return;
    for (int i = 0; i < specs.size(); ++i) Check(specs[i], At("specs")[i]);
  }

 private:
  Problems problems_;
};

template <typename Request>
absl::Status CheckCommonParts(const Request& request) {
  Fields fields;
  fields.CommonParts(request);
  return fields.Done();
}

// What of a request only goes into the metadata.
template <typename Request>
void CheckOrigin(const Request& request, Fields& fields) {
  fields.At("job_id").Text(request.job_id(), 0, 128);
  fields.At("brief_text").Text(request.brief_text(), 0, 4000);
  if (request.has_brief_seed()) {
    fields.At("brief_seed").InRange(static_cast<double>(request.brief_seed()), validation::kSeed);
  }
}

// Words around a layout.
template <typename Message>
void CheckCaption(const Message& message, Fields& fields, const std::string& path = "") {
  fields.At(path + "caption").Text(message.caption(), 0, 200);
  fields.At(path + "remark").Text(message.remark(), 0, 400);
}

void CheckBeside(const v1::RenderRequest& request, Fields& fields) {
  if (!fields.At("beside").Count(request.beside_size(), 0, 7, "layouts") || request.beside().empty()) return;
  const v1::PreviewView view = request.options().view();
  if (view != v1::PREVIEW_VIEW_UNSPECIFIED && view != v1::PREVIEW_VIEW_PLAN) {
    fields.At("beside").Reject("is for plans; leave it out for a ray-traced view");
  }
  for (int i = 0; i < request.beside_size(); ++i) {
    const v1::ComparedLayout& other = request.beside(i);
    const std::string path = fmt::format("beside[{}].", i);
    fields.Part(other.solved_layout(), path + "solved_layout");
    CheckCaption(other, fields, path);
    if (!fields.At(path + "changes").Count(other.changes_size(), 0, 1000, "changes")) return;
    for (int j = 0; j < other.changes_size(); ++j) {
      fields.At(fmt::format("{}changes[{}].words", path, j)).Text(other.changes(j).words(), 0, 400);
    }
  }
}

}  // namespace

absl::Status Validate(const v1::DescribeRoomRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::PlanZonesRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::ListObjectsRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::ChooseStyleRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::ListConstraintsRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::CleanConstraintsRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::TranslateRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::SolveRequest& request) { return CheckCommonParts(request); }
absl::Status Validate(const v1::EvaluateRequest& request) { return CheckCommonParts(request); }

absl::Status Validate(const v1::SolveRestartsRequest& request) {
  Fields fields;
  fields.CommonParts(request);
  const NameSet stages = {"primary", "secondary", "tertiary", "polish"};
  if (fields.At("stage").Refers(request.stage(), stages, "a stage") && request.stage() == "secondary") {
    fields.At("zone_id").Refers(request.zone_id(), validation::ZoneIds(request.layout_graph().zone_plan()), "a zone");
  }
  fields.At("first_restart").InRange(request.first_restart(), {.least = 0, .most = 1e6});
  fields.At("restart_count").InRange(request.restart_count(), {.least = 1, .most = 1000});
  return fields.Done();
}

absl::Status Validate(const v1::RenderRequest& request) {
  Fields fields;
  fields.CommonParts(request);
  CheckOrigin(request, fields);
  CheckCaption(request, fields);
  CheckBeside(request, fields);
  return fields.Done();
}

absl::Status Validate(const v1::ExportSceneRequest& request) {
  Fields fields;
  fields.CommonParts(request);
  fields.At("format").Enum(request.format(), v1::SceneFormat_IsValid(request.format()));
  CheckOrigin(request, fields);
  return fields.Done();
}

absl::Status Validate(const v1::ComposeContactSheetRequest& request, int index) {
  Fields fields;
  if (index == 0 && !request.has_options()) fields.At("options").Reject("is not set; the first message holds it");
  if (index > 0 && !request.has_tile()) fields.At("tile").Reject("is not set; every message after the first holds one");
  if (request.has_options()) fields.Part(request.options(), "options");
  if (request.has_tile()) fields.Part(request.tile(), "tile");
  return fields.Done();
}

absl::Status Validate(const v1::CreateJobRequest& request) {
  Fields fields;
  fields.At("request_id").Text(request.request_id(), 1, kLongestRequestId);
  fields.Part(request.spec(), "spec");
  return fields.Done();
}

absl::Status Validate(const v1::CreateBatchRequest& request) {
  Fields fields;
  fields.At("request_id").Text(request.request_id(), 1, kLongestRequestId);
  fields.At("label").Text(request.label(), 0, 200);
  fields.Specs(request.specs(), request.open() ? 0 : 1, 10000);
  return fields.Done();
}

absl::Status Validate(const v1::AddToBatchRequest& request) {
  Fields fields;
  fields.At("first_index").InRange(static_cast<double>(request.first_index()), {.least = 0, .most = 1e8});
  fields.Specs(request.specs(), 0, 1000);
  return fields.Done();
}

}  // namespace flair
