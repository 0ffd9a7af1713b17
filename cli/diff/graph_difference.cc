// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms, zones, objects, sentences and calls.
#include <algorithm>

#include "cli/diff/difference.h"
#include "cli/diff/field_words.h"
#include "cli/diff/pairing.h"
#include "cli/output/artifact_text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

std::string ObjectName(const v1::Object& object) {
  return object.name().empty() || object.name() == object.id() ? object.id()
                                                               : fmt::format("{} ({})", object.id(), object.name());
}

std::string ObjectFacts(const v1::Object& object) {
  const std::string zone = object.zone_id().empty() ? "the whole room" : object.zone_id();
  return fmt::format("{:.2f} x {:.2f} x {:.2f} m, of {}", object.width_m(), object.depth_m(), object.height_m(), zone);
}

std::string FloorWords(const v1::Polygon& floor) {
  double width = 0, depth = 0;
  for (const v1::Point2& vertex : floor.vertices()) {
    width = std::max(width, vertex.x_m());
    depth = std::max(depth, vertex.y_m());
  }
  return fmt::format("{:.2f} x {:.2f} m, {} corners", width, depth, floor.vertices_size());
}

nlohmann::json FloorPoints(const v1::Polygon& floor) {
  nlohmann::json points = nlohmann::json::array();
  for (const v1::Point2& vertex : floor.vertices()) points.push_back({vertex.x_m(), vertex.y_m()});
  return points;
}

// Where an opening or socket is.
template <typename Feature>
std::string OnWall(const Feature& feature) {
  return fmt::format("in {}, {:.2f} m from its start", feature.wall(), feature.offset_m());
}

const auto kId = [](const auto& thing) { return thing.id(); };

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
    } else if (auto changed = ChangedFields(a.edges(pair.a), edge, {"id", "sentence_id", "arguments"})) {
      section.changes.push_back({Became::kChanged, subject, changed->words, changed->detail});
    } else {
      ++section.same_count;
    }
  }
  return section;
}

}  // namespace

void CompareRooms(const v1::Room& a, const v1::Room& b, std::vector<Section>& sections) {
  Section room = FieldsSection("room", a, b, {"floor", "walls", "openings", "sockets", "diagnostics"});
  if (FloorPoints(a.floor()) != FloorPoints(b.floor())) {
    const std::string of_a = FloorWords(a.floor()), of_b = FloorWords(b.floor());
    const std::string words = of_a == of_b ? "other corners" : fmt::format("{} -> {}", of_a, of_b);
    room.changes.push_back(
        {Became::kChanged, "floor", words, {{"a", FloorPoints(a.floor())}, {"b", FloorPoints(b.floor())}}});
  }
  AddSection(std::move(room), sections);
  AddSection(CompareThings("openings", a.openings(), b.openings(), MatchThings(a.openings(), b.openings(), kId), kId,
                           [](const v1::Opening& opening) {
                             return fmt::format("{}, {:.2f} m wide", OnWall(opening), opening.width_m());
                           }),
             sections);
  AddSection(CompareThings("sockets", a.sockets(), b.sockets(), MatchThings(a.sockets(), b.sockets(), kId), kId,
                           OnWall<v1::Socket>),
             sections);
}

void CompareZones(const v1::ZonePlan& a, const v1::ZonePlan& b, std::vector<Section>& sections) {
  AddSection(CompareThings("zones", a.zones(), b.zones(), MatchThings(a.zones(), b.zones(), kId), kId,
                           [](const v1::Zone& zone) { return zone.purpose(); }),
             sections);
}

void CompareObjects(const v1::ObjectList& a, const v1::ObjectList& b, std::vector<Section>& sections) {
  AddSection(CompareThings("objects", a.objects(), b.objects(), PairObjects(a, b), ObjectName, ObjectFacts), sections);
  AddSection(
      CompareThings(
          "left out", a.omissions(), b.omissions(),
          MatchThings(a.omissions(), b.omissions(), [](const v1::Omission& left) { return left.name(); }),
          [](const v1::Omission& left) { return left.name(); }, [](const v1::Omission& left) { return left.reason(); }),
      sections);
}

void CompareStyles(const v1::StyleSheet& a, const v1::StyleSheet& b, std::vector<Section>& sections) {
  AddSection(FieldsSection("style", a, b, {"surfaces", "objects", "diagnostics"}), sections);
  const auto surface = [](const v1::SurfaceStyle& style) { return style.surface(); };
  AddSection(CompareThings("surfaces", a.surfaces(), b.surfaces(), MatchThings(a.surfaces(), b.surfaces(), surface),
                           surface, [](const v1::SurfaceStyle& style) { return style.material(); }),
             sections);
  const auto subject = [](const v1::ObjectStyle& style) { return style.subject_id(); };
  AddSection(CompareThings("looks", a.objects(), b.objects(), MatchThings(a.objects(), b.objects(), subject), subject,
                           [](const v1::ObjectStyle& style) { return style.material(); }),
             sections);
}

void CompareSentences(const v1::ConstraintList& a, const v1::ConstraintList& b, std::vector<Section>& sections) {
  // Which number a sentence has says nothing when it says the same.
  AddSection(CompareThings(
                 "sentences", a.sentences(), b.sentences(), PairSentences(a, b),
                 [](const v1::Sentence& sentence) { return fmt::format("{} {}", sentence.id(), sentence.text()); },
                 [](const v1::Sentence& sentence) {
                   return sentence.weight() == 1 ? "" : fmt::format("weight {:g}", sentence.weight());
                 },
                 {"id", "made_from_ids"}),
             sections);
  if (a.cleaning_steps_size() + b.cleaning_steps_size() > 0) {
    AddSection(FieldsSection("cleaning", a, b, {"sentences", "diagnostics"}), sections);
  }
}

void CompareGraphs(const v1::LayoutGraph& a, const v1::LayoutGraph& b, std::vector<Section>& sections) {
  CompareRooms(a.room(), b.room(), sections);
  CompareZones(a.zone_plan(), b.zone_plan(), sections);
  CompareObjects(a.object_list(), b.object_list(), sections);
  CompareStyles(a.style_sheet(), b.style_sheet(), sections);
  CompareSentences(a.constraint_list(), b.constraint_list(), sections);
  AddSection(CompareCalls(a, b), sections);
  AddSection(FieldsSection("catalogue", a, b,
                           {"room", "zone_plan", "object_list", "style_sheet", "constraint_list", "edges",
                            "diagnostics", "pinned_placements"}),
             sections);
  const auto pinned = [](const v1::Placement& place) { return place.object_id(); };
  AddSection(CompareThings("pinned", a.pinned_placements(), b.pinned_placements(),
                           MatchThings(a.pinned_placements(), b.pinned_placements(), pinned), pinned,
                           [](const v1::Placement& place) {
                             return fmt::format("at {:.2f}, {:.2f} m", place.x_m(), place.y_m());
                           }),
             sections);
}

}  // namespace flair::cli
