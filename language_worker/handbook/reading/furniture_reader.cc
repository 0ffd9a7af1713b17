// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/furniture_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace flair::language {
namespace {

constexpr int kMostSeats = 40;

template <std::size_t n>
bool IsOneOf(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool IsArticle(std::string_view word) { return word == "a" || word == "an" || word == "the"; }

std::string LastWord(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

}  // namespace

std::vector<Saying<hb::NamedColour>> ColourSayings(const Handbook& handbook) {
  std::vector<Saying<hb::NamedColour>> colours;
  for (const hb::NamedColour& colour : handbook.contents().colours()) {
    AddSayings(colour.name(), colour.synonyms(), colour, colours);
  }
  return colours;
}

bool IsSeat(const hb::Furniture& furniture) {
  return furniture.category() == "chair" || furniture.category() == "stool";
}

const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook) {
  for (const hb::ObjectEntry& companion : furniture.companions()) {
    const hb::Furniture* seat = handbook.FindFurniture(companion.furniture());
    if (seat != nullptr && (IsSeat(*seat) || seat->category() == "bench")) return seat;
  }
  return nullptr;
}

FurnitureReader::FurnitureReader(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used,
                                 BriefFacts& facts)
    : handbook_(handbook), tokens_(tokens), used_(used), facts_(facts), colours_(ColourSayings(handbook)) {
  for (const hb::Furniture& furniture : handbook.contents().furniture()) {
    AddSayings(furniture.name(), furniture.synonyms(), furniture, names_);
  }
}

void FurnitureReader::Use(std::size_t start, std::size_t length) {
  std::fill_n(used_.begin() + static_cast<std::ptrdiff_t>(start), length, true);
}

void FurnitureReader::Read() {
  const auto rank = [this](const hb::Furniture& furniture) { return RankOf(furniture); };
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (used_[i]) continue;
    const auto [furniture, length] = BestAt(names_, tokens_, i, /*plural=*/true, rank);
    if (length == 0) {
      if (tokens_[i].kind == Token::Kind::kWord && IsRefused(i)) used_[i] = RefuseKind(i);
      continue;
    }
    if (IsRefused(i)) {
      AddOnce(facts_.refusals, furniture);
      if (length == 1) RefuseKind(i);
      last_.reset();
    } else {
      Wishing(*furniture, i, length);
    }
    Use(i, length);
    i += length - 1;
  }
  // What is asked for by its own name is not refused by a word for all of its kind: "no chairs but two armchairs".
  std::erase_if(facts_.refusals, [this](const hb::Furniture* refusal) {
    return std::ranges::any_of(facts_.wishes, [&](const Wish& wish) { return wish.furniture == refusal; });
  });
  ReadOnly();
}

// How much a class belongs to the kind of room: its list names it, or one of its zones is where it stands.
int FurnitureReader::RankOf(const hb::Furniture& furniture) const {
  const hb::Archetype& archetype = *facts_.archetype;
  if (archetype.per_person() == furniture.name()) return 3;
  const auto names = [&](const hb::ObjectEntry& entry) { return entry.furniture() == furniture.name(); };
  if (std::ranges::any_of(archetype.tertiaries(), names)) return 2;
  for (const hb::Band& band : archetype.bands()) {
    if (std::ranges::any_of(band.objects(), names)) return 2;
  }
  const auto is_home = [&](const hb::ZoneSpec& zone) {
    return std::ranges::find(furniture.zone_hints(), zone.name()) != furniture.zone_hints().end();
  };
  return std::ranges::any_of(archetype.zones(), is_home) ? 1 : 0;
}

// A word alone refuses all of its kind: "no chairs" also the armchairs, "no lamps" those on tables and floor. Whether
// there are any.
bool FurnitureReader::RefuseKind(std::size_t i) {
  bool any = false;
  for (const hb::Furniture& other : handbook_.contents().furniture()) {
    const std::string last = LastWord(other.name());
    const bool same = Phrase(last).MatchAt(tokens_, i) == 1;
    const bool compound = last.size() > 5 && last.ends_with("chair") && Phrase("chair").MatchAt(tokens_, i) == 1;
    if (same || compound) AddOnce(facts_.refusals, &other);
    any = any || same || compound;
  }
  return any;
}

// "no tv", "without a desk", "no tv or desk", "a shower instead of a bathtub"; not "not near the bed", "no more than
// two chairs".
bool FurnitureReader::IsRefused(std::size_t i) const {
  constexpr std::array<std::string_view, 20> kPlaces = {
      "near",   "next",     "by",    "facing", "in",      "on",   "at",    "under",   "beside", "against",
      "behind", "opposite", "close", "below",  "beneath", "from", "above", "between", "too",    "front"};
  for (std::size_t back = 1; back <= 4 && back <= i; ++back) {
    const std::string& word = tokens_[i - back].text;
    const std::string_view before = back < i ? std::string_view(tokens_[i - back - 1].text) : std::string_view();
    if (IsOneOf(kPlaces, word)) return false;
    if ((word == "of" && before == "instead") || (word == "than" && before == "rather")) return true;
    if (word == "than") return false;
    if (word == "no" || word == "without" || word == "not") return true;
    if (word == "," || word == "." || word == ";" || word == "with" || word == "but" || word == "and") return false;
  }
  return false;
}

