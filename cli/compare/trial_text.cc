// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/compare/trial.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

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
    text += fmt::format("* by the optimizer's own account: our catalogue does not have the type of {}\n",
                        Counted(contest.trials.front().unknown_count, "constraint"));
  }
  return text;
}

std::string ContestsTable(const std::vector<Contest>& contests, const std::vector<std::string>& optimizers) {
  const TextTable table(
      {"graph", "by", "hold %", "OOB %", "OOR %", "overlap mm", "floor %", "fronts %", "path m3", "cost", "s"}, 28, 8);
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
