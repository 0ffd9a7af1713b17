// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/resolve/resolve_layout.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>

#include "evaluation/metrics/measures.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/arguments.h"
#include "optimizer_worker/resolve/losses.h"
#include "optimizer_worker/resolve/warm_search.h"
#include "optimizer_worker/stages/driver.h"
#include "optimizer_worker/stages/solved_layout.h"
#include "optimizer_worker/stages/tertiary.h"
#include "room/conversion/conversion.h"
#include "room/geometry/pose.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/read_number.h"

namespace flair::optimizer {
namespace {

using PlacementList = google::protobuf::RepeatedPtrField<v1::Placement>;

// The placements of objects that the input knows.
absl::StatusOr<PartialLayout> StateOf(const SolveInput& input, const PlacementList& placements) {
  PlacementList known;
  for (const v1::Placement& placement : placements) {
    if (input.scene.IndexOf(placement.object_id()) >= 0) *known.Add() = placement;
  }
  PartialLayout state(input.scene);
  RETURN_IF_ERROR(ReadPlacements(input, known, state));
  return state;
}

// Of what stands in the way of something that is held where it was put, what is measured as no overlap: a chair that is
// turned has its knees under the desk still.
std::set<std::pair<int, int>> UnderTops(const SolveInput& input, const PartialLayout& now) {
  std::set<std::pair<int, int>> measured, under;
  for (const v1::Finding& one : evaluation::MeasureSolids({input.scene, now.layout, now.placed}).findings) {
    measured.insert(std::minmax(input.scene.IndexOf(one.object_id()), input.scene.IndexOf(one.partner_id())));
  }
  for (const auto& [object, other] : PairsInTheWay(input, now)) {
    const auto sits = [&](int one) { return input.scene.objects[one].seat; };
    const bool held = other >= 0 && input.pinned[object] != input.pinned[other] && (sits(object) || sits(other));
    if (held && !measured.contains(std::minmax(object, other))) under.emplace(object, other);
  }
  return under;
}

Baseline MakeBaseline(const SolveInput& input, const v1::SolvedLayout& layout, const EditedProblem& problem,
                      const PartialLayout& before, const std::vector<int>& touched, const PartialLayout& now) {
  std::map<std::string_view, bool> satisfied;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) {
    satisfied[outcome.edge_id()] = outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
  }
  Baseline baseline;
  for (const v1::ConstraintEdge& edge : input.graph.edges()) {
    const auto known = satisfied.find(edge.id());
    // A new or changed edge is to be tried for as well.
    const bool edited = problem.edited_edges.contains(edge.id());
    baseline.held.push_back(edited || (known != satisfied.end() && known->second));
  }
  PartialLayout untouched = before;
  for (int object : touched) untouched.placed[object] = 0;
  baseline.tolerated = PairsInTheWay(input, untouched);
  baseline.tolerated.merge(UnderTops(input, now));
  baseline.reachable_share = ReachableShare(input, before);
  return baseline;
}

// What stood on something that is gone now, and what that was.
absl::StatusOr<std::map<int, Object>> LostCarriers(const SolveInput& input, const v1::SolvedLayout& layout) {
  ASSIGN_OR_RETURN(const Scene old, SceneFromProto(layout.graph()));
  PartialLayout state(old);
  for (const v1::Placement& placement : layout.placements()) {
    const int object = old.IndexOf(placement.object_id());
    if (object >= 0) state.Place(object, {placement.x_m(), placement.y_m(), placement.theta_rad()});
  }
  std::map<int, Object> lost;
  for (int i = 0; i < static_cast<int>(old.objects.size()); ++i) {
    if (old.objects[i].kind != ObjectKind::kSurface || !state.placed[i]) continue;
    const int carrier = CarrierOf(old, i, state), now = input.scene.IndexOf(old.objects[i].id);
    if (carrier < 0 || now < 0 || input.scene.IndexOf(old.objects[carrier].id) >= 0) continue;
    lost.emplace(now, old.objects[carrier]);
  }
  return lost;
}

std::vector<LeftOut> WithoutCarrier(const std::map<int, Object>& lost_carriers, const PartialLayout& state) {
  std::vector<LeftOut> left_out;
  for (const auto& [object, carrier] : lost_carriers) {
    if (state.placed[object]) continue;
    left_out.push_back(
        {object, fmt::format("it stood on the {}, which is gone, and nothing like it has a free place", carrier.name)});
  }
  return left_out;
}

// That a spare piece has no place was said when the room was solved.
void DropWhatIsSpare(v1::SolvedLayout& layout) {
  IdSet spares;
  for (const v1::Object& object : layout.graph().object_list().objects()) {
    if (object.spare() && !object.requested()) spares.insert(object.id());
  }
  auto& diagnostics = *layout.mutable_diagnostics();
  for (int i = diagnostics.size() - 1; i >= 0; --i) {
    if (diagnostics[i].code() == "not_placed" && spares.contains(diagnostics[i].subject_id())) {
      diagnostics.DeleteSubrange(i, 1);
    }
  }
}

// Everything anew, but for the pins.
absl::StatusOr<WarmResult> SolveAnew(const SolveInput& input) {
  ASSIGN_OR_RETURN(std::vector<Branch> branches, Driver(input, LocalRestartRunner()).Run());
  Branch& best = branches.front();
  return WarmResult{std::move(best.state), std::move(best.outcomes), std::move(best.durations)};
}

absl::StatusOr<WarmResult> Search(const SolveInput& input, const WarmStart& start) {
  absl::StatusOr<WarmResult> warm = SearchWarm(input, start);
  if (!warm.ok() || input.OutOfTime()) return warm;
  const double left_m = FindViolations(input, warm->state, start.baseline).depth_m;
  if (left_m <= kFits_m) return warm;
  ASSIGN_OR_RETURN(const WarmResult anew, SolveAnew(input));
  if (FindViolations(input, anew.state, start.baseline).depth_m >= left_m) return warm;
  // What can goes back to where it stood.
  WarmStart from_anew = start;
  from_anew.state = anew.state;
  return SearchWarm(input, from_anew);
}

std::vector<std::string> MovedIds(const SolveInput& input, const PartialLayout& before, const PartialLayout& after) {
  std::vector<std::string> ids;
  for (size_t i = 0; i < after.layout.size(); ++i) {
    if (!after.placed[i] || (before.placed[i] && before.layout[i] == after.layout[i])) continue;
    ids.push_back(input.scene.objects[i].id);
  }
  return ids;
}

using Words = std::vector<std::string>;
using Edit = absl::StatusOr<v1::LayoutEdit>;

// "1.5x0.6x2.1" as numbers; empty when it is none.
std::vector<double> ExtentsFrom(const std::string& word) {
  std::vector<double> extents;
  std::istringstream parts(word);
  for (std::string part; std::getline(parts, part, 'x');) {
    const std::optional<double> extent = ReadNumber(part);
    if (!extent) return {};
    extents.push_back(*extent);
  }
  return extents;
}

absl::Status Should(const char* form) { return InvalidArgument("should be: {}", form); }

Edit Move(const Words& words, const v1::SolvedLayout& layout) {
  constexpr const char* kForm = "move OBJECT X Y [HEADING], metres and degrees";
  if (words.size() < 4 || words.size() > 5) return Should(kForm);
  const std::optional<double> x = ReadNumber(words[2]), y = ReadNumber(words[3]);
  if (!x || !y) return Should(kForm);
  v1::LayoutEdit edit;
  v1::Placement& target = *edit.mutable_move_object();
  target.set_object_id(words[1]);
  target.set_x_m(*x);
  target.set_y_m(*y);
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == words[1]) target.set_theta_rad(placement.theta_rad());
  }
  if (words.size() == 5) {
    const std::optional<double> heading = ReadNumber(words[4]);
    if (!heading) return Should(kForm);
    target.set_theta_rad(WrapHeading(*heading * kPi / 180));
  }
  return edit;
}

