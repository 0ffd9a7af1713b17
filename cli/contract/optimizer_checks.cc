// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: what comes of a problem that every optimizer can solve, whatever its library; and what optimizers claim
// beside.
#include <google/protobuf/util/message_differencer.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/contract/bedroom.h"
#include "cli/contract/stage_checks.h"
#include "evaluation/metrics/layout_metrics.h"
#include "flair/v1/optimizer_service.pb.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::contract {
namespace {

constexpr int kManyObjects = 60;
constexpr int kFarTooManyObjects = 240;
constexpr int kRestarts = 5;
constexpr int kVariants = 3;
constexpr char kNoSuchType[] = "surely_no_such_type";

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

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& object_id) {
  const auto found = std::ranges::find(layout.placements(), object_id, &v1::Placement::object_id);
  return found == layout.placements().end() ? nullptr : &*found;
}

// What is wrong with a layout as an answer to the request; empty when nothing is.
std::string LayoutFault(const v1::SolveRequest& request, const v1::SolvedLayout& layout) {
  if (const absl::Status status = Validate(layout); !status.ok()) return std::string(status.message());
  for (const v1::Object& object : request.layout_graph().object_list().objects()) {
    if (PlacementOf(layout, object.id()) == nullptr) {
      return fmt::format("solved_layout.placements: \"{}\" is not among them", object.id());
    }
  }
  return "";
}

Finding PlacesEveryObject(const v1::SolveResponse& answer) {
  return WrongIf(LayoutFault(BedroomSolve(), answer.solved_layout()));
}

Finding GivesTheProblemBack(const v1::SolveResponse& answer) {
  google::protobuf::util::MessageDifferencer differencer;
  std::string difference;
  differencer.ReportDifferencesToString(&difference);
  if (differencer.Compare(BedroomGraph(), answer.solved_layout().graph())) return Kept();
  return Wrong("solved_layout.graph differs: " + difference.substr(0, 200));
}

v1::SolveRequest SolveWithAPin() {
  v1::SolveRequest request = BedroomSolve();
  v1::Placement& pin = *request.mutable_layout_graph()->add_pinned_placements();
  pin.set_object_id("bed");
  pin.set_x_m(2.25);
  pin.set_y_m(2.5);
  pin.set_theta_rad(0.75);
  return request;
}

Finding KeepsThePin(const v1::SolveResponse& answer) {
  const v1::Placement* const bed = PlacementOf(answer.solved_layout(), "bed");
  if (bed == nullptr) return Wrong("no placement of the bed");
  const bool kept = bed->x_m() == 2.25 && bed->y_m() == 2.5 && bed->theta_rad() == 0.75;
  return kept ? Kept() : Wrong(bed->ShortDebugString());
}

// One outcome for each edge of the request, in order, each DROPPED with a reason.
Finding DropsEdges(Target& target, const v1::SolveRequest& request) {
  ASSIGN_OR_RETURN(const v1::SolveResponse answer, target.Ask<v1::SolveResponse>(request));
  const auto& outcomes = answer.solved_layout().edge_outcomes();
  if (outcomes.size() != request.layout_graph().edges_size()) return Wrong(fmt::format("{} outcomes", outcomes.size()));
  for (int i = 0; i < outcomes.size(); ++i) {
    const bool dropped = outcomes[i].status() == v1::OUTCOME_STATUS_DROPPED && !outcomes[i].reason().empty();
    if (dropped && outcomes[i].edge_id() == request.layout_graph().edges(i).id()) continue;
    return Wrong(fmt::format("edge_outcomes[{}]: {{ {} }}", i, outcomes[i].ShortDebugString()));
  }
  return Kept();
}

Finding DropsUnknownTypes(Target& target) {
  v1::SolveRequest request = BedroomSolve();
  for (const char* id : {"e7", "e2"}) {
    v1::ConstraintEdge& edge = *request.mutable_layout_graph()->add_edges();
    edge = EdgeOn(kNoSuchType, "object", "bed");
    edge.set_id(id);
  }
  return DropsEdges(target, request);
}

