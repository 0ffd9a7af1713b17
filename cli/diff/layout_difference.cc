// SPDX-License-Identifier: GPL-3.0-or-later
// Graphs and layouts: calls, where things stand, which constraints hold, what it costs, and how good the layout is.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "cli/diff/difference.h"
#include "cli/output/artifact_text.h"
#include "cli/output/message_view.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

// A call as it is written, without its weight. Arguments have names, so their order says nothing.
std::string BareCall(v1::ConstraintEdge edge) {
  edge.set_weight(1);
  std::ranges::sort(*edge.mutable_arguments(), {}, &v1::Argument::name);
  return CallText(edge);
}

// Calls by what they say and the sentence that says so, then by what they say, then by id and type. Ids of calls are
// mere numbers: one call more in front changes them all.
std::vector<Pair> PairCalls(const v1::LayoutGraph& a, const v1::LayoutGraph& b) {
  const auto keys = [](const v1::LayoutGraph& graph) {
    std::map<std::string_view, std::string_view> words;
    for (const v1::Sentence& sentence : graph.constraint_list().sentences()) words[sentence.id()] = sentence.text();
    Keys all(3);
    for (const v1::ConstraintEdge& edge : graph.edges()) {
      all[1].push_back(BareCall(edge));
      all[0].push_back(fmt::format("{}\n{}", all[1].back(), words[edge.sentence_id()]));
      all[2].push_back(edge.id().empty() ? "" : edge.id() + "\n" + edge.type());
    }
    return all;
  };
  return MatchKeys(keys(a), keys(b));
}

// What a call says changes as a whole: arguments alone would say little.
Section CompareCalls(const v1::LayoutGraph& a, const v1::LayoutGraph& b) {
  Section section{.title = "calls"};
  for (const Pair& pair : PairCalls(a, b)) {
    const v1::ConstraintEdge& edge = pair.b < 0 ? a.edges(pair.a) : b.edges(pair.b);
    const std::string subject = fmt::format("{} {}", edge.id(), CallText(edge));
    if (pair.a < 0 || pair.b < 0) {
      const std::string words = edge.sentence_id().empty() ? "" : "of sentence " + edge.sentence_id();
      section.changes.push_back({pair.a < 0 ? Became::kAdded : Became::kRemoved, subject, words, {}});
    } else if (const std::string was = CallText(a.edges(pair.a)); BareCall(a.edges(pair.a)) != BareCall(edge)) {
      section.changes.push_back({Became::kChanged, subject, "was " + was, {{"a", was}, {"b", CallText(edge)}}});
    } else {
      CompareThing(subject, a.edges(pair.a), edge, {"id", "sentence_id", "arguments"}, section);
    }
  }
  return section;
}

constexpr double kVisible_m = 1e-3;
constexpr double kVisible_deg = 0.1;

// How far and where something went, in room frame R.
struct PlaceChange {
  double east_m, north_m, up_m;
  double turn_deg;  // counter-clockwise, (-180, 180]

  PlaceChange(const v1::Placement& a, const v1::Placement& b)
      : east_m(b.x_m() - a.x_m()),
        north_m(b.y_m() - a.y_m()),
        up_m(b.z_m() - a.z_m()),
        turn_deg(std::remainder(b.theta_rad() - a.theta_rad(), 2 * std::numbers::pi) * 180 / std::numbers::pi) {}

  double distance_m() const { return std::hypot(east_m, north_m); }
  bool is_any() const { return east_m != 0 || north_m != 0 || up_m != 0 || turn_deg != 0; }

  // "moved 0.35 m west, turned 90° left"; empty when it is less than 1 mm and 0.1°.
  std::string InWords() const {
    // Small moves in millimetres: "0.00 m" says nothing.
    const auto length = [](double length_m) {
      return length_m < 0.01 ? fmt::format("{:.0f} mm", 1e3 * length_m) : fmt::format("{:.2f} m", length_m);
    };
    constexpr const char* kDirections[] = {"east", "north-east", "north", "north-west",
                                           "west", "south-west", "south", "south-east"};
    std::vector<std::string> words;
    if (distance_m() >= kVisible_m) {
      const double eighths = std::atan2(north_m, east_m) / (std::numbers::pi / 4);
      words.push_back(fmt::format("moved {} {}", length(distance_m()),
                                  kDirections[(static_cast<int>(std::lround(eighths)) + 8) % 8]));
    }
    if (std::abs(turn_deg) >= kVisible_deg) {
      const double shown = std::round(10 * std::abs(turn_deg)) / 10;
      words.push_back(shown == 180 ? "turned round"
                                   : fmt::format("turned {:g}° {}", shown, turn_deg > 0 ? "left" : "right"));
    }
    if (std::abs(up_m) >= kVisible_m) words.push_back(length(std::abs(up_m)) + (up_m > 0 ? " higher" : " lower"));
    return fmt::format("{}", fmt::join(words, ", "));
  }

