// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SceneNames that finds zones, doors and windows.
#include <algorithm>

#include "english/lexicon.h"
#include "english/words.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {
namespace {

// Whether the two are words for one use of a room.
bool SameUse(const std::string& a, const std::string& b) {
  const auto has = [](const english::v1::WordList& list, const std::string& word) {
    return std::ranges::find(list.words(), word) != list.words().end();
  };
  const auto& lists = english::Language::Get().data().lists();
  return std::ranges::any_of(
      lists, [&](const english::v1::WordList& list) { return list.name() == "uses" && has(list, a) && has(list, b); });
}

// "Reading spot": words that say nothing alone make a zone of its name.
bool IsAreaWord(const std::vector<Token>& tokens, size_t at) {
  if (at >= tokens.size()) return false;
  // "In the reading space", but not "enough working space".
  if (tokens[at].IsWord("space")) return at > 2 && tokens[at - 2].IsWord("the") && !tokens[at - 3].IsWord("of");
  return Lexicon::Get().Find(tokens, at, 1).word_class == english::v1::WORD_CLASS_AREA || tokens[at].IsWord("spot") ||
         tokens[at].IsWord("furniture") || tokens[at].IsWord("nook");
}

}  // namespace

size_t SceneNames::ZoneLength(const v1::Zone& zone, const std::vector<Token>& tokens, size_t at) const {
  const std::vector<std::string> words = NameWords(zone.name().empty() ? zone.id() : zone.name());
  if (words.empty() || at >= tokens.size()) return 0;
  size_t next = at;
  for (const std::string& word : words) {
    // "Shower/Bath", "Cooking and Eating".
    if (next > at && next < tokens.size() && (tokens[next].IsMark('/') || tokens[next].IsWord("and"))) ++next;
    if (next >= tokens.size() || tokens[next].kind != Token::Kind::kWord ||
        !english::BeginAlike(tokens[next].text, word))
      return 0;
    ++next;
  }
  return next - at;
}

SceneNames::Found SceneNames::FindZone(const std::vector<Token>& tokens, size_t at) const {
  for (const v1::Zone& zone : zones_.zones()) {
    const size_t words = ZoneLength(zone, tokens, at);
    if (words == 0) continue;
    const size_t next = at + words;
    // "the seating area", "the workstation and relaxation areas".
    for (size_t i = next; i < std::min(tokens.size(), next + 5); ++i) {
      if (IsAreaWord(tokens, i)) {
        Found found;
        found.reference.kind = RefKind::kZone;
        found.reference.name = zone.id();
        found.length = i == next ? words + 1 : words;
        return found;
      }
      if (i > next && !tokens[i].IsWord("or") && !tokens[i].IsWord("and") && tokens[i - 1].kind != Token::Kind::kWord)
        break;
      if (i == next && !tokens[i].IsWord("or") && !tokens[i].IsWord("and")) break;
    }
  }
  return {};
}

SceneNames::Found SceneNames::FindZoneByUse(const std::vector<Token>& tokens, size_t at) const {
  if (tokens[at].kind != Token::Kind::kWord) return {};
  // "The workspace" is a place by itself, "the eating area" needs its second word.
  const bool area = at + 1 < tokens.size() && IsAreaWord(tokens, at + 1);
  if (!area && !tokens[at].IsWord("workspace") && !tokens[at].IsWord("workstation")) return {};
  for (const v1::Zone& zone : zones_.zones()) {
    const std::vector<std::string> words = NameWords(zone.name().empty() ? zone.id() : zone.name());
    if (words.empty() || !SameUse(tokens[at].text, words.front())) continue;
    Found found;
    found.reference.kind = RefKind::kZone;
    found.reference.name = zone.id();
    found.length = area ? 2 : 1;
    return found;
  }
  return {};
}

SceneNames::Found SceneNames::FindOpening(const std::vector<Token>& tokens, size_t at) const {
  const auto begins = [&](const std::vector<std::string>& words) {
    bool same = !words.empty() && at + words.size() <= tokens.size();
    for (size_t i = 0; same && i < words.size(); ++i) same = tokens[at + i].text == words[i];
    return same;
  };
  Found found;
  for (const v1::Opening& opening : room_.openings()) {
    const std::string kind = opening.kind() == v1::OPENING_KIND_DOOR ? "door" : "window";
    std::vector<std::string> words = NameWords(opening.id());
    if (!begins(words)) {
      words = NameWords(opening.wall());
      if (words.empty() || words.front() == "wall") continue;
      words.push_back(kind);
      if (!begins(words)) continue;
      // Of two on a wall neither is meant alone.
      if (found.length > 0) return {};
    }
    found.length = words.size();
    found.reference.kind = RefKind::kFeature;
    found.reference.name = kind;
    found.reference.opening = opening.id();
  }
  return found;
}

}  // namespace flair::translator
