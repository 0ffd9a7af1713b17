// SPDX-License-Identifier: GPL-3.0-or-later
// A step of the language or translation phase whose model answers with the bytes.
#include <google/protobuf/text_format.h>

#include <string>

#include "flair/v1/translator_service.pb.h"
#include "language_worker/service/testing/model_session.h"
#include "llm/testing/fake_llm_client.h"
#include "room/validation/validate.h"
#include "tests/fixtures/bedroom.h"
#include "tests/fuzz/targets.h"
#include "translator_worker/model/model_translator.h"

namespace flair {
std::string_view SmallCatalogText();  // small_catalog.textproto, embedded
}

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

// A failure of the model, or a valid part: nothing else may come of a model's answer.
template <typename Response, typename Part>
void CheckEnd(const absl::StatusOr<Response>& response, const Part& (Response::*part)() const) {
  if (response.ok()) return Require(Validate(((*response).*part)()).ok(), "what an answer was made into is valid");
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

void Objects(const std::string& step, const Answers& answers) {
  CheckEnd(Session(step, answers, Known::kZones)->ListObjects(), &v1::ListObjectsResponse::object_list);
}

void Constraints(const std::string& step, const Answers& answers) {
  CheckEnd(Session(step, answers, Known::kObjects)->ListConstraints(), &v1::ListConstraintsResponse::constraint_list);
}

void Translation(const Answers& answers) {
  static const v1::TranslateRequest request = [] {
    v1::TranslateRequest made;
    *made.mutable_room() = testing::BedroomRoom();
    *made.mutable_zone_plan() = testing::BedroomZones();
    for (const char* id : {"bed", "bed_2"}) *made.mutable_object_list()->add_objects() = testing::BedroomBed(id);
    *made.mutable_constraint_list()->add_sentences() = testing::BedroomSentence();
    Require(google::protobuf::TextFormat::ParseFromString(std::string(SmallCatalogText()), made.mutable_catalog()),
            "the catalogue parses");
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
  CheckEnd(response, &v1::TranslateResponse::layout_graph);
}

}  // namespace

void ModelStep(std::string_view bytes) {
  if (bytes.empty()) return;
  const Answers answers = Split(bytes.substr(1));
  switch (static_cast<unsigned char>(bytes.front()) % 9) {
    case 0:
      return CheckEnd(Session("room", answers, Known::kNothing)->DescribeRoom(), &v1::DescribeRoomResponse::room);
    case 1:
      return CheckEnd(Session("zones", answers, Known::kRoom)->PlanZones(), &v1::PlanZonesResponse::zone_plan);
    case 2:
      return Objects("objects.floor", answers);
    case 3:
      return Objects("objects.tertiary", answers);
    case 4:
      return CheckEnd(Session("style", answers, Known::kObjects)->ChooseStyle(), &v1::ChooseStyleResponse::style_sheet);
    case 5:
      return Constraints("constraints.intra", answers);
    case 6:
      return Constraints("constraints.inter", answers);
    case 7:
      return CheckEnd(Session("cleaning", answers, Known::kConstraints)->CleanConstraints(),
                      &v1::CleanConstraintsResponse::constraint_list);
    default:
      return Translation(answers);
  }
}

}  // namespace flair::fuzz
