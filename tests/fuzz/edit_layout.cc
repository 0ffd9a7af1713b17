// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a solved layout. What must hold:
//   a line of text is an edit, or INVALID_ARGUMENT that repeats the line and says what would be right;
//   edits apply, or are INVALID_ARGUMENT that names the edit; the graph that they make validates, and what they touched
//   is in it;
//   where edits apply to a valid layout, resolving succeeds: the new layout is valid, what is pinned stands where it is
//   pinned, and exactly the objects named as moved stand elsewhere than before.
#include <google/protobuf/text_format.h>

#include <cmath>
#include <set>
#include <string>

#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/validation/validate.h"
#include "tests/fuzz/random_problem.h"
#include "tests/fuzz/targets.h"

namespace flair {
std::string_view StudyText();  // study.textproto, embedded
}

namespace flair::fuzz {
namespace {

constexpr std::string_view kText = "text\n";
constexpr int kMostEdits = 6;

// Little enough for a fuzzer.
v1::SolveOptions Tight() {
  v1::SolveOptions options;
  options.set_max_restart_count(1);
  options.set_thread_count(1);
  options.mutable_tolerances()->set_max_evaluation_count(5);
  return options;
}

v1::SolvedLayout SolveStudy() {
  v1::LayoutGraph graph;
  Require(google::protobuf::TextFormat::ParseFromString(std::string(StudyText()), &graph), "the study parses");
  const optimizer::NloptSolver solver;
  absl::StatusOr<optimizer::SolveResult> result = optimizer::SolveLayout(graph, Tight(), solver);
  Require(result.ok(), "the study is solved");
  return std::move(result->layout);
}

const v1::SolvedLayout& Study() {
  static const v1::SolvedLayout layout = SolveStudy();
  return layout;
}

std::string ObjectId(ByteSource& bytes) { return fmt::format("object_{}", 1 + bytes.Below(bytes.Rarely(20) ? 9 : 6)); }
std::string EdgeId(ByteSource& bytes) { return fmt::format("edge_{}", 1 + bytes.Below(bytes.Rarely(20) ? 6 : 3)); }

double Number(ByteSource& bytes, double least, double most) {
  return bytes.Rarely(30) ? Nasty(bytes) : bytes.Between(least, most);
}

v1::LayoutEdit RandomEdit(ByteSource& bytes) {
  v1::LayoutEdit edit;
  switch (bytes.Below(10)) {
    case 0: {
      v1::Placement& target = *edit.mutable_move_object();
      target.set_object_id(ObjectId(bytes));
      target.set_x_m(Number(bytes, -0.5, 4.5));
      target.set_y_m(Number(bytes, -0.5, 3.5));
      target.set_theta_rad(Number(bytes, -7, 7));
      break;
    }
    case 1:
      edit.set_pin_object_id(ObjectId(bytes));
      break;
    case 2:
      edit.set_unpin_object_id(ObjectId(bytes));
      break;
    case 3: {
      v1::ResizeObject& size = *edit.mutable_resize_object();
      size.set_object_id(ObjectId(bytes));
      if (bytes.Below(2) == 0) size.set_width_m(Number(bytes, 0.01, 3));
      if (bytes.Below(2) == 0) size.set_depth_m(Number(bytes, 0.01, 2));
      if (bytes.Below(3) == 0) size.set_height_m(Number(bytes, 0.01, 2.5));
      break;
    }
    case 4: {
      v1::LayoutGraph graph = Study().graph();
      AddRandomObject(bytes, graph);
      *edit.mutable_add_object()->mutable_object() = *graph.object_list().objects().rbegin();
      while (bytes.Rarely(2) && edit.add_object().edges_size() < 3) {
        AddRandomEdge(bytes, graph);
        *edit.mutable_add_object()->add_edges() = *graph.edges().rbegin();
      }
      break;
    }
    case 5:
      edit.set_remove_object_id(ObjectId(bytes));
      break;
    case 6: {
      v1::LayoutGraph graph = Study().graph();
      AddRandomEdge(bytes, graph);
      *edit.mutable_add_edge() = *graph.edges().rbegin();
      if (bytes.Below(2) == 0) edit.mutable_add_edge()->clear_id();
      break;
    }
    case 7:
      edit.set_remove_edge_id(EdgeId(bytes));
      break;
    case 8:
      edit.mutable_set_edge_weight()->set_edge_id(EdgeId(bytes));
      edit.mutable_set_edge_weight()->set_weight(Number(bytes, 0, 120));
      break;
    default:
      break;
  }
  return edit;
}

// Damage as old, cut or edited files have it; mostly none.
v1::SolvedLayout SpoiledStudy(ByteSource& bytes) {
  v1::SolvedLayout layout = Study();
  const int one = bytes.Below(layout.placements_size());
  switch (bytes.Below(16)) {
    case 0:
      layout.mutable_placements()->DeleteSubrange(one, 1);
      break;
    case 1:
      *layout.add_placements() = layout.placements(one);
      break;
    case 2:
      layout.mutable_placements(one)->set_x_m(Nasty(bytes));
      break;
    case 3:
      layout.mutable_placements(one)->set_theta_rad(Nasty(bytes));
      break;
    case 4:
      layout.clear_edge_outcomes();
      break;
    case 5:
      layout.mutable_placements(one)->set_object_id("nobody");
      break;
    case 6:
      layout.mutable_placements(one)->set_y_m(bytes.Between(-2, 5));
      break;
    default:
      break;
  }
  return layout;
}

void CheckProblem(const optimizer::EditedProblem& problem) {
  const absl::Status good = Validate(problem.graph);
  Require(good.ok(), fmt::format("the edited graph validates: {}", std::string(good.message())));
  std::set<std::string> objects;
  for (const v1::Object& object : problem.graph.object_list().objects()) objects.insert(object.id());
  for (const std::string& id : problem.touched) Require(objects.contains(id), "what was touched is an object");
  for (const v1::Placement& placement : problem.placements) {
    Require(objects.contains(placement.object_id()), "what is placed is an object");
  }
}

void CheckResolved(const v1::SolvedLayout& before, const optimizer::ResolveResult& result) {
  const absl::Status good = Validate(result.layout);
  Require(good.ok(), fmt::format("a resolved layout is valid: {}", std::string(good.message())));
  const std::set<std::string> moved(result.moved_ids.begin(), result.moved_ids.end());
  for (const v1::Placement& now : result.layout.placements()) {
    bool same = false;
    for (const v1::Placement& then : before.placements()) {
      same = same || (then.object_id() == now.object_id() && then.x_m() == now.x_m() && then.y_m() == now.y_m() &&
                      then.theta_rad() == now.theta_rad());
    }
    Require(same != moved.contains(now.object_id()), "what has moved is named, and nothing else");
    for (const v1::Placement& pin : result.layout.graph().pinned_placements()) {
      if (pin.object_id() != now.object_id()) continue;
      Require(pin.x_m() == now.x_m() && pin.y_m() == now.y_m() && pin.theta_rad() == now.theta_rad(),
              "what is pinned stands where it is pinned");
    }
  }
  Require(std::isfinite(result.layout.total_cost()), "the cost is a number");
}

void ApplyAndResolve(const v1::SolvedLayout& layout, const optimizer::EditList& edits) {
  const bool good_layout = Validate(layout).ok();
  bool applies = false;
  if (good_layout) {
    const absl::StatusOr<optimizer::EditedProblem> problem = optimizer::ApplyEdits(layout, edits);
    applies = problem.ok();
    if (applies) CheckProblem(*problem);
  }
  const optimizer::NloptSolver solver;
  const absl::StatusOr<optimizer::ResolveResult> result =
      optimizer::ResolveLayout(layout, edits, Tight(), solver, nullptr);
  Require(result.ok() == applies, fmt::format("what applies to a valid layout is solved, and nothing else: {}",
                                              std::string(result.status().message())));
  if (result.ok()) return CheckResolved(layout, *result);
  Require(absl::IsInvalidArgument(result.status()) && !result.status().message().empty(), "a refusal says why");
}

optimizer::EditList EditsFromText(std::string_view text) {
  optimizer::EditList edits;
  while (!text.empty()) {
    const size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    const absl::StatusOr<v1::LayoutEdit> edit = optimizer::EditFromText(line, Study());
    if (edit.ok()) {
      Require(edit->edit_case() != v1::LayoutEdit::EDIT_NOT_SET, "an edit that was read says something");
      if (edits.size() < kMostEdits) *edits.Add() = *edit;
      continue;
    }
    Require(absl::IsInvalidArgument(edit.status()), "a line that is no edit is INVALID_ARGUMENT");
    Require(edit.status().message().find("should") != absl::string_view::npos, "it says what would be right");
  }
  return edits;
}

}  // namespace

void EditLayout(std::string_view bytes) {
  if (bytes.substr(0, kText.size()) == kText) {
    return ApplyAndResolve(Study(), EditsFromText(bytes.substr(kText.size())));
  }
  ByteSource source(bytes);
  const v1::SolvedLayout layout = SpoiledStudy(source);
  optimizer::EditList edits;
  for (int i = source.Below(kMostEdits); i >= 0; --i) *edits.Add() = RandomEdit(source);
  ApplyAndResolve(layout, edits);
}

}  // namespace flair::fuzz
