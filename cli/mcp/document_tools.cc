// SPDX-License-Identifier: GPL-3.0-or-later
// The list of tools, and those that make rooms.
#include "cli/mcp/document_tools.h"

#include <algorithm>
#include <random>
#include <set>
#include <string_view>
#include <utility>

#include "cli/mcp/layout_json.h"
#include "cli/mcp/schema.h"
#include "fmt/format.h"
#include "orchestrator/pipeline/stage.h"
#include "worker_runtime/status/status_macros.h"

namespace flair {
std::string_view McpToolTable();
}

namespace flair::cli::mcp {
namespace {

const Json& Table() {
  static const Json& table = *new Json(Json::parse(McpToolTable()));
  return table;
}

std::string NewRequestId() {
  std::random_device random;
  return fmt::format("mcp-{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

}  // namespace

std::string DocumentTools::Instructions() const {
  return fmt::format("{} export writes below {}.", Table().at("instructions").get<std::string>(),
                     root_.path().string());
}

std::vector<Tool> DocumentTools::Tools() {
  std::vector<Tool> tools;
  for (const Json& listed : WithShared(Table().at("tools"), Table().at("shared"))) {
    tools.push_back({.listed = listed, .run = Find(listed.at("name"))});
  }
  return tools;
}

std::function<DocumentTools::Result(const Json&, ToolCall&)> DocumentTools::Find(const std::string& name) {
  using Run = std::function<Result(const Json&, ToolCall&)>;
  // An act that does the same to whatever is shown, or that edits one object.
  const auto plain = [this](void (*set)(const Json&, v1::ActRequest&)) -> Run {
    return [this, set](const Json& arguments, ToolCall& call) {
      return Act(arguments, call, [&](const v1::SolvedLayout&, v1::ActRequest& request) {
        set(arguments, request);
        return absl::OkStatus();
      });
    };
  };
  const auto edit = [this](void (*set)(const std::string&, v1::LayoutEdit&)) -> Run {
    return [this, set](const Json& arguments, ToolCall& call) {
      return Act(arguments, call, [&](const v1::SolvedLayout& shown, v1::ActRequest& request) -> absl::Status {
        ASSIGN_OR_RETURN(const v1::Object* object, ObjectMeant(shown.graph(), arguments.at("object"), "object"));
        request.mutable_edit()->set_without_solving(!arguments.value("settle", true));
        set(object->id(), *request.mutable_edit()->add_edits());
        return absl::OkStatus();
      });
    };
  };
  const std::map<std::string, Run> runs = {
      {"design", [this](const Json& arguments, ToolCall& call) { return Design(arguments, call); }},
      {"list_documents", [this](const Json& arguments, ToolCall&) { return List(arguments); }},
      {"describe",
       [this](const Json& arguments, ToolCall& call) { return Describe(arguments.at("document_id"), call.context()); }},
      {"explain", [this](const Json& arguments, ToolCall& call) { return Explain(arguments, call); }},
      {"move",
       [this](const Json& arguments, ToolCall& call) {
         return Act(arguments, call, [&](const v1::SolvedLayout& shown, v1::ActRequest& request) {
           return FillMove(arguments, shown, request);
         });
       }},
      {"add",
       [this](const Json& arguments, ToolCall& call) {
         return Act(arguments, call, [&](const v1::SolvedLayout& shown, v1::ActRequest& request) {
           return FillAdd(arguments, call.context(), shown, request);
         });
       }},
      {"replace",
       [this](const Json& arguments, ToolCall& call) {
         return Act(arguments, call, [&](const v1::SolvedLayout& shown, v1::ActRequest& request) {
           return FillReplace(arguments, call.context(), shown, request);
         });
       }},
      {"resize",
       [this](const Json& arguments, ToolCall& call) {
         return Act(arguments, call, [&](const v1::SolvedLayout& shown, v1::ActRequest& request) {
           return FillResize(arguments, shown, request);
         });
       }},
      {"remove", edit([](const std::string& id, v1::LayoutEdit& edit) { edit.set_remove_object_id(id); })},
      {"pin", edit([](const std::string& id, v1::LayoutEdit& edit) { edit.set_pin_object_id(id); })},
      {"unpin", edit([](const std::string& id, v1::LayoutEdit& edit) { edit.set_unpin_object_id(id); })},
      {"say", plain([](const Json& arguments, v1::ActRequest& request) {
         request.mutable_say()->set_text(arguments.at("sentence").get<std::string>());
       })},
      {"weigh", plain([](const Json& arguments, v1::ActRequest& request) {
         request.mutable_weigh()->set_sentence_id(arguments.at("sentence_id").get<std::string>());
         request.mutable_weigh()->set_weight(arguments.at("weight").get<double>());
       })},
      {"drop", plain([](const Json& arguments, v1::ActRequest& request) {
         request.mutable_weigh()->set_sentence_id(arguments.at("sentence_id").get<std::string>());
       })},
      {"settle", plain([](const Json&, v1::ActRequest& request) { request.mutable_settle(); })},
      {"undo", plain([](const Json&, v1::ActRequest& request) { request.mutable_undo(); })},
      {"redo", plain([](const Json&, v1::ActRequest& request) { request.mutable_redo(); })},
      {"alternatives", [this](const Json& arguments, ToolCall& call) { return Alternatives(arguments, call); }},
      {"take_alternative", plain([](const Json& arguments, v1::ActRequest& request) {
         request.mutable_take_variant()->set_index(arguments.at("index").get<int>());
       })},
      {"render", [this](const Json& arguments, ToolCall& call) { return Render(arguments, call); }},
      {"export", [this](const Json& arguments, ToolCall& call) { return Export(arguments, call); }},
      {"share", [this](const Json& arguments, ToolCall& call) { return Share(arguments, call); }},
      {"find_furniture", [this](const Json& arguments, ToolCall& call) { return FindFurniture(arguments, call); }},
  };
  return runs.at(name);
}

absl::StatusOr<v1::GetDocumentResponse> DocumentTools::Shown(const std::string& document_id) {
  v1::GetDocumentRequest request;
  request.set_document_id(document_id);
  ASSIGN_OR_RETURN(v1::GetDocumentResponse shown, documents_.Get(request));
  if (shown.has_layout()) return shown;
  return FailedPrecondition("the room has no layout{}", shown.document().job_error().empty()
                                                            ? " yet: it is being designed"
                                                            : ": " + shown.document().job_error());
}

DocumentTools::Result DocumentTools::Describe(const std::string& document_id, runtime::CallContext& call) {
  ASSIGN_OR_RETURN(const v1::GetDocumentResponse shown, Shown(document_id));
  v1::ExplainRequest explain;
  explain.set_document_id(document_id);
  ASSIGN_OR_RETURN(const v1::ExplainResponse explained, documents_.Explain(explain, call));
  ToolResult result;
  result.structured = DescribedJson(shown.document(), shown.layout());
  result.structured["not_as_asked"] = Json::array();
  for (const std::string& line : explained.not_as_asked()) result.structured["not_as_asked"].push_back(line);
  return result;
}

DocumentTools::Result DocumentTools::Design(const Json& arguments, ToolCall& call) {
  v1::CreateDocumentRequest create;
  create.set_request_id(NewRequestId());
  v1::Brief& brief = *create.mutable_design()->mutable_brief();
  brief.set_text(arguments.at("brief").get<std::string>());
  brief.set_seed(arguments.value("seed", int64_t{0}));
  ASSIGN_OR_RETURN(const v1::CreateDocumentResponse made, documents_.Create(create, call.context()));
  const std::string& id = made.document().id();
  const auto stages =
      static_cast<double>(std::ranges::count_if(orchestrator::Stages(), [&](const orchestrator::Stage& stage) {
        return stage.wanted == nullptr || stage.wanted(create.design());
      }));
  double ended = 0;
  const auto see = [&](const v1::JobEvent& event) {
    const bool reused = event.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED;
    if (!reused && event.kind() != v1::JOB_EVENT_KIND_STAGE_FINISHED) return;
    ended += 1;
    call.Tell(ended, std::max(stages, ended), fmt::format("{}: {}", event.stage(), event.message()));
  };
  const absl::StatusOr<v1::Document> designed = documents_.AwaitJob(id, see, call.context());
  const bool succeeded = designed.ok() && designed->job_state() == v1::JOB_STATE_SUCCEEDED;
  if (succeeded) return Describe(id, call.context());
  // Nobody has heard of the document yet: without a layout it would only be in the way.
  runtime::CallContext cleaning;
  documents_.CancelJob(id, cleaning).IgnoreError();
  v1::DeleteDocumentRequest forget;
  forget.set_document_id(id);
  documents_.Delete(forget).IgnoreError();
  RETURN_IF_ERROR(designed.status());
  if (designed->job_state() == v1::JOB_STATE_CANCELLED) return absl::CancelledError("the design was cancelled");
  return absl::FailedPreconditionError(designed->job_error());
}

DocumentTools::Result DocumentTools::Alternatives(const Json& arguments, ToolCall& call) {
  ASSIGN_OR_RETURN(const v1::GetDocumentResponse shown, Shown(arguments.at("document_id")));
  ASSIGN_OR_RETURN(
      const v1::GetDocumentResponse found,
      documents_.FindAlternatives(shown.document().id(), arguments.value("revision", shown.document().revision()),
                                  arguments.value("count", 3), arguments.value("seed", int64_t{0}), call.context()));
  ToolResult result;
  result.structured = {{"document_id", found.document().id()},
                       {"revision", found.document().revision()},
                       {"alternatives", Json::array()}};
  const v1::LayoutGraph& graph = shown.layout().graph();
  for (const v1::RunnerUp& other : found.layout().runner_ups()) {
    Json& json = result.structured["alternatives"].emplace_back();
    json = {{"index", result.structured["alternatives"].size() - 1},
            {"measures", MeasuresJson(other.edge_outcomes(), other.metrics())},
            {"faults", FaultsJson(graph, other.metrics())},
            {"moved", Json::array()}};
    v1::SolvedLayout places;
    *places.mutable_placements() = other.placements();
    for (const v1::Object& object : graph.object_list().objects()) {
      const v1::Placement* before = PlacementOf(shown.layout(), object.id());
      const v1::Placement* after = PlacementOf(places, object.id());
      if (after == nullptr || object.kind() != v1::OBJECT_KIND_FLOOR) continue;
      if (before != nullptr && before->SerializeAsString() == after->SerializeAsString()) continue;
      json["moved"].push_back(PlaceJson(graph, object, after));
    }
  }
  return result;
}

}  // namespace flair::cli::mcp
