// SPDX-License-Identifier: GPL-3.0-or-later
// Language: six steps, each of which answers something valid that the next one can use.
#include <google/protobuf/util/message_differencer.h>

#include <array>

#include "cli/contract/bedroom.h"
#include "cli/contract/stage_checks.h"
#include "flair/v1/language_service.pb.h"
#include "fmt/format.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

// What the steps have said so far about one brief. A model may be behind each, so all checks of a run share it.
struct Design {
  v1::Brief brief = BedroomBrief();
  v1::Room room;
  v1::ZonePlan zones;
  v1::ObjectList objects;
  v1::ConstraintList sentences;
  // How each step that was asked came out; later steps are not asked once one has no answer.
  std::vector<Finding> steps;
  bool ended = false;
};

// The request of a step: as much of the design as it has fields for.
template <typename Request>
Request RequestFor(const Design& design) {
  Request request;
  if constexpr (requires { request.mutable_brief(); }) *request.mutable_brief() = design.brief;
  if constexpr (requires { request.mutable_room(); }) *request.mutable_room() = design.room;
  if constexpr (requires { request.mutable_zone_plan(); }) *request.mutable_zone_plan() = design.zones;
  if constexpr (requires { request.mutable_object_list(); }) *request.mutable_object_list() = design.objects;
  if constexpr (requires { request.mutable_constraint_list(); }) {
    *request.mutable_constraint_list() = design.sentences;
  }
  return request;
}

// Asks for one step; `take` keeps what it says and says whether that validates.
template <typename Request, typename Response>
void Take(Target& target, Design& design, absl::Status (*take)(const Response&, Design&)) {
  if (design.ended) return;
  const absl::StatusOr<Response> answer = target.Ask<Response>(RequestFor<Request>(design));
  design.ended = !answer.ok();
  if (!answer.ok()) {
    design.steps.emplace_back(answer.status());
    return;
  }
  const absl::Status valid = take(*answer, design);
  const std::string fault = valid.ok() ? ProducerFault(answer->producer()) : std::string(valid.message());
  design.steps.push_back(WrongIf(fault));
}

void Run(Target& target, Design& design) {
  Take<v1::DescribeRoomRequest, v1::DescribeRoomResponse>(target, design, [](const auto& answer, Design& d) {
    d.room = answer.room();
    return Validate(d.room);
  });
  Take<v1::PlanZonesRequest, v1::PlanZonesResponse>(target, design, [](const auto& answer, Design& d) {
    d.zones = answer.zone_plan();
    return Validate(d.zones);
  });
  Take<v1::ListObjectsRequest, v1::ListObjectsResponse>(target, design, [](const auto& answer, Design& d) {
    d.objects = answer.object_list();
    return Validate(d.objects, d.zones);
  });
  Take<v1::ChooseStyleRequest, v1::ChooseStyleResponse>(
      target, design, [](const auto& answer, Design& d) { return Validate(answer.style_sheet(), d.room, d.objects); });
  Take<v1::ListConstraintsRequest, v1::ListConstraintsResponse>(target, design, [](const auto& answer, Design& d) {
    d.sentences = answer.constraint_list();
    return Validate(d.sentences, d.objects);
  });
  Take<v1::CleanConstraintsRequest, v1::CleanConstraintsResponse>(
      target, design, [](const auto& answer, Design& d) { return Validate(answer.constraint_list(), d.objects); });
}

struct Step {
  const char* rpc;
  const char* right;
};

constexpr std::array<Step, 6> kSteps = {
    {{"DescribeRoom",
      "a room: a simple floor in metres, counter-clockwise from (0, 0), with walls and a door that fit"},
     {"PlanZones", "one zone at least, with unique ids"},
     {"ListObjects", "objects with unique ids, sizes in metres and zones of the plan"},
     {"ChooseStyle", "a style sheet about these objects and openings"},
     {"ListConstraints", "sentences with unique ids about these objects"},
     {"CleanConstraints", "sentences with unique ids about these objects"}}};

Finding StepFinding(Target& target, Design& design, size_t index) {
  if (design.steps.empty()) Run(target, design);
  if (index < design.steps.size()) return design.steps[index];
  return Skipped(fmt::format("{} had no answer", kSteps[design.steps.size() - 1].rpc));
}

