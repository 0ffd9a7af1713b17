// SPDX-License-Identifier: GPL-3.0-or-later
// What servers must refuse, as tables: one field of a good request is spoiled by its path, and the error must name it.
#include <google/protobuf/descriptor.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cstdlib>

#include "cli/contract/bedroom.h"
#include "cli/contract/stage_checks.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "flair/v1/renderer_service.pb.h"
#include "fmt/format.h"

namespace flair::contract {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

struct Refusal {
  // What is bad, such as "a width that is no number".
  std::string what;
  // Path of the message that is spoiled, from the request on: "layout_graph.object_list.objects[0]". Empty: the
  // request.
  std::string_view path;
  // First "-FIELD" clears a field and "-FIELD[]" removes the last item of a list; the rest is merged as a text proto.
  std::string edit;
  // How the error must name the field, at least. Empty: the end of the path and the field that `edit` names first, such
  // as "objects[0].width_m".
  std::string named = {};
};

// The tables are this library's own: what does not fit the protocol is a bug.
const FieldDescriptor& FieldOf(const Message& message, std::string_view name) {
  const FieldDescriptor* const field = message.GetDescriptor()->FindFieldByName(std::string(name));
  if (field == nullptr) std::abort();
  return *field;
}

Message& PartOf(Message& request, std::string_view path) {
  Message* part = &request;
  while (!path.empty()) {
    const std::string step(path.substr(0, path.find('.')));
    path.remove_prefix(std::min(path.size(), step.size() + 1));
    const size_t bracket = step.find('[');
    const FieldDescriptor& field = FieldOf(*part, step.substr(0, bracket));
    const Reflection& reflection = *part->GetReflection();
    part = bracket == std::string::npos
               ? reflection.MutableMessage(part, &field)
               : reflection.MutableRepeatedMessage(part, &field, std::atoi(step.c_str() + bracket + 1));
  }
  return *part;
}

void Spoil(const Refusal& refusal, Message& request) {
  Message& part = PartOf(request, refusal.path);
  std::string_view text = refusal.edit;
  while (text.starts_with('-')) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (word.ends_with("[]")) {
      part.GetReflection()->RemoveLast(&part, &FieldOf(part, word.substr(1, word.size() - 3)));
    } else {
      part.GetReflection()->ClearField(&part, &FieldOf(part, word.substr(1)));
    }
  }
  if (!google::protobuf::TextFormat::MergeFromString(std::string(text), &part)) std::abort();
}

std::string NamedBy(const Refusal& refusal) {
  if (!refusal.named.empty()) return refusal.named;
  const std::string_view field = std::string_view(refusal.edit).substr(refusal.edit.starts_with('-') ? 1 : 0);
  const size_t dot = refusal.path.rfind('.');
  const std::string_view end = dot == std::string_view::npos ? refusal.path : refusal.path.substr(dot + 1);
  return fmt::format("{}{}{}", end, end.empty() ? "" : ".", field.substr(0, field.find_first_of(" :[")));
}

// One check for each row: `good` spoiled in its way must be refused as bad input, with an error that names the field.
void AddRefusals(const Message& good, const std::vector<Refusal>& refusals, Checks& checks,
                 v1::Capability capability = v1::CAPABILITY_UNSPECIFIED) {
  for (const Refusal& refusal : refusals) {
    const std::shared_ptr<Message> bad(good.New());
    bad->CopyFrom(good);
    Spoil(refusal, *bad);
    const std::string field = NamedBy(refusal);
    checks.push_back({.name = fmt::format("{} refuses {}", RpcName(good), refusal.what),
                      .promise = Promise::kErrors,
                      .sent = fmt::format("{} with {} ({})", RpcName(good), refusal.what, field),
                      .right = fmt::format("INVALID_ARGUMENT with a message that names \"{}\"", field),
                      .run = [bad, field](Target& target) -> Finding {
                        const absl::Status status = target.AskForBytes(*bad).status();
                        if (status.ok()) return Wrong("OK, with an answer");
                        const bool named = std::string(status.message()).find(field) != std::string::npos;
                        return absl::IsInvalidArgument(status) && named ? Kept() : Finding(status);
                      },
                      .capability = capability});
  }
}

constexpr std::string_view kGraph = "layout_graph";
constexpr std::string_view kFloor = "layout_graph.room.floor";
constexpr std::string_view kDoor = "layout_graph.room.openings[0]";
constexpr std::string_view kList = "layout_graph.object_list";
constexpr std::string_view kBed = "layout_graph.object_list.objects[0]";

