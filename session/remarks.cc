// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/remarks.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "fmt/format.h"
#include "session/act_words.h"

namespace flair::session {
namespace {

using Ids = std::set<std::string>;

template <typename List, typename Which>
void EraseIf(List& list, const Which& which) {
  list.erase(std::remove_if(list.begin(), list.end(), which), list.end());
}

// Sentences that ask for something.
Ids Asking(const v1::LayoutGraph& graph) {
  Ids ids;
  for (const v1::ConstraintEdge& edge : graph.edges()) ids.insert(edge.sentence_id());
  return ids;
}

Ids IdsOfAll(const v1::LayoutGraph& graph) {
  Ids ids;
  for (const v1::Object& object : graph.object_list().objects()) ids.insert(object.id());
  return ids;
}

Ids NamesOf(const v1::LayoutGraph& graph) {
  Ids names;
  for (const v1::Object& object : graph.object_list().objects()) names.insert(absl::AsciiStrToLower(object.name()));
  return names;
}

Ids Without(Ids all, const Ids& gone) {
  for (const std::string& id : gone) all.erase(id);
  return all;
}

// Those whose every constraint holds.
Ids Holding(const v1::SolvedLayout& layout) {
  Ids holding = Asking(layout.graph());
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    if (layout.edge_outcomes(i).status() == v1::OUTCOME_STATUS_SATISFIED) continue;
    holding.erase(layout.graph().edges(i).sentence_id());
  }
  holding.erase("");
  return holding;
}

// Whether a text has that among its words: "desk" is in "no desk", not in "desktop".
bool Speaks(const std::string& text, const std::string& name) {
  const auto letter = [&](size_t at) {
    return at < text.size() && absl::ascii_isalnum(static_cast<unsigned char>(text[at]));
  };
  for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    if ((at == 0 || !letter(at - 1)) && !letter(at + name.size())) return true;
  }
  return false;
}

// "Coffee table" answers who missed a table.
bool Supplies(const std::string& name, const std::string& missed) {
  return name == missed || absl::EndsWith(name, " " + missed);
}

}  // namespace

void ForgetWhatIsAnswered(const v1::LayoutGraph& before, v1::SolvedLayout& layout) {
  v1::LayoutGraph& graph = *layout.mutable_graph();
  const Ids silenced = Without(Asking(before), Asking(graph));
  const Ids lost = Without(IdsOfAll(before), IdsOfAll(graph));
  const Ids came = Without(NamesOf(graph), NamesOf(before)), holding = Holding(layout);
  Ids gone = lost;
  const v1::ConstraintList& wishes = graph.constraint_list();
  const v1::ObjectList& objects = graph.object_list();
  std::map<std::string, const v1::Sentence*> sentences;
  for (const v1::Sentence& sentence : before.constraint_list().sentences()) sentences[sentence.id()] = &sentence;
  const auto asks_nothing = [&](const v1::Sentence& sentence) {
    const auto was = sentences.find(sentence.id());
    const bool orphan =
        was != sentences.end() && !was->second->subject_ids().empty() &&
        std::ranges::all_of(was->second->subject_ids(), [&](const auto& id) { return lost.contains(id); });
    if (!orphan && !silenced.contains(sentence.id())) return false;
    gone.insert(sentence.id());
    return true;
  };
  if (!wishes.sentences().empty()) EraseIf(*graph.mutable_constraint_list()->mutable_sentences(), asks_nothing);
  const auto answered = [&](const v1::Diagnostic& remark) {
    if (gone.contains(remark.subject_id())) return true;
    // What of a sentence was not understood is not answered by the rest of it.
    if (holding.contains(remark.subject_id()) && remark.code() != "partial") return true;
    const bool misses = remark.code() == "names_absent_object" || remark.code() == "essential_missing";
    return misses && std::ranges::any_of(came, [&](const std::string& name) {
             return Speaks(absl::AsciiStrToLower(remark.message()), name);
           });
  };
  // What is not there must not come to be by being asked.
  if (graph.room().diagnostics_size() > 0) EraseIf(*graph.mutable_room()->mutable_diagnostics(), answered);
  if (graph.zone_plan().diagnostics_size() > 0) EraseIf(*graph.mutable_zone_plan()->mutable_diagnostics(), answered);
  if (objects.diagnostics_size() > 0) EraseIf(*graph.mutable_object_list()->mutable_diagnostics(), answered);
  if (wishes.diagnostics_size() > 0) EraseIf(*graph.mutable_constraint_list()->mutable_diagnostics(), answered);
  EraseIf(*graph.mutable_diagnostics(), answered);
  EraseIf(*layout.mutable_diagnostics(), answered);
  if (objects.omissions().empty()) return;
  EraseIf(*graph.mutable_object_list()->mutable_omissions(), [&](const v1::Omission& omission) {
    const std::string missed = absl::AsciiStrToLower(omission.name());
    return std::ranges::any_of(came, [&](const std::string& name) { return Supplies(name, missed); });
  });
}