Edit Resize(const Words& words) {
  constexpr const char* kForm = "resize OBJECT WIDTHxDEPTH[xHEIGHT], metres";
  if (words.size() != 3) return Should(kForm);
  const std::vector<double> extents = ExtentsFrom(words[2]);
  if (extents.size() != 2 && extents.size() != 3) return Should(kForm);
  v1::LayoutEdit edit;
  v1::ResizeObject& resize = *edit.mutable_resize_object();
  resize.set_object_id(words[1]);
  resize.set_width_m(extents[0]);
  resize.set_depth_m(extents[1]);
  if (extents.size() == 3) resize.set_height_m(extents[2]);
  return edit;
}

// The zone of an object; of the first one when there is no such object.
std::string ZoneOf(const v1::LayoutGraph& graph, const std::string& object_id) {
  for (const v1::Object& object : graph.object_list().objects()) {
    if (object.id() == object_id && !object.zone_id().empty()) return object.zone_id();
  }
  return graph.zone_plan().zones_size() > 0 ? graph.zone_plan().zones(0).id() : "";
}

Edit Add(const Words& words, const v1::LayoutGraph& graph) {
  constexpr const char* kForm = "add OBJECT WIDTHxDEPTHxHEIGHT [near OBJECT], metres";
  if (words.size() != 3 && (words.size() != 5 || words[3] != "near")) return Should(kForm);
  const std::vector<double> extents = ExtentsFrom(words[2]);
  if (extents.size() != 3) return Should(kForm);
  v1::LayoutEdit edit;
  v1::AddObject& add = *edit.mutable_add_object();
  v1::Object& object = *add.mutable_object();
  object.set_id(words[1]);
  object.set_name(words[1]);
  object.set_role(v1::OBJECT_ROLE_SECONDARY);
  object.set_kind(v1::OBJECT_KIND_FLOOR);
  object.set_width_m(extents[0]);
  object.set_depth_m(extents[1]);
  object.set_height_m(extents[2]);
  object.set_requested(true);
  object.set_zone_id(ZoneOf(graph, words.size() == 5 ? words[4] : ""));
  if (words.size() == 5) {
    v1::ConstraintEdge edge = EdgeFromText(kNearCall, fmt::format("object={} target={}", words[1], words[4]));
    edge.clear_id();
    *add.add_edges() = std::move(edge);
  }
  return edit;
}

