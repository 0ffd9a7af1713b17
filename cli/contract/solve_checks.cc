// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: what comes of a problem that every optimizer can solve, whatever its library.
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/optimizer_service.pb.h"
#include "room/validation/validate.h"

namespace flair::contract {
namespace {

constexpr int kManyObjects = 60;
constexpr int kFarTooManyObjects = 240;

// The bedroom with so many beds: hard, and never good.
v1::SolveRequest Crowd(int object_count) {
  v1::SolveRequest request = BedroomSolve();
  v1::ObjectList& list = *request.mutable_layout_graph()->mutable_object_list();
  for (int i = 0; list.objects_size() < object_count; ++i) {
    v1::Object& object = *list.add_objects();
    object = list.objects(0);
    object.set_id(fmt::format("piece_{}", i));
  }
  request.mutable_options()->set_thread_count(1);
  return request;
}

// What is wrong with a layout as an answer to the request; empty when nothing is.
std::string LayoutFault(const v1::SolveRequest& request, const v1::SolvedLayout& layout) {
  if (const absl::Status status = Validate(layout); !status.ok()) return std::string(status.message());
  for (const v1::Object& object : request.layout_graph().object_list().objects()) {
    const auto is_it = [&object](const v1::Placement& placement) { return placement.object_id() == object.id(); };
    if (std::ranges::none_of(layout.placements(), is_it)) {
      return fmt::format("solved_layout.placements: \"{}\" is not among them", object.id());
    }
  }
  return "";
}

constexpr char kRightLayout[] = "a valid layout in which every object is placed once";

Finding PlacesEveryObject(Target& target) {
  const v1::SolveRequest request = BedroomSolve();
  return Given<v1::SolveResponse>(target, kBedroomSolve, request, [&](const v1::SolveResponse& answer) {
    const std::string fault = LayoutFault(request, answer.solved_layout());
    return fault.empty() ? Kept() : Broken(kBedroomSolve, fault, kRightLayout);
  });
}

Finding NamesItsProducer(Target& target) {
  return Given<v1::SolveResponse>(target, kBedroomSolve, BedroomSolve(), [](const v1::SolveResponse& answer) {
    if (!answer.producer().program().empty() && !answer.producer().method().empty()) return Kept();
    return Broken(kBedroomSolve, fmt::format("producer: {{ {} }}", answer.producer().ShortDebugString()),
                  "a producer whose program and method are set, as artifacts say where they come from");
  });
}

Finding GivesTheProblemBack(Target& target) {
  const v1::SolveRequest request = BedroomSolve();
  return Given<v1::SolveResponse>(target, kBedroomSolve, request, [&](const v1::SolveResponse& answer) {
    google::protobuf::util::MessageDifferencer differencer;
    std::string difference;
    differencer.ReportDifferencesToString(&difference);
    if (differencer.Compare(request.layout_graph(), answer.solved_layout().graph())) return Kept();
    return Broken(kBedroomSolve, "solved_layout.graph differs: " + difference.substr(0, 200),
                  "the graph that was sent, unchanged");
  });
}

Finding KeepsPins(Target& target) {
  v1::SolveRequest request = BedroomSolve();
  v1::Placement& pin = *request.mutable_layout_graph()->add_pinned_placements();
  pin.set_object_id("bed");
  pin.set_x_m(2.25);
  pin.set_y_m(2.5);
  pin.set_theta_rad(0.75);
  const std::string sent = "Solve with the bed pinned at (2.25, 2.5), heading 0.75";
  return Given<v1::SolveResponse>(target, sent, request, [&](const v1::SolveResponse& answer) {
    for (const v1::Placement& placed : answer.solved_layout().placements()) {
      if (placed.object_id() != "bed") continue;
      if (placed.x_m() == 2.25 && placed.y_m() == 2.5 && placed.theta_rad() == 0.75) return Kept();
      return Broken(sent, placed.ShortDebugString(), "the very numbers of the pin");
    }
    return Broken(sent, "no placement of the bed", "the very numbers of the pin");
  });
}

// One outcome for each edge of the request, in order, each DROPPED with a reason.
Finding DropsEdges(Target& target, const v1::SolveRequest& request, const std::string& sent) {
  const std::string right =
      "an answer with one outcome for each edge, in their order, OUTCOME_STATUS_DROPPED with a reason";
  return Given<v1::SolveResponse>(target, sent, request, [&](const v1::SolveResponse& answer) {
    const auto& outcomes = answer.solved_layout().edge_outcomes();
    if (outcomes.size() != request.layout_graph().edges_size()) {
      return Broken(sent, fmt::format("{} outcomes", outcomes.size()), right);
    }
    for (int i = 0; i < outcomes.size(); ++i) {
      const bool dropped = outcomes[i].status() == v1::OUTCOME_STATUS_DROPPED && !outcomes[i].reason().empty();
      if (!dropped || outcomes[i].edge_id() != request.layout_graph().edges(i).id()) {
        return Broken(sent, fmt::format("edge_outcomes[{}]: {{ {} }}", i, outcomes[i].ShortDebugString()), right);
      }
    }
    return Kept();
  });
}

Finding DropsUnknownTypes(Target& target) {
  v1::SolveRequest request = BedroomSolve();
  for (const char* id : {"e7", "e2"}) {
    *request.mutable_layout_graph()->add_edges() = EdgeOn("surely_no_such_type", "object", "bed");
    request.mutable_layout_graph()->mutable_edges()->rbegin()->set_id(id);
  }
  return DropsEdges(target, request, "Solve with two edges of type \"surely_no_such_type\"");
}

// A type of the server's own that takes one object, and the name of that parameter; empty when it has none.
absl::StatusOr<std::pair<std::string, std::string>> TypeOfOneObject(Target& target) {
  const auto catalog = target.Ask<v1::ListConstraintTypesResponse>(v1::ListConstraintTypesRequest());
  if (!catalog.ok()) return catalog.status();
  for (const v1::ConstraintType& type : catalog->catalog().types()) {
    if (type.built_in() || type.parameters().empty()) continue;
    if (type.parameters(0).kind() == v1::PARAMETER_KIND_OBJECT)
      return std::pair(type.name(), type.parameters(0).name());
  }
  return std::pair(std::string(), std::string());
}

Finding DropsBadCalls(Target& target, const std::string& what, void (*spoil)(v1::ConstraintEdge&)) {
  const auto type = TypeOfOneObject(target);
  if (!type.ok()) return Broken("ListConstraintTypes", StatusText(type.status()), "a catalogue");
  if (type->first.empty()) return Skipped("no type of its catalogue takes an object first");
  v1::SolveRequest request = BedroomSolve();
  v1::ConstraintEdge& edge = *request.mutable_layout_graph()->add_edges();
  edge = EdgeOn(type->first, type->second, "bed");
  spoil(edge);
  return DropsEdges(target, request, fmt::format("Solve with an edge {} {}", type->first, what));
}

Finding DropsUnknownOperands(Target& target) {
  return DropsBadCalls(target, "of an object \"ghost\" that is not there",
                       [](v1::ConstraintEdge& edge) { edge.mutable_arguments(0)->mutable_value()->set_text("ghost"); });
}

Finding DropsUnknownParameters(Target& target) {
  return DropsBadCalls(target, "with an argument \"no_such_parameter\"", [](v1::ConstraintEdge& edge) {
    v1::Argument& argument = *edge.add_arguments();
    argument.set_name("no_such_parameter");
    argument.mutable_value()->set_number(1);
  });
}

// Says that time was short, in one of the two ways.
bool SaysThatTimeWasShort(const v1::SolvedLayout& layout) {
  return std::ranges::any_of(layout.stage_outcomes(), &v1::StageOutcome::stopped_early) ||
         std::ranges::any_of(layout.diagnostics(),
                             [](const v1::Diagnostic& diagnostic) { return diagnostic.code() == "time_limit"; });
}

Finding ObeysATimeLimit(Target& target) {
  v1::SolveRequest request = Crowd(kManyObjects);
  request.mutable_options()->mutable_time_limit()->set_nanos(1000000);
  const std::string sent = fmt::format("Solve of {} beds with options.time_limit 1 ms", kManyObjects);
  return Given<v1::SolveResponse>(target, sent, request, [&](const v1::SolveResponse& answer) {
    const std::string fault = LayoutFault(request, answer.solved_layout());
    if (!fault.empty()) return Broken(sent, fault, kRightLayout);
    if (SaysThatTimeWasShort(answer.solved_layout())) return Kept();
    return Broken(sent, "a layout that does not say that time was short",
                  "stage_outcomes with stopped_early, as such a layout depends on the machine");
  });
}

Finding ThreadsChangeNothing(Target& target) {
  v1::SolveRequest request = BedroomSolve();
  std::vector<std::string> layouts;
  for (const int threads : {1, 4}) {
    request.set_request_id(target.NewRequestId());
    request.mutable_options()->set_thread_count(threads);
    const auto answer = target.Ask<v1::SolveResponse>(request);
    if (!answer.ok()) return Broken(kBedroomSolve, StatusText(answer.status()), "an answer");
    layouts.push_back(answer->solved_layout().SerializeAsString());
  }
  if (layouts[0] == layouts[1]) return Kept();
  return Broken("Solve of a small bedroom with options.thread_count 1 and 4", "layouts that differ",
                "the same bytes: threads never change a result");
}

}  // namespace

Sample SolveSample() {
  const v1::SolveRequest bedroom = BedroomSolve();
  v1::SolveRequest crowd = Crowd(kFarTooManyObjects);
  crowd.mutable_options()->set_max_restart_count(1);
  v1::SolveRequest restarts = BedroomSolve();
  restarts.mutable_options()->set_thread_count(1);
  restarts.mutable_options()->set_max_restart_count(10000);
  return {.what = kBedroomSolve,
          .request = std::make_shared<v1::SolveRequest>(bedroom),
          .fault =
              [bedroom](const std::string& bytes) {
                v1::SolveResponse answer;
                if (!answer.ParseFromString(bytes)) return std::string("bytes that are no SolveResponse");
                return LayoutFault(bedroom, answer.solved_layout());
              },
          .core =
              [](const std::string& bytes) {
                v1::SolveResponse answer;
                answer.ParseFromString(bytes);
                return answer.solved_layout().SerializeAsString();
              },
          .long_requests = {std::make_shared<v1::SolveRequest>(crowd), std::make_shared<v1::SolveRequest>(restarts)}};
}

void AddSolveChecks(Checks& checks) {
  checks.push_back({"Solve places every object once, in a valid layout", Promise::kMessages, PlacesEveryObject});
  checks.push_back({"Solve gives the problem back as it was sent", Promise::kMessages, GivesTheProblemBack});
  checks.push_back({"Solve says who solved it", Promise::kMessages, NamesItsProducer});
  checks.push_back({"Pinned objects stay where they are", Promise::kMessages, KeepsPins});
  checks.push_back(
      {"Edges of no known type are dropped with a reason, in order", Promise::kMessages, DropsUnknownTypes});
  checks.push_back(
      {"An edge on an object that is not there is dropped with a reason", Promise::kMessages, DropsUnknownOperands});
  checks.push_back({"An edge with an argument that its type does not have is dropped with a reason", Promise::kMessages,
                    DropsUnknownParameters});
  checks.push_back({"A time limit gives the best layout so far, which says so", Promise::kMessages, ObeysATimeLimit});
  checks.push_back(
      {"Threads do not change a layout", Promise::kRepetition, ThreadsChangeNothing, v1::CAPABILITY_DETERMINISTIC});
}

}  // namespace flair::contract
