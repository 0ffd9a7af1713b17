// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/diff/pairing.h"

#include <algorithm>

#include "cli/output/artifact_text.h"
#include "fmt/format.h"

namespace flair::cli {

namespace {

// The words of the sentence a call comes from.
std::map<std::string, std::string> WordsById(const v1::ConstraintList& list) {
  std::map<std::string, std::string> words;
  for (const v1::Sentence& sentence : list.sentences()) words[sentence.id()] = sentence.text();
  return words;
}

}  // namespace

std::string BareCall(const v1::ConstraintEdge& edge) {
  v1::ConstraintEdge bare = edge;
  bare.set_weight(1);
  // Arguments have names, so their order says nothing.
  std::sort(bare.mutable_arguments()->begin(), bare.mutable_arguments()->end(),
            [](const v1::Argument& x, const v1::Argument& y) { return x.name() < y.name(); });
  return CallText(bare);
}

std::vector<Pair> PairObjects(const v1::ObjectList& a, const v1::ObjectList& b) {
  return MatchThings(
      a.objects(), b.objects(), [](const v1::Object& object) { return object.id(); },
      [](const v1::Object& object) {
        return fmt::format("{}\n{}\n{}", object.name(), static_cast<int>(object.kind()), object.zone_id());
      },
      [](const v1::Object& object) { return fmt::format("{}\n{}", object.name(), static_cast<int>(object.kind())); });
}

std::vector<Pair> PairCalls(const v1::LayoutGraph& a, const v1::LayoutGraph& b) {
  const std::map<std::string, std::string> of_a = WordsById(a.constraint_list()), of_b = WordsById(b.constraint_list());
  // What an edge of either graph says, worked out once.
  std::map<const v1::ConstraintEdge*, std::string> calls, calls_of_sentences;
  const auto read = [&](const v1::LayoutGraph& graph, const std::map<std::string, std::string>& words) {
    for (const v1::ConstraintEdge& edge : graph.edges()) {
      calls[&edge] = BareCall(edge);
      const auto found = words.find(edge.sentence_id());
      calls_of_sentences[&edge] = calls[&edge] + "\n" + (found == words.end() ? "" : found->second);
    }
  };
  read(a, of_a);
  read(b, of_b);
  return MatchThings(
      a.edges(), b.edges(), [&](const v1::ConstraintEdge& edge) { return calls_of_sentences.at(&edge); },
      [&](const v1::ConstraintEdge& edge) { return calls.at(&edge); },
      [](const v1::ConstraintEdge& edge) { return edge.id().empty() ? "" : edge.id() + "\n" + edge.type(); });
}

std::vector<Pair> PairSentences(const v1::ConstraintList& a, const v1::ConstraintList& b) {
  return MatchThings(
      a.sentences(), b.sentences(), [](const v1::Sentence& sentence) { return sentence.text(); },
      [](const v1::Sentence& sentence) { return sentence.id(); });
}

}  // namespace flair::cli
