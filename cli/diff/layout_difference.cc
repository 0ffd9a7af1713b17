// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diff/layout_difference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "cli/diff/difference.h"
#include "cli/diff/field_words.h"
#include "cli/diff/pairing.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {

namespace {

constexpr double kVisible_m = 1e-3;
constexpr double kVisible_deg = 0.1;
constexpr double kDegrees = 180 / std::numbers::pi;

// Of eight, counted counter-clockwise from the east.
const char* Direction(double east_m, double north_m) {
  constexpr const char* kNames[] = {"east", "north-east", "north", "north-west",
                                    "west", "south-west", "south", "south-east"};
  const double eighths = std::atan2(north_m, east_m) / (std::numbers::pi / 4);
  return kNames[(static_cast<int>(std::lround(eighths)) + 8) % 8];
}

// Small moves in millimetres: "0.00 m" says nothing.
std::string Length(double length_m) {
  return length_m < 0.01 ? fmt::format("{:.0f} mm", 1e3 * length_m) : fmt::format("{:.2f} m", length_m);
}

}  // namespace

double PlaceChange::distance_m() const { return std::hypot(east_m, north_m); }

bool PlaceChange::is_any() const { return east_m != 0 || north_m != 0 || up_m != 0 || turn_rad != 0; }

bool PlaceChange::is_visible() const { return !InWords().empty(); }

