// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_patterns.h"

#include <algorithm>
#include <utility>

#include "language_worker/handbook/reading/own_classes.h"

namespace flair::language {
namespace {

bool Fits(const std::string& slot, const Landmark& landmark) {
  using Kind = Landmark::Kind;
  const Kind kind = landmark.kind;
  for (const auto& [name, feature] :
       {std::pair("door", Kind::kDoor), std::pair("window", Kind::kWindow), std::pair("socket", Kind::kSocket),
        std::pair("wall", Kind::kWall), std::pair("corner", Kind::kCorner)}) {
    if (slot == name) return kind == feature;
  }
  if (slot == "windows") return kind == Kind::kWindow && landmark.plural;
  const bool beside = landmark.beside != Kind::kNone;
  const bool piece = kind == Kind::kPiece || kind == Kind::kPronoun || (beside && slot == "targets");
  const bool two = landmark.second != nullptr || landmark.plural || beside;
  return piece && (slot == "target" || (slot == "targets" && two));
}

}  // namespace

PlacePatterns::PlacePatterns(const Handbook& handbook, const std::vector<Token>& tokens,
                             const LandmarkReader& landmarks)
    : tokens_(tokens), text_(tokens), landmarks_(landmarks), places_(*handbook.vocabulary().places) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    plain_at_.push_back(plain_.size());
    if (text_.IsHyphen(i)) continue;
    plain_.push_back(tokens[i]);
    token_at_.push_back(i);
  }
  token_at_.push_back(tokens.size());
}

std::vector<PlacePatterns::Match> PlacePatterns::MatchesAt(std::size_t i) const {
  std::vector<Match> matches;
  constexpr std::size_t kMostFillers = 3;
  const bool denied = Denies(i);
  for (std::size_t start = i + (denied ? 1 : 0), last = i + kMostFillers; start <= last; ++start) {
    for (const PlaceWords& words : places_) {
      if (words.denied != denied) continue;
      Match match{words.asked, {}, LengthAt(words, start), 0};
      match.end = start + match.length;
      if (match.length > 0 && Complete(words, match)) matches.push_back(match);
    }
    // "Should not stand near".
    if (!denied || !IsIn("place_fillers", text_.At(start))) break;
  }
  std::ranges::stable_sort(matches, [](const Match& a, const Match& b) {
    return a.length != b.length ? a.length > b.length : a.end > b.end;
  });
  return matches;
}

std::size_t PlacePatterns::LengthAt(const PlaceWords& words, std::size_t i) const {
  if (i >= tokens_.size() || text_.IsHyphen(i)) return 0;
  const std::size_t plain = plain_at_[i];
  const std::size_t length = words.words.Find(plain_, plain).length;
  return length == 0 ? 0 : token_at_[plain + length - 1] + 1 - i;
}