// Each makes a bad problem of BedroomGraph().
const std::vector<Refusal>& GraphRefusals() {
  static const std::vector<Refusal> refusals = {
      {"an empty problem", "", "-layout_graph layout_graph {}"},
      {"a floor that runs clockwise", kFloor,
       "-vertices vertices {} vertices { y_m: 5 } vertices { x_m: 4 y_m: 5 } vertices { x_m: 4 }", "room.floor"},
      {"a floor with a corner that is no number", "layout_graph.room.floor.vertices[1]", "x_m: nan",
       "room.floor.vertices[1]"},
      {"a floor of a kilometre", kFloor,
       "-vertices vertices {} vertices { x_m: 1000 } vertices { x_m: 1000 y_m: 5 } vertices { y_m: 5 }", "room.floor"},
      {"fewer walls than the floor has edges", "layout_graph.room", "-walls[]"},
      {"a door in a wall that is not there", kDoor, "wall: 'nort'"},
      {"a door that is wider than its wall", kDoor, "width_m: 7.2"},
      {"two zones of one id", "layout_graph.zone_plan", "zones { id: 'sleeping' name: 'sleeping' }", "zones[1].id"},
      {"no objects", kList, "-objects"},
      {"two objects of one id", "layout_graph.object_list.objects[1]", "id: 'bed'"},
      {"an object without an id", kBed, "id: ''"},
      {"a width that is no number", kBed, "width_m: nan"},
      {"a width below zero", kBed, "width_m: -1"},
      {"an infinite depth", kBed, "depth_m: inf"},
      {"a height of zero", kBed, "height_m: 0"},
      {"a role that no enum has", kBed, "role: 99"},
      {"a kind that is not set", kBed, "kind: OBJECT_KIND_UNSPECIFIED"},
      {"an object of a zone that is not there", kBed, "zone_id: 'sleping'"},
      {"two edges of one id", kGraph,
       "edges { id: 'e1' type: 'some_type' weight: 1 } edges { id: 'e1' type: 'some_type' weight: 1 }", "edges[1].id"},
      {"an edge of weight zero", kGraph, "edges { id: 'e1' type: 'some_type' weight: 0 }", "edges[0].weight"},
      {"an edge of a weight that is no number", kGraph, "edges { id: 'e1' type: 'some_type' weight: nan }",
       "edges[0].weight"},
      {"an edge of a sentence that is not there", kGraph,
       "edges { id: 'e1' type: 'some_type' weight: 1 sentence_id: 's99' }", "edges[0].sentence_id"},
      {"a pin of an object that is not there", kGraph, "pinned_placements { object_id: 'ghost' x_m: 2 y_m: 2 }",
       "pinned_placements[0].object_id"},
      {"a pin at a place that is no number", kGraph, "pinned_placements { object_id: 'bed' x_m: nan y_m: 2 }",
       "pinned_placements[0].x_m"},
      {"a pinned heading beyond a full turn", kGraph,
       "pinned_placements { object_id: 'bed' x_m: 2 y_m: 2 theta_rad: 7 }", "pinned_placements[0].theta_rad"}};
  return refusals;
}

const std::vector<Refusal>& OptionRefusals() {
  static const std::vector<Refusal> refusals = {{"a seed below zero", "options", "seed: -1"},
                                                {"no restarts", "options", "max_restart_count: 0"},
                                                {"no threads", "options", "thread_count: 0"},
                                                {"a path that is no number wide", "options", "path_width_m: nan"},
                                                {"a factor below zero", "options.lambdas", "no_overlap: -1"},
                                                {"no layouts wanted", "options", "variant_count: 0"},
                                                {"a misfit policy that no enum has", "options", "misfit_policy: 99"},
                                                {"a time limit of zero", "options", "time_limit {}"}};
  return refusals;
}

