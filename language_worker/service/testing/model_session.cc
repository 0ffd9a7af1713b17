// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/testing/model_session.h"

#include <cstdlib>
#include <utility>

#include "language_worker/handbook/loading/load_handbook.h"
#include "language_worker/model/model_tools.h"

namespace flair::language {
namespace {

const llm::PromptLibrary& Prompts() {
  static const auto prompts = llm::PromptLibrary::Load(DefaultPromptsFolder(), {}, LanguagePrompts());
  if (!prompts.ok()) std::abort();
  return *prompts;
}

// What later steps build on when the earlier ones are not asked.
const char* const kObjects = R"({"objects":[
  {"name":"double bed","zone":"sleeping","primary":true,"count":1,"width_m":1.6,"depth_m":2.0,"height_m":0.5,"description":"Oak frame, linen headboard.","requested":false},
  {"name":"nightstand","zone":"sleeping","primary":false,"count":2,"width_m":0.45,"depth_m":0.4,"height_m":0.5,"description":null,"requested":false},
  {"name":"wardrobe","zone":"storage","primary":true,"count":1,"width_m":1.5,"depth_m":0.6,"height_m":2.1,"description":"Two sliding doors.","requested":false},
  {"name":"desk","zone":"working","primary":true,"count":1,"width_m":1.2,"depth_m":0.6,"height_m":0.75,"description":null,"requested":false},
  {"name":"desk chair","zone":"working","primary":false,"count":1,"width_m":0.55,"depth_m":0.55,"height_m":0.9,"description":null,"requested":false}],
  "left_out":[{"name":"sofa","reason":"It would block the way to the wardrobe."}]})";

const char* const kTertiaries = R"({"objects":[
  {"name":"table lamp","kind":"surface","at":"nightstand","count":2,"width_m":0.25,"depth_m":0.25,"height_m":0.4,"elevation_m":null,"placement":"A table lamp stands on each nightstand.","description":null,"requested":false},
  {"name":"painting","kind":"wall","at":"double_bed","count":1,"width_m":0.8,"depth_m":0.03,"height_m":0.6,"elevation_m":1.2,"placement":"The painting hangs on the wall above the double bed.","description":"A calm landscape.","requested":false},
  {"name":"area rug","kind":"floor","at":"double_bed","count":1,"width_m":2.0,"depth_m":1.5,"height_m":0.01,"elevation_m":null,"placement":"The area rug lies under the front of the double bed.","description":null,"requested":false},
  {"name":"pendant light","kind":"ceiling","at":null,"count":1,"width_m":0.4,"depth_m":0.4,"height_m":0.5,"elevation_m":null,"placement":"The pendant light hangs in the middle of the ceiling.","description":null,"requested":false}]})";

const char* const kStyle = R"json({"name":"calm natural","summary":"Oak and linen. Warm whites.",
  "palette":["warm white #F3EEE6","sage #9CAF94"],
  "surfaces":[{"surface":"walls","material":"matt paint","colour":"warm white #F3EEE6"},
    {"surface":"floor","material":"oak boards","colour":"oak #B98B55"},
    {"surface":"ceiling","material":"paint","colour":"white #FFFFFF"}],
  "looks":[{"of":["double_bed"],"material":"oak","colour":"oak #B98B55","description":"A low oak bed."},
    {"of":["nightstand"],"material":"oak","colour":"oak #B98B55","description":null},
    {"of":["wardrobe"],"material":"lacquer","colour":"warm white #FFEEEE","description":null},
    {"of":["desk"],"material":"oak","colour":"oak #B98B55","description":null},
    {"of":["desk_chair"],"material":"wool","colour":"sage #9CAF94","description":null},
    {"of":["door_1"],"material":"painted wood","colour":"white #FFFFFF","description":null}]})json";

const char* const kIntra = R"({"objects":[
  {"object":"double_bed","must":["The double bed's back is against a wall."],"should":["The double bed does not block a door.","There is 0.6 m of free floor to the left of the double bed."]},
  {"object":"nightstand","must":[],"should":["The nightstands do not block a window."]},
  {"object":"wardrobe","must":["The wardrobe's back is against a wall."],"should":["The front of the wardrobe is free."]},
  {"object":"desk","must":[],"should":["The desk is near a window and near a socket."]},
  {"object":"desk_chair","must":[],"should":[]}]})";