  nlohmann::json ToJson() const {
    return {
        {"distance_m", distance_m()}, {"east_m", east_m}, {"north_m", north_m}, {"up_m", up_m}, {"turn_deg", turn_deg}};
  }
};

const v1::Placement* PlacementOf(const v1::SolvedLayout& layout, const std::string& object_id) {
  const auto found = std::ranges::find(layout.placements(), object_id, &v1::Placement::object_id);
  return found == layout.placements().end() ? nullptr : &*found;
}

std::string SizeWords(const v1::Object& a, const v1::Object& b) {
  std::vector<std::string> words;
  if (a.width_m() != b.width_m()) words.push_back(NumberWords("width_m", a.width_m(), b.width_m()) + " wide");
  if (a.depth_m() != b.depth_m()) words.push_back(NumberWords("depth_m", a.depth_m(), b.depth_m()) + " deep");
  return fmt::format("{}", fmt::join(words, ", "));
}

// Rooms whose floors share less than three quarters of both are two rooms: where things stand in them compares to
// nothing.
bool ArePlacesComparable(const v1::Room& a, const v1::Room& b) {
  const auto [width_a, depth_a] = ExtentOf(a.floor());
  const auto [width_b, depth_b] = ExtentOf(b.floor());
  const double shared = std::min(width_a, width_b) * std::min(depth_a, depth_b);
  return shared >= 0.75 * (width_a * depth_a + width_b * depth_b - shared);
}

// Where things stand; `fates` takes what shows on a plan.
void ComparePlaces(const v1::SolvedLayout& a, const v1::SolvedLayout& b, Difference& difference) {
  Section section{.title = "places"};
  const bool is_comparable = ArePlacesComparable(a.graph().room(), b.graph().room());
  const v1::ObjectList &of_a = a.graph().object_list(), &of_b = b.graph().object_list();
  int slight_count = 0;
  for (const Pair& pair : MatchItems(of_a, of_b, "objects")) {
    const std::string a_id = pair.a < 0 ? "" : of_a.objects(pair.a).id(),
                      b_id = pair.b < 0 ? "" : of_b.objects(pair.b).id();
    const v1::Placement *was = PlacementOf(a, a_id), *is = PlacementOf(b, b_id);
    if (was == nullptr && is == nullptr) continue;
    if (was == nullptr || is == nullptr) {
      difference.fates.push_back({was == nullptr ? "" : a_id, is == nullptr ? "" : b_id, ""});
      if (!is_comparable || pair.a < 0 || pair.b < 0) continue;
      section.changes.push_back({is != nullptr ? Became::kAdded : Became::kRemoved,
                                 b_id,
                                 is != nullptr ? "placed now" : "not placed any more",
                                 {}});
      continue;
    }
    std::string words = SizeWords(of_a.objects(pair.a), of_b.objects(pair.b));
    if (is_comparable) {
      const PlaceChange change(*was, *is);
      if (const std::string moved = change.InWords(); !moved.empty()) {
        section.changes.push_back({Became::kChanged, b_id, moved, change.ToJson()});
        words = words.empty() ? moved : moved + ", " + words;
      } else {
        ++section.same_count;
        slight_count += change.is_any() ? 1 : 0;
      }
    }
    if (!words.empty()) difference.fates.push_back({a_id, b_id, words});
  }
  if (!is_comparable) section.note = "not compared: the rooms are too different";
  if (slight_count > 0) section.note = fmt::format("{} of them moved by less than 1 mm and 0.1°", slight_count);
  AddSection(std::move(section), difference.sections);
}

std::string StatusWords(const v1::EdgeOutcome& outcome) {
  if (outcome.status() == v1::OUTCOME_STATUS_SATISFIED) return "holds";
  const bool is_dropped = outcome.status() == v1::OUTCOME_STATUS_DROPPED;
  if (!outcome.reason().empty()) return (is_dropped ? "dropped: " : "missed: ") + outcome.reason();
  return is_dropped ? "dropped" : fmt::format("missed, cost {:.4g}", outcome.cost());
}

// Whether a difference of two costs says anything: descents end a little apart.
bool Differs(double a, double b) { return std::abs(a - b) > 1e-4 + 1e-2 * std::max(std::abs(a), std::abs(b)); }

