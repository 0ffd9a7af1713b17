// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/compare/trial.h"

#include <algorithm>
#include <map>
#include <set>

#include "absl/time/clock.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "cli/session/stage_calls.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/registry.h"
#include "optimizer_worker/solver/solver.h"
#include "optimizer_worker/stages/solve_layout.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

std::set<std::string> OwnTypes() {
  std::set<std::string> names;
  for (const v1::ConstraintType& type : optimizer::MakeCatalog().types()) {
    names.insert(type.name());
    names.insert(type.aliases().begin(), type.aliases().end());
  }
  return names;
}

double TotalCost(const v1::SolvedLayout& layout) {
  double total = 0;
  for (const v1::EdgeOutcome& edge : layout.edge_outcomes()) total += edge.weighted_cost();
  for (const v1::TermOutcome& term : layout.term_outcomes()) total += term.cost() * term.factor();
  return total;
}

// What the optimizer says of an edge, by id.
std::map<std::string, v1::EdgeOutcome> ClaimsOf(const v1::SolvedLayout& layout) {
  std::map<std::string, v1::EdgeOutcome> claims;
  for (const v1::EdgeOutcome& outcome : layout.edge_outcomes()) claims[outcome.edge_id()] = outcome;
  return claims;
}

void FillVerdicts(const v1::LayoutGraph& graph, const v1::SolvedLayout& answer, Trial& trial) {
  static const std::set<std::string> own_types = OwnTypes();
  const std::map<std::string, v1::EdgeOutcome> claims = ClaimsOf(answer);
  for (int i = 0; i < graph.edges_size(); ++i) {
    const v1::ConstraintEdge& edge = graph.edges(i);
    Verdict verdict{.outcome = trial.layout.edge_outcomes(i), .is_its_own = !own_types.contains(edge.type())};
    const auto claim = claims.find(edge.id());
    if (claim != claims.end()) {
      trial.claimed_count += claim->second.status() == v1::OUTCOME_STATUS_SATISFIED ? 1 : 0;
      if (verdict.is_its_own) verdict.outcome = claim->second;
    }
    trial.unknown_count += verdict.is_its_own ? 1 : 0;
    trial.held_count += verdict.outcome.status() == v1::OUTCOME_STATUS_SATISFIED ? 1 : 0;
    *trial.layout.mutable_edge_outcomes(i) = verdict.outcome;
    trial.verdicts.push_back(std::move(verdict));
  }
}

constexpr size_t kNameWidth = 44;
constexpr size_t kCellWidth = 16;

std::string VerdictCell(const Verdict& verdict) {
  const std::string mark = verdict.is_its_own ? "*" : "";
  switch (verdict.outcome.status()) {
    case v1::OUTCOME_STATUS_SATISFIED:
      return "holds" + mark;
    case v1::OUTCOME_STATUS_DROPPED:
      return "dropped" + mark;
    default:
      break;
  }
  if (!verdict.outcome.has_missed_by()) return "missed" + mark;
  const std::string& unit = verdict.outcome.unit();
  return fmt::format("missed {:.2f}{}{}", verdict.outcome.missed_by(), unit.empty() ? "" : " " + unit, mark);
}

std::vector<std::string> Letters(size_t count) {
  std::vector<std::string> letters = {""};
  for (size_t i = 0; i < count; ++i) letters.push_back(LetterOf(i));
  return letters;
}

std::string FigureLines(const Contest& contest, const TextTable& table) {
  std::string text;
  const auto row = [&](const std::string& name, const auto& cell) {
    std::vector<std::string> cells = {name};
    for (const Trial& trial : contest.trials) cells.push_back(cell(trial));
    text += table.Row(cells);
  };
  row("constraints that hold",
      [](const Trial& trial) { return fmt::format("{} of {}", trial.held_count, trial.verdicts.size()); });
  row("  by its own account", [](const Trial& trial) { return fmt::format("{}", trial.claimed_count); });
  for (const Figure& figure : Figures()) {
    row(figure.name,
        [&figure](const Trial& trial) { return fmt::format("{:.{}f}", figure.value(trial), figure.digits); });
  }
  row("restarts", [](const Trial& trial) {
    int restarts = 0;
    for (const v1::StageOutcome& stage : trial.layout.stage_outcomes()) restarts += stage.restart_count();
    return fmt::format("{}", restarts);
  });
  return text;
}