const char* const kInter = R"({"constraints":[
  {"objects":["nightstand_1","double_bed"],"must":["The first nightstand is next to the left side of the double bed."],"should":[]},
  {"objects":["nightstand_2","double_bed"],"must":["The second nightstand is next to the right side of the double bed."],"should":[]},
  {"objects":["desk_chair","desk"],"must":["The desk chair is in front of the desk."],"should":[]},
  {"objects":["wardrobe","double_bed"],"must":[],"should":["Ideally the wardrobe is away from the double bed."]}]})";

}  // namespace

const std::map<std::string, std::string>& GoodAnswers() {
  static const std::map<std::string, std::string> answers = {
      {"room", R"({"room_type":"bedroom","width_m":4,"depth_m":5,"height_m":null,
        "openings":[{"kind":"door","wall":"south","position":0.2,"width_m":0.9,"sill_m":null,"head_m":2.1,"swing":"inward"},
          {"kind":"window","wall":"north","position":0.5,"width_m":1.6,"sill_m":0.9,"head_m":2.2,"swing":null}],
        "sockets":[{"wall":"north","position":0.1},{"wall":"east","position":0.8}]})"},
      {"zones", R"({"zones":[{"name":"sleeping","purpose":"Sleep and rest."},
        {"name":"storage","purpose":"Clothes."},{"name":"working","purpose":"A desk by the window."}]})"},
      {"objects.floor", kObjects},
      {"objects.tertiary", kTertiaries},
      {"style", kStyle},
      {"constraints.intra", kIntra},
      {"constraints.inter", kInter},
      {"cleaning", R"({"changes":[
        "s11: The wardrobe is away from the double bed."]})"},
  };
  return answers;
}

const Handbook& ModelSession::handbook() {
  static const auto handbook = LoadHandbook(DefaultHandbookFolder());
  if (!handbook.ok()) std::abort();
  return **handbook;
}

ModelSession::ModelSession(const std::string& except)
    : model_(new llm::FakeLlmClient), handlers_(handbook(), std::unique_ptr<llm::LlmClient>(model_), Prompts()) {
  brief_.set_text("A bedroom that is 4m x 5m.");
  for (const auto& [step, answer] : GoodAnswers()) {
    if (step != except) model_->Answer(step, answer);
  }
}

void ModelSession::TakePartsOf(const ModelSession& other) {
  room_ = other.room_;
  zones_ = other.zones_;
  objects_ = other.objects_;
  constraints_ = other.constraints_;
}

template <typename Request>
Request ModelSession::Ask() const {
  Request request;
  request.set_request_id("test");
  *request.mutable_model_options() = options_;
  if constexpr (requires { request.mutable_brief(); }) *request.mutable_brief() = brief_;
  if constexpr (requires { request.mutable_room(); }) *request.mutable_room() = room_;
  if constexpr (requires { request.mutable_zone_plan(); }) *request.mutable_zone_plan() = zones_;
  if constexpr (requires { request.mutable_object_list(); }) *request.mutable_object_list() = objects_;
  if constexpr (requires { request.mutable_constraint_list(); }) *request.mutable_constraint_list() = constraints_;
  return request;
}

absl::StatusOr<v1::DescribeRoomResponse> ModelSession::DescribeRoom() {
  auto response = handlers_.Handle(Ask<v1::DescribeRoomRequest>(), call_);
  if (response.ok()) room_ = response->room();
  return response;
}

absl::StatusOr<v1::PlanZonesResponse> ModelSession::PlanZones() {
  auto response = handlers_.Handle(Ask<v1::PlanZonesRequest>(), call_);
  if (response.ok()) zones_ = response->zone_plan();
  return response;
}

absl::StatusOr<v1::ListObjectsResponse> ModelSession::ListObjects() {
  auto response = handlers_.Handle(Ask<v1::ListObjectsRequest>(), call_);
  if (response.ok()) objects_ = response->object_list();
  return response;
}

absl::StatusOr<v1::ChooseStyleResponse> ModelSession::ChooseStyle() {
  return handlers_.Handle(Ask<v1::ChooseStyleRequest>(), call_);
}

absl::StatusOr<v1::ListConstraintsResponse> ModelSession::ListConstraints() {
  auto response = handlers_.Handle(Ask<v1::ListConstraintsRequest>(), call_);
  if (response.ok()) constraints_ = response->constraint_list();
  return response;
}

absl::StatusOr<v1::CleanConstraintsResponse> ModelSession::CleanConstraints() {
  return handlers_.Handle(Ask<v1::CleanConstraintsRequest>(), call_);
}

}  // namespace flair::language
