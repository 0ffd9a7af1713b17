// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/noun_book.h"

#include <algorithm>
#include <optional>

#include "english/wordnet.h"
#include "english/words.h"
#include "language_worker/handbook/reading/other_words.h"

namespace flair::language {
namespace {

enum Rank { kOfOtherRooms = -1, kNotOfTheRoom, kOfAZone, kListed, kOfTheRoom, kOnePerPerson };

// Whether what stands before a noun leaves open which one it is.
bool SaysLooks(const Token& token) {
  const bool sign = token.kind == Token::Kind::kSign && token.text != "-" && token.text != "'";
  return sign || IsIn("noun_phrase_ends", token.text) || token.kind == Token::Kind::kNumber || NumberWord(token.text) ||
         IsIn("looks", token.text) || IsIn("materials", token.text) || IsIn("adjectives", token.text) ||
         IsIn("piece_measures", token.text);
}

// "An overbed table", "a treatment chair": a noun before it makes a thing of its own.
bool IsCompound(const std::vector<Token>& tokens, std::size_t noun) {
  const Token& before = tokens[noun - 1];
  if (before.kind != Token::Kind::kWord || tokens[noun].kind != Token::Kind::kWord) return false;
  const english::WordNet& words = english::WordNet::Get();
  // "Overbed" is over a bed, "frobnicated" is done to it.
  constexpr std::size_t kShortest = 3, kLongest = 24;
  for (std::size_t k = kShortest; k + kShortest <= std::min(before.text.size(), kLongest); ++k) {
    const std::string_view word = before.text;
    if (words.Knows(word.substr(0, k)) && !words.SensesOf(word.substr(k)).empty()) return !words.IsAdjective(word);
  }
  return !before.text.ends_with("ed") && !words.IsAdjective(before.text) && !words.IsVerb(before.text);
}

}  // namespace

NounBook::NounBook(const Handbook& handbook, const BriefFacts& facts)
    : vocabulary_(handbook.vocabulary()), room_(*facts.archetype), names_{&vocabulary_.names} {
  const auto raise = [&](std::string_view name, int rank) { ranks_[name] = std::max(ranks_[name], rank); };
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    for (const hb::ZoneSpec& zone : room_.zones()) {
      if (Includes(furniture.zone_hints(), zone.name())) raise(furniture.name(), kOfAZone);
    }
  }
  const hb::Band& usual = BandFor(room_, AreaOf(facts));
  for (const hb::Band& band : room_.bands()) {
    for (const hb::ObjectEntry& entry : band.objects()) raise(entry.furniture(), &band == &usual ? kListed : kOfAZone);
  }
  for (const hb::ObjectEntry& entry : room_.tertiaries()) raise(entry.furniture(), kListed);
  raise(room_.per_person(), kOnePerPerson);
  // Where the room has one piece of that kind.
  for (const Vocabulary::ShortName& one : vocabulary_.short_names) {
    if (RankOf(*one.furniture) != kNotOfTheRoom && RankOf(*one.elsewhere) == kNotOfTheRoom)
      names_.more.push_back({one.word, one.furniture});
  }
}

int NounBook::RankOf(const hb::Furniture& furniture) const {
  const auto rank = ranks_.find(furniture.name());
  return rank == ranks_.end() ? kNotOfTheRoom : rank->second;
}

int NounBook::RankAt(const std::vector<Token>& tokens, std::size_t i, const hb::Furniture& furniture) const {
  const auto here = [&](const hb::NounOption& option) { return Includes(option.rooms(), room_.name()); };
  std::size_t longest = 0;
  int meant = kNotOfTheRoom;
  for (const Vocabulary::Head& head : vocabulary_.heads) {
    for (const Phrase& word : head.words) {
      const std::size_t length = word.MatchAt(tokens, i);
      if (length <= longest) continue;
      longest = length;
      bool is_option = false, anywhere = false, of_the_room = false;
      for (const hb::NounOption& option : head.noun->options()) {
        if (option.furniture() != furniture.name()) continue;
        is_option = true;
        anywhere = anywhere || option.rooms().empty();
        of_the_room = of_the_room || here(option);
      }
      meant = of_the_room ? kOfTheRoom : is_option && !anywhere ? kOfOtherRooms : kNotOfTheRoom;
    }
  }
  const int rank = RankOf(furniture);
  return meant == kOfOtherRooms && rank < kListed ? meant : std::max(rank, meant);
}