void FurnitureReader::Wishing(const hb::Furniture& furniture, std::size_t i, std::size_t length) {
  const Count count = CountBefore(furniture, i, length);
  if (SeatsTheLast(furniture, count, i, length)) return;
  Wish wish{&furniture, count.number, 0, count.said};
  if (!furniture.companions().empty()) wish.seats = SeatsAfter(i + length);
  if (wish.seats > 0) Use(i + length, 2);  // these are the table's, not the room's
  if (wish.seats == 0 && TakesTheLastAsSeats(i, wish)) last_.reset();
  last_ = Last{AddWish(wish), i + length, IsSeat(furniture) && length == 1};
  TakeColourBefore(i, furniture);
  TakePlaceAfter(i + length, furniture);
}

// "a meeting table with six chairs", "two tables and eight chairs", "four desks with two chairs each".
bool FurnitureReader::SeatsTheLast(const hb::Furniture& seat, const Count& count, std::size_t i, std::size_t length) {
  if (!last_ || last_->seat || !OnlyWordsBetween(last_->end, i, /*around=*/false)) return false;
  Wish& host = facts_.wishes[last_->wish];
  const hb::Furniture* usual = SeatOf(*host.furniture, handbook_);
  if (usual == nullptr || host.seats > 0) return false;
  const bool any = length == 1 && (seat.category() == usual->category() || IsSeat(seat));
  if (usual != &seat && !any) return false;
  const bool each = i + length < tokens_.size() && tokens_[i + length].text == "each";
  if (count.said) {
    const bool shared = !each && count.number >= host.count && count.number % host.count == 0;
    host.seats = std::min(shared ? count.number / host.count : count.number, kMostSeats);
  }
  last_.reset();
  return true;
}

// "six chairs round a table".
bool FurnitureReader::TakesTheLastAsSeats(std::size_t i, Wish& host) {
  if (!last_ || !last_->seat || SeatOf(*host.furniture, handbook_) == nullptr) return false;
  if (!OnlyWordsBetween(last_->end, i, /*around=*/true)) return false;
  const Wish seats = facts_.wishes[last_->wish];
  facts_.wishes.erase(facts_.wishes.begin() + static_cast<std::ptrdiff_t>(last_->wish));
  if (seats.counted) host.seats = std::min(std::max(1, seats.count / std::max(1, host.count)), kMostSeats);
  return true;
}

// Whether tokens [from, to) only say that what follows belongs to what came before.
bool FurnitureReader::OnlyWordsBetween(std::size_t from, std::size_t to, bool around) const {
  constexpr std::array<std::string_view, 5> kWith = {"with", "and", "plus", "surrounded", "seating"};
  constexpr std::array<std::string_view, 4> kAround = {"around", "round", "at", "surrounding"};
  constexpr std::size_t kMostWords = 5;
  bool joined = false;
  if (to < from || to - from > kMostWords) return false;
  for (std::size_t i = from; i < to; ++i) {
    if (used_[i] || tokens_[i].kind == Token::Kind::kSign) return false;
    joined = joined || (around ? IsOneOf(kAround, tokens_[i].text) : IsOneOf(kWith, tokens_[i].text));
  }
  return joined;
}

std::size_t FurnitureReader::AddWish(const Wish& wish) {
  const int count = std::min(wish.count, kMostOfAKind);
  if (wish.count > kMostOfAKind) AddOnce(facts_.too_many, wish.furniture);
  for (std::size_t i = 0; i < facts_.wishes.size(); ++i) {
    Wish& there = facts_.wishes[i];
    if (there.furniture != wish.furniture) continue;
    there.count = std::max(there.count, count);
    there.seats = std::max(there.seats, wish.seats);
    return i;
  }
  facts_.wishes.push_back({wish.furniture, count, wish.seats, wish.counted});
  return facts_.wishes.size() - 1;
}

// Of "a table for eight", "a table for 8 people": eight. 0 when nothing of the kind stands there.
int FurnitureReader::SeatsAfter(std::size_t i) const {
  if (i + 1 >= tokens_.size() || tokens_[i].text != "for") return 0;
  const Token& token = tokens_[i + 1];
  if (IsArticle(token.text)) return 0;
  const int number = token.kind == Token::Kind::kNumber ? static_cast<int>(std::min(token.number, 1e6))
                                                        : NumberWord(token.text).value_or(0);
  const bool ends = i + 2 == tokens_.size() || tokens_[i + 2].kind == Token::Kind::kSign ||
                    CountsPeople(tokens_[i + 2].text) || tokens_[i + 2].text == "and" ||
                    tokens_[i + 2].text == "with" || tokens_[i + 2].text == "near";
  return ends && number <= kMostSeats ? number : 0;
}