// Sends a call of a type of the server's own that takes an object first, once it is spoiled.
std::function<Finding(Target&)> DropsCall(void (*spoil)(v1::ConstraintEdge&)) {
  return [spoil](Target& target) -> Finding {
    ASSIGN_OR_RETURN(const auto catalog, target.Ask<v1::ListConstraintTypesResponse>(v1::ListConstraintTypesRequest()));
    const auto type = std::ranges::find_if(catalog.catalog().types(), [](const v1::ConstraintType& each) {
      return !each.built_in() && !each.parameters().empty() && each.parameters(0).kind() == v1::PARAMETER_KIND_OBJECT;
    });
    if (type == catalog.catalog().types().end()) return Skipped("no type of its catalogue takes an object first");
    v1::SolveRequest request = BedroomSolve();
    v1::ConstraintEdge& edge = *request.mutable_layout_graph()->add_edges();
    edge = EdgeOn(type->name(), type->parameters(0).name(), "bed");
    spoil(edge);
    return DropsEdges(target, request);
  };
}

void NameAGhost(v1::ConstraintEdge& edge) { edge.mutable_arguments(0)->mutable_value()->set_text("ghost"); }

void AddAnArgument(v1::ConstraintEdge& edge) {
  v1::Argument& argument = *edge.add_arguments();
  argument.set_name("no_such_parameter");
  argument.mutable_value()->set_number(1);
}

v1::SolveRequest CrowdInNoTime() {
  v1::SolveRequest request = Crowd(kManyObjects);
  request.mutable_options()->mutable_time_limit()->set_nanos(1000000);
  return request;
}

// Time was short, and the layout says so in one of the two ways.
Finding SaysThatTimeWasShort(const v1::SolveResponse& answer) {
  const v1::SolvedLayout& layout = answer.solved_layout();
  if (const std::string fault = LayoutFault(CrowdInNoTime(), layout); !fault.empty()) return Wrong(fault);
  const bool said =
      std::ranges::any_of(layout.stage_outcomes(), &v1::StageOutcome::stopped_early) ||
      std::ranges::find(layout.diagnostics(), "time_limit", &v1::Diagnostic::code) != layout.diagnostics().end();
  return said ? Kept() : Wrong("a layout that does not say that time was short");
}

Finding ThreadsChangeNothing(Target& target) {
  v1::SolveRequest request = BedroomSolve();
  std::vector<std::string> layouts;
  for (const int threads : {1, 4}) {
    request.set_request_id(target.NewRequestId());
    request.mutable_options()->set_thread_count(threads);
    ASSIGN_OR_RETURN(const v1::SolveResponse answer, target.Ask<v1::SolveResponse>(request));
    layouts.push_back(answer.solved_layout().SerializeAsString());
  }
  return layouts[0] == layouts[1] ? Kept() : Wrong("layouts that differ");
}

Finding StandsOnTheFloor(const v1::SolveResponse& answer) {
  for (const v1::Placement& placement : answer.solved_layout().placements()) {
    if (placement.z_m() != 0) return Wrong(fmt::format("\"{}\" at z_m {}", placement.object_id(), placement.z_m()));
  }
  return Kept();
}

// A bench that fits a corridor in one direction only. A server that measures otherwise puts it through the walls.
std::function<Finding(Target&)> FitsTheCorridor(const std::string& room) {
  v1::SolveRequest request;
  *request.mutable_layout_graph() =
      GraphFromText(room + "; zone hall; bench 2.4x0.5 at 1,1,0 primary zone hall height 0.5");
  return Answered<v1::SolveResponse>(request, [request](const v1::SolveResponse& answer) -> Finding {
    constexpr double kOutsidePercent = 1;
    v1::SolvedLayout layout = answer.solved_layout();
    *layout.mutable_graph() = request.layout_graph();
    const absl::StatusOr<v1::LayoutMetrics> metrics = evaluation::MeasureLayout(layout);
    if (!metrics.ok()) return Wrong(std::string(metrics.status().message()));
    if (metrics->oob_percent() <= kOutsidePercent) return Kept();
    const bool told = std::ranges::any_of(layout.diagnostics(), [](const v1::Diagnostic& diagnostic) {
      return diagnostic.subject_id() == "bench" || diagnostic.message().find("bench") != std::string::npos;
    });
    if (told) return Skipped("a diagnostic says that the bench has no good place");
    const v1::Placement* const bench = PlacementOf(layout, "bench");
    return Wrong(fmt::format("{{ {} }}, which is outside the room by {:.1f} % of its area",
                             bench == nullptr ? "no placement" : bench->ShortDebugString(), metrics->oob_percent()));
  });
}

