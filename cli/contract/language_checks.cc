// SPDX-License-Identifier: GPL-3.0-or-later
// Language: six steps, each of which answers something valid that the next one can use.
#include <google/protobuf/util/message_differencer.h>

#include <limits>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/language_service.pb.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

// What the steps have said so far about one brief. A model may be behind each, so all checks of a run share it.
struct Design {
  absl::Status status;
  std::string sent;
  v1::Brief brief = BedroomBrief();
  v1::DescribeRoomResponse room;
  v1::PlanZonesResponse zones;
  v1::ListObjectsResponse objects;
  v1::ChooseStyleResponse style;
  v1::ListConstraintsResponse constraints;
  v1::CleanConstraintsResponse cleaned;
  int steps_done = 0;
};
constexpr int kStepCount = 6;

v1::DescribeRoomRequest DescribeRoomOf(const v1::Brief& brief) {
  v1::DescribeRoomRequest request;
  *request.mutable_brief() = brief;
  return request;
}

v1::PlanZonesRequest PlanZonesOf(const v1::Brief& brief, const v1::Room& room) {
  v1::PlanZonesRequest request;
  *request.mutable_brief() = brief;
  *request.mutable_room() = room;
  return request;
}

// ListObjectsRequest, ChooseStyleRequest and ListConstraintsRequest begin alike.
template <typename Request>
Request OfZones(const Design& design) {
  Request request;
  *request.mutable_brief() = design.brief;
  *request.mutable_room() = design.room.room();
  *request.mutable_zone_plan() = design.zones.zone_plan();
  return request;
}

template <typename Request>
Request OfObjects(const Design& design) {
  Request request = OfZones<Request>(design);
  *request.mutable_object_list() = design.objects.object_list();
  return request;
}

v1::CleanConstraintsRequest CleanOf(const Design& design) {
  v1::CleanConstraintsRequest request;
  *request.mutable_room() = design.room.room();
  *request.mutable_object_list() = design.objects.object_list();
  *request.mutable_constraint_list() = design.constraints.constraint_list();
  return request;
}

// Asks for one step; whether it was answered.
bool Take(Target& target, const google::protobuf::Message& request, google::protobuf::Message& answer, Design& design) {
  design.sent = fmt::format("{} for \"{}\"", RpcName(request), design.brief.text());
  design.status = target.AskInto(request, answer);
  if (!design.status.ok()) return false;
  ++design.steps_done;
  return true;
}

void Run(Target& target, Design& design) {
  [[maybe_unused]] const bool done =
      Take(target, DescribeRoomOf(design.brief), design.room, design) &&
      Take(target, PlanZonesOf(design.brief, design.room.room()), design.zones, design) &&
      Take(target, OfZones<v1::ListObjectsRequest>(design), design.objects, design) &&
      Take(target, OfObjects<v1::ChooseStyleRequest>(design), design.style, design) &&
      Take(target, OfObjects<v1::ListConstraintsRequest>(design), design.constraints, design) &&
      Take(target, CleanOf(design), design.cleaned, design);
}

// A step of the design: `judge` says whether its answer validates.
struct Step {
  const char* rpc;
  const char* right;
  absl::Status (*judge)(const Design&);
  const v1::Producer& (*producer)(const Design&);
};

const Step kSteps[kStepCount] = {
    {"DescribeRoom", "a room: a simple floor in metres, counter-clockwise from (0, 0), with walls and a door that fit",
     [](const Design& d) { return Validate(d.room.room()); },
     [](const Design& d) -> const v1::Producer& { return d.room.producer(); }},
    {"PlanZones", "one zone at least, with unique ids", [](const Design& d) { return Validate(d.zones.zone_plan()); },
     [](const Design& d) -> const v1::Producer& { return d.zones.producer(); }},
    {"ListObjects", "objects with unique ids, sizes in metres and zones of the plan",
     [](const Design& d) { return Validate(d.objects.object_list(), d.zones.zone_plan()); },
     [](const Design& d) -> const v1::Producer& { return d.objects.producer(); }},
    {"ChooseStyle", "a style sheet about these objects and openings",
     [](const Design& d) { return Validate(d.style.style_sheet(), d.room.room(), d.objects.object_list()); },
     [](const Design& d) -> const v1::Producer& { return d.style.producer(); }},
    {"ListConstraints", "sentences with unique ids about these objects",
     [](const Design& d) { return Validate(d.constraints.constraint_list(), d.objects.object_list()); },
     [](const Design& d) -> const v1::Producer& { return d.constraints.producer(); }},
    {"CleanConstraints", "sentences with unique ids about these objects",
     [](const Design& d) { return Validate(d.cleaned.constraint_list(), d.objects.object_list()); },
     [](const Design& d) -> const v1::Producer& { return d.cleaned.producer(); }},
};

