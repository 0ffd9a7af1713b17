// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/bench/resolve_bench.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/bench/statistics.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "optimizer_worker/resolve/resolve_layout.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/geometry/pose.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

int Held(const v1::SolvedLayout& layout) {
  return static_cast<int>(std::count_if(layout.edge_outcomes().begin(), layout.edge_outcomes().end(),
                                        [](const auto& e) { return e.status() == v1::OUTCOME_STATUS_SATISFIED; }));
}

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& id) {
  for (const v1::Placement& placement : layout.placements()) {
    if (placement.object_id() == id) return &placement;
  }
  return nullptr;
}

// Half a metre towards the middle of the room, where nobody is pushed through a wall.
std::string MoveLine(const v1::SolvedLayout& layout, const v1::Placement& at, double turn_deg) {
  double x = 0, y = 0;
  const auto& vertices = layout.graph().room().floor().vertices();
  for (const v1::Point2& p : vertices) {
    x += p.x_m() / vertices.size();
    y += p.y_m() / vertices.size();
  }
  const double far = std::max(1e-9, std::hypot(x - at.x_m(), y - at.y_m())),
               step = turn_deg == 0 ? std::min(0.5, far) : 0;
  return fmt::format("move {} {} {} {}", at.object_id(), at.x_m() + step / far * (x - at.x_m()),
                     at.y_m() + step / far * (y - at.y_m()), at.theta_rad() * 180 / kPi + turn_deg);
}

std::vector<std::string> EditsOf(const v1::SolvedLayout& layout, int per_kind) {
  std::vector<std::string> lines;
  const auto& objects = layout.graph().object_list().objects();
  const int step = std::max(1, objects.size() / per_kind);
  for (int i = 0; i < objects.size(); i += step) {
    const v1::Object& object = objects[i];
    const v1::Placement* at = PlacementOf(layout, object.id());
    if (at == nullptr) continue;
    lines.push_back(MoveLine(layout, *at, 0));
    lines.push_back(fmt::format("resize {} {}x{}", object.id(), 1.2 * object.width_m(), 1.2 * object.depth_m()));
    lines.push_back(fmt::format("pin {}", object.id()));
    lines.push_back(fmt::format("remove {}", object.id()));
    if (object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over()) continue;
    lines.push_back(MoveLine(layout, *at, 90));
    lines.push_back(fmt::format("add extra_piece {}x{}x{} near {}", std::min(0.5, object.width_m()),
                                std::min(0.5, object.depth_m()), object.height_m(), object.id()));
  }
  const int stride = std::max(1, layout.graph().edges_size() / per_kind);
  for (int e = 0; e < layout.graph().edges_size(); e += stride) {
    lines.push_back(fmt::format("weight {} 5", layout.graph().edges(e).id()));
    lines.push_back(fmt::format("drop {}", layout.graph().edges(e).id()));
  }
  return lines;
}

std::string KindOf(const ResolveMeasure& measure) { return measure.edit.substr(0, measure.edit.find(' ')); }

TextTable Table(const std::vector<ResolveMeasure>& measures) {
  size_t width = 12;
  for (const ResolveMeasure& measure : measures) width = std::max(width, measure.room.size());
  return TextTable(
      {"edits of", "edits", "CPU ms", "95 %", "most", "moved", "held", "after", "of these", "anew", "deep mm"}, width,
      7);
}

std::vector<std::string> Cells(const std::string& name, const std::vector<const ResolveMeasure*>& measures) {
  std::vector<double> cpu_ms;
  double moved = 0, before = 0, after = 0, anew = 0, after_compared = 0;
  double deepest_m = 0;
  int compared = 0;
  for (const ResolveMeasure* m : measures) {
    cpu_ms.push_back(1e3 * m->cpu_s);
    moved += m->moved_count;
    before += m->held_before;
    after += m->held_after;
    deepest_m = std::max(deepest_m, m->deepest_overlap_m);
    if (m->held_anew < 0) continue;
    ++compared;
    anew += m->held_anew;
    after_compared += m->held_after;
  }
  const double n = static_cast<double>(measures.size());
  return {name,
          fmt::format("{}", measures.size()),
          fmt::format("{:.1f}", Quantile(cpu_ms, 0.5)),
          fmt::format("{:.1f}", Quantile(cpu_ms, 0.95)),
          fmt::format("{:.1f}", Quantile(cpu_ms, 1)),
          fmt::format("{:.2f}", moved / n),
          fmt::format("{:.2f}", before / n),
          fmt::format("{:.2f}", after / n),
          compared > 0 ? fmt::format("{:.2f}", after_compared / compared) : "-",
          compared > 0 ? fmt::format("{:.2f}", anew / compared) : "-",
          fmt::format("{:.3f}", 1e3 * deepest_m)};
}

}  // namespace

absl::StatusOr<std::vector<ResolveMeasure>> MeasureResolves(const BenchProblem& problem,
                                                            const v1::SolveOptions& options, int per_kind,
                                                            int compare_every) {
  const optimizer::NloptSolver solver;
  ASSIGN_OR_RETURN(const optimizer::SolveResult start, optimizer::SolveLayout(problem.graph, options, solver));
  std::vector<ResolveMeasure> measures;
  for (const std::string& line : EditsOf(start.layout, per_kind)) {
    ASSIGN_OR_RETURN(v1::LayoutEdit edit, optimizer::EditFromText(line, start.layout));
    google::protobuf::RepeatedPtrField<v1::LayoutEdit> edits;
    *edits.Add() = std::move(edit);
    const double began = ProcessCpu_s();
    const absl::StatusOr<optimizer::ResolveResult> result =
        optimizer::ResolveLayout(start.layout, edits, options, solver);
    const double cpu_s = ProcessCpu_s() - began;
    // An object grown or added beyond what validation lets through is no measure of the solver.
    if (!result.ok()) continue;
    ResolveMeasure& measure = measures.emplace_back();
    measure.room = problem.name;
    measure.edit = line;
    measure.cpu_s = cpu_s;
    measure.object_count = problem.graph.object_list().objects_size();
    measure.moved_count = static_cast<int>(result->moved_ids.size());
    measure.held_before = Held(start.layout);
    measure.held_after = Held(result->layout);
    measure.deepest_overlap_m = result->layout.metrics().deepest_overlap_m();
    if (compare_every == 0 || measures.size() % compare_every != 1 % compare_every) continue;
    const auto anew = optimizer::SolveLayout(result->layout.graph(), options, solver);
    if (anew.ok()) measure.held_anew = Held(anew->layout);
  }
  return measures;
}

std::string ResolveTable(const std::vector<ResolveMeasure>& measures) {
  std::map<std::string, std::vector<const ResolveMeasure*>> rooms, kinds;
  std::vector<const ResolveMeasure*> all;
  for (const ResolveMeasure& measure : measures) {
    rooms[measure.room].push_back(&measure);
    kinds[KindOf(measure)].push_back(&measure);
    all.push_back(&measure);
  }
  const TextTable table = Table(measures);
  std::string text =
      "CPU ms    of one edit: median, 95th percentile, most\n"
      "moved     objects; held, after: constraints that hold before and after it; means\n"
      "of these  held after the edits that were compared with a solve anew (--compare-every), and held by that\n"
      "deep mm   deepest overlap; what a person moves or pins into something stays there\n\n" +
      table.Header();
  for (const auto& [name, list] : rooms) text += table.Row(Cells(name, list));
  text += "\n" + table.Header();
  for (const auto& [name, list] : kinds) text += table.Row(Cells("all: " + name, list));
  return text + table.Row(Cells("all", all));
}

}  // namespace flair::cli
