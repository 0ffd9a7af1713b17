// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/scene_names.h"

#include <algorithm>
#include <cmath>

#include "absl/strings/str_join.h"
#include "translator_worker/grammar/furniture_words.h"
#include "translator_worker/grammar/lexicon.h"

namespace flair::translator {
namespace {

constexpr size_t kLongestName = 6;

std::vector<std::string> SingularWords(const std::string& name) {
  std::vector<std::string> words = NameWords(name);
  for (std::string& word : words) word = Singular(word);
  return words;
}

// Whether one word is the other or its beginning: "prep" and "preparation", "alchemical" and "alchemy".
bool SameStem(const std::string& a, const std::string& b) {
  const size_t shared = std::min({a.size(), b.size(), size_t{6}});
  return a == b || (shared >= 4 && a.compare(0, shared, b, 0, shared) == 0);
}

double WallLength(const v1::Room& room, int wall) {
  const auto& vertices = room.floor().vertices();
  const auto& a = vertices[wall];
  const auto& b = vertices[(wall + 1) % vertices.size()];
  return std::hypot(b.x_m() - a.x_m(), b.y_m() - a.y_m());
}

}  // namespace

std::vector<std::string> NameWords(const std::string& name) {
  std::vector<std::string> words;
  for (const Token& token : Tokenize(name)) {
    if (token.kind != Token::Kind::kPunctuation) words.push_back(token.text);
  }
  return words;
}

SceneNames::SceneNames(const v1::Room& room, const v1::ZonePlan& zones, const v1::ObjectList& objects)
    : room_(room), zones_(zones), objects_(objects) {
  for (int i = 0; i < objects.objects_size(); ++i) {
    const v1::Object& object = objects.objects(i);
    const std::vector<std::string> words = SingularWords(object.name());
    Add(SingularWords(object.id()), i, 0);
    for (size_t skip = 0; skip < words.size(); ++skip) {
      const std::vector<std::string> tail(words.begin() + static_cast<long>(skip), words.end());
      Add(tail, i, skip == 0 ? 0 : 1);
      for (const std::vector<std::string>& group : FurnitureSynonyms()) {
        if (std::find(group.begin(), group.end(), absl::StrJoin(tail, " ")) == group.end()) continue;
        for (const std::string& synonym : group) Add(NameWords(synonym), i, skip == 0 ? 2 : 3);
      }
    }
  }
  for (const std::vector<std::string>& group : FurnitureSynonyms()) {
    for (const std::string& name : group) names_[name];
  }
  for (const std::string& name : FurnitureNames()) names_[name];
  // "TV" alone means the TV stand when there is no television.
  for (int i = 0; i < objects.objects_size(); ++i) {
    const std::vector<std::string> words = SingularWords(objects.objects(i).name());
    for (size_t length = words.size() - (words.empty() ? 0 : 1); length > 0; --length) {
      const std::vector<std::string> front(words.begin(), words.begin() + static_cast<long>(length));
      if (names_.count(absl::StrJoin(front, " ")) != 0 && front.front() != "storage") Add(front, i, 4);
    }
  }
}

void SceneNames::Add(const std::vector<std::string>& words, int object, int rank) {
  if (words.empty() || words.size() > kLongestName) return;
  std::vector<Candidate>& list = names_[absl::StrJoin(words, " ")];
  const auto same = std::find_if(list.begin(), list.end(), [&](const Candidate& c) { return c.object == object; });
  if (same == list.end()) {
    list.push_back({object, rank});
  } else {
    same->rank = std::min(same->rank, rank);
  }
}

SceneNames::Found SceneNames::Find(const std::vector<Token>& tokens, size_t at) const {
  Found best = FindObject(tokens, at);
  for (const Found& other : {FindZone(tokens, at), FindWall(tokens, at)}) {
    if (other.length > best.length) best = other;
  }
  return best;
}

SceneNames::Found SceneNames::FindObject(const std::vector<Token>& tokens, size_t at) const {
  Found found;
  std::string key;
  for (size_t length = 1; length <= kLongestName && at + length <= tokens.size(); ++length) {
    const Token& token = tokens[at + length - 1];
    if (token.kind != Token::Kind::kWord && token.kind != Token::Kind::kNumber) break;
    const std::string singular = Singular(token.text);
    const auto entry = names_.find(key + singular);
    key += singular + " ";
    if (entry == names_.end()) continue;
    found.length = length;
    found.reference = {};
    found.reference.name = entry->first;
    found.reference.plural = singular != token.text;
    found.reference.kind = entry->second.empty() ? RefKind::kAbsent : RefKind::kObjects;
    int best = 9;
    for (const Candidate& candidate : entry->second) best = std::min(best, candidate.rank);
    for (const Candidate& candidate : entry->second) {
      if (candidate.rank == best) found.reference.candidates.push_back(candidate.object);
      if (best > 0 && candidate.rank > best && candidate.rank < 4) {
        found.reference.weak_candidates.push_back(candidate.object);
      }
    }
    found.full = best == 0;
    std::sort(found.reference.candidates.begin(), found.reference.candidates.end());
  }
  // "the alchemical table" among several tables: the word before tells which.
  if (found.reference.candidates.size() > 1 && at > 0 && tokens[at - 1].kind == Token::Kind::kWord) {
    std::vector<int> fitting;
    for (const int object : found.reference.candidates) {
      const std::vector<std::string> words = SingularWords(objects_.objects(object).name());
      if (SameStem(words.front(), tokens[at - 1].text)) fitting.push_back(object);
    }
    if (!fitting.empty()) found.reference.candidates = fitting;
  }
  return found;
}

SceneNames::Found SceneNames::FindZone(const std::vector<Token>& tokens, size_t at) const {
  for (const v1::Zone& zone : zones_.zones()) {
    const std::vector<std::string> words = NameWords(zone.name().empty() ? zone.id() : zone.name());
    bool same = !words.empty() && at + words.size() <= tokens.size();
    for (size_t i = 0; same && i < words.size(); ++i) {
      same = tokens[at + i].kind == Token::Kind::kWord && SameStem(tokens[at + i].text, words[i]);
    }
    if (!same) continue;
    const size_t next = at + words.size();
    // "the seating area", "the workstation and relaxation areas".
    for (size_t i = next; i < std::min(tokens.size(), next + 5); ++i) {
      if (Lexicon::Get().Find(tokens, i).word_class == WordClass::kArea) {
        Found found;
        found.reference.kind = RefKind::kZone;
        found.reference.name = zone.id();
        found.length = i == next ? words.size() + 1 : words.size();
        return found;
      }
      if (i > next && !tokens[i].IsWord("or") && !tokens[i].IsWord("and") && tokens[i - 1].kind != Token::Kind::kWord)
        break;
      if (i == next && !tokens[i].IsWord("or") && !tokens[i].IsWord("and")) break;
    }
  }
  return {};
}

SceneNames::Found SceneNames::FindWall(const std::vector<Token>& tokens, size_t at) const {
  const auto make = [](const std::string& wall, size_t length) {
    Found found;
    found.reference.kind = RefKind::kWall;
    found.reference.name = wall;
    found.length = length;
    return found;
  };
  const auto word = [&](size_t offset, std::string_view text) {
    return at + offset < tokens.size() && tokens[at + offset].IsWord(text);
  };
  for (const v1::Wall& wall : room_.walls()) {
    const std::vector<std::string> words = NameWords(wall.name());
    bool same = !words.empty() && at + words.size() <= tokens.size();
    for (size_t i = 0; same && i < words.size(); ++i) same = tokens[at + i].text == words[i];
    if (!same) continue;
    if (words.front() == "wall") return make(wall.name(), words.size());
    if (word(words.size(), "wall")) return make(wall.name(), words.size() + 1);
  }
  if ((word(0, "longest") || word(0, "shortest")) && word(1, "wall") && room_.walls_size() > 0 &&
      room_.walls_size() == room_.floor().vertices_size()) {
    int best = 0;
    for (int i = 1; i < room_.walls_size(); ++i) {
      const double longer = WallLength(room_, i) - WallLength(room_, best);
      if (word(0, "longest") ? longer > 1e-9 : longer < -1e-9) best = i;
    }
    return make(room_.walls(best).name(), 2);
  }
  return {};
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
