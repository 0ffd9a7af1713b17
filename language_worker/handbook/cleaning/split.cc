// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/cleaning/split.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>
#include <utility>

namespace flair::language {
namespace {

using Parts = std::optional<std::pair<std::string, std::string>>;

constexpr std::array<std::string_view, 12> kSentenceVerbs = {"is",  "are",  "should", "must",   "faces",  "face",
                                                             "has", "have", "does",   "stands", "leaves", "keeps"};
constexpr std::array<std::string_view, 12> kCopulas = {
    " should not be ", " must not be ", " is not ", " are not ", " should be placed ", " is placed ",
    " should be ",     " must be ",     " is ",     " are ",     " stands ",           " stand "};
constexpr std::array<std::string_view, 13> kRelationWords = {
    "against", "near",     "close to", "next to",     "away from", "in front of", "under",
    "beside",  "opposite", "facing",   "in a corner", "at least",  "within"};

bool StartsWith(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

bool StartsWithWord(std::string_view text, std::string_view word) {
  return StartsWith(text, word) &&
         (text.size() == word.size() || std::isalpha(static_cast<unsigned char>(text[word.size()])) == 0);
}

std::string Sentence(std::string text) {
  while (!text.empty() && (text.back() == ' ' || text.back() == ',' || text.back() == ';' || text.back() == '.'))
    text.pop_back();
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

// "… doors or windows …"
Parts SplitOpenings(const std::string& text) {
  constexpr std::array<std::array<std::string_view, 2>, 2> kNouns = {{{"doors", "windows"}, {"door", "window"}}};
  for (const auto& [door, window] : kNouns) {
    for (const std::string_view joint : {" or ", " and ", " or the ", " and the ", " or any ", " nor ", " or a "}) {
      for (const auto& [first, second] : {std::pair(door, window), std::pair(window, door)}) {
        const std::string both = std::string(first) + std::string(joint) + std::string(second);
        const std::size_t at = text.find(both);
        if (at == std::string::npos) continue;
        const char after = at + both.size() >= text.size() ? '.' : text[at + both.size()];
        if (std::isalpha(static_cast<unsigned char>(after)) != 0) continue;
        const auto with = [&](std::string_view noun) { return std::string(text).replace(at, both.size(), noun); };
        return std::pair(with(first), with(second));
      }
    }
  }
  return std::nullopt;
}

// The words before the first verb: who the sentence is about.
std::string SubjectOf(std::string_view clause) {
  std::size_t first = std::string_view::npos;
  for (const std::string_view verb : kSentenceVerbs) {
    first = std::min(first, clause.find(" " + std::string(verb) + " "));
  }
  return first == std::string_view::npos ? "" : std::string(clause.substr(0, first));
}

// The subject with the copula behind it, "The desk is ", to which a place can be added; empty when there is none.
std::string PlacedSubjectOf(std::string_view clause) {
  std::size_t best = std::string_view::npos, end = 0;
  for (const std::string_view copula : kCopulas) {
    const std::size_t at = clause.find(copula);
    if (at < best) {  // at equal places the longer copula stands earlier in the list
      best = at;
      end = at + copula.size();
    }
  }
  return best == std::string_view::npos ? "" : std::string(clause.substr(0, end));
}

Parts SplitClauses(const std::string& text) {
  if (const std::size_t semicolon = text.find("; "); semicolon != std::string::npos) {
    return std::pair(Sentence(text.substr(0, semicolon)), Sentence(text.substr(semicolon + 2)));
  }
  for (std::size_t at = text.find(" and "); at != std::string::npos; at = text.find(" and ", at + 1)) {
    const std::string_view rest = std::string_view(text).substr(at + 5);
    const std::string left = text.substr(0, at);
    for (const std::string_view verb : kSentenceVerbs) {
      const std::string subject = SubjectOf(left);
      if (StartsWithWord(rest, verb) && !subject.empty()) {
        return std::pair(Sentence(left), Sentence(subject + " " + std::string(rest)));
      }
    }
    for (const std::string_view place : kRelationWords) {
      const std::string subject = PlacedSubjectOf(left);
      if (StartsWithWord(rest, place) && !subject.empty()) {
        return std::pair(Sentence(left), Sentence(subject + std::string(rest)));
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> SplitStatements(const std::string& text) {
  Parts parts = SplitOpenings(text);
  if (!parts) parts = SplitClauses(text);
  if (!parts || parts->first.size() < 3 || parts->second.size() < 3) return {text};
  std::vector<std::string> statements = SplitStatements(parts->first);
  for (std::string& more : SplitStatements(parts->second)) statements.push_back(std::move(more));
  return statements;
}

}  // namespace flair::language