// 1.6 m x 0.5 m of the bed is south of the room of 20 m2.
constexpr double kOutsidePercent = 100 * 1.6 * 0.5 / 20;

Finding MeasuresWhatIsOutside(const v1::EvaluateResponse& answer) {
  if (!answer.has_metrics()) return Skipped("Evaluate gives no metrics");
  if (std::abs(answer.metrics().oob_percent() - kOutsidePercent) < 1e-6) return Kept();
  return Wrong(fmt::format("metrics.oob_percent {}", answer.metrics().oob_percent()));
}

v1::EvaluateRequest EvaluateOfNoType() {
  v1::EvaluateRequest request = BedroomEvaluate();
  *request.mutable_layout_graph()->add_edges() = EdgeOn(kNoSuchType, "object", "nightstand");
  return request;
}

Finding DropsTheOnlyEdge(const v1::EvaluateResponse& answer) {
  if (answer.edge_outcomes_size() != 1) return Wrong(fmt::format("{} outcomes", answer.edge_outcomes_size()));
  const v1::EdgeOutcome& outcome = answer.edge_outcomes(0);
  const bool dropped = outcome.status() == v1::OUTCOME_STATUS_DROPPED && !outcome.reason().empty();
  return dropped ? Kept() : Wrong(outcome.ShortDebugString());
}

bool Contains(const google::protobuf::RepeatedPtrField<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

// What is wrong with the answer after the bed was moved to (2, 2); empty when nothing is.
std::string MoveFault(const v1::SolvedLayout& before, const v1::ResolveResponse& answer) {
  const v1::SolvedLayout& after = answer.solved_layout();
  if (const absl::Status status = Validate(after); !status.ok()) return std::string(status.message());
  const v1::Placement* const bed = PlacementOf(after, "bed");
  if (bed == nullptr || bed->x_m() != 2 || bed->y_m() != 2) return "the bed is not at (2, 2)";
  if (after.graph().pinned_placements_size() != 1) {
    return fmt::format("{} pinned_placements in its graph", after.graph().pinned_placements_size());
  }
  if (!Contains(answer.moved_object_ids(), "bed")) return "moved_object_ids without the bed";
  const v1::Placement* const old = PlacementOf(before, "nightstand");
  const v1::Placement* const now = PlacementOf(after, "nightstand");
  if (old == nullptr || now == nullptr) return "no placement of the nightstand";
  const bool moved = old->SerializeAsString() != now->SerializeAsString();
  if (moved == Contains(answer.moved_object_ids(), "nightstand")) return "";
  return fmt::format("a nightstand that was {}moved, and moved_object_ids that say otherwise", moved ? "" : "not ");
}

Finding MovesWhatItSays(Target& target) {
  ASSIGN_OR_RETURN(const v1::SolveResponse solved, target.Ask<v1::SolveResponse>(BedroomSolve()));
  v1::ResolveRequest request;
  request.set_request_id(target.NewRequestId());
  *request.mutable_solved_layout() = solved.solved_layout();
  v1::Placement& bed = *request.add_edits()->mutable_move_object();
  bed.set_object_id("bed");
  bed.set_x_m(2);
  bed.set_y_m(2);
  ASSIGN_OR_RETURN(const v1::ResolveResponse answer, target.Ask<v1::ResolveResponse>(request));
  return WrongIf(MoveFault(solved.solved_layout(), answer));
}

Finding RefusesEditsOfGhosts(Target& target) {
  ASSIGN_OR_RETURN(const v1::SolveResponse solved, target.Ask<v1::SolveResponse>(BedroomSolve()));
  v1::ResolveRequest request;
  *request.mutable_solved_layout() = solved.solved_layout();
  request.add_edits()->set_pin_object_id("ghost");
  const absl::Status status = target.AskForBytes(request).status();
  if (status.ok()) return Wrong("OK, with an answer");
  const bool named = status.message().find("edits[0]") != std::string::npos;
  return absl::IsInvalidArgument(status) && named ? Kept() : Finding(status);
}

v1::SolveRequest SolveForVariants() {
  v1::SolveRequest request = BedroomSolve();
  request.mutable_options()->set_variant_count(kVariants);
  return request;
}

// A room may have but one good layout; this one has many.
Finding VariantsAreComplete(const v1::SolveResponse& answer) {
  const v1::SolvedLayout& layout = answer.solved_layout();
  if (const absl::Status status = Validate(layout); !status.ok()) return Wrong(std::string(status.message()));
  if (layout.runner_ups().empty() || layout.runner_ups_size() > kVariants - 1) {
    return Wrong(fmt::format("{} runner_ups", layout.runner_ups_size()));
  }
  for (const v1::RunnerUp& runner_up : layout.runner_ups()) {
    if (runner_up.placements_size() == layout.placements_size()) continue;
    return Wrong(fmt::format("a runner-up with {} placements", runner_up.placements_size()));
  }
  return Kept();
}

// The outcomes' bytes, or what is wrong with them.
absl::StatusOr<std::string> OutcomesOf(Target& target, int first, int count) {
  ASSIGN_OR_RETURN(const v1::SolveRestartsResponse answer,
                   target.Ask<v1::SolveRestartsResponse>(BedroomRestarts(first, count)));
  if (answer.outcomes_size() != count) {
    return absl::InternalError(fmt::format("{} outcomes of {} restarts", answer.outcomes_size(), count));
  }
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    if (answer.outcomes(i).restart() != first + i) {
      return absl::InternalError(fmt::format("restart {} in place {}", answer.outcomes(i).restart(), first + i));
    }
    bytes += answer.outcomes(i).SerializeAsString();
  }
  return bytes;
}