std::string VerdictLines(const Contest& contest, const TextTable& table, bool all) {
  std::string text;
  int left_out = 0;
  for (int i = 0; i < contest.graph.edges_size(); ++i) {
    const bool hold_all = std::ranges::all_of(contest.trials, [i](const Trial& trial) {
      return trial.verdicts[i].outcome.status() == v1::OUTCOME_STATUS_SATISFIED;
    });
    left_out += hold_all && !all ? 1 : 0;
    if (hold_all && !all) continue;
    const v1::ConstraintEdge& edge = contest.graph.edges(i);
    std::vector<std::string> cells = {fmt::format("{} {}", edge.id(), CallText(edge))};
    for (const Trial& trial : contest.trials) cells.push_back(VerdictCell(trial.verdicts[i]));
    // A long call has its line alone: cut short, it would say nothing.
    if (cells.front().size() > kNameWidth) {
      text += cells.front() + "\n";
      cells.front().clear();
    }
    text += table.Row(cells);
  }
  if (left_out > 0) text += fmt::format("{} more hold with all of them (--all lists them)\n", left_out);
  return text;
}

}  // namespace

absl::StatusOr<Trial> Judge(const v1::SolveRequest& request, const v1::SolveResponse& response) {
  if (absl::Status status = Validate(response.solved_layout()); !status.ok()) {
    return Internal("its layout is not valid: {}", status.message());
  }
  v1::EvaluateRequest evaluate;
  *evaluate.mutable_layout_graph() = request.layout_graph();
  *evaluate.mutable_placements() = response.solved_layout().placements();
  *evaluate.mutable_options() = request.options();
  const optimizer::NloptSolver solver;
  const absl::StatusOr<v1::EvaluateResponse> judged = optimizer::EvaluateLayout(evaluate, solver);
  if (!judged.ok()) return Internal("its layout cannot be judged: {}", judged.status().message());
  Trial trial{.layout = response.solved_layout(), .producer = response.producer()};
  *trial.layout.mutable_graph() = request.layout_graph();
  *trial.layout.mutable_edge_outcomes() = judged->edge_outcomes();
  *trial.layout.mutable_term_outcomes() = judged->term_outcomes();
  *trial.layout.mutable_metrics() = judged->metrics();
  FillVerdicts(request.layout_graph(), response.solved_layout(), trial);
  trial.layout.set_total_cost(TotalCost(trial.layout));
  return trial;
}

absl::StatusOr<Trial> RunTrial(const v1::SolveRequest& request, const std::string& address) {
  const absl::Time start = absl::Now();
  const absl::StatusOr<v1::SolveResponse> response = CallSolve(request, address);
  const double seconds = absl::ToDoubleSeconds(absl::Now() - start);
  if (!response.ok()) return response.status();
  absl::StatusOr<Trial> trial = Judge(request, *response);
  if (trial.ok()) trial->seconds = seconds;
  return trial;
}

const std::vector<Figure>& Figures() {
  static const std::vector<Figure> figures = {
      {"constraints that hold, %", "satisfied_percent", 1,
       [](const Trial& trial) {
         return trial.verdicts.empty() ? 100.0 : 100.0 * trial.held_count / static_cast<double>(trial.verdicts.size());
       }},
      {"out of bounds (OOB), %", "oob_percent", 3,
       [](const Trial& trial) { return trial.layout.metrics().oob_percent(); }},
      {"overlaps (OOR), %", "oor_percent", 3, [](const Trial& trial) { return trial.layout.metrics().oor_percent(); }},
      {"deepest overlap, mm", "deepest_overlap_mm", 1,
       [](const Trial& trial) { return 1e3 * trial.layout.metrics().deepest_overlap_m(); }},
      {"overlaps in 3D, %", "oor_3d_percent", 3,
       [](const Trial& trial) { return trial.layout.metrics().oor_3d_percent(); }},
      {"uses met, %", "uses_met_percent", 1,
       [](const Trial& trial) {
         const v1::LayoutMetrics& metrics = trial.layout.metrics();
         return metrics.use_count() == 0 ? 100.0 : 100.0 * metrics.met_use_count() / metrics.use_count();
       }},
      {"floor reached, %", "reachable_floor_percent", 1,
       [](const Trial& trial) { return 100 * trial.layout.metrics().reachable_floor_share(); }},
      {"fronts reached, %", "reachable_front_percent", 1,
       [](const Trial& trial) { return 100 * trial.layout.metrics().reachable_front_share(); }},
      {"pathway cost, m3", "pathway_cost_m3", 4,
       [](const Trial& trial) { return trial.layout.metrics().pathway_cost_m3(); }},
      {"total cost", "total_cost", 3, [](const Trial& trial) { return trial.layout.total_cost(); }},
      {"seconds", "seconds", 2, [](const Trial& trial) { return trial.seconds; }},
  };
  return figures;
}