// The RPCs of the orchestrator that are about one job, batch or artifact, told from the fields of their requests.
void AddUnknownIds(Checks& checks) {
  // The id of no artifact, job or batch.
  const std::string nowhere(64, '0');
  const google::protobuf::FileDescriptor& file = *v1::GetJobRequest::descriptor()->file();
  const google::protobuf::ServiceDescriptor& service = *file.FindServiceByName("OrchestratorService");
  for (int i = 0; i < service.method_count(); ++i) {
    const google::protobuf::Descriptor* const type = service.method(i)->input_type();
    // Lists take ids as filters: nothing matches one that is not there.
    if (service.method(i)->name().starts_with("List")) continue;
    for (const char* name : {"job_id", "batch_id", "artifact_id"}) {
      const FieldDescriptor* const id = type->FindFieldByName(name);
      if (id == nullptr || id->is_repeated()) continue;
      const std::shared_ptr<Message> request(
          google::protobuf::MessageFactory::generated_factory()->GetPrototype(type)->New());
      request->GetReflection()->SetString(request.get(), id, nowhere);
      checks.push_back({fmt::format("{} of an id that is not there is NOT_FOUND", RpcName(*request)), Promise::kErrors,
                        fmt::format("{} of an id that is not there", RpcName(*request)), "NOT_FOUND",
                        [request](Target& target) -> Finding {
                          const absl::Status status = target.AskForBytes(*request).status();
                          if (absl::IsNotFound(status)) return Kept();
                          return Wrong(StatusText(status));
                        }});
      break;
    }
  }
}

// The first fields of most requests of the language stage.
template <typename Request>
Request OfBedroom() {
  const v1::LayoutGraph graph = BedroomGraph();
  Request request;
  if constexpr (requires { request.mutable_brief(); }) *request.mutable_brief() = BedroomBrief();
  if constexpr (requires { request.mutable_room(); }) *request.mutable_room() = graph.room();
  if constexpr (requires { request.mutable_zone_plan(); }) *request.mutable_zone_plan() = graph.zone_plan();
  if constexpr (requires { request.mutable_object_list(); }) *request.mutable_object_list() = graph.object_list();
  if constexpr (requires { request.mutable_constraint_list(); }) {
    *request.mutable_constraint_list() = graph.constraint_list();
  }
  return request;
}

}  // namespace

Checks LanguageRefusals() {
  const Refusal bad_room = {"a room whose height is no number", "room", "height_m: nan"};
  const Refusal same_objects = {"two objects of one id", "object_list.objects[1]", "id: 'bed'"};
  Checks checks;
  AddRefusals(OfBedroom<v1::DescribeRoomRequest>(),
              {{"a brief without text", "brief", "text: '  '"},
               {"a brief of more than 4000 characters", "brief", fmt::format("text: '{}'", std::string(4001, 'a'))},
               {"a brief with a control character", "brief", "text: 'A bed\\001room.'"},
               {"a seed below zero", "brief", "seed: -1"}},
              checks);
  AddRefusals(OfBedroom<v1::PlanZonesRequest>(), {bad_room}, checks);
  AddRefusals(OfBedroom<v1::ListObjectsRequest>(), {bad_room, {"no zones", "", "-zone_plan"}}, checks);
  AddRefusals(OfBedroom<v1::ChooseStyleRequest>(), {same_objects}, checks);
  AddRefusals(OfBedroom<v1::ListConstraintsRequest>(), {same_objects}, checks);
  AddRefusals(OfBedroom<v1::CleanConstraintsRequest>(),
              {same_objects,
               {"a sentence about an object that is not there", "constraint_list.sentences[0]",
                "-subject_ids subject_ids: 'ghost'", "sentences[0].subject_ids[0]"},
               {"two sentences of one id", "constraint_list.sentences[1]", "id: 's1'"}},
              checks);
  return checks;
}

Checks TranslatorRefusals() {
  const v1::TranslateRequest good = BedroomTranslate();
  constexpr std::string_view kSentence = "constraint_list.sentences[0]";
  Checks checks;
  AddRefusals(good,
              {{"a request without a room", "", "-room"},
               {"an object without an id", "object_list.objects[0]", "id: ''"},
               {"two sentences of one id", "constraint_list.sentences[1]", "id: 's1'"},
               {"an empty sentence", kSentence, "text: ''"},
               {"a sentence about an object that is not there", kSentence, "-subject_ids subject_ids: 'ghost'",
                "sentences[0].subject_ids[0]"},
               {"a sentence of a scope that is not set", kSentence, "scope: SENTENCE_SCOPE_UNSPECIFIED"},
               {"a catalogue with two types of one name", "catalog.types[1]",
                fmt::format("name: '{}'", good.catalog().types(0).name())},
               {"a catalogue without types", "catalog", "-types"}},
              checks);
  return checks;
}