// Restarts are a pure function of their numbers, which lets a solve be spread over several servers.
Finding CutsDoNotMatter(Target& target) {
  ASSIGN_OR_RETURN(const std::string whole, OutcomesOf(target, 0, kRestarts));
  std::string pieces;
  for (const auto& [first, count] : {std::pair(0, 1), std::pair(1, 3), std::pair(4, 1)}) {
    ASSIGN_OR_RETURN(const std::string piece, OutcomesOf(target, first, count));
    pieces += piece;
  }
  return pieces == whole ? Kept() : Wrong("outcomes that differ");
}

}  // namespace

Sample SolveSample() {
  auto crowd = std::make_shared<v1::SolveRequest>(Crowd(kFarTooManyObjects));
  crowd->mutable_options()->set_max_restart_count(1);
  auto restarts = std::make_shared<v1::SolveRequest>(BedroomSolve());
  restarts->mutable_options()->set_thread_count(1);
  restarts->mutable_options()->set_max_restart_count(10000);
  return {.what = kBedroomSolve,
          .request = std::make_shared<v1::SolveRequest>(BedroomSolve()),
          .fault = FaultOf<v1::SolveResponse>(
              [](const v1::SolveResponse& answer) { return LayoutFault(BedroomSolve(), answer.solved_layout()); }),
          .core =
              [](const std::string& bytes) {
                v1::SolveResponse answer;
                answer.ParseFromString(bytes);
                return answer.solved_layout().SerializeAsString();
              },
          .long_requests = {crowd, restarts}};
}

