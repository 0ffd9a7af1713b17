// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_patterns.h"

#include <algorithm>
#include <utility>

namespace flair::language {
namespace {

bool Fits(const std::string& slot, const Landmark& landmark) {
  using Kind = Landmark::Kind;
  const Kind kind = landmark.kind;
  for (const auto& [name, feature] : {std::pair("door", Kind::kDoor), std::pair("window", Kind::kWindow),
                                      std::pair("wall", Kind::kWall), std::pair("corner", Kind::kCorner)}) {
    if (slot == name) return kind == feature;
  }
  const bool piece = kind == Kind::kPiece || kind == Kind::kPronoun;
  const bool two = landmark.second != nullptr || landmark.plural;
  return piece && (slot == "target" || (slot == "targets" && two));
}

}  // namespace

PlacePatterns::PlacePatterns(const Handbook& handbook, const std::vector<Token>& tokens,
                             const LandmarkReader& landmarks)
    : handbook_(handbook), tokens_(tokens), text_(tokens), landmarks_(landmarks) {
  for (const hb::AskedPlace& asked : handbook.contents().asked_places()) {
    for (const std::string& words : asked.words()) {
      const std::size_t brace = std::min(words.find('{'), words.size());
      std::string slot = brace < words.size() ? words.substr(brace + 1, words.size() - brace - 2) : "";
      const std::string first = words.substr(0, words.find(' '));
      // "Not" may stand apart from the rest: "must not be placed near the door".
      const std::size_t from = first == "not" ? first.size() : 0;
      patterns_[first].push_back({Phrase(words.substr(from, brace - from)), std::move(slot), &asked});
    }
  }
}

std::vector<PlacePatterns::Match> PlacePatterns::MatchesAt(std::size_t i) const {
  std::vector<Match> matches;
  const bool negated = Denies(i);
  const auto found = patterns_.find(negated ? "not" : tokens_[i].text);
  if (found == patterns_.end()) return matches;
  std::size_t start = i + (negated ? 1 : 0);
  while (negated && start < i + 4 && IsIn("place_fillers", text_.At(start))) ++start;
  for (const Pattern& pattern : found->second) {
    Match match{pattern.asked, {}, pattern.words.MatchAt(tokens_, start, /*plural=*/false), 0};
    match.end = start + match.length;
    if (match.length > 0 && Complete(pattern, match)) matches.push_back(match);
  }
  std::ranges::stable_sort(matches, [](const Match& a, const Match& b) {
    return a.length != b.length ? a.length > b.length : a.end > b.end;
  });
  return matches;
}

const hb::AskedPlace* PlacePatterns::Find(std::string_view words, hb::FurnitureKind kind) const {
  for (const hb::AskedPlace& asked : handbook_.contents().asked_places()) {
    const bool of_kind =
        asked.kinds().empty() ? kind == hb::FURNITURE_KIND_FLOOR : Includes(asked.kinds(), static_cast<int>(kind));
    if (of_kind && Includes(asked.words(), words)) return &asked;
  }
  return nullptr;
}

bool PlacePatterns::IsDenied(std::size_t i) const {
  constexpr std::size_t kMostWordsBack = 4;
  for (std::size_t at = i; at > 0 && at + kMostWordsBack > i; --at) {
    if (Denies(at - 1)) return true;
    if (!IsIn("place_fillers", text_.At(at - 1))) return false;
  }
  return false;
}

// Whether no noun follows that a place could be told by.
bool PlacePatterns::EndsPhrase(std::size_t i) const {
  return i >= tokens_.size() || tokens_[i].kind == Token::Kind::kSign || IsIn("place_ends", text_.At(i));
}

// Reads what follows the words; false when it is not what they need.
bool PlacePatterns::Complete(const Pattern& pattern, Match& match) const {
  if (pattern.asked->target_first()) return true;
  if (pattern.slot.empty()) {
    const bool needs_piece = AskedNames(*pattern.asked, "{target}") || AskedNames(*pattern.asked, "{first}");
    const std::size_t begin = match.end - match.length;
    const bool inverted = text_.Is(match.end, "thing_articles") &&
                          (begin == 0 || text_.EndsSentence(begin - 1) || text_.Says(begin - 1, {",", "and", "while"}));
    return !needs_piece || inverted || EndsPhrase(match.end);
  }
  match.landmark = landmarks_.Read(match.end);
  match.end = match.landmark.end;
  return Fits(pattern.slot, match.landmark);
}

void TakeTwo(const hb::Furniture& other, const PlacePatterns& patterns, Place& place) {
  const hb::Relation& relation = place.asked->relation();
  if (relation.pairing() != hb::PAIRING_TOGETHER || place.target != nullptr || &other == place.furniture) return;
  const bool facing = relation.text().find("face") != std::string::npos;
  const hb::AskedPlace* two = patterns.Find(facing ? "facing {target}" : "next to {target}", hb::FURNITURE_KIND_FLOOR);
  if (two == nullptr) return;
  place.asked = two;
  place.target = &other;
}

void TakeWhatHangs(const PlacePatterns& patterns, Place& place) {
  if (place.target == nullptr || !AskedNames(*place.asked, "under the {target}")) return;
  const hb::FurnitureKind kind = place.target->kind();
  if (kind != hb::FURNITURE_KIND_WALL && kind != hb::FURNITURE_KIND_CEILING) return;
  const hb::AskedPlace* above = patterns.Find("above {target}", kind);
  if (above == nullptr) return;
  place.asked = above;
  std::swap(place.furniture, place.target);
}

}  // namespace flair::language
