// SPDX-License-Identifier: GPL-3.0-or-later
// A step of the language or translation phase whose model answers with the bytes.
#include <array>
#include <string>

#include "flair/v1/translator_service.pb.h"
#include "language_worker/service/testing/model_session.h"
#include "llm/client/fake_llm_client.h"
#include "room/validation/validate.h"
#include "tests/fixtures/bedroom.h"
#include "tests/fuzz/targets.h"
#include "translator_worker/model/model_translator.h"

namespace flair::fuzz {
namespace {

// The answer and its repair.
constexpr std::string_view kBetween = "\n=====\n";

struct Answers {
  std::string first;
  std::string repaired;
};

Answers Split(std::string_view bytes) {
  const size_t at = bytes.find(kBetween);
  if (at == std::string_view::npos) return {std::string(bytes), std::string(bytes)};
  return {std::string(bytes.substr(0, at)), std::string(bytes.substr(at + kBetween.size()))};
}

// Nothing but a model's failure may come of a model's answer.
template <typename Response>
void CheckEnd(const absl::StatusOr<Response>& response) {
  if (response.ok()) return;
  Require(absl::IsDataLoss(response.status()), "a useless answer is DATA_LOSS, not " + response.status().ToString());
  Require(!response.status().message().empty(), "a failure says why");
}

// How far a session has come before the step that is fuzzed.
enum class Known { kNothing, kRoom, kZones, kObjects, kConstraints };

// A bedroom that a good model has described so far, and that answers `step` with the bytes.
class Session {
 public:
  Session(const std::string& step, const Answers& answers, Known known) : session_(step) {
    session_.model().Answer(step, answers.first);
    session_.model().Answer(step + "/repair", answers.repaired);
    // What this step answers may make good answers to the next one doubtful.
    for (const auto& [other, answer] : language::GoodAnswers()) {
      if (other != step) session_.model().Answer(other + "/repair", answer);
    }
    if (known >= Known::kRoom) Require(session_.DescribeRoom().ok(), "a good room is taken");
    if (known >= Known::kZones) Require(session_.PlanZones().ok(), "good zones are taken");
    if (known >= Known::kObjects) Require(session_.ListObjects().ok(), "good objects are taken");
    if (known >= Known::kConstraints) Require(session_.ListConstraints().ok(), "good sentences are taken");
  }
  language::ModelSession* operator->() { return &session_; }

 private:
  language::ModelSession session_;
};

void Room(const Answers& answers) {
  const auto response = Session("room", answers, Known::kNothing)->DescribeRoom();
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->room()).ok(), "the room is valid");
}

void Zones(const Answers& answers) {
  const auto response = Session("zones", answers, Known::kRoom)->PlanZones();
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->zone_plan()).ok(), "the zones are valid");
}

void Objects(const std::string& step, const Answers& answers) {
  const auto response = Session(step, answers, Known::kZones)->ListObjects();
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->object_list()).ok(), "the objects are valid");
}

void Style(const Answers& answers) {
  const auto response = Session("style", answers, Known::kObjects)->ChooseStyle();
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->style_sheet()).ok(), "the style is valid");
}

void Constraints(const std::string& step, const Answers& answers) {
  const auto response = Session(step, answers, Known::kObjects)->ListConstraints();
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->constraint_list()).ok(), "the sentences are valid");
}

void Cleaning(const Answers& answers) {
  const auto response = Session("cleaning", answers, Known::kConstraints)->CleanConstraints();
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->constraint_list()).ok(), "the cleaned sentences are valid");
}

v1::ConstraintCatalog SmallCatalog() {
  v1::ConstraintCatalog catalog;
  catalog.set_library("fuzz 1");
  v1::ConstraintType& wall = *catalog.add_types();
  wall.set_name("against_wall");
  wall.set_family("wall");
  const std::pair<const char*, v1::ParameterKind> parameters[] = {
      {"object", v1::PARAMETER_KIND_OBJECT}, {"others", v1::PARAMETER_KIND_OBJECTS},
      {"side", v1::PARAMETER_KIND_SIDE},     {"sides", v1::PARAMETER_KIND_SIDES},
      {"wall", v1::PARAMETER_KIND_WALL},     {"gap_m", v1::PARAMETER_KIND_NUMBER},
      {"strict", v1::PARAMETER_KIND_BOOLEAN}};
  for (const auto& [name, kind] : parameters) {
    v1::ParameterSpec& parameter = *wall.add_parameters();
    parameter.set_name(name);
    parameter.set_kind(kind);
    parameter.set_required(parameter.name() == "object");
    if (kind == v1::PARAMETER_KIND_NUMBER) parameter.set_unit("m");
  }
  return catalog;
}

void Translation(const Answers& answers) {
  static const v1::TranslateRequest request = [] {
    v1::TranslateRequest made;
    *made.mutable_room() = testing::BedroomRoom();
    *made.mutable_zone_plan() = testing::BedroomZones();
    for (const char* id : {"bed", "bed_2"}) *made.mutable_object_list()->add_objects() = testing::BedroomBed(id);
    *made.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
    *made.mutable_catalog() = SmallCatalog();
    return made;
  }();
  auto* model = new llm::FakeLlmClient();
  model->Answer("translation.intra", answers.first);
  model->Answer("translation.intra/repair", answers.repaired);
  const auto translator =
      translator::ModelTranslator::Make(std::unique_ptr<llm::LlmClient>(model), translator::DefaultPromptFolder(), "");
  Require(translator.ok(), "the installed prompts are good");
  runtime::CallContext call;
  const auto response = (*translator)->Translate(request, call);
  CheckEnd(response);
  if (response.ok()) Require(Validate(response->layout_graph()).ok(), "the graph is valid");
}

}  // namespace

void ModelStep(std::string_view bytes) {
  if (bytes.empty()) return;
  const Answers answers = Split(bytes.substr(1));
  switch (static_cast<unsigned char>(bytes.front()) % 9) {
    case 0:
      return Room(answers);
    case 1:
      return Zones(answers);
    case 2:
      return Objects("objects.floor", answers);
    case 3:
      return Objects("objects.tertiary", answers);
    case 4:
      return Style(answers);
    case 5:
      return Constraints("constraints.intra", answers);
    case 6:
      return Constraints("constraints.inter", answers);
    case 7:
      return Cleaning(answers);
    default:
      return Translation(answers);
  }
}

}  // namespace flair::fuzz
