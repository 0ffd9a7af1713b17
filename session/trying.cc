// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/trying.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "absl/strings/str_join.h"
#include "fmt/format.h"
#include "optimizer_worker/solver/separation.h"
#include "room/conversion/conversion.h"

namespace flair::session {
namespace {

// What stands this near to a piece may be what it needs the room of.
constexpr double kReach_m = 1.0;
// As for a resolve: nothing moves for a gain of less.
constexpr double kWorthMoving = 0.05;
// What a way through the room is worth against sentences: a tenth of the floor as much as one of weight 1.
constexpr double kWayWeight = 10;

double FaultsOf(const v1::SolvedLayout& layout) {
  const auto& findings = layout.metrics().findings();
  const auto faults = std::ranges::count_if(
      findings, [](const v1::Finding& one) { return one.kind() != v1::FINDING_KIND_USE_NOT_MET; });
  return static_cast<double>(faults + layout.graph().object_list().objects_size() - layout.placements_size());
}

double MissedBy(const v1::SolvedLayout& layout, const v1::SolvedLayout& before) {
  double missed = 0;
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    if (layout.edge_outcomes(i).status() != v1::OUTCOME_STATUS_SATISFIED) missed += layout.graph().edges(i).weight();
  }
  for (const v1::Finding& one : layout.metrics().findings()) missed += one.kind() == v1::FINDING_KIND_USE_NOT_MET;
  const double lost = before.metrics().reachable_floor_share() - layout.metrics().reachable_floor_share();
  return missed + kWayWeight * std::max(0.0, lost);
}

}  // namespace

IdSet ObjectsOf(const v1::ConstraintEdge& edge, const v1::LayoutGraph& graph) {
  IdSet known, named;
  for (const v1::Object& object : graph.object_list().objects()) known.insert(object.id());
  for (const v1::Argument& argument : edge.arguments()) {
    if (known.contains(argument.value().text())) named.insert(argument.value().text());
    for (const std::string& text : argument.value().texts().items()) {
      if (known.contains(text)) named.insert(text);
    }
  }
  return named;
}

IdSet ObjectsOf(const IdSet& sentence_ids, const v1::LayoutGraph& graph) {
  IdSet ids;
  for (const v1::ConstraintEdge& edge : graph.edges()) {
    if (sentence_ids.contains(edge.sentence_id())) ids.merge(ObjectsOf(edge, graph));
  }
  return ids;
}

IdSet UnmetSentences(const v1::SolvedLayout& layout) {
  IdSet unmet;
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    const std::string& sentence = layout.graph().edges(i).sentence_id();
    if (layout.edge_outcomes(i).status() != v1::OUTCOME_STATUS_SATISFIED && !sentence.empty()) unmet.insert(sentence);
  }
  return unmet;
}

std::string WhyUnmet(const v1::SolvedLayout& layout, const IdSet& sentence_ids) {
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    const v1::EdgeOutcome& outcome = layout.edge_outcomes(i);
    if (!sentence_ids.contains(layout.graph().edges(i).sentence_id())) continue;
    if (outcome.status() == v1::OUTCOME_STATUS_SATISFIED) continue;
    return outcome.reason().empty() ? "other wishes stand against it" : outcome.reason();
  }
  return "";
}

IdSet InReach(const v1::SolvedLayout& layout, const IdSet& ids) {
  IdSet reached = ids;
  for (const v1::ConstraintEdge& edge : layout.graph().edges()) {
    IdSet named = ObjectsOf(edge, layout.graph());
    if (std::ranges::any_of(named, [&](const std::string& id) { return ids.contains(id); })) reached.merge(named);
  }
  const absl::StatusOr<Scene> scene = SceneFromProto(layout.graph());
  if (!scene.ok()) return reached;
  std::map<std::string, Box<double>> boxes;
  for (const v1::Placement& at : layout.placements()) {
    const int index = scene->IndexOf(at.object_id());
    if (index < 0 || !IsSolid(scene->objects[index])) continue;
    const Pose<double> pose{at.x_m(), at.y_m(), at.theta_rad()};
    boxes.emplace(at.object_id(), Box<double>(scene->objects[index].footprint, FrameOf(pose)));
  }
  for (const auto& [id, box] : boxes) {
    for (const std::string& one : ids) {
      const auto other = boxes.find(one);
      if (other != boxes.end() && optimizer::Separate(box, other->second).gap_m < kReach_m) reached.insert(id);
    }
  }
  for (bool more = true; more;) {
    more = false;
    for (const v1::Object& object : layout.graph().object_list().objects()) {
      more = (reached.contains(object.host_id()) && reached.insert(object.id()).second) || more;
    }
  }
  return reached;
}