Section CompareVerdicts(const v1::SolvedLayout& a, const v1::SolvedLayout& b) {
  Section section{.title = "verdicts"};
  const auto held = [](const v1::SolvedLayout& layout) {
    return std::ranges::count(layout.edge_outcomes(), v1::OUTCOME_STATUS_SATISFIED, &v1::EdgeOutcome::status);
  };
  section.note =
      fmt::format("{} of {} hold -> {} of {}", held(a), a.edge_outcomes_size(), held(b), b.edge_outcomes_size());
  for (const Pair& pair : PairCalls(a.graph(), b.graph())) {
    if (pair.a < 0 || pair.b < 0 || pair.a >= a.edge_outcomes_size() || pair.b >= b.edge_outcomes_size()) continue;
    const v1::EdgeOutcome &was = a.edge_outcomes(pair.a), &is = b.edge_outcomes(pair.b);
    const bool both_missed = was.status() == is.status() && is.status() == v1::OUTCOME_STATUS_VIOLATED;
    if (was.status() == is.status() && !(both_missed && Differs(was.weighted_cost(), is.weighted_cost()))) {
      ++section.same_count;
      continue;
    }
    // Verdicts first, then by how much what does not hold costs.
    const bool is_better = std::pair(is.status(), is.weighted_cost()) < std::pair(was.status(), was.weighted_cost());
    const auto detail = [](const v1::EdgeOutcome& outcome) -> nlohmann::json {
      return {{"status", EnumInWords(outcome.status())}, {"weighted_cost", outcome.weighted_cost()}};
    };
    const v1::ConstraintEdge& edge = b.graph().edges(pair.b);
    section.changes.push_back({is_better ? Became::kBetter : Became::kWorse,
                               fmt::format("{} {}", edge.id(), CallText(edge)),
                               fmt::format("{}; before: {}", StatusWords(is), StatusWords(was)),
                               {{"edge_id", edge.id()}, {"a", detail(was)}, {"b", detail(is)}}});
  }
  return section;
}

Section CompareCosts(const v1::SolvedLayout& a, const v1::SolvedLayout& b) {
  Section section{.title = "costs"};
  const auto compare = [&section](const std::string& what, double was, double is) {
    if (!Differs(was, is)) return void(++section.same_count);
    section.changes.push_back(
        {is < was ? Became::kBetter : Became::kWorse, what, NumberWords("", was, is), {{"a", was}, {"b", is}}});
  };
  compare("total", a.total_cost(), b.total_cost());
  for (const Pair& pair : MatchItems(a, b, "term_outcomes")) {
    const auto weighted = [](const auto& terms, int i) { return i < 0 ? 0.0 : terms[i].cost() * terms[i].factor(); };
    compare(pair.a >= 0 ? a.term_outcomes(pair.a).term() : b.term_outcomes(pair.b).term(),
            weighted(a.term_outcomes(), pair.a), weighted(b.term_outcomes(), pair.b));
  }
  return section;
}

Section CompareMeasures(const v1::LayoutMetrics& a, const v1::LayoutMetrics& b) {
  Section section = FieldsSection("measures", a, b);
  section.same_count = v1::LayoutMetrics::descriptor()->field_count() - static_cast<int>(section.changes.size());
  for (Change& change : section.changes) {
    const nlohmann::json& field = change.detail["fields"][0];
    // Of shares that can be reached, more is better; of all else, less.
    const bool more_is_better = field["field"].get<std::string>().ends_with("_share");
    change.became = (field["b"] > field["a"]) == more_is_better ? Became::kBetter : Became::kWorse;
  }
  return section;
}

}  // namespace

void CompareGraphs(const v1::LayoutGraph& a, const v1::LayoutGraph& b, std::vector<Section>& sections) {
  CompareMessages(a, b, sections);
  AddSection(CompareCalls(a, b), sections);
}

void CompareLayouts(const v1::SolvedLayout& a, const v1::SolvedLayout& b, Difference& difference) {
  CompareGraphs(a.graph(), b.graph(), difference.sections);
  ComparePlaces(a, b, difference);
  AddSection(CompareVerdicts(a, b), difference.sections);
  AddSection(CompareCosts(a, b), difference.sections);
  AddSection(CompareMeasures(a.metrics(), b.metrics()), difference.sections);
  // A variant of a solve says nothing of its stages.
  if (!a.stage_outcomes().empty() && !b.stage_outcomes().empty()) {
    CompareLists(a, b, "stage_outcomes", difference.sections);
  }
}

}  // namespace flair::cli