Checks SolveChecks() {
  using Response = v1::SolveResponse;
  const std::string dropped =
      "an answer with one outcome for each edge, in their order, OUTCOME_STATUS_DROPPED with a reason";
  return {
      {"Solve places every object once, in a valid layout", Promise::kMessages, kBedroomSolve,
       "a valid layout in which every object is placed once", Answered<Response>(BedroomSolve(), PlacesEveryObject)},
      {"Solve gives the problem back as it was sent", Promise::kMessages, kBedroomSolve,
       "the graph that was sent, unchanged", Answered<Response>(BedroomSolve(), GivesTheProblemBack)},
      {"Solve says who solved it", Promise::kMessages, kBedroomSolve,
       "a producer whose program and method are set, as artifacts say where they come from",
       Answered<Response>(BedroomSolve(),
                          [](const Response& answer) { return WrongIf(ProducerFault(answer.producer())); })},
      {"Pinned objects stay where they are", Promise::kMessages,
       "Solve with the bed pinned at (2.25, 2.5), heading 0.75", "the very numbers of the pin",
       Answered<Response>(SolveWithAPin(), KeepsThePin)},
      {"Edges of no known type are dropped with a reason, in order", Promise::kMessages,
       fmt::format("Solve with two edges of type \"{}\"", kNoSuchType), dropped, DropsUnknownTypes},
      {"An edge on an object that is not there is dropped with a reason", Promise::kMessages,
       "Solve with an edge on an object \"ghost\" that is not there", dropped, DropsCall(NameAGhost)},
      {"An edge with an argument that its type does not have is dropped with a reason", Promise::kMessages,
       "Solve with an edge with an argument \"no_such_parameter\"", dropped, DropsCall(AddAnArgument)},
      {"A time limit gives the best layout so far, which says so", Promise::kMessages,
       fmt::format("Solve of {} beds with options.time_limit 1 ms", kManyObjects),
       "a valid layout in which every object is placed once, and stage_outcomes with stopped_early, as such a layout "
       "depends on the machine",
       Answered<Response>(CrowdInNoTime(), SaysThatTimeWasShort)},
      {"Threads do not change a layout", Promise::kRepetition,
       "Solve of a small bedroom with options.thread_count 1 and 4", "the same bytes: threads never change a result",
       ThreadsChangeNothing, v1::CAPABILITY_DETERMINISTIC},
      {"What stands on the floor has its underside at 0 m", Promise::kUnits, kBedroomSolve,
       "0 for what stands on the floor: z_m is the height of the underside",
       Answered<Response>(BedroomSolve(), StandsOnTheFloor)},
      {"Headings are radians and 0 faces north: a bench fits a straight corridor", Promise::kUnits,
       "Solve of a corridor of 1.2 m (x) by 4 m (y) with a bench 2.4 m wide and 0.5 m deep",
       "theta_rad near pi/2 or 3 pi/2: at 0 an object faces north, with its width along x",
       FitsTheCorridor("1.2x4 room")},
      {"Headings turn counter-clockwise: a bench fits a slanting corridor", Promise::kUnits,
       "Solve of a corridor 1.2 m wide that runs 30 degrees counter-clockwise from the x axis, with a bench 2.4 m wide",
       "theta_rad near pi/6 or 7 pi/6 (headings turn counter-clockwise), or a diagnostic that names the bench",
       FitsTheCorridor("room 0.6,0 4.0641,2 3.4641,3.0392 0,1.0392")},
  };
}

Checks OptionalSolveChecks() {
  return {
      {"Evaluate measures what is outside the room", Promise::kUnits,
       "Evaluate of a bed of 1.6 m x 2 m at (2, 0.5), half a metre of it outside the room",
       fmt::format("{}: the bed stands on (2, 0.5) and its width is along x", kOutsidePercent),
       Answered<v1::EvaluateResponse>(BedroomEvaluate(), MeasuresWhatIsOutside), v1::CAPABILITY_EVALUATE},
      {"Evaluate drops edges of no known type with a reason", Promise::kMessages,
       fmt::format("Evaluate with an edge of type \"{}\"", kNoSuchType),
       "one outcome, OUTCOME_STATUS_DROPPED with a reason",
       Answered<v1::EvaluateResponse>(EvaluateOfNoType(), DropsTheOnlyEdge), v1::CAPABILITY_EVALUATE},
      {"Resolve puts a moved object where it is wanted and says what else moved", Promise::kMessages,
       "Resolve with the bed moved to (2, 2)",
       "a valid layout with the bed at (2, 2) and pinned, and the ids of all that moved", MovesWhatItSays,
       v1::CAPABILITY_RESOLVE},
      {"Resolve refuses an edit of an object that is not there", Promise::kErrors,
       "Resolve with a pin of an object that is not there (edits[0])",
       "INVALID_ARGUMENT with a message that names \"edits[0]\"", RefusesEditsOfGhosts, v1::CAPABILITY_RESOLVE},
      {"Variants are complete layouts, and no more than were asked for", Promise::kMessages,
       fmt::format("Solve of a small bedroom with options.variant_count {}", kVariants),
       fmt::format("a layout with at most {} runner_ups, each with a placement of every object", kVariants - 1),
       Answered<v1::SolveResponse>(SolveForVariants(), VariantsAreComplete), v1::CAPABILITY_VARIANTS},
      {"Restarts do not depend on how their range is cut", Promise::kRepetition,
       fmt::format("SolveRestarts of restarts 0 to {}, as one range and as three", kRestarts - 1),
       "one outcome for each restart, in order, with the same bytes whichever range it is in", CutsDoNotMatter,
       v1::CAPABILITY_SOLVE_RESTARTS},
  };
}

}  // namespace flair::contract
