// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/meet_later.h"

#include <algorithm>
#include <string>

#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions) {
  for (std::size_t i = 0; i < facts.wishes.size(); ++i) {
    const hb::Furniture* vague = facts.wishes[i].furniture;
    const auto mention = std::ranges::find(mentions, vague, &Mention::furniture);
    const bool by_noun = facts.wishes[i].noun != nullptr && mention != mentions.end() &&
                         mention->end == mention->begin + 1 && mention->begin > 0;
    const bool the = by_noun && text.At(mention->begin - 1) == "the" && facts.wishes[i].count == 1;
    // "Separate beds now. Two twin beds with ..."
    const bool plural = by_noun && !facts.wishes[i].counted && facts.wishes[i].seats == 0;
    if (!(the || plural) || vague->category() == "box") continue;
    const auto later = std::ranges::find_if(
        facts.wishes.begin() + static_cast<std::ptrdiff_t>(i) + 1, facts.wishes.end(), [&](const Wish& wish) {
          return wish.furniture->category() == vague->category() && (the || (wish.counted && wish.count > 1));
        });
    if (later == facts.wishes.end()) continue;
    for (Mention& one : mentions) {
      if (one.furniture == vague) one.furniture = later->furniture;
    }
    facts.wishes.erase(facts.wishes.begin() + static_cast<std::ptrdiff_t>(i--));
  }
}

namespace {

// "A freestanding bathtub ... opposite the tub": the wish for a class of this brief's own that these words name again.
const Wish* NamedAgain(const BriefText& text, std::size_t i, const hb::Furniture* named, const BriefFacts& facts,
                       const Handbook& handbook) {
  if (named == nullptr || i == 0 || text.At(i - 1) != "the" || named->category() == "box") return nullptr;
  const auto own = std::ranges::find_if(facts.wishes, [&](const Wish& wish) {
    return wish.furniture != named && handbook.IsOwn(*wish.furniture) && !named->category().empty() &&
           wish.furniture->category() == named->category();
  });
  return own == facts.wishes.end() ? nullptr : &*own;
}

}  // namespace

std::optional<Mention> MeantBefore(const BriefText& text, std::size_t i, std::size_t length, const NounBook& nouns,
                                   const BriefFacts& facts, const Handbook& handbook) {
  // "The two beds" are those that were asked for.
  const bool counted = i > 1 && NumberWord(text.At(i - 1)) && !text.Says(i - 1, {"a", "an", "the"});
  const std::size_t before = i - std::min<std::size_t>(i, counted ? 2 : 1);
  const bool bare = text.PhraseBegin(i) == i && !text.At(i).ends_with('s') && text.Is(before, "before_known");
  const Wish* own =
      NamedAgain(text, i, LongestAt(nouns.names(), text.tokens(), i, /*plural=*/true).first, facts, handbook);
  if (own != nullptr) return Mention{own->furniture, i, i + length, own->count};
  if (length != 1 || i == 0 || !(text.Is(before, "known_before") || bare)) return std::nullopt;
  const hb::Noun* noun = nouns.NounAt(text.tokens(), i, length);
  const auto is_meant = [&](const hb::Furniture& furniture) {
    const std::string last = LastWord(furniture.name());
    const bool compound = last.ends_with("chair") && MatchesWord(text.tokens()[i].text, "chair");
    return MatchesWord(text.tokens()[i].text, last) || compound ||
           (noun != nullptr && std::ranges::any_of(noun->options(), [&](const hb::NounOption& option) {
              return option.furniture() == furniture.name();
            }));
  };
  for (auto wish = facts.wishes.rbegin(); wish != facts.wishes.rend(); ++wish) {
    if (is_meant(*wish->furniture)) return Mention{wish->furniture, i, i + length, wish->count};
    const hb::Furniture* seat = SeatOf(*wish->furniture, handbook);
    if (seat != nullptr && wish->seats > 0 && is_meant(*seat)) {
      Mention seats{wish->furniture, i, i + length, wish->count};
      seats.seats = true;
      return seats;
    }
  }
  return std::nullopt;
}

}  // namespace flair::language
