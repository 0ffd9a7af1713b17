// SPDX-License-Identifier: GPL-3.0-or-later
#include "fmt/format.h"
#include "room/validation/checks.h"
#include "room/validation/validate.h"

namespace flair {
namespace {

using validation::Check;
using validation::Field;
using validation::Known;
using validation::NameSet;
using validation::Problems;

constexpr int kLongestRequestId = 128;

// The parts of a request, checked in order; each refers to the ones before it.
class Parts {
 public:
  Field At(std::string_view name) { return Field(problems_, std::string(name)); }

  Parts& Id(const std::string& request_id, int least = 0) {
    At("request_id").Text(request_id, least, kLongestRequestId);
    return *this;
  }
  template <typename Message>
  Parts& Part(const Message& message, std::string_view name) {
    Check(message, At(name));
    return *this;
  }
  Parts& Zones(const v1::ZonePlan& plan) {
    zones_ = validation::ZoneIds(plan);
    known_.zones = &zones_;
    return Part(plan, "zone_plan");
  }
  Parts& Objects(const v1::ObjectList& list) {
    objects_ = validation::ObjectIds(list);
    Check(list, known_, At("object_list"));
    known_.objects = &objects_;
    return *this;
  }
  template <typename Message>
  Parts& Referring(const Message& message, std::string_view name) {
    Check(message, known_, At(name));
    return *this;
  }
  absl::Status Done() const { return problems_.ToStatus(); }

 private:
  Problems problems_;
  NameSet zones_;
  NameSet objects_;
  Known known_;
};

void CheckGraphPlacements(const v1::LayoutGraph& graph,
                          const google::protobuf::RepeatedPtrField<v1::Placement>& placements, Parts& parts) {
  const NameSet objects = validation::ObjectIds(graph.object_list());
  validation::CheckPlacements(placements, {.objects = &objects}, parts.At("placements"));
}

// What of a request only goes into the metadata.
template <typename Request>
void CheckOrigin(const Request& request, Parts& parts) {
  parts.At("job_id").Text(request.job_id(), 0, 128);
  parts.At("brief_text").Text(request.brief_text(), 0, 4000);
  if (request.has_brief_seed()) {
    parts.At("brief_seed")
        .InRange(static_cast<double>(request.brief_seed()),
                 {.least = 0, .most = 9007199254740992.0, .open_most = true});
  }
}

// Words around a layout.
template <typename Message>
void CheckCaption(const Message& message, Parts& parts, const std::string& path = "") {
  parts.At(path + "caption").Text(message.caption(), 0, 200);
  parts.At(path + "remark").Text(message.remark(), 0, 400);
}

void CheckBeside(const v1::RenderRequest& request, Parts& parts) {
  if (!parts.At("beside").Count(request.beside_size(), 0, 7, "layouts") || request.beside().empty()) return;
  const v1::PreviewView view = request.options().view();
  if (view != v1::PREVIEW_VIEW_UNSPECIFIED && view != v1::PREVIEW_VIEW_PLAN) {
    parts.At("beside").Reject("is for plans; leave it out for a ray-traced view");
  }
  for (int i = 0; i < request.beside_size(); ++i) {
    const v1::ComparedLayout& other = request.beside(i);
    const std::string path = fmt::format("beside[{}].", i);
    parts.Part(other.solved_layout(), path + "solved_layout");
    CheckCaption(other, parts, path);
    if (!parts.At(path + "changes").Count(other.changes_size(), 0, 1000, "changes")) return;
    for (int j = 0; j < other.changes_size(); ++j) {
      parts.At(fmt::format("{}changes[{}].words", path, j)).Text(other.changes(j).words(), 0, 400);
    }
  }
}

}  // namespace

absl::Status Validate(const v1::DescribeRoomRequest& request) {
  return Parts()
      .Id(request.request_id())
      .Part(request.brief(), "brief")
      .Part(request.model_options(), "model_options")
      .Done();
}

absl::Status Validate(const v1::PlanZonesRequest& request) {
  return Parts()
      .Id(request.request_id())
      .Part(request.brief(), "brief")
      .Part(request.room(), "room")
      .Part(request.model_options(), "model_options")
      .Done();
}

absl::Status Validate(const v1::ListObjectsRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.brief(), "brief").Part(request.room(), "room");
  return parts.Zones(request.zone_plan()).Part(request.model_options(), "model_options").Done();
}

