// SPDX-License-Identifier: GPL-3.0-or-later
// Where things stand.
#include <algorithm>

#include "cli/diff/compare_things.h"
#include "cli/diff/content_difference.h"
#include "cli/diff/pairing.h"
#include "cli/diff/place_change.h"
#include "fmt/format.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
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

}  // namespace flair::cli