// A design whose brief brings its own room, zones, objects and sentences.
Design GivenDesign() {
  const v1::LayoutGraph graph = BedroomGraph();
  Design design;
  design.room = *design.brief.mutable_room() = graph.room();
  design.zones = *design.brief.mutable_zone_plan() = graph.zone_plan();
  design.objects = *design.brief.mutable_object_list() = graph.object_list();
  design.sentences = *design.brief.mutable_constraint_list() = graph.constraint_list();
  return design;
}

Finding KeepsTheRoom(const v1::DescribeRoomResponse& answer) {
  const v1::Room room = BedroomGraph().room();
  const bool kept = google::protobuf::util::MessageDifferencer::Equals(answer.room().floor(), room.floor()) &&
                    answer.room().openings_size() == room.openings_size();
  return kept ? Kept() : Wrong("another room");
}

Finding KeepsTheZones(const v1::PlanZonesResponse& answer) {
  const auto& zones = answer.zone_plan().zones();
  const bool kept = zones.size() == 1 && zones[0].id() == BedroomGraph().zone_plan().zones(0).id();
  return kept ? Kept() : Wrong(fmt::format("{} zones, not the same", zones.size()));
}

Finding KeepsTheObjects(const v1::ListObjectsResponse& answer) {
  const v1::ObjectList wanted = BedroomGraph().object_list();
  const auto& got = answer.object_list().objects();
  bool kept = got.size() == wanted.objects_size();
  for (int i = 0; kept && i < got.size(); ++i) {
    kept = got[i].id() == wanted.objects(i).id() && got[i].width_m() == wanted.objects(i).width_m();
  }
  return kept ? Kept() : Wrong(fmt::format("{} objects, not the same", got.size()));
}

Finding KeepsTheSentences(const v1::ListConstraintsResponse& answer) {
  const v1::ConstraintList wanted = BedroomGraph().constraint_list();
  const auto& got = answer.constraint_list().sentences();
  bool kept = got.size() >= wanted.sentences_size();
  for (int i = 0; kept && i < wanted.sentences_size(); ++i) kept = got[i].text() == wanted.sentences(i).text();
  return kept ? Kept() : Wrong(fmt::format("{} sentences, not the same", got.size()));
}

}  // namespace

Sample LanguageSample() {
  auto request = std::make_shared<v1::DescribeRoomRequest>();
  *request->mutable_brief() = BedroomBrief();
  return {.what = "DescribeRoom of \"A bedroom that is 4m x 5m.\"",
          .request = request,
          .fault = FaultOf<v1::DescribeRoomResponse>(
              [](const v1::DescribeRoomResponse& answer) { return std::string(Validate(answer.room()).message()); }),
          .core = [](const std::string& bytes) { return bytes; },
          .long_requests = {request}};
}

Checks LanguageChecks() {
  Checks checks;
  const auto design = std::make_shared<Design>();
  for (size_t i = 0; i < kSteps.size(); ++i) {
    checks.push_back({fmt::format("{} answers something valid that says who made it", kSteps[i].rpc),
                      Promise::kMessages, fmt::format("{} for \"{}\"", kSteps[i].rpc, design->brief.text()),
                      fmt::format("{}; and a producer whose program and method are set", kSteps[i].right),
                      [design, i](Target& target) { return StepFinding(target, *design, i); }});
  }
  const Design given = GivenDesign();
  checks.push_back({"A room that the brief brings is kept", Promise::kMessages,
                    "DescribeRoom of a brief with a room of its own", "the floor and the openings of the brief",
                    Answered<v1::DescribeRoomResponse>(RequestFor<v1::DescribeRoomRequest>(given), KeepsTheRoom)});
  checks.push_back({"Zones that the brief brings are kept", Promise::kMessages,
                    "PlanZones of a brief with zones of its own", "the zones of the brief",
                    Answered<v1::PlanZonesResponse>(RequestFor<v1::PlanZonesRequest>(given), KeepsTheZones)});
  checks.push_back({"Objects that the brief brings are kept", Promise::kMessages,
                    "ListObjects of a brief with objects of its own", "the objects of the brief",
                    Answered<v1::ListObjectsResponse>(RequestFor<v1::ListObjectsRequest>(given), KeepsTheObjects)});
  checks.push_back(
      {"Sentences that the brief brings are kept", Promise::kMessages,
       "ListConstraints of a brief with sentences of its own", "the sentences of the brief",
       Answered<v1::ListConstraintsResponse>(RequestFor<v1::ListConstraintsRequest>(given), KeepsTheSentences)});
  return checks;
}

}  // namespace flair::contract