// The number said before a noun, looking back over adjectives: "two comfortable armchairs", "2 x desk", "a pair of".
// A plural without one means two at least.
FurnitureReader::Count FurnitureReader::CountBefore(const hb::Furniture& furniture, std::size_t i,
                                                    std::size_t length) const {
  for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
    const std::size_t at = i - back;
    const Token& token = tokens_[at];
    if (token.kind == Token::Kind::kNumber) {
      const double number = std::min(token.number, 1e6);
      return {number >= 1 && number == std::floor(number) ? static_cast<int>(number) : 1};
    }
    for (const hb::CountWord& word : handbook_.contents().count_words()) {
      for (const std::string& text : word.words()) {
        const std::size_t said = Phrase(text).MatchAt(tokens_, at, false);
        if (said > 0 && at + said <= i && word.count() > 0) return {word.count()};
      }
    }
    // "a pair of": the article belongs to the pair, which stands after it.
    if (const std::optional<int> number = NumberWord(token.text)) return {*number};
    if (token.kind == Token::Kind::kSign && token.text != "-") break;
    if (token.text == "and" || token.text == "with" || token.text == "the") break;
  }
  const std::string& last = tokens_[i + length - 1].text;
  const bool plural =
      furniture.plural() != furniture.name() && last.ends_with('s') && !last.ends_with("ss") &&
      BestAt(names_, tokens_, i, /*plural=*/false, [](const hb::Furniture&) { return 0; }).second < length;
  return plural ? Count{2, false} : Count{};
}

// "a green armchair", "two sage green velvet armchairs": the colour is the piece's, not the room's.
void FurnitureReader::TakeColourBefore(std::size_t i, const hb::Furniture& furniture) {
  for (std::size_t back = 3; back >= 1; --back) {
    if (back > i || used_[i - back]) continue;
    const auto [colour, length] = LongestAt(colours_, tokens_, i - back, /*plural=*/false);
    if (length == 0 || length > back) continue;
    for (std::size_t k = i - back + length; k < i; ++k) {
      if (tokens_[k].kind != Token::Kind::kWord || tokens_[k].text == "and" || tokens_[k].text == "with") return;
    }
    facts_.object_colours.emplace_back(&furniture, colour);
    Use(i - back, length);
    return;
  }
}

// "... under the window", "... is placed next to the bed". The longest words count.
void FurnitureReader::TakePlaceAfter(std::size_t end, const hb::Furniture& furniture) {
  constexpr std::array<std::string_view, 12> kBefore = {"is",       "are",   "stands",   "standing", "placed", "which",
                                                        "directly", "right", "standing", "that",     "but",    "set"};
  while (end < tokens_.size() && IsOneOf(kBefore, tokens_[end].text)) ++end;
  Place place;
  std::size_t longest = 0;
  for (const hb::AskedPlace& asked : handbook_.contents().asked_places()) {
    const bool names_other = asked.relation().text().find("{target}") != std::string::npos;
    for (const std::string& words : asked.words()) {
      const std::size_t length = Phrase(words).MatchAt(tokens_, end, /*plural=*/false);
      if (length <= longest) continue;
      std::size_t other = end + length;
      if (names_other && other < tokens_.size() && IsArticle(tokens_[other].text)) ++other;
      const auto* target = names_other ? LongestAt(names_, tokens_, other, /*plural=*/true).first : nullptr;
      if (names_other && (target == nullptr || target == &furniture)) continue;
      longest = length;
      place = {&furniture, &asked, target};
    }
  }
  if (longest > 0) facts_.places.push_back(place);
}

// "only a bed and a wardrobe", "just a desk", "nothing but a sofa", "and nothing else".
void FurnitureReader::ReadOnly() {
  if (facts_.wishes.empty()) return;
  for (std::size_t i = 0; i + 1 < tokens_.size(); ++i) {
    const std::string &word = tokens_[i].text, &next = tokens_[i + 1].text;
    const bool negated = i > 0 && (tokens_[i - 1].text == "not" || tokens_[i - 1].text == "if");
    const bool counts = NumberWord(next) || IsArticle(next) || tokens_[i + 1].kind == Token::Kind::kNumber;
    if ((word == "only" || word == "just") && !negated && counts) {
      // "only 3 m wide", "only one window": of the room.
      const std::size_t end = std::min(i + 5, tokens_.size());
      for (std::size_t k = i + 2; k < end; ++k) {
        facts_.nothing_else = facts_.nothing_else || LongestAt(names_, tokens_, k, /*plural=*/true).second > 0;
        if (tokens_[k].kind == Token::Kind::kSign || tokens_[k].text == "with" || tokens_[k].text == "for") break;
      }
    }
    if (word == "nothing" && (next == "but" || next == "else")) facts_.nothing_else = true;
  }
}

}  // namespace flair::language