const hb::Furniture* NounBook::Modified(const std::vector<Token>& tokens, std::size_t noun, std::size_t length,
                                        const hb::Furniture* named) const {
  const Vocabulary::Head* head = HeadAt(tokens, noun, length);
  if (head == nullptr) return named;
  // The "patient chair" of a dentist is not that of a ward.
  for (const bool here : {true, false}) {
    for (std::size_t at = noun, begin = BriefText(tokens).PhraseBegin(noun); at-- > begin;) {
      for (const Vocabulary::Head::Modifier& modifier : head->modifiers) {
        const std::size_t said = modifier.words.MatchAt(tokens, at, /*plural=*/false);
        if (said > 0 && at + said <= noun && (!here || IsOfTheRoom(*head->noun, *modifier.furniture)))
          return modifier.furniture;
      }
    }
  }
  // "A leather chair for reading" is a reading chair, "a sofa in L shape" an L-shaped one.
  if (noun + length < tokens.size() && IsOneOf(tokens[noun + length].text, {"for", "in"})) {
    const BriefText text(tokens);
    std::size_t what = noun + length + 1;
    while (tokens[noun + length].text == "for" &&
           (text.Is(what, "articles") || text.Is(what, "adjectives") || text.Is(what, "looks")))
      ++what;
    for (const Vocabulary::Head::Modifier& modifier : head->modifiers) {
      if (modifier.words.MatchAt(tokens, what, /*plural=*/false) > 0) return modifier.furniture;
    }
  }
  // "A cushion by the fire".
  for (const Vocabulary::Head::Modifier& modifier : head->modifiers) {
    if (modifier.words.MatchAt(tokens, noun + length, /*plural=*/false) > 1) return modifier.furniture;
  }
  return noun > 0 && !SaysLooks(tokens[noun - 1]) && (head->noun->strict() || IsCompound(tokens, noun)) ? nullptr
                                                                                                        : named;
}

NounBook::Purpose NounBook::PurposeOf(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) const {
  const BriefText text(tokens);
  std::optional<std::size_t> behind = text.BehindPhrase(end, "made_for");
  // "A rack with dumbbells".
  const bool holds = end > 0 && text.At(end) == "with" && IsFormIn("holders_of_things", text.At(end - 1));
  if (holds && english::IsPlural(text.At(end + 1))) behind = end + 1;
  if (!behind || !text.IsWord(begin)) return {};
  std::size_t at = *behind;
  while (text.Is(at, "thing_articles") || text.IsNumber(at) || NumberWord(text.At(at))) ++at;
  if (!text.IsWord(at) || (text.At(at - 1) == "the" && !CountsPeople(text.At(at)))) return {};
  std::vector<Token> name = {tokens[at]};
  name.front().text = english::Singular(name.front().text);
  for (std::size_t i = begin; i < end; ++i) name.push_back(tokens[i]);
  const auto [furniture, length] = LongestAt(names_, name, 0, /*plural=*/true);
  return length == name.size() ? Purpose{furniture, at + 1} : Purpose();
}

const hb::Furniture* NounBook::ChairsBehind(const std::vector<Token>& tokens, std::size_t end) const {
  constexpr std::size_t kMostWords = 6;
  const BriefText text(tokens);
  for (std::size_t k = end + 1; text.At(end) == "with" && k < end + kMostWords; ++k) {
    if (text.IsSign(k) && !text.IsHyphen(k)) break;
    const auto [named, length] = LongestAt(names_, tokens, k, /*plural=*/true);
    if (named == nullptr || !(named->category() == "chair" || named->category() == "armchair")) continue;
    const hb::Furniture* meant = Modified(tokens, k, length, named);
    return meant == named ? nullptr : meant;
  }
  return nullptr;
}

bool NounBook::IsOfTheRoom(const hb::Noun& noun, const hb::Furniture& furniture) const {
  return std::ranges::any_of(noun.options(), [&](const hb::NounOption& option) {
    return option.furniture() == furniture.name() && Includes(option.rooms(), room_.name());
  });
}

const hb::Noun* NounBook::NounAt(const std::vector<Token>& tokens, std::size_t i, std::size_t length) const {
  const Vocabulary::Head* head = HeadAt(tokens, i, length);
  return head == nullptr ? nullptr : head->noun;
}

std::size_t NounBook::LengthWithHead(const std::vector<Token>& tokens, std::size_t start, std::size_t length,
                                     const hb::Furniture& furniture) const {
  const std::size_t end = start + length;
  if (length == 0 || end >= tokens.size() || HeadAt(tokens, start, length) != nullptr) return length;
  for (const Vocabulary::Head& head : vocabulary_.heads) {
    if (!Includes(head.options, &furniture)) continue;
    for (const Phrase& word : head.words) {
      if (const std::size_t more = word.MatchAt(tokens, end); more > 0) return length + more;
    }
  }
  return length;
}

std::size_t NounBook::OtherThingAt(const std::vector<Token>& tokens, std::size_t start) const {
  std::size_t longest = 0;
  for (const Phrase& thing : vocabulary_.other_things) longest = std::max(longest, thing.MatchAt(tokens, start));
  return longest;
}

const Vocabulary::Head* NounBook::HeadAt(const std::vector<Token>& tokens, std::size_t i, std::size_t length) const {
  for (const Vocabulary::Head& head : vocabulary_.heads) {
    for (const Phrase& word : head.words) {
      if (length > 0 && word.MatchAt(tokens, i) == length) return &head;
    }
  }
  return nullptr;
}

}  // namespace flair::language