void KeepForgotten(const v1::LayoutGraph& shown, v1::LayoutGraph& graph) {
  Ids known;
  for (const v1::Sentence& sentence : shown.constraint_list().sentences()) known.insert(sentence.id());
  if (graph.constraint_list().sentences_size() > 0) {
    EraseIf(*graph.mutable_constraint_list()->mutable_sentences(),
            [&](const v1::Sentence& sentence) { return !known.contains(sentence.id()); });
  }
  if (graph.has_constraint_list()) {
    *graph.mutable_constraint_list()->mutable_diagnostics() = shown.constraint_list().diagnostics();
  }
  *graph.mutable_diagnostics() = shown.diagnostics();
  *graph.mutable_object_list()->mutable_omissions() = shown.object_list().omissions();
  *graph.mutable_object_list()->mutable_diagnostics() = shown.object_list().diagnostics();
}

v1::Diagnostic WhyNothingMoves(const Acted& acted) {
  constexpr size_t kMost = 3;
  const v1::SolvedLayout& layout = acted.layout;
  Ids locked;
  for (const v1::Placement& pin : layout.graph().pinned_placements()) locked.insert(pin.object_id());
  const Ids by_hand(acted.by_hand.begin(), acted.by_hand.end()), here = IdsOfAll(layout.graph());
  std::vector<std::string> causes;
  Ids told;
  const auto tell = [&](const std::string& id, const std::string& reason) {
    if (reason.empty() || causes.size() == kMost || !told.insert(reason).second) return;
    const std::string name = NameOf(layout, id);
    const std::string stays = locked.contains(id)    ? fmt::format(" (the {} is locked)", name)
                              : by_hand.contains(id) ? fmt::format(" (the {} stays where it was put by hand)", name)
                                                     : "";
    causes.push_back(reason + stays);
  };
  for (int i = 0; i < layout.edge_outcomes_size() && i < layout.graph().edges_size(); ++i) {
    if (layout.edge_outcomes(i).status() != v1::OUTCOME_STATUS_VIOLATED) continue;
    for (const v1::Argument& argument : layout.graph().edges(i).arguments()) {
      if (!here.contains(argument.value().text())) continue;
      tell(argument.value().text(), layout.edge_outcomes(i).reason());
      break;
    }
  }
  for (const v1::Finding& finding : layout.metrics().findings()) tell(finding.object_id(), finding.message());
  v1::Diagnostic why;
  why.set_severity(v1::SEVERITY_NOTE);
  why.set_code("nothing_moved");
  why.set_message(causes.empty() ? "Nothing was moved: all is as good as it gets."
                                 : fmt::format("Nothing was moved: no better places were found, although {}.",
                                               fmt::join(causes, "; ")));
  return why;
}

}  // namespace flair::session