Checks OptimizerRefusals() {
  v1::SolveRequest solve;
  *solve.mutable_layout_graph() = BedroomGraph();
  Checks checks;
  AddRefusals(solve, GraphRefusals(), checks);
  AddRefusals(solve, OptionRefusals(), checks);
  AddRefusals(BedroomEvaluate(),
              {{"a problem with a bad width", kBed, "width_m: -1"},
               {"a placement of an object that is not there", "placements[0]", "object_id: 'ghost'"},
               {"an object that is placed twice", "", "placements { object_id: 'bed' }", "placements[1].object_id"},
               {"a placement that is no number", "placements[0]", "y_m: nan"},
               {"a heading that is no number", "placements[0]", "theta_rad: nan"}},
              checks, v1::CAPABILITY_EVALUATE);
  AddRefusals(BedroomRestarts(0, 1),
              {{"a stage that is not there", "", "stage: 'quaternary'"},
               {"too many restarts", "", "restart_count: 1001"},
               {"a first restart below zero", "", "first_restart: -1"},
               {"a zone that is not there", "", "zone_id: 'nowhere' stage: 'secondary'"},
               {"a placement of an object that is not there", "", "placements { object_id: 'ghost' }",
                "placements[0].object_id"}},
              checks, v1::CAPABILITY_SOLVE_RESTARTS);
  return checks;
}

Checks RendererRefusals() {
  v1::RenderRequest plan;
  *plan.mutable_solved_layout() = BedroomLayout();
  plan.mutable_options()->set_size_px(512);
  constexpr std::string_view kPlacement = "solved_layout.placements[0]";
  Checks checks;
  AddRefusals(plan,
              {{"no layout", "", "-solved_layout"},
               {"an object whose width is no number", "solved_layout.graph.object_list.objects[0]", "width_m: nan"},
               {"a placement that is no number", kPlacement, "x_m: nan"},
               {"a placement of an object that is not there", kPlacement, "object_id: 'ghost'"},
               {"a picture of nine pixels", "options", "size_px: 9"},
               {"a view that no enum has", "options", "view: 99"},
               {"a format that no enum has", "options", "format: 99"},
               {"a plan as EXR", "options", "format: PREVIEW_FORMAT_EXR"},
               {"a size in pixels for a page", "options", "format: PREVIEW_FORMAT_SVG", "options.size_px"}},
              checks);
  v1::RenderRequest view = plan;
  view.mutable_options()->set_view(v1::PREVIEW_VIEW_BIRDSEYE);
  view.mutable_options()->set_sample_count(1);
  AddRefusals(view,
              {{"a view as SVG", "options", "-size_px format: PREVIEW_FORMAT_SVG", "options.format"},
               {"a view without paths", "options", "sample_count: 0"},
               {"a camera without an eye", "options.camera", "target_m: 1", "options.camera.eye_m"},
               {"an EXR that is larger than an answer may be", "options", "size_px: 8192 format: PREVIEW_FORMAT_EXR"}},
              checks, v1::CAPABILITY_VIEWS);
  v1::ExportSceneRequest scene;
  *scene.mutable_solved_layout() = BedroomLayout();
  AddRefusals(scene, {{"a format that is not set", "", "format: SCENE_FORMAT_UNSPECIFIED"}}, checks,
              v1::CAPABILITY_EXPORT_SCENE);
  return checks;
}

Checks OrchestratorRefusals() {
  v1::CreateJobRequest job;
  job.set_request_id("contract-refusals");
  *job.mutable_spec()->mutable_brief() = BedroomBrief();
  v1::CreateBatchRequest batch;
  batch.set_request_id("contract-refusals");
  Checks checks;
  AddUnknownIds(checks);
  AddRefusals(job,
              {{"no request_id", "", "-request_id"},
               {"a request_id of 129 characters", "", fmt::format("request_id: '{}'", std::string(129, 'a'))},
               {"a brief without text", "spec.brief", "-text"},
               {"a seed below zero", "spec.brief", "seed: -1"},
               {"solve options out of range", "spec.solve_options", "max_restart_count: 0"},
               {"render options out of range", "spec.render_options", "size_px: 9"}},
              checks);
  AddRefusals(batch, {{"no jobs", "", "-specs"}}, checks);
  AddRefusals(v1::ListJobsRequest(),
              {{"a page size below zero", "", "page_size: -1"}, {"a page size of 1001", "", "page_size: 1001"}},
              checks);
  return checks;
}

}  // namespace flair::contract
