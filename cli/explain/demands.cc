// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/explain/demands.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

#include "cli/explain/call_words.h"
#include "cli/explain/sentence_words.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/shortfall.h"

namespace flair::cli {
namespace {

constexpr std::array<std::string_view, 6> kOrdinals = {"first", "second", "third", "fourth", "fifth", "sixth"};

// What sentences call an object.
std::vector<std::string> SpokenNames(const Scene& scene, int object) {
  const Object& what = scene.objects[static_cast<size_t>(object)];
  std::vector<std::string> names = {what.id};
  std::string spaced = what.id;
  std::replace(spaced.begin(), spaced.end(), '_', ' ');
  names.push_back(spaced);
  const std::string people = optimizer::NameForPeople(scene, object);
  const bool alone = people.starts_with("the ");
  names.push_back(alone ? people.substr(4) : people);
  size_t place = 0;
  for (int other = 0; other < object; ++other)
    place += scene.objects[static_cast<size_t>(other)].name == what.name ? 1 : 0;
  if (!alone && place < kOrdinals.size()) names.push_back(fmt::format("{} {}", kOrdinals[place], what.name));
  return names;
}

class Collector {
 public:
  Collector(const v1::SolvedLayout& layout, const Scene& scene) : layout_(layout), scene_(scene) {
    for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) names_.push_back(SpokenNames(scene, i));
    for (int e = 0; e < layout.graph().edges_size(); ++e) {
      const std::string& sentence = layout.graph().edges(e).sentence_id();
      if (!sentence.empty()) edges_of_[sentence].push_back(e);
    }
  }

  std::vector<AssignedDemand> Collect() {
    for (const v1::Sentence& sentence : layout_.graph().constraint_list().sentences()) {
      known_.push_back(sentence.id());
      AddSentence(sentence);
    }
    for (int e = 0; e < layout_.graph().edges_size(); ++e) {
      const std::string& id = layout_.graph().edges(e).sentence_id();
      if (id.empty() || std::find(known_.begin(), known_.end(), id) == known_.end()) AddCall(e);
    }
    return std::move(demands_);
  }

 private:
  void AddSentence(const v1::Sentence& sentence) {
    Demand demand;
    demand.sentence_id = sentence.id();
    demand.text = sentence.text();
    demand.reason = sentence.reason();
    std::vector<int> subjects, named;
    const std::vector<int>& edges = edges_of_[sentence.id()];
    for (const int e : edges) {
      AddOutcome(e, demand);
      Append(SubjectsOf(layout_.graph().edges(e), scene_), subjects);
      Append(AllNamedIn(layout_.graph().edges(e), scene_), named);
    }
    // Who the sentence says it is about knows better than a call that may be written either way round.
    const int first = sentence.subject_ids_size() > 0 ? scene_.IndexOf(sentence.subject_ids(0)) : -1;
    if (first >= 0 && subjects.size() <= 1) subjects = {first};
    if (edges.empty()) SayNotUnderstood(sentence, demand);
    Assign(
        subjects, named, [&](int object) { return AboutIt(sentence.text(), NamesOf(object), OtherNames(object)); },
        demand);
  }

  void AddCall(int e) {
    const v1::ConstraintEdge& edge = layout_.graph().edges(e);
    Demand demand;
    AddOutcome(e, demand);
    const std::string words = fmt::format("It {}", CallInWords(edge, scene_));
    Assign(SubjectsOf(edge, scene_), AllNamedIn(edge, scene_), [&](int) { return words; }, demand);
  }

  template <typename AboutObject>
  void Assign(const std::vector<int>& subjects, const std::vector<int>& named, const AboutObject& about,
              const Demand& demand) {
    for (const int object : subjects.empty() ? std::vector<int>{-1} : subjects) {
      AssignedDemand& assigned = demands_.emplace_back(AssignedDemand{object, demand});
      assigned.demand.about_it = object < 0 ? demand.text : about(object);
      for (const int other : named) {
        if (other != object) assigned.demand.other_ids.push_back(scene_.objects[static_cast<size_t>(other)].id);
      }
    }
  }

  // The worst of its calls decides; among equally bad ones the first has the word.
  void AddOutcome(int e, Demand& demand) const {
    demand.edge_ids.push_back(layout_.graph().edges(e).id());
    demand.types.push_back(layout_.graph().edges(e).type());
    if (e >= layout_.edge_outcomes_size()) return;
    const v1::EdgeOutcome& outcome = layout_.edge_outcomes(e);
    DemandFate fate = DemandFate::kHolds;
    if (outcome.status() == v1::OUTCOME_STATUS_VIOLATED) fate = DemandFate::kMissed;
    if (outcome.status() == v1::OUTCOME_STATUS_DROPPED) fate = DemandFate::kDropped;
    const bool worse = fate == DemandFate::kMissed ? demand.fate != DemandFate::kMissed
                                                   : fate != demand.fate && demand.fate == DemandFate::kHolds;
    if (!worse) return;
    demand.fate = fate;
    demand.shortfall = outcome.reason();
    if (outcome.has_missed_by()) demand.missed_by = outcome.missed_by();
    demand.unit = outcome.unit();
  }

  void SayNotUnderstood(const v1::Sentence& sentence, Demand& demand) const {
    demand.fate = DemandFate::kNotUnderstood;
    for (const v1::Diagnostic& diagnostic : layout_.graph().diagnostics()) {
      if (diagnostic.subject_id() == sentence.id() && demand.shortfall.empty()) demand.shortfall = diagnostic.message();
    }
  }

  const std::vector<std::string>& NamesOf(int object) const { return names_[static_cast<size_t>(object)]; }

  std::vector<std::string> OtherNames(int object) const {
    std::vector<std::string> others;
    for (size_t i = 0; i < names_.size(); ++i) {
      if (static_cast<int>(i) != object) others.insert(others.end(), names_[i].begin(), names_[i].end());
    }
    return others;
  }

  static void Append(const std::vector<int>& from, std::vector<int>& to) {
    for (const int object : from) {
      if (std::find(to.begin(), to.end(), object) == to.end()) to.push_back(object);
    }
  }

  const v1::SolvedLayout& layout_;
  const Scene& scene_;
  std::vector<std::vector<std::string>> names_;
  std::map<std::string, std::vector<int>> edges_of_;
  std::vector<std::string> known_;
  std::vector<AssignedDemand> demands_;
};

}  // namespace

std::vector<AssignedDemand> CollectDemands(const v1::SolvedLayout& layout, const Scene& scene) {
  return Collector(layout, scene).Collect();
}

bool DrawsNear(const std::string& type) {
  static constexpr std::array<std::string_view, 15> kTypes = {
      "between",      "ceiling_above",    "in_front_of",       "near",          "next_to",
      "on",           "on_top_center",    "on_top_corner",     "on_wall_above", "on_wall_facing",
      "on_wall_near", "rug_under_center", "rug_under_forward", "surround",      "under_center"};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

}  // namespace flair::cli