absl::Status Validate(const v1::ChooseStyleRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.brief(), "brief").Part(request.room(), "room");
  return parts.Zones(request.zone_plan())
      .Objects(request.object_list())
      .Part(request.model_options(), "model_options")
      .Done();
}

absl::Status Validate(const v1::ListConstraintsRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.brief(), "brief").Part(request.room(), "room");
  return parts.Zones(request.zone_plan())
      .Objects(request.object_list())
      .Part(request.model_options(), "model_options")
      .Done();
}

absl::Status Validate(const v1::CleanConstraintsRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.room(), "room").Objects(request.object_list());
  return parts.Referring(request.constraint_list(), "constraint_list")
      .Part(request.model_options(), "model_options")
      .Done();
}

absl::Status Validate(const v1::TranslateRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.room(), "room");
  parts.Zones(request.zone_plan()).Objects(request.object_list());
  parts.Referring(request.constraint_list(), "constraint_list").Referring(request.style_sheet(), "style_sheet");
  if (request.has_catalog()) parts.Part(request.catalog(), "catalog");
  return parts.Part(request.model_options(), "model_options").Done();
}

absl::Status Validate(const v1::SolveRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.layout_graph(), "layout_graph").Part(request.options(), "options");
  return parts.Done();
}

absl::Status Validate(const v1::SolveRestartsRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.layout_graph(), "layout_graph").Part(request.options(), "options");
  const NameSet stages = {"primary", "secondary", "tertiary", "polish"};
  if (parts.At("stage").Refers(request.stage(), stages, "a stage") && request.stage() == "secondary") {
    parts.At("zone_id").Refers(request.zone_id(), validation::ZoneIds(request.layout_graph().zone_plan()), "a zone");
  }
  CheckGraphPlacements(request.layout_graph(), request.placements(), parts);
  parts.At("first_restart").InRange(request.first_restart(), {.least = 0, .most = 1e6});
  parts.At("restart_count").InRange(request.restart_count(), {.least = 1, .most = 1000});
  return parts.Done();
}

absl::Status Validate(const v1::EvaluateRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.layout_graph(), "layout_graph").Part(request.options(), "options");
  CheckGraphPlacements(request.layout_graph(), request.placements(), parts);
  return parts.Done();
}

absl::Status Validate(const v1::RenderRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.solved_layout(), "solved_layout").Part(request.options(), "options");
  CheckOrigin(request, parts);
  CheckCaption(request, parts);
  CheckBeside(request, parts);
  return parts.Done();
}

absl::Status Validate(const v1::ExportSceneRequest& request) {
  Parts parts;
  parts.Id(request.request_id()).Part(request.solved_layout(), "solved_layout");
  parts.At("format").Enum(request.format(), v1::SceneFormat_IsValid(request.format()));
  CheckOrigin(request, parts);
  return parts.Done();
}

absl::Status Validate(const v1::ComposeContactSheetRequest& request, int index) {
  Parts parts;
  if (index == 0 && !request.has_options()) parts.At("options").Reject("is not set; the first message holds it");
  if (index > 0 && !request.has_tile()) parts.At("tile").Reject("is not set; every message after the first holds one");
  if (request.has_options()) parts.Part(request.options(), "options");
  if (request.has_tile()) parts.Part(request.tile(), "tile");
  return parts.Done();
}

absl::Status Validate(const v1::CreateJobRequest& request) {
  return Parts().Id(request.request_id(), 1).Part(request.spec(), "spec").Done();
}

absl::Status Validate(const v1::CreateBatchRequest& request) {
  Parts parts;
  parts.Id(request.request_id(), 1);
  parts.At("label").Text(request.label(), 0, 200);
  const int least = request.open() ? 0 : 1;
  if (!parts.At("specs").Count(request.specs_size(), least, 10000, "jobs")) return parts.Done();
  for (int i = 0; i < request.specs_size(); ++i) Check(request.specs(i), parts.At("specs")[i]);
  return parts.Done();
}

absl::Status Validate(const v1::AddToBatchRequest& request) {
  Parts parts;
  parts.At("first_index").InRange(static_cast<double>(request.first_index()), {.least = 0, .most = 1e8});
  if (!parts.At("specs").Count(request.specs_size(), 0, 1000, "jobs")) return parts.Done();
  for (int i = 0; i < request.specs_size(); ++i) Check(request.specs(i), parts.At("specs")[i]);
  return parts.Done();
}

}  // namespace flair