std::string LetterOf(size_t optimizer) { return std::string(1, static_cast<char>('A' + optimizer)); }

std::string ContestText(const Contest& contest, const std::vector<std::string>& optimizers, bool all) {
  std::string text =
      fmt::format("{}: {}, {}, seed {}\n", contest.name, Counted(contest.graph.object_list().objects_size(), "object"),
                  Counted(contest.graph.edges_size(), "constraint"), contest.seed);
  for (size_t i = 0; i < optimizers.size(); ++i) {
    const v1::Producer& producer = contest.trials[i].producer;
    text += fmt::format("  {}  {}: {} {} {}\n", LetterOf(i), optimizers[i], producer.program(), producer.method(),
                        producer.version());
  }
  const TextTable table(Letters(optimizers.size()), kNameWidth, kCellWidth);
  text += "\n" + table.Header() + FigureLines(contest, table);
  text += "\n" + table.Header() + VerdictLines(contest, table, all);
  const bool is_any_unknown = std::ranges::any_of(contest.trials, [](const Trial& t) { return t.unknown_count > 0; });
  if (is_any_unknown) {
    text += fmt::format("* the optimizer's own verdict: our catalogue does not have the type of {}\n",
                        Counted(contest.trials.front().unknown_count, "constraint"));
  }
  return text;
}

std::string ContestsTable(const std::vector<Contest>& contests, const std::vector<std::string>& optimizers) {
  const TextTable table({"graph", "by", "hold %", "OOB %", "OOR %", "overlap mm", "OOR 3D %", "uses %", "floor %",
                         "fronts %", "path m3", "cost", "s"},
                        28, 8);
  std::string text = table.Header();
  const auto row = [&](const std::string& name, size_t optimizer, const auto& value) {
    std::vector<std::string> cells = {name, LetterOf(optimizer)};
    for (const Figure& figure : Figures()) cells.push_back(fmt::format("{:.{}f}", value(figure), figure.digits));
    text += table.Row(cells);
  };
  for (const Contest& contest : contests) {
    for (size_t i = 0; i < optimizers.size(); ++i) {
      row(i == 0 ? contest.name : "", i, [&](const Figure& figure) { return figure.value(contest.trials[i]); });
    }
  }
  text += table.Header();
  for (size_t i = 0; i < optimizers.size(); ++i) {
    row(i == 0 ? fmt::format("median of {}", contests.size()) : "", i, [&](const Figure& figure) {
      std::vector<double> values;
      for (const Contest& contest : contests) values.push_back(figure.value(contest.trials[i]));
      std::ranges::nth_element(values, values.begin() + values.size() / 2);
      return values[values.size() / 2];
    });
  }
  for (size_t i = 0; i < optimizers.size(); ++i) text += fmt::format("{}  {}\n", LetterOf(i), optimizers[i]);
  return text;
}

nlohmann::json ContestJson(const Contest& contest, const std::vector<std::string>& optimizers) {
  nlohmann::json json = {{"graph", contest.name}, {"seed", contest.seed}, {"optimizers", nlohmann::json::array()}};
  for (size_t i = 0; i < optimizers.size(); ++i) {
    const Trial& trial = contest.trials[i];
    nlohmann::json one = {{"optimizer", optimizers[i]},          {"program", trial.producer.program()},
                          {"method", trial.producer.method()},   {"version", trial.producer.version()},
                          {"held_count", trial.held_count},      {"claimed_count", trial.claimed_count},
                          {"unknown_count", trial.unknown_count}};
    for (const Figure& figure : Figures()) one[figure.field] = figure.value(trial);
    json["optimizers"].push_back(std::move(one));
  }
  json["constraints"] = nlohmann::json::array();
  for (int e = 0; e < contest.graph.edges_size(); ++e) {
    nlohmann::json verdicts = nlohmann::json::array();
    for (const Trial& trial : contest.trials) {
      const v1::EdgeOutcome& outcome = trial.verdicts[e].outcome;
      verdicts.push_back({{"status", EnumInWords(outcome.status())},
                          {"weighted_cost", outcome.weighted_cost()},
                          {"reason", outcome.reason()},
                          {"is_its_own", trial.verdicts[e].is_its_own}});
    }
    const v1::ConstraintEdge& edge = contest.graph.edges(e);
    json["constraints"].push_back({{"id", edge.id()}, {"call", CallText(edge)}, {"verdicts", std::move(verdicts)}});
  }
  return json;
}

}  // namespace flair::cli
