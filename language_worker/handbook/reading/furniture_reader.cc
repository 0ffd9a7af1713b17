// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/furniture_reader.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/wish_words.h"

namespace flair::language {
namespace {

constexpr double kSmallM = 0.6;

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

bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner) {
  const auto names = [&](const auto& list) { return std::ranges::find(list, partner.name()) != list.end(); };
  return names(furniture.hosts()) ||
         std::ranges::any_of(furniture.relations(), [&](const hb::Relation& one) { return names(one.targets()); });
}

FurnitureReader::FurnitureReader(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used,
                                 BriefFacts& facts)
    : handbook_(handbook),
      tokens_(tokens),
      used_(used),
      facts_(facts),
      nouns_(handbook, facts),
      names_(nouns_.names()),
      colours_(ColourSayings(handbook)) {}

void FurnitureReader::Use(std::size_t start, std::size_t length) {
  std::fill_n(used_.begin() + static_cast<std::ptrdiff_t>(start), length, true);
}

void FurnitureReader::Read() {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    if (used_[i] || IsMeasure(tokens_, i)) continue;
    const hb::Furniture* partner = LongestAt(names_, tokens_, i, /*plural=*/true).second == 1 ? PartnerOf(i) : nullptr;
    const bool seats = SeatsFollow(tokens_, i + 1);
    const bool between = i + 1 < tokens_.size() && (tokens_[i + 1].text == "between" || tokens_[i + 1].text == "in");
    const auto rank = [&](const hb::Furniture& furniture) {
      const bool beside = partner != nullptr && StandsWith(furniture, *partner);
      const bool table = seats && SeatOf(furniture, handbook_) != nullptr;
      // Between two seats stands something small.
      const bool small = beside && between && furniture.width_m().typical() <= kSmallM;
      return nouns_.RankAt(tokens_, i, furniture) + (beside ? 64 : 0) + (small ? 32 : 0) + (table ? 128 : 0);
    };
    const auto [named, name_length] = BestAt(names_, tokens_, i, /*plural=*/true, rank);
    if (const std::size_t other = TakeOtherThing(i, name_length); other > 0) {
      i += other - 1;
      continue;
    }
    const hb::Furniture* furniture = nouns_.Modified(tokens_, i, name_length, named);
    const std::size_t length = furniture == nullptr ? 0 : nouns_.LengthWithHead(tokens_, i, name_length, *furniture);
    if (length == 0) {
      if (tokens_[i].kind == Token::Kind::kWord && IsRefused(tokens_, i))
        used_[i] = RefuseKind(handbook_, tokens_, i, facts_);
      continue;
    }
    if (IsRefused(tokens_, i)) {
      AddOnce(facts_.refusals, furniture);
      if (length == 1) RefuseKind(handbook_, tokens_, i, facts_);
      last_.reset();
    } else if (const Wish* meant = MeantBefore(i, length)) {
      mentions_.push_back({meant->furniture, i, i + length, meant->count});
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
  if (!facts_.wishes.empty() && AsksForNothingElse(handbook_, tokens_)) facts_.nothing_else = true;
}

void FurnitureReader::ReadPlaces() {
  const auto rank = [this](const hb::Furniture& furniture) {
    const bool wished =
        std::ranges::any_of(facts_.wishes, [&](const Wish& one) { return one.furniture == &furniture; });
    return RankOf(furniture) + (wished ? 1024 : 0);
  };
  PlaceReader(handbook_, tokens_, names_, mentions_, rank, used_, facts_).Read();
}

const hb::Furniture* FurnitureReader::AnyAt(std::size_t i) {
  const auto [found, fresh] = any_at_.try_emplace(i, nullptr);
  if (fresh) found->second = LongestAt(names_, tokens_, i, /*plural=*/true).first;
  return found->second;
}

// The piece that a word for several kinds is said together with: "a table in front of the sofa", "a desk and a chair".
const hb::Furniture* FurnitureReader::PartnerOf(std::size_t i) {
  constexpr std::array<std::string_view, 14> kTogether = {"between", "next", "beside", "by",   "near",
                                                          "front",   "foot", "end",    "on",   "either",
                                                          "behind",  "at",   "around", "round"};
  constexpr std::array<std::string_view, 5> kJoined = {"with", "and", "plus", "has", "have"};
  constexpr std::size_t kMostWords = 8;
  bool together = false;
  for (std::size_t k = i + 1; k < tokens_.size() && k < i + kMostWords; ++k) {
    const Token& token = tokens_[k];
    if (token.kind == Token::Kind::kSign || token.text == "with" || (token.text == "and" && !together)) break;
    if (token.text == "them") break;
    together = together || IncludesWord(kTogether, token.text);
    if (const hb::Furniture* piece = AnyAt(k); together && piece != nullptr) return piece;
  }
  if (mentions_.empty() || i - mentions_.back().end > kMostWords) return nullptr;
  for (std::size_t k = mentions_.back().end; k < i; ++k) {
    if (tokens_[k].kind == Token::Kind::kSign && tokens_[k].text != ",") return nullptr;
    if (IncludesWord(kJoined, tokens_[k].text)) return mentions_.back().furniture;
  }
  return nullptr;
}

// "... a coffee table. The table should be round": the piece of that name that was asked for before. Null where the
// words ask for another one.
const Wish* FurnitureReader::MeantBefore(std::size_t i, std::size_t length) const {
  constexpr std::array<std::string_view, 9> kKnown = {"the",  "these",  "those", "each", "every",
                                                      "both", "either", "that",  "this"};
  if (length != 1 || i == 0 || !IncludesWord(kKnown, tokens_[i - 1].text)) return nullptr;
  for (auto wish = facts_.wishes.rbegin(); wish != facts_.wishes.rend(); ++wish) {
    const std::string& name = wish->furniture->name();
    const std::string last = LastWord(name);
    const bool compound = last.ends_with("chair") && MatchesWord(tokens_[i].text, "chair");
    if (MatchesWord(tokens_[i].text, last) || compound) return &*wish;
  }
  return nullptr;
}

int FurnitureReader::RankOf(const hb::Furniture& furniture) const { return nouns_.RankOf(furniture); }

// "a luggage rack": its last word is a class, but the thing is none.
std::size_t FurnitureReader::TakeOtherThing(std::size_t i, std::size_t piece_length) {
  const std::size_t length = nouns_.OtherThingAt(tokens_, i);
  if (length == 0 || length < piece_length) return 0;
  std::string text;
  for (std::size_t k = i; k < i + length; ++k) text += (k > i && !tokens_[k].glued ? " " : "") + tokens_[k].text;
  if (!IsRefused(tokens_, i) && std::ranges::find(facts_.not_known, text) == facts_.not_known.end())
    facts_.not_known.push_back(text);
  Use(i, length);
  return length;
}

void FurnitureReader::Wishing(const hb::Furniture& furniture, std::size_t i, std::size_t length) {
  PieceCount count = CountBefore(handbook_, tokens_, furniture, i, length);
  if (const Rows rows = RowsAround(tokens_, i, length); rows.number > 0) {
    count = {rows.number};
    Use(rows.begin, rows.end - rows.begin);
  }
  if (SeatsTheLast(furniture, count, i, length)) return;
  Wish wish{&furniture, count.number, 0, count.said, IsOptional(tokens_, used_, i, i + length)};
  if (!furniture.companions().empty()) wish.seats = SeatsAfter(tokens_, i + length);
  if (wish.seats > 0) Use(i + length, 2);  // these are the table's, not the room's
  if (wish.seats == 0 && TakesTheLastAsSeats(i, wish)) last_.reset();
  const bool further = IsFurther(tokens_, i);
  Mentioned(furniture, i, length, count);
  last_ = Last{AddWish(wish, further), i + length, IsSeat(furniture) && length == 1};
  TakeColourBefore(i, furniture);
}

void FurnitureReader::Mentioned(const hb::Furniture& furniture, std::size_t i, std::size_t length,
                                const PieceCount& count) {
  Mention mention{&furniture, i, i + length, count.number};
  for (const Wish& there : facts_.wishes) {
    if (there.furniture != &furniture || !IsFurther(tokens_, i) || count.number != 1) continue;
    // "One desk by the door and another one ...": each has its own place from now on.
    mention.which = there.count;
    for (Mention& earlier : mentions_) {
      if (earlier.furniture == &furniture && there.count == 1) earlier.which = 0;
    }
  }
  mentions_.push_back(mention);
}

// "a meeting table with six chairs", "two tables and eight chairs", "four desks with two chairs each".
bool FurnitureReader::SeatsTheLast(const hb::Furniture& seat, const PieceCount& count, std::size_t i,
                                   std::size_t length) {
  if (!last_ || last_->seat || !OnlyWordsBetween(last_->end, i, /*around=*/false)) return false;
  Wish& host = facts_.wishes[last_->wish];
  const hb::Furniture* usual = SeatOf(*host.furniture, handbook_);
  if (usual == nullptr || host.seats > 0) return false;
  const bool any = length == 1 && (seat.category() == usual->category() || IsSeat(seat));
  if (usual != &seat && !any) return false;
  const bool each = i + length < tokens_.size() && tokens_[i + length].text == "each";
  Mentioned(*host.furniture, i, length, {host.count});
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
    joined = joined || (around ? IncludesWord(kAround, tokens_[i].text) : IncludesWord(kWith, tokens_[i].text));
  }
  return joined;
}

std::size_t FurnitureReader::AddWish(const Wish& wish, bool further) {
  const int count = std::min(wish.count, kMostOfAKind);
  if (wish.count > kMostOfAKind) AddOnce(facts_.too_many, wish.furniture);
  for (std::size_t i = 0; i < facts_.wishes.size(); ++i) {
    Wish& there = facts_.wishes[i];
    if (there.furniture != wish.furniture) continue;
    there.count = further ? std::min(there.count + count, kMostOfAKind) : std::max(there.count, count);
    there.optional = there.optional && wish.optional;
    there.seats = std::max(there.seats, wish.seats);
    return i;
  }
  facts_.wishes.push_back({wish.furniture, count, wish.seats, wish.counted, wish.optional});
  return facts_.wishes.size() - 1;
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

}  // namespace flair::language