const hb::AskedPlace* PlacePatterns::Find(std::string_view words, std::string_view slot, hb::FurnitureKind kind) const {
  const std::vector<Token> tokens = english::Tokenize(words);
  for (const PlaceWords& one : places_) {
    const auto& kinds = one.asked->kinds();
    const bool of_kind = kinds.empty() ? kind == hb::FURNITURE_KIND_FLOOR : Includes(kinds, static_cast<int>(kind));
    if (of_kind && one.slot == slot && one.words.Find(tokens, 0).length == tokens.size()) return one.asked;
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
bool PlacePatterns::Complete(const PlaceWords& words, Match& match) const {
  if (words.asked->target_first()) return true;
  if (words.slot.empty()) {
    const bool needs_piece = AskedNames(*words.asked, "{target}") || AskedNames(*words.asked, "{first}");
    const std::size_t begin = match.end - match.length;
    const bool inverted = text_.Is(match.end, "thing_articles") &&
                          (begin == 0 || text_.EndsSentence(begin - 1) || text_.Says(begin - 1, {",", "and", "while"}));
    return !needs_piece || inverted || EndsPhrase(match.end);
  }
  match.landmark = landmarks_.Read(match.end);
  match.end = words.slot == "targets" ? std::max(match.landmark.end, match.landmark.second_end) : match.landmark.end;
  return Fits(words.slot, match.landmark);
}

bool MayBeCarriedOtherwise(const hb::Furniture& furniture, const hb::AskedPlace& asked) {
  constexpr double kSmallM2 = 0.3, kHangsM2 = 0.7, kFlatM = 0.4;
  const double area_m2 = furniture.width_m().typical() * furniture.depth_m().typical();
  const bool floor = IsOnTheFloor(furniture);
  const auto of_kind = [&](hb::FurnitureKind kind) { return Includes(asked.kinds(), static_cast<int>(kind)); };
  if (furniture.walk_over() || furniture.kind() == hb::FURNITURE_KIND_CEILING) return false;
  if (asked.carried() == hb::CARRIED_ON || asked.carried() == hb::CARRIED_IN) {
    return area_m2 <= kSmallM2;
  }
  const auto& text = asked.relation().text();
  // A curtain between two beds stands there, a television over the fireplace hangs.
  const bool between = text.find("{first}") != std::string::npos;
  if (between) return furniture.kind() == hb::FURNITURE_KIND_WALL;
  const bool by_piece = text.find("{target}") != std::string::npos;
  constexpr double kSlimM = 0.2;
  if (by_piece && of_kind(hb::FURNITURE_KIND_WALL) && text.find("above") != std::string::npos) {
    return furniture.kind() == hb::FURNITURE_KIND_SURFACE && furniture.depth_m().typical() < kSlimM;
  }
  if (by_piece || asked.carried() != hb::CARRIED_UNSPECIFIED) return false;
  if (asked.kinds().empty() || of_kind(hb::FURNITURE_KIND_FLOOR)) {
    return !floor && furniture.companions().empty();
  }
  if (of_kind(hb::FURNITURE_KIND_CEILING)) return area_m2 <= kHangsM2;
  return !floor || furniture.depth_m().typical() < kFlatM;
}

bool IsFor(const hb::AskedPlace& asked, const hb::Furniture& furniture, bool otherwise) {
  if (IsOfAnyKind(furniture)) return true;
  const bool floor = IsOnTheFloor(furniture);
  if (otherwise) return MayBeCarriedOtherwise(furniture, asked);
  // It has neither front nor back.
  if (furniture.walk_over() && (AskedNames(asked, "faces") || AskedNames(asked, "{wall}"))) return false;
  if (asked.kinds().empty()) return floor && (!furniture.walk_over() || !AskedNames(asked, "under the {target}"));
  return std::ranges::find(asked.kinds(), static_cast<int>(furniture.kind())) != asked.kinds().end() &&
         (!floor || furniture.walk_over());
}

void TakeTwo(const hb::Furniture& other, const PlacePatterns& patterns, Place& place) {
  const hb::Relation& relation = place.asked->relation();
  if (relation.pairing() != hb::PAIRING_TOGETHER || place.target != nullptr || &other == place.furniture) return;
  const bool facing = relation.text().find("face") != std::string::npos;
  const hb::AskedPlace* two = patterns.Find(facing ? "facing" : "next to", "target", hb::FURNITURE_KIND_FLOOR);
  if (two == nullptr) return;
  place.asked = two;
  place.target = &other;
}

void TakeWhatHangs(const PlacePatterns& patterns, Place& place, bool at_the_front) {
  if (place.target == nullptr || place.furniture->kind() == place.target->kind()) return;
  const hb::FurnitureKind kind = place.target->kind();
  const bool on_wall = kind == hb::FURNITURE_KIND_WALL;
  if (!on_wall && kind != hb::FURNITURE_KIND_CEILING) return;
  const auto says = [&](std::string_view words) { return AskedNames(*place.asked, words); };
  const std::string_view converse =
      says("under the {target}")                                                                       ? "above"
      : !on_wall || !IsOnTheFloor(*place.furniture)                                                    ? ""
      : says(" m of the {target}") || says("next to the {target}") || says("in front of the {target}") ? "near"
                                                                                                       : "";
  const hb::AskedPlace* hanging = converse.empty() ? nullptr : patterns.Find(converse, "target", kind);
  if (hanging == nullptr) return;
  const hb::AskedPlace* near = patterns.Find("near", "target", hb::FURNITURE_KIND_FLOOR);
  if (at_the_front && converse == "near" && near != nullptr) {
    place.asked = near;
    return;
  }
  place.asked = hanging;
  std::swap(place.furniture, place.target);
}

void HangWhatIsFaced(const PlacePatterns& patterns, BriefFacts& facts, bool at_the_front) {
  std::vector<Place> walls;
  for (Place& place : facts.places) {
    if (place.target == nullptr || place.target->kind() != hb::FURNITURE_KIND_WALL || !IsOnTheFloor(*place.furniture) ||
        !(AskedNames(*place.asked, "faces the {target}") || at_the_front)) {
      continue;
    }
    const auto own = [&](const Place& one) { return one.furniture == place.target && one.asked->carried() == 0; };
    if (std::ranges::any_of(facts.places, own) || std::ranges::any_of(walls, own)) continue;
    const auto wish = std::ranges::find(facts.wishes, place.furniture, &Wish::furniture);
    if (!at_the_front && (wish == facts.wishes.end() || wish->count == 1)) {
      const hb::AskedPlace* opposite = patterns.Find("opposite", "target", hb::FURNITURE_KIND_WALL);
      if (opposite == nullptr) continue;
      place.asked = opposite;
      std::swap(place.furniture, place.target);
      continue;
    }
    Place hung = place;
    hung.furniture = place.target;
    hung.target = nullptr;
    hung.which = -1;
    // One that all are to see hangs in the middle.
    const auto hangs = std::ranges::find(facts.wishes, hung.furniture, &Wish::furniture);
    const bool one = hangs == facts.wishes.end() || hangs->count == 1;
    hung.asked = patterns.Find(one ? "in the middle of" : "on", "wall", hb::FURNITURE_KIND_WALL);
    hung.side = "blank far";
    if (hung.asked != nullptr) walls.push_back(hung);
  }
  facts.places.insert(facts.places.end(), walls.begin(), walls.end());
}

}  // namespace flair::language
