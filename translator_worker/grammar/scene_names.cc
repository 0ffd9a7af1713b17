// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/scene_names.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <string_view>
#include <utility>

#include "absl/strings/str_join.h"
#include "english/lexicon.h"
#include "english/words.h"

namespace flair::translator {
namespace {

constexpr size_t kLongestName = 6;
// What is chosen later ranks after everything else that bears a name.
constexpr int kLaterRank = 10;
// "Bench" for "workbench".
constexpr int kCompoundRank = 3;
// "TV" for "TV stand".
constexpr int kFrontRank = 4;

std::vector<std::string> SingularWords(const std::string& name) {
  std::vector<std::string> words = NameWords(name);
  for (std::string& word : words) word = english::Singular(word);
  return words;
}

bool IsNumber(const std::string& word) {
  return !word.empty() && word.size() < 4 && std::ranges::all_of(word, [](char c) { return c >= '0' && c <= '9'; });
}

int NumberOf(const std::string& word) { return IsNumber(word) ? std::atoi(word.c_str()) : 0; }

bool IsIn(std::string_view list, std::string_view word) { return english::Language::Get().IsIn(list, word); }

// "bench" of a workbench, "table" of a worktable; empty for other words.
std::string HeadOfCompound(const std::string& word) {
  constexpr size_t kShortestFirstPart = 3;
  for (size_t cut = kShortestFirstPart; cut < word.size(); ++cut) {
    if (IsIn("heads of compounds", word.substr(cut))) return word.substr(cut);
  }
  return "";
}

// "Toy storage" of a toy storage unit, "vanity" of a vanity with sink: enough of a name.
bool NamesByItself(const std::vector<std::string>& words, size_t length) {
  const auto joint = [&](size_t i) { return IsIn("name joints", words[i]); };
  return joint(length) || (length > 1 && !joint(length - 1));
}

// "nightstand 2" is a nightstand.
std::vector<std::string> WithoutLastNumber(std::vector<std::string> words) {
  if (words.size() > 1 && IsNumber(words.back())) words.pop_back();
  return words;
}

}  // namespace

std::vector<std::string> NameWords(const std::string& name) {
  std::vector<std::string> words;
  for (const Token& token : english::KeepClauseMarks(english::Tokenize(name))) {
    // "Captain's desk" is found whether or not it is said so.
    if (token.kind != Token::Kind::kSign && !token.IsWord("'s")) words.push_back(token.text);
  }
  return words;
}

SceneNames::SceneNames(const v1::Room& room, const v1::ZonePlan& zones, const v1::ObjectList& objects,
                       NamedObjects named)
    : room_(room), zones_(zones), objects_(objects), numbers_(objects.objects_size(), 0) {
  const auto rank = [&](const v1::Object& object) {
    const bool first = named == NamedObjects::kAll || object.role() != v1::OBJECT_ROLE_TERTIARY ||
                       object.kind() == v1::OBJECT_KIND_FLOOR;
    return first ? 0 : kLaterRank;
  };
  for (int i = 0; i < objects.objects_size(); ++i) AddNamesOf(i, rank(objects.objects(i)));
  for (const english::v1::WordList& list : english::Language::Get().data().lists()) {
    if (!list.name().starts_with("furniture")) continue;
    for (const std::string& name : list.words()) names_[name];
  }
  // "TV" alone means the TV stand when there is no television, but no counter is a counter stool.
  for (int i = 0; i < objects.objects_size(); ++i) {
    const std::vector<std::string> words = WithoutLastNumber(SingularWords(objects.objects(i).name()));
    // "Counter stool", "desk lamp": what is named for where it is used, not for what it carries.
    if (words.empty() || IsIn("things named for a place", words.back())) continue;
    for (size_t length = words.size() - 1; length > 0; --length) {
      const std::vector<std::string> front(words.begin(), words.begin() + static_cast<long>(length));
      const bool furniture = names_.count(absl::StrJoin(front, " ")) != 0 && front.front() != "storage";
      if (!furniture && !NamesByItself(words, length)) continue;
      Add(front, i, rank(objects.objects(i)) + kFrontRank);
      if (front.back() == "tv") Add({"television"}, i, rank(objects.objects(i)) + kFrontRank);
    }
  }
}

void SceneNames::AddNamesOf(int i, int rank) {
  const v1::Object& object = objects_.objects(i);
  const std::vector<std::string> all = SingularWords(object.name());
  const std::vector<std::string> words = WithoutLastNumber(all);
  if (words.size() < all.size()) numbers_[i] = NumberOf(all.back());
  Add(SingularWords(object.id()), i, rank);
  joined_names_[absl::StrJoin(words, "")].push_back({i, rank});
  if (const std::string head = HeadOfCompound(words.back()); !head.empty()) Add({head}, i, rank + kCompoundRank);
  for (size_t skip = 0; skip < words.size(); ++skip) {
    const std::vector<std::string> tail(words.begin() + static_cast<long>(skip), words.end());
    Add(tail, i, rank + (skip == 0 ? 0 : 1));
    for (const english::v1::WordList& group : english::Language::Get().data().lists()) {
      if (group.name() != "furniture synonyms") continue;
      if (std::ranges::find(group.words(), absl::StrJoin(tail, " ")) == group.words().end()) continue;
      for (const std::string& synonym : group.words()) Add(NameWords(synonym), i, rank + (skip == 0 ? 2 : 3));
    }
  }
}

void SceneNames::Add(const std::vector<std::string>& words, int object, int rank) {
  if (words.empty() || words.size() > kLongestName) return;
  std::vector<Candidate>& list = names_[absl::StrJoin(words, " ")];
  const auto same = std::ranges::find_if(list, [&](const Candidate& c) { return c.object == object; });
  if (same == list.end()) {
    list.push_back({object, rank});
  } else {
    same->rank = std::min(same->rank, rank);
  }
}

SceneNames::Found SceneNames::Find(const std::vector<Token>& tokens, size_t at) const {
  Found best = FindObject(tokens, at);
  for (const Found& other : {FindInZone(tokens, at), FindZone(tokens, at), FindWall(tokens, at), FindCorner(tokens, at),
                             FindOpening(tokens, at)}) {
    if (other.length > best.length) best = other;
  }
  return best.length > 0 ? best : FindZoneByUse(tokens, at);
}

SceneNames::Found SceneNames::FindObject(const std::vector<Token>& tokens, size_t at) const {
  Found found = FindObjectByWords(tokens, at);
  TakeNumbers(tokens, at, found);
  return found;
}

void SceneNames::TakeNumbers(const std::vector<Token>& tokens, size_t at, Found& found) const {
  if (found.reference.kind != RefKind::kObjects || found.length == 0) return;
  std::vector<int>& candidates = found.reference.candidates;
  const std::vector<int> all = std::exchange(candidates, {});
  for (size_t next = at + found.length; next < tokens.size() && tokens[next].kind == Token::Kind::kNumber;) {
    const int number = NumberOf(tokens[next].text);
    const size_t before = candidates.size();
    std::copy_if(all.begin(), all.end(), std::back_inserter(candidates),
                 [&](int object) { return number > 0 && numbers_[object] == number; });
    const bool counted = candidates.size() == before && number > 0 && number <= static_cast<int>(all.size());
    if (counted) candidates.push_back(all[number - 1]);
    if (number == 0 || (before > 0 && candidates.size() == before)) break;
    found.reference.plural = before > 0;
    found.length = ++next - at;
    // "Chairs 1 and 2", "1, 2, and 3".
    if (next < tokens.size() && tokens[next].IsMark(',')) ++next;
    if (next < tokens.size() && IsOneOf(tokens[next], {"and", "or"})) ++next;
    if (next == at + found.length) break;
  }
  if (candidates.empty()) candidates = all;
}

// "The warm bench", "the reading area's chair": of several of the name those of the zone.
SceneNames::Found SceneNames::FindInZone(const std::vector<Token>& tokens, size_t at) const {
  for (const v1::Zone& zone : zones_.zones()) {
    const size_t words = ZoneLength(zone, tokens, at);
    if (words == 0) continue;
    size_t next = at + words;
    const Phrase area = Lexicon::Get().Find(tokens, next);
    if (area.word_class == english::v1::WORD_CLASS_AREA) next += area.length;
    if (next < tokens.size() && (tokens[next].IsWord("'s") || tokens[next].IsMark(':'))) ++next;
    Found found = FindObject(tokens, next);
    std::vector<int>& candidates = found.reference.candidates;
    std::erase_if(candidates, [&](int object) { return objects_.objects(object).zone_id() != zone.id(); });
    if (found.length == 0 || candidates.empty()) continue;
    found.length += next - at;
    return found;
  }
  return {};
}

SceneNames::Found SceneNames::FindObjectByWords(const std::vector<Token>& tokens, size_t at) const {
  Found found;
  std::string key;
  std::string joined;
  int best = 2 * kLaterRank;
  for (size_t length = 1; length <= kLongestName && at + length <= tokens.size(); ++length) {
    const Token& token = tokens[at + length - 1];
    if (token.kind != Token::Kind::kWord && token.kind != Token::Kind::kNumber) break;
    // "The judge's bench" is the judge bench.
    if (token.IsWord("'s") && length > 1) continue;
    const std::string singular = english::Singular(token.text);
    auto entry = names_.find(key + singular);
    key += singular + " ";
    joined += singular;
    if (entry == names_.end()) {
      entry = joined_names_.find(joined);
      if (entry == joined_names_.end()) continue;
    } else if (const auto whole = joined_names_.find(joined); entry->second.empty() && whole != joined_names_.end()) {
      entry = whole;
    }
    const auto chosen_later = [](const Candidate& candidate) { return candidate.rank >= kLaterRank; };
    const bool later = !entry->second.empty() && std::ranges::all_of(entry->second, chosen_later);
    found.length = length;
    // "The TV screen" before there is a screen: what "the TV" is, the TV stand.
    if (later && best == kFrontRank) continue;
    found.reference = {};
    found.reference.name = entry->first;
    found.reference.plural = singular != token.text;
    found.reference.kind = entry->second.empty() ? RefKind::kAbsent : RefKind::kObjects;
    best = 2 * kLaterRank;
    for (const Candidate& candidate : entry->second) best = std::min(best, candidate.rank);
    for (const Candidate& candidate : entry->second) {
      if (candidate.rank == best) found.reference.candidates.push_back(candidate.object);
      if (candidate.rank > best && candidate.rank < (best == 0 ? 2 : kFrontRank)) {
        found.reference.weak_candidates.push_back(candidate.object);
      }
    }
    found.full = best == 0;
    found.reference.full = found.full;
    std::ranges::sort(found.reference.candidates);
  }
  // "the alchemical table" among several tables: the word before tells which.
  if (found.reference.candidates.size() > 1 && at > 0 && tokens[at - 1].kind == Token::Kind::kWord) {
    std::vector<int> fitting;
    for (const int object : found.reference.candidates) {
      const std::vector<std::string> words = SingularWords(objects_.objects(object).name());
      if (english::BeginAlike(words.front(), tokens[at - 1].text)) fitting.push_back(object);
    }
    if (!fitting.empty()) found.reference.candidates = fitting;
  }
  return found;
}

int SceneNames::MainObject(const std::string& zone_id) const {
  int first = -1;
  for (int i = 0; i < objects_.objects_size(); ++i) {
    const v1::Object& object = objects_.objects(i);
    if (object.zone_id() != zone_id || object.kind() != v1::OBJECT_KIND_FLOOR || object.walk_over()) continue;
    if (object.role() == v1::OBJECT_ROLE_PRIMARY) return i;
    if (first < 0) first = i;
  }
  return first;
}

}  // namespace flair::translator
