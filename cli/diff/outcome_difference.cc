// SPDX-License-Identifier: GPL-3.0-or-later
// Which constraints hold, what it costs, and how good the layout is.
#include <algorithm>
#include <cmath>

#include "cli/diff/compare_things.h"
#include "cli/diff/content_difference.h"
#include "cli/diff/pairing.h"
#include "cli/output/call_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

std::string StatusWords(const v1::EdgeOutcome& outcome) {
  switch (outcome.status()) {
    case v1::OUTCOME_STATUS_SATISFIED:
      return "holds";
    case v1::OUTCOME_STATUS_DROPPED:
      return outcome.reason().empty() ? "dropped" : "dropped: " + outcome.reason();
    default:
      return outcome.reason().empty() ? fmt::format("missed, cost {:.4g}", outcome.cost())
                                      : "missed: " + outcome.reason();
  }
}

// Verdicts first, then by how much what does not hold costs.
Became BecameOf(const v1::EdgeOutcome& a, const v1::EdgeOutcome& b) {
  if (a.status() != b.status()) return b.status() < a.status() ? Became::kBetter : Became::kWorse;
  return b.weighted_cost() < a.weighted_cost() ? Became::kBetter : Became::kWorse;
}

// Whether a difference of two costs says anything: descents end a little apart.
bool Differs(double a, double b) { return std::abs(a - b) > 1e-4 + 1e-2 * std::max(std::abs(a), std::abs(b)); }

void CompareVerdicts(const v1::SolvedLayout& a, const v1::SolvedLayout& b, std::vector<Section>& sections) {
  Section section{.title = "verdicts"};
  for (const Pair& pair : PairCalls(a.graph(), b.graph())) {
    if (pair.a < 0 || pair.b < 0 || pair.a >= a.edge_outcomes_size() || pair.b >= b.edge_outcomes_size()) continue;
    const v1::EdgeOutcome &was = a.edge_outcomes(pair.a), &is = b.edge_outcomes(pair.b);
    const bool both_missed = was.status() == is.status() && is.status() == v1::OUTCOME_STATUS_VIOLATED;
    if (was.status() == is.status() && !(both_missed && Differs(was.weighted_cost(), is.weighted_cost()))) {
      ++section.same_count;
      continue;
    }
    const v1::ConstraintEdge& edge = b.graph().edges(pair.b);
    section.changes.push_back({BecameOf(was, is),
                               fmt::format("{} {}", edge.id(), CallText(edge)),
                               fmt::format("{}; before: {}", StatusWords(is), StatusWords(was)),
                               {{"edge_id", edge.id()},
                                {"a", {{"status", StatusName(was.status())}, {"weighted_cost", was.weighted_cost()}}},
                                {"b", {{"status", StatusName(is.status())}, {"weighted_cost", is.weighted_cost()}}}}});
  }
  const auto held = [](const v1::SolvedLayout& layout) {
    return std::ranges::count(layout.edge_outcomes(), v1::OUTCOME_STATUS_SATISFIED, &v1::EdgeOutcome::status);
  };
  section.note =
      fmt::format("{} of {} hold -> {} of {}", held(a), a.edge_outcomes_size(), held(b), b.edge_outcomes_size());
  AddSection(std::move(section), sections);
}

void CompareCosts(const v1::SolvedLayout& a, const v1::SolvedLayout& b, std::vector<Section>& sections) {
  Section section{.title = "costs"};
  const auto compare = [&section](const std::string& what, double was, double is) {
    if (!Differs(was, is)) return void(++section.same_count);
    section.changes.push_back(
        {is < was ? Became::kBetter : Became::kWorse, what, NumberWords("", was, is), {{"a", was}, {"b", is}}});
  };
  compare("total", a.total_cost(), b.total_cost());
  const auto term_name = [](const v1::TermOutcome& term) { return term.term(); };
  for (const Pair& pair : MatchThings(a.term_outcomes(), b.term_outcomes(), term_name)) {
    const auto weighted = [](const auto& terms, int i) { return i < 0 ? 0.0 : terms[i].cost() * terms[i].factor(); };
    compare(pair.a >= 0 ? a.term_outcomes(pair.a).term() : b.term_outcomes(pair.b).term(),
            weighted(a.term_outcomes(), pair.a), weighted(b.term_outcomes(), pair.b));
  }
  AddSection(std::move(section), sections);
}

void CompareMeasures(const v1::LayoutMetrics& a, const v1::LayoutMetrics& b, std::vector<Section>& sections) {
  Section section = FieldsSection("measures", a, b);
  section.same_count = v1::LayoutMetrics::descriptor()->field_count() - static_cast<int>(section.changes.size());
  for (Change& change : section.changes) {
    const nlohmann::json& field = change.detail["fields"][0];
    // Of shares that can be reached, more is better; of all else, less.
    const bool more_is_better = field["field"].get<std::string>().ends_with("_share");
    change.became = (field["b"] > field["a"]) == more_is_better ? Became::kBetter : Became::kWorse;
  }
  AddSection(std::move(section), sections);
}

}  // namespace

const char* StatusName(v1::OutcomeStatus status) {
  switch (status) {
    case v1::OUTCOME_STATUS_SATISFIED:
      return "satisfied";
    case v1::OUTCOME_STATUS_VIOLATED:
      return "violated";
    default:
      return "dropped";
  }
}

void CompareOutcomes(const v1::SolvedLayout& a, const v1::SolvedLayout& b, std::vector<Section>& sections) {
  CompareVerdicts(a, b, sections);
  CompareCosts(a, b, sections);
  CompareMeasures(a.metrics(), b.metrics(), sections);
}

}  // namespace flair::cli
