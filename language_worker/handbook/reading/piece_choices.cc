// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/piece_choices.h"

#include <algorithm>

#include "language_worker/handbook/reading/piece_mentions.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

// Whether there is space for it, with ways round it, and for something else.
bool HasSpaceFor(const hb::Furniture& piece, double area_m2) {
  constexpr double kWayM = 0.9, kMost = 0.55;
  const int ways = piece.back() == hb::BACK_RULE_WALL ? 1 : 2;
  return (piece.width_m().typical() + (ways - 1) * 2 * kWayM) * (piece.depth_m().typical() + ways * kWayM) <
         kMost * area_m2;
}

// Whether only "or" parts two pieces: "a table for four persons, or an island".
bool AreAlternatives(const BriefText& text, const Mention& one, const Mention& other) {
  constexpr std::size_t kMostBetween = 9;
  if (other.begin <= one.end || other.begin - one.end > kMostBetween) return false;
  const std::size_t begin = text.PhraseBegin(other.begin);
  if (text.At(begin - 1) != "or") return false;
  // "A bench, four or five tables": it is their number that is left open.
  const auto is_number = [&](std::size_t i) {
    return text.IsNumber(i) || (NumberWord(text.At(i)) && !text.Is(i, "articles"));
  };
  if (begin > 1 && is_number(begin - 2) && is_number(begin)) return false;
  for (std::size_t i = one.end; i < begin; ++i) {
    if (text.EndsSentence(i) || text.Says(i, {"and", "with"})) return false;
  }
  return true;
}

// "..., if there is space", up to the end of the sentence.
bool IsConditional(const BriefText& text, std::size_t end) {
  constexpr std::size_t kMostWords = 10;
  for (std::size_t i = end; i < end + kMostWords && i < text.size() && !text.EndsSentence(i); ++i) {
    if (text.BehindPhrase(i, "optional_behind")) return true;
  }
  return false;
}

}  // namespace

bool IsInAnotherRoom(const Reading& reading, std::size_t end) {
  const auto& [handbook, text, used, facts] = reading;
  const std::size_t at = end + 2;
  if (text.At(end) != "in" || !text.Is(end + 1, "definite")) return false;
  const auto [room, length] = LongestAt(handbook.vocabulary().rooms, text.tokens(), at, /*plural=*/false);
  const bool outside = text.Is(at, "open_air") || (room != nullptr && room->serving());
  return outside && room != facts.archetype && !text.Is(at + std::max<std::size_t>(length, 1), "room_ends");
}

bool IsBehindItsDoor(const Reading& reading, std::size_t begin, std::size_t end) {
  const auto& [handbook, text, used, facts] = reading;
  const bool room =
      text.At(end) == "room" || LongestAt(handbook.vocabulary().rooms, text.tokens(), begin, false).second > 0;
  return room && IsBeforeADoor(text, end);
}

std::optional<Mention> NamedAgainByItsLook(const Reading& reading, const hb::Furniture& furniture, std::size_t i,
                                           std::size_t length) {
  const auto& [handbook, text, used, facts] = reading;
  const std::size_t begin = text.PhraseBegin(i);
  if (length != 1 || begin == i || text.At(i).ends_with('s')) return std::nullopt;
  for (std::size_t k = begin; k < i; ++k) {
    const bool colour = LongestAt(handbook.vocabulary().colours, text.tokens(), k, /*plural=*/false).second > 0;
    if (!colour && !text.Is(k, "materials")) return std::nullopt;
  }
  for (const hb::Noun& noun : handbook.contents().nouns()) {
    const auto means = [&](const hb::Furniture& one) {
      return std::ranges::any_of(noun.options(), [&](const auto& option) { return option.furniture() == one.name(); });
    };
    if (!noun.one_of() || !means(furniture)) continue;
    for (const Wish& wish : facts.wishes) {
      if (wish.furniture != &furniture && means(*wish.furniture) &&
          MatchesWord(text.At(i), LastWord(wish.furniture->name())))
        return Mention{wish.furniture, i, i + length, wish.count};
    }
  }
  return std::nullopt;
}

bool IsTheLastAsWell(const Reading& reading, std::vector<Mention>& mentions, const hb::Furniture& named,
                     std::size_t i) {
  const auto& [handbook, text, used, facts] = reading;
  constexpr std::size_t kMostWords = 6;
  if (mentions.empty() || mentions.back().furniture == &named) return false;
  for (std::size_t at = mentions.back().end; at < i && at < mentions.back().end + kMostWords; ++at) {
    const auto end = text.BehindPhrase(at, "doubling");
    const std::size_t begin = text.PhraseBegin(i);
    if (!end || begin < *end || begin > text.BehindArticle(*end)) continue;
    reading.Use(at, i);
    // A sofa that doubles as a bed is a sofa bed.
    const hb::Furniture*& last = mentions.back().furniture;
    const hb::Furniture* both =
        Includes(named.zone_hints(), "sleeping") ? handbook.FindFurniture(last->name() + " bed") : nullptr;
    const auto wish = std::ranges::find(facts.wishes, last, &Wish::furniture);
    if (both == nullptr || wish == facts.wishes.end()) {
      facts.also_serves.emplace_back(last, &named);
    } else {
      last = wish->furniture = both;
    }
    return true;
  }
  return false;
}

void ChooseOne(const Reading& reading, std::vector<Mention>& mentions) {
  const auto& [handbook, text, used, facts] = reading;
  const auto wish_of = [&](const Mention& mention) {
    return mention.seats ? facts.wishes.end() : std::ranges::find(facts.wishes, mention.furniture, &Wish::furniture);
  };
  for (std::size_t m = 1; m < mentions.size(); ++m) {
    const Mention first = mentions[m - 1], second = mentions[m];
    const auto one = wish_of(first), other = wish_of(second);
    if (one == facts.wishes.end() || other == facts.wishes.end() || one == other) continue;
    if (!AreAlternatives(text, first, second)) continue;
    const bool on_floor = IsFloorPiece(*first.furniture), if_second = IsConditional(text, second.end);
    if (!on_floor && !IsFloorPiece(*second.furniture)) continue;
    const bool later = if_second ? HasSpaceFor(*second.furniture, AreaOf(facts)) : !on_floor || one->optional;
    const Mention loser = later ? first : second;
    const hb::Furniture* const winner = (later ? second : first).furniture;
    (later ? other : one)->optional = false;
    AddOnce(facts.refusals, loser.furniture);
    facts.wishes.erase(later ? one : other);
    // And who was to sit there. Its place is the other's.
    std::erase_if(mentions, [&](const Mention& one) { return one.furniture == loser.furniture && one.seats; });
    for (Mention& mention : mentions) {
      if (mention.furniture == loser.furniture) mention.furniture = winner;
    }
    m = 0;
  }
}

}  // namespace flair::language