std::string PlaceChange::InWords() const {
  std::vector<std::string> words;
  if (distance_m() >= kVisible_m) {
    words.push_back(fmt::format("moved {} {}", Length(distance_m()), Direction(east_m, north_m)));
  }
  if (const double turn_deg = turn_rad * kDegrees; std::abs(turn_deg) >= kVisible_deg) {
    const double shown = std::round(10 * std::abs(turn_deg)) / 10;
    words.push_back(shown == 180 ? "turned round"
                                 : fmt::format("turned {:g}° {}", shown, turn_deg > 0 ? "left" : "right"));
  }
  if (std::abs(up_m) >= kVisible_m) {
    words.push_back(fmt::format("{} {}", Length(std::abs(up_m)), up_m > 0 ? "higher" : "lower"));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

nlohmann::json PlaceChange::ToJson() const {
  return {{"distance_m", distance_m()},
          {"east_m", east_m},
          {"north_m", north_m},
          {"up_m", up_m},
          {"turn_deg", turn_rad * kDegrees}};
}

PlaceChange ChangeOf(const v1::Placement& a, const v1::Placement& b) {
  return {.east_m = b.x_m() - a.x_m(),
          .north_m = b.y_m() - a.y_m(),
          .up_m = b.z_m() - a.z_m(),
          .turn_rad = std::remainder(b.theta_rad() - a.theta_rad(), 2 * std::numbers::pi)};
}

// Where things stand.

namespace {

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& object_id) {
  for (const v1::Placement& place : layout.placements()) {
    if (place.object_id() == object_id) return &place;
  }
  return nullptr;
}

std::string SizeWords(const v1::Object& a, const v1::Object& b) {
  std::string words;
  const auto add = [&words](const char* field, const char* word, double was, double is) {
    if (was != is) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", NumberWords(field, was, is), word);
  };
  add("width_m", "wide", a.width_m(), b.width_m());
  add("depth_m", "deep", a.depth_m(), b.depth_m());
  return words;
}

// How one object of both layouts stands now. `fate` takes it when it shows on a plan.
void ComparePlace(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const Pair& pair, Difference& difference,
                  Section& section, int& slight_count) {
  const v1::Object &of_a = a.graph().object_list().objects(pair.a), &of_b = b.graph().object_list().objects(pair.b);
  const v1::Placement *was = PlacementOf(a, of_a.id()), *is = PlacementOf(b, of_b.id());
  if (was == nullptr && is == nullptr) return;
  if (was == nullptr || is == nullptr) {
    const bool is_placed = is != nullptr;
    section.changes.push_back({is_placed ? Became::kAdded : Became::kRemoved,
                               of_b.id(),
                               is_placed ? "placed now" : "not placed any more",
                               {}});
    difference.fates.push_back({is_placed ? "" : of_a.id(), is_placed ? of_b.id() : "", ""});
    return;
  }
  const PlaceChange change = ChangeOf(*was, *is);
  std::string words = SizeWords(of_a, of_b);
  if (change.is_visible()) {
    section.changes.push_back({Became::kChanged, of_b.id(), change.InWords(), change.ToJson()});
    words = words.empty() ? change.InWords() : change.InWords() + ", " + words;
  } else {
    ++section.same_count;
    slight_count += change.is_any() ? 1 : 0;
  }
  if (!words.empty()) difference.fates.push_back({of_a.id(), of_b.id(), words});
}

// Of objects whose places are not compared.
void CompareSize(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const Pair& pair, Difference& difference) {
  const v1::Object &of_a = a.graph().object_list().objects(pair.a), &of_b = b.graph().object_list().objects(pair.b);
  const std::string words = SizeWords(of_a, of_b);
  if (!words.empty()) difference.fates.push_back({of_a.id(), of_b.id(), words});
}

// Rooms whose floors share less than three quarters of both are two rooms: where things stand in them compares to
// nothing.
bool ArePlacesComparable(const v1::Room& a, const v1::Room& b) {
  const auto extent = [](const v1::Room& room) {
    double width = 0, depth = 0;
    for (const v1::Point2& vertex : room.floor().vertices()) {
      width = std::max(width, vertex.x_m());
      depth = std::max(depth, vertex.y_m());
    }
    return std::pair(width, depth);
  };
  const auto [width_a, depth_a] = extent(a);
  const auto [width_b, depth_b] = extent(b);
  const double shared = std::min(width_a, width_b) * std::min(depth_a, depth_b);
  return shared >= 0.75 * (width_a * depth_a + width_b * depth_b - shared);
}

void ComparePlaces(const v1::SolvedLayout& a, const v1::SolvedLayout& b, Difference& difference) {
  Section section{.title = "places"};
  const bool is_comparable = ArePlacesComparable(a.graph().room(), b.graph().room());
  int slight_count = 0;
  for (const Pair& pair : PairObjects(a.graph().object_list(), b.graph().object_list())) {
    if (pair.a >= 0 && pair.b >= 0) {
      if (is_comparable) ComparePlace(a, b, pair, difference, section, slight_count);
      if (!is_comparable) CompareSize(a, b, pair, difference);
      continue;
    }
    const v1::SolvedLayout& of = pair.a >= 0 ? a : b;
    const std::string& id = of.graph().object_list().objects(std::max(pair.a, pair.b)).id();
    if (PlacementOf(of, id) != nullptr) difference.fates.push_back({pair.a < 0 ? "" : id, pair.b < 0 ? "" : id, ""});
  }
  if (!is_comparable) section.note = "not compared: the rooms are too different";
  if (slight_count > 0) section.note = fmt::format("{} of them moved by less than 1 mm and 0.1°", slight_count);
  AddSection(std::move(section), difference.sections);
}

}  // namespace

void CompareLayouts(const v1::SolvedLayout& a, const v1::SolvedLayout& b, Difference& difference) {
  CompareGraphs(a.graph(), b.graph(), difference.sections);
  ComparePlaces(a, b, difference);
  CompareOutcomes(a, b, difference.sections);
  const auto stage = [](const v1::StageOutcome& outcome) {
    return outcome.zone_id().empty() ? outcome.stage() : outcome.stage() + " " + outcome.zone_id();
  };
  AddSection(CompareThings("stages of the solve", a.stage_outcomes(), b.stage_outcomes(),
                           MatchThings(a.stage_outcomes(), b.stage_outcomes(), stage), stage,
                           [](const v1::StageOutcome& outcome) { return Counted(outcome.restart_count(), "restart"); }),
             difference.sections);
}

// Which constraints hold, what it costs, and how good the layout is.

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