void AddSteps(Checks& checks) {
  auto design = std::make_shared<Design>();
  for (int i = 0; i < kStepCount; ++i) {
    const Step& step = kSteps[i];
    checks.push_back({fmt::format("{} answers something valid that says who made it", step.rpc), Promise::kMessages,
                      [design, i, &step](Target& target) {
                        if (design->steps_done == 0 && design->status.ok()) Run(target, *design);
                        if (design->steps_done < i) return Skipped(fmt::format("{} had no answer", design->sent));
                        const std::string sent = fmt::format("{} for \"{}\"", step.rpc, design->brief.text());
                        if (design->steps_done == i) return Broken(sent, StatusText(design->status), "an answer");
                        const absl::Status valid = step.judge(*design);
                        if (!valid.ok()) return Broken(sent, std::string(valid.message()), step.right);
                        const v1::Producer& producer = step.producer(*design);
                        if (!producer.program().empty() && !producer.method().empty()) return Kept();
                        return Broken(sent, "a producer without program or method", "both set");
                      }});
  }
}

bool SameMessage(const google::protobuf::Message& a, const google::protobuf::Message& b) {
  return google::protobuf::util::MessageDifferencer::Equals(a, b);
}

// A brief that brings its own room, zones, objects and sentences.
v1::Brief BriefWithAll() {
  const v1::LayoutGraph graph = BedroomGraph();
  v1::Brief brief = BedroomBrief();
  *brief.mutable_room() = graph.room();
  *brief.mutable_zone_plan() = graph.zone_plan();
  *brief.mutable_object_list() = graph.object_list();
  *brief.mutable_constraint_list() = graph.constraint_list();
  return brief;
}

Finding KeepsAGivenRoom(Target& target) {
  const v1::Brief brief = BriefWithAll();
  const std::string sent = "DescribeRoom of a brief with a room of its own";
  return Given<v1::DescribeRoomResponse>(
      target, sent, DescribeRoomOf(brief), [&](const v1::DescribeRoomResponse& answer) {
        const bool kept = SameMessage(answer.room().floor(), brief.room().floor()) &&
                          answer.room().openings_size() == brief.room().openings_size();
        return kept ? Kept() : Broken(sent, "another room", "the floor and the openings of the brief");
      });
}

Finding KeepsGivenZones(Target& target) {
  const v1::Brief brief = BriefWithAll();
  const std::string sent = "PlanZones of a brief with zones of its own";
  return Given<v1::PlanZonesResponse>(
      target, sent, PlanZonesOf(brief, brief.room()), [&](const v1::PlanZonesResponse& answer) {
        const bool kept =
            answer.zone_plan().zones_size() == 1 && answer.zone_plan().zones(0).id() == brief.zone_plan().zones(0).id();
        return kept ? Kept()
                    : Broken(sent, fmt::format("{} zones", answer.zone_plan().zones_size()), "the zones of the brief");
      });
}

Design DesignOf(const v1::Brief& brief) {
  Design design;
  design.brief = brief;
  *design.room.mutable_room() = BedroomGraph().room();
  *design.zones.mutable_zone_plan() = BedroomGraph().zone_plan();
  *design.objects.mutable_object_list() = BedroomGraph().object_list();
  *design.constraints.mutable_constraint_list() = BedroomGraph().constraint_list();
  return design;
}

Finding KeepsGivenObjects(Target& target) {
  const Design design = DesignOf(BriefWithAll());
  const std::string sent = "ListObjects of a brief with objects of its own";
  return Given<v1::ListObjectsResponse>(
      target, sent, OfZones<v1::ListObjectsRequest>(design), [&](const v1::ListObjectsResponse& answer) {
        const auto& wanted = design.brief.object_list().objects();
        const auto& got = answer.object_list().objects();
        bool kept = got.size() == wanted.size();
        for (int i = 0; kept && i < got.size(); ++i) {
          kept = got[i].id() == wanted[i].id() && got[i].width_m() == wanted[i].width_m();
        }
        return kept ? Kept()
                    : Broken(sent, fmt::format("{} objects, not the same", got.size()), "the objects of the brief");
      });
}