bool IsBetter(const v1::SolvedLayout& a, const v1::SolvedLayout& b, const v1::SolvedLayout& before) {
  constexpr double kRounding = 1e-6;
  if (FaultsOf(a) != FaultsOf(b)) return FaultsOf(a) < FaultsOf(b);
  const double gain = MissedBy(b, before) - MissedBy(a, before);
  if (std::abs(gain) > kRounding) return gain > 0;
  return a.total_cost() < b.total_cost() - kWorthMoving;
}

IdSet OfRoom(const IdSet& sentence_ids, const v1::LayoutGraph& graph) {
  IdSet of_room;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence.scope() == v1::SENTENCE_SCOPE_INTRA && sentence_ids.contains(sentence.id())) {
      of_room.insert(sentence.id());
    }
  }
  return of_room;
}

bool HasMoreFaults(const v1::SolvedLayout& layout, const v1::SolvedLayout& before) {
  return FaultsOf(layout) > FaultsOf(before);
}

bool IsWorseOff(const v1::SolvedLayout& layout, const v1::SolvedLayout& before) {
  constexpr double kClearly = 0.03;
  const double lost = before.metrics().reachable_floor_share() - layout.metrics().reachable_floor_share();
  return HasMoreFaults(layout, before) || lost > kClearly;
}

void LendSentences(const v1::LayoutGraph& from, v1::LayoutGraph& to) {
  IdSet known;
  for (const v1::Sentence& sentence : to.constraint_list().sentences()) known.insert(sentence.id());
  for (const v1::Sentence& sentence : from.constraint_list().sentences()) {
    if (known.contains(sentence.id())) continue;
    v1::Sentence& lent = *to.mutable_constraint_list()->add_sentences();
    lent = sentence;
    lent.clear_subject_ids();
    lent.clear_meaning();
  }
}

void ReturnSubjects(const v1::LayoutGraph& from, v1::LayoutGraph& to) {
  IdSet objects;
  for (const v1::Object& object : to.object_list().objects()) objects.insert(object.id());
  const auto are_there = [&](const auto& participants) {
    return std::ranges::all_of(participants, [&](const v1::Participant& one) {
      return !one.has_object_id() || objects.contains(one.object_id());
    });
  };
  std::map<std::string, const v1::Sentence*> known;
  for (const v1::Sentence& sentence : from.constraint_list().sentences()) known[sentence.id()] = &sentence;
  for (v1::Sentence& sentence : *to.mutable_constraint_list()->mutable_sentences()) {
    const auto full = known.find(sentence.id());
    if (full == known.end() || !sentence.subject_ids().empty()) continue;
    for (const std::string& id : full->second->subject_ids()) {
      if (objects.contains(id)) sentence.add_subject_ids(id);
    }
    const bool whole = std::ranges::all_of(full->second->meaning().facts(), [&](const v1::Fact& fact) {
      return are_there(fact.movers()) && are_there(fact.targets()) && are_there(fact.others());
    });
    if (full->second->has_meaning() && whole) *sentence.mutable_meaning() = full->second->meaning();
  }
}

bool ForgetWhatIsGone(const v1::LayoutGraph& before, v1::LayoutGraph& graph) {
  IdSet objects, known, lost, spoken;
  for (const v1::Object& object : graph.object_list().objects()) objects.insert(object.id());
  for (const v1::Sentence& sentence : before.constraint_list().sentences()) known.insert(sentence.id());
  for (const v1::ConstraintEdge& edge : graph.edges()) spoken.insert(edge.sentence_id());
  for (const v1::ConstraintEdge& edge : before.edges()) {
    if (!std::ranges::includes(objects, ObjectsOf(edge, before))) lost.insert(edge.sentence_id());
  }
  auto& sentences = *graph.mutable_constraint_list()->mutable_sentences();
  const int had = sentences.size();
  for (int i = had - 1; i >= 0; --i) {
    const std::string& id = sentences[i].id();
    if (!spoken.contains(id) && (lost.contains(id) || !known.contains(id))) sentences.DeleteSubrange(i, 1);
  }
  return sentences.size() < had;
}

std::string QuotedTexts(const v1::LayoutGraph& graph, const IdSet& sentence_ids) {
  constexpr size_t kMost = 3;
  std::vector<std::string> texts;
  for (const v1::Sentence& sentence : graph.constraint_list().sentences()) {
    if (sentence_ids.contains(sentence.id()) && texts.size() < kMost) {
      texts.push_back(fmt::format("\"{}\"", sentence.text()));
    }
  }
  if (texts.size() < 2) return absl::StrJoin(texts, "");
  const std::string last = texts.back();
  texts.pop_back();
  return absl::StrJoin(texts, ", ") + " and " + last;
}

}  // namespace flair::session