Edit Weigh(const Words& words) {
  constexpr const char* kForm = "weight EDGE NUMBER";
  if (words.size() != 3) return Should(kForm);
  const std::optional<double> weight = ReadNumber(words[2]);
  if (!weight) return Should(kForm);
  v1::LayoutEdit edit;
  edit.mutable_set_edge_weight()->set_edge_id(words[1]);
  edit.mutable_set_edge_weight()->set_weight(*weight);
  return edit;
}

Edit AddEdge(const Words& words) {
  if (words.size() < 3) return Should("edge TYPE NAME=VALUE ...");
  std::string call;
  double weight = 1;
  for (size_t i = 2; i < words.size(); ++i) {
    if (words[i].rfind("weight=", 0) == 0) {
      const std::optional<double> given = ReadNumber(words[i].substr(7));
      if (!given) return Should("edge TYPE NAME=VALUE ... weight=NUMBER");
      weight = *given;
      continue;
    }
    call += words[i] + " ";
  }
  v1::LayoutEdit edit;
  *edit.mutable_add_edge() = EdgeFromText(words[1], call);
  edit.mutable_add_edge()->clear_id();
  edit.mutable_add_edge()->set_weight(weight);
  return edit;
}

// "pin bed" and the like: a verb and an id.
Edit OneId(const Words& words) {
  if (words.size() != 2) return Should(fmt::format("{} ID", words[0]).c_str());
  v1::LayoutEdit edit;
  if (words[0] == "pin") edit.set_pin_object_id(words[1]);
  if (words[0] == "unpin") edit.set_unpin_object_id(words[1]);
  if (words[0] == "remove") edit.set_remove_object_id(words[1]);
  if (words[0] == "drop") edit.set_remove_edge_id(words[1]);
  return edit;
}

}  // namespace

