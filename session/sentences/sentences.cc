// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/sentences/sentences.h"

#include <algorithm>
#include <map>

#include "absl/strings/str_join.h"
#include "fmt/format.h"

namespace flair::session {

IdSet UnmetSentences(const v1::SolvedLayout& layout) {
  IdSet unmet;
  ForOutcomes(layout, [&](const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) {
    if (outcome.status() != v1::OUTCOME_STATUS_SATISFIED) unmet.insert(edge.sentence_id());
  });
  unmet.erase("");
  return unmet;
}

std::string WhyUnmet(const v1::SolvedLayout& layout, const IdSet& sentence_ids) {
  std::string why;
  ForOutcomes(layout, [&](const v1::ConstraintEdge& edge, const v1::EdgeOutcome& outcome) {
    const bool unmet = outcome.status() != v1::OUTCOME_STATUS_SATISFIED && sentence_ids.contains(edge.sentence_id());
    if (!unmet || !why.empty()) return;
    why = outcome.reason().empty() ? "other wishes stand against it" : outcome.reason();
  });
  return why;
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

void LendSentences(const v1::LayoutGraph& from, v1::LayoutGraph& to) {
  const IdSet known = IdsOf(to.constraint_list().sentences());
  for (const v1::Sentence& sentence : from.constraint_list().sentences()) {
    if (known.contains(sentence.id())) continue;
    v1::Sentence& lent = *to.mutable_constraint_list()->add_sentences();
    lent = sentence;
    lent.clear_subject_ids();
    lent.clear_meaning();
  }
}

void ReturnSubjects(const v1::LayoutGraph& from, v1::LayoutGraph& to) {
  const IdSet objects = IdsOf(to.object_list().objects());
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