Finding KeepsGivenSentences(Target& target) {
  const Design design = DesignOf(BriefWithAll());
  const std::string sent = "ListConstraints of a brief with sentences of its own";
  return Given<v1::ListConstraintsResponse>(
      target, sent, OfObjects<v1::ListConstraintsRequest>(design), [&](const v1::ListConstraintsResponse& answer) {
        const auto& wanted = design.brief.constraint_list().sentences();
        const auto& got = answer.constraint_list().sentences();
        bool kept = got.size() >= wanted.size();
        for (int i = 0; kept && i < wanted.size(); ++i) kept = got[i].text() == wanted[i].text();
        return kept ? Kept()
                    : Broken(sent, fmt::format("{} sentences, not the same", got.size()), "the sentences of the brief");
      });
}

template <typename Request>
std::vector<Fault<Request>> BriefFaults() {
  return {
      {"a brief without text", "brief.text", [](Request& request) { request.mutable_brief()->set_text("  "); }},
      {"a brief of more than 4000 characters", "brief.text",
       [](Request& request) { request.mutable_brief()->set_text(std::string(4001, 'a')); }},
      {"a brief with a control character", "brief.text",
       [](Request& request) { request.mutable_brief()->set_text("A bed\x01room."); }},
      {"a seed below zero", "brief.seed", [](Request& request) { request.mutable_brief()->set_seed(-1); }},
  };
}

template <typename Request>
Fault<Request> RoomFault() {
  return {"a room whose height is no number", "room.height_m",
          [](Request& request) { request.mutable_room()->set_height_m(std::numeric_limits<double>::quiet_NaN()); }};
}

template <typename Request>
Fault<Request> ObjectFault() {
  return {"two objects of one id", "objects[1].id",
          [](Request& request) { request.mutable_object_list()->mutable_objects(1)->set_id("bed"); }};
}

void AddLanguageRefusals(Checks& checks) {
  const Design design = DesignOf(BedroomBrief());
  AddRefusals<v1::DescribeRoomResponse>(DescribeRoomOf(design.brief), BriefFaults<v1::DescribeRoomRequest>(), checks);
  AddRefusals<v1::PlanZonesResponse, v1::PlanZonesRequest>(PlanZonesOf(design.brief, design.room.room()),
                                                           {RoomFault<v1::PlanZonesRequest>()}, checks);
  AddRefusals<v1::ListObjectsResponse, v1::ListObjectsRequest>(
      OfZones<v1::ListObjectsRequest>(design),
      {RoomFault<v1::ListObjectsRequest>(),
       {"no zones", "zone_plan", [](v1::ListObjectsRequest& request) { request.clear_zone_plan(); }}},
      checks);
  AddRefusals<v1::ChooseStyleResponse, v1::ChooseStyleRequest>(OfObjects<v1::ChooseStyleRequest>(design),
                                                               {ObjectFault<v1::ChooseStyleRequest>()}, checks);
  AddRefusals<v1::ListConstraintsResponse, v1::ListConstraintsRequest>(
      OfObjects<v1::ListConstraintsRequest>(design), {ObjectFault<v1::ListConstraintsRequest>()}, checks);
  AddRefusals<v1::CleanConstraintsResponse, v1::CleanConstraintsRequest>(
      CleanOf(design),
      {ObjectFault<v1::CleanConstraintsRequest>(),
       {"a sentence about an object that is not there", "sentences[0].subject_ids[0]",
        [](v1::CleanConstraintsRequest& request) {
          request.mutable_constraint_list()->mutable_sentences(0)->set_subject_ids(0, "ghost");
        }},
       {"two sentences of one id", "sentences[1].id",
        [](v1::CleanConstraintsRequest& request) {
          request.mutable_constraint_list()->mutable_sentences(1)->set_id("s1");
        }}},
      checks);
}

}  // namespace

Sample LanguageSample() {
  const auto request = std::make_shared<v1::DescribeRoomRequest>(DescribeRoomOf(BedroomBrief()));
  return {.what = "DescribeRoom of \"A bedroom that is 4m x 5m.\"",
          .request = request,
          .fault =
              [](const std::string& bytes) {
                v1::DescribeRoomResponse answer;
                if (!answer.ParseFromString(bytes)) return std::string("bytes that are no DescribeRoomResponse");
                return std::string(Validate(answer.room()).message());
              },
          .core = [](const std::string& bytes) { return bytes; },
          .long_requests = {request}};
}

void AddLanguageChecks(Checks& checks) {
  AddSteps(checks);
  checks.push_back({"A room that the brief brings is kept", Promise::kMessages, KeepsAGivenRoom});
  checks.push_back({"Zones that the brief brings are kept", Promise::kMessages, KeepsGivenZones});
  checks.push_back({"Objects that the brief brings are kept", Promise::kMessages, KeepsGivenObjects});
  checks.push_back({"Sentences that the brief brings are kept", Promise::kMessages, KeepsGivenSentences});
  AddLanguageRefusals(checks);
}

}  // namespace flair::contract