absl::StatusOr<ResolveResult> ResolveLayout(const v1::SolvedLayout& layout, const EditList& edits,
                                            const v1::SolveOptions& options, const Solver& solver,
                                            const CancelCheck& cancelled) {
  RETURN_IF_ERROR(Validate(layout));
  ASSIGN_OR_RETURN(const EditedProblem problem, ApplyEdits(layout, edits));
  v1::SolveOptions one = options;
  one.clear_variant_count();
  ASSIGN_OR_RETURN(const SolveInput input, MakeSolveInput(problem.graph, one, solver, cancelled));
  ASSIGN_OR_RETURN(const PartialLayout before, StateOf(input, layout.placements()));
  ASSIGN_OR_RETURN(const PartialLayout now,
                   StateOf(input, PlacementList(problem.placements.begin(), problem.placements.end())));

  WarmStart start{now, before, {}, {}, {}};
  for (const Pin& pin : input.pins) start.state.Place(pin.object, pin.pose);
  for (int i = 0; i < static_cast<int>(input.scene.objects.size()); ++i) {
    if (problem.touched.contains(input.scene.objects[i].id)) start.touched.push_back(i);
  }
  start.baseline = MakeBaseline(input, layout, problem, before, start.touched, start.state);
  ASSIGN_OR_RETURN(start.lost_carriers, LostCarriers(input, layout));
  // The search also keeps at their walls what stands there without a call, and the ways.
  v1::LayoutGraph with_walls = problem.graph;
  HoldWalls(input, before, start.touched, with_walls);
  start.baseline.held.resize(with_walls.edges_size(), 1);
  ASSIGN_OR_RETURN(WarmResult found, Search(WithEdgesOf(with_walls, input), start));

  ResolveResult result;
  result.moved_ids = MovedIds(input, before, found.state);
  result.stage_durations = found.durations;
  Branch branch{std::move(found.state), 0, std::move(found.outcomes), std::move(found.durations)};
  branch.left_out = WithoutCarrier(start.lost_carriers, branch.state);
  if (input.settings.leave_out_misfits) LeaveOutOf(input, branch);
  result.layout = MakeSolvedLayout(input, {branch});
  DropWhatIsSpare(result.layout);
  for (const v1::Diagnostic& diagnostic : problem.diagnostics) *result.layout.add_diagnostics() = diagnostic;
  for (v1::Diagnostic& loss : LossesOf(input, before, branch.state, start.touched)) {
    *result.layout.add_diagnostics() = std::move(loss);
  }
  return result;
}

absl::StatusOr<v1::LayoutEdit> EditFromText(std::string_view line, const v1::SolvedLayout& layout) {
  Words words;
  std::istringstream stream{std::string(line)};
  for (std::string word; stream >> word;) words.push_back(word);
  const std::string verb = words.empty() ? "" : words[0];
  Edit edit =
      absl::InvalidArgumentError("should begin with move, pin, unpin, resize, add, remove, edge, drop or weight");
  if (verb == "move") edit = Move(words, layout);
  if (verb == "resize") edit = Resize(words);
  if (verb == "add") edit = Add(words, layout.graph());
  if (verb == "weight") edit = Weigh(words);
  if (verb == "edge") edit = AddEdge(words);
  if (verb == "pin" || verb == "unpin" || verb == "remove" || verb == "drop") edit = OneId(words);
  if (edit.ok()) return edit;
  return InvalidArgument("edit \"{}\": {}", line, edit.status().message());
}

}  // namespace flair::optimizer
