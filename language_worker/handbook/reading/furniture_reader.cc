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
constexpr double kSmallM = 0.6;

template <std::size_t n>
bool IsOneOf(const std::array<std::string_view, n>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool IsArticle(std::string_view word) { return word == "a" || word == "an" || word == "the"; }

std::string LastWord(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

// "another desk", "a second desk": one more than were asked for before.
bool IsFurther(const std::vector<Token>& tokens, std::size_t i) {
  for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
    const std::string& word = tokens[i - back].text;
    if (word == "another" || word == "second" || word == "further" || word == "additional") return true;
    if (tokens[i - back].kind == Token::Kind::kSign || word == "and" || word == "with" || IsArticle(word)) break;
  }
  return false;
}

// "three-seat", "2 seater", "six-drawer", "ten-foot", "65-inch", "2 m long": how large a piece is, not how many of it.
bool MeasuresThePiece(const std::vector<Token>& tokens, std::size_t i) {
  constexpr std::array<std::string_view, 33> kMeasures = {
      "seat",  "seats", "seater", "person", "drawer", "door",  "tier", "piece", "leg",    "legged", "poster",
      "bulb",  "arm",   "armed",  "burner", "panel",  "shelf", "foot", "feet",  "ft",     "m",      "metre",
      "meter", "cm",    "mm",     "inch",   "inches", "\"",    "'",    "litre", "string", "bay",    "light"};
  if (tokens[i].kind != Token::Kind::kNumber && !NumberWord(tokens[i].text)) return false;
  std::size_t next = i + 1;
  if (next < tokens.size() && tokens[next].text == "-" && tokens[next].glued) ++next;
  const bool one = tokens[i].text == "a" || tokens[i].text == "an";
  return !one && next < tokens.size() && IsOneOf(kMeasures, tokens[next].text);
}

// "not too many plants", "hardly any cushions", "few pictures": one at most. "A few" are some.
bool AsksForFew(const std::vector<Token>& tokens, std::size_t i) {
  static const std::vector<Phrase> kFew = {Phrase("not too many"), Phrase("not many"),   Phrase("not so many"),
                                           Phrase("hardly any"),   Phrase("barely any"), Phrase("few"),
                                           Phrase("as few")};
  constexpr std::size_t kMostBack = 4;
  for (std::size_t back = 1; back <= kMostBack && back <= i; ++back) {
    const std::size_t at = i - back;
    if (tokens[at].kind == Token::Kind::kSign || tokens[at].text == "and" || tokens[at].text == "with") return false;
    const bool some = at > 0 && (tokens[at - 1].text == "a" || tokens[at - 1].text == "quite");
    for (const Phrase& few : kFew) {
      const std::size_t length = few.MatchAt(tokens, at, /*plural=*/false);
      if (length > 0 && at + length <= i && !some) return true;
    }
  }
  return false;
}

// The "poster" of "four-poster" is no picture.
bool IsMeasure(const std::vector<Token>& tokens, std::size_t i) {
  return i >= 2 && tokens[i].glued && tokens[i - 1].text == "-" && MeasuresThePiece(tokens, i - 2);
}

// "for eight", "with six chairs": behind a word for a table, those who sit at it.
bool SeatsFollow(const std::vector<Token>& tokens, std::size_t i) {
  if (i + 1 >= tokens.size() || (tokens[i].text != "for" && tokens[i].text != "with")) return false;
  const bool number =
      tokens[i + 1].kind == Token::Kind::kNumber || (!IsArticle(tokens[i + 1].text) && NumberWord(tokens[i + 1].text));
  if (!number) return false;
  return tokens[i].text == "for" || (i + 2 < tokens.size() && (MatchesWord(tokens[i + 2].text, "chair") ||
                                                               MatchesWord(tokens[i + 2].text, "seat")));
}

// Whether a class usually stands at, on or beside the other.
bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner) {
  const auto names = [&](const auto& list) { return std::ranges::find(list, partner.name()) != list.end(); };
  return names(furniture.hosts()) ||
         std::ranges::any_of(furniture.relations(), [&](const hb::Relation& one) { return names(one.targets()); });
}

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
      if (tokens_[i].kind == Token::Kind::kWord && IsRefused(i)) used_[i] = RefuseKind(i);
      continue;
    }
    if (IsRefused(i)) {
      AddOnce(facts_.refusals, furniture);
      if (length == 1) RefuseKind(i);
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
  ReadOnly();
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
    together = together || IsOneOf(kTogether, token.text);
    if (const hb::Furniture* piece = AnyAt(k); together && piece != nullptr) return piece;
  }
  if (mentions_.empty() || i - mentions_.back().end > kMostWords) return nullptr;
  for (std::size_t k = mentions_.back().end; k < i; ++k) {
    if (tokens_[k].kind == Token::Kind::kSign && tokens_[k].text != ",") return nullptr;
    if (IsOneOf(kJoined, tokens_[k].text)) return mentions_.back().furniture;
  }
  return nullptr;
}

// "... a coffee table. The table should be round": the piece of that name that was asked for before. Null where the
// words ask for another one.
const Wish* FurnitureReader::MeantBefore(std::size_t i, std::size_t length) const {
  constexpr std::array<std::string_view, 9> kKnown = {"the",  "these",  "those", "each", "every",
                                                      "both", "either", "that",  "this"};
  if (length != 1 || i == 0 || !IsOneOf(kKnown, tokens_[i - 1].text)) return nullptr;
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
  if (!IsRefused(i) && std::ranges::find(facts_.not_known, text) == facts_.not_known.end())
    facts_.not_known.push_back(text);
  Use(i, length);
  return length;
}

// A word alone refuses all of its kind: "no chairs" also the armchairs, "no lamps" those on tables and floor. Whether
// there are any.
bool FurnitureReader::RefuseKind(std::size_t i) {
  bool any = false;
  for (const hb::Furniture& other : handbook_.contents().furniture()) {
    const std::string last = LastWord(other.name());
    // Planters and bonsai are plants too.
    const bool same = Phrase(last).MatchAt(tokens_, i) == 1 || MatchesWord(tokens_[i].text, other.category());
    const bool compound = last.size() > 5 && last.ends_with("chair") && Phrase("chair").MatchAt(tokens_, i) == 1;
    if (same || compound) AddOnce(facts_.refusals, &other);
    any = any || same || compound;
  }
  return any;
}

// "no tv", "without a desk", "no tv or desk", "a shower instead of a bathtub"; not "not near the bed", "no more than
// two chairs".
bool FurnitureReader::IsRefused(std::size_t i) const {
  constexpr std::array<std::string_view, 21> kPlaces = {
      "near",     "next",  "by",    "facing",  "in",   "on",    "at",      "under", "beside", "against", "behind",
      "opposite", "close", "below", "beneath", "from", "above", "between", "too",   "front",  "many"};
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

// Of "two rows of five benches" and "mats in 3 rows of 4" the number in all; 0 where no rows are counted.
int FurnitureReader::TakeRows(std::size_t i, std::size_t length) {
  constexpr std::size_t kMostWords = 4, kPhrase = 4;
  const auto number = [&](std::size_t k) {
    if (tokens_[k].kind == Token::Kind::kNumber) return static_cast<int>(std::clamp(tokens_[k].number, 0.0, 100.0));
    return IsArticle(tokens_[k].text) ? 0 : NumberWord(tokens_[k].text).value_or(0);
  };
  const auto rows_at = [&](std::size_t k) {
    if (k + kPhrase > tokens_.size() || !MatchesWord(tokens_[k + 1].text, "row") || tokens_[k + 2].text != "of")
      return 0;
    return number(k) * number(k + 3);
  };
  const std::size_t end = i + length;
  std::vector<std::size_t> starts;
  for (std::size_t back = kPhrase; back <= kPhrase + kMostWords && back <= i; ++back) starts.push_back(i - back);
  if (end < tokens_.size() && tokens_[end].text == "in") starts.push_back(end + 1);
  for (const std::size_t start : starts) {
    const int rows = rows_at(start);
    if (rows == 0) continue;
    Use(start, kPhrase);
    return rows;
  }
  return 0;
}

void FurnitureReader::Wishing(const hb::Furniture& furniture, std::size_t i, std::size_t length) {
  Count count = CountBefore(furniture, i, length);
  if (const int in_rows = TakeRows(i, length); in_rows > 0) count = {in_rows};
  if (SeatsTheLast(furniture, count, i, length)) return;
  Wish wish{&furniture, count.number, 0, count.said, IsOptional(i, i + length)};
  if (!furniture.companions().empty()) wish.seats = SeatsAfter(i + length);
  if (wish.seats > 0) Use(i + length, 2);  // these are the table's, not the room's
  if (wish.seats == 0 && TakesTheLastAsSeats(i, wish)) last_.reset();
  const bool further = IsFurther(tokens_, i);
  Mentioned(furniture, i, length, count);
  last_ = Last{AddWish(wish, further), i + length, IsSeat(furniture) && length == 1};
  TakeColourBefore(i, furniture);
}

void FurnitureReader::Mentioned(const hb::Furniture& furniture, std::size_t i, std::size_t length, const Count& count) {
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

// "a bench if there is room", "perhaps a bench", "an optional bench".
bool FurnitureReader::IsOptional(std::size_t begin, std::size_t end) const {
  static const std::vector<Phrase> kBehind = {Phrase("if there is room"),
                                              Phrase("if there s room"),
                                              Phrase("if there is space"),
                                              Phrase("if there s space"),
                                              Phrase("if there is any room"),
                                              Phrase("if there is enough room"),
                                              Phrase("if there is enough space"),
                                              Phrase("if it fits"),
                                              Phrase("if they fit"),
                                              Phrase("if possible"),
                                              Phrase("if needed"),
                                              Phrase("if space allows"),
                                              Phrase("if room allows"),
                                              Phrase("if space permits"),
                                              Phrase("space permitting"),
                                              Phrase("room permitting"),
                                              Phrase("where it fits"),
                                              Phrase("would be nice"),
                                              Phrase("would be a bonus"),
                                              Phrase("if you can"),
                                              Phrase("if you can fit"),
                                              Phrase("as an option"),
                                              Phrase("if at all possible"),
                                              Phrase("optional"),
                                              Phrase("if necessary"),
                                              Phrase("if we have room"),
                                              Phrase("if room remains")};
  static const std::vector<Phrase> kBefore = {
      Phrase("perhaps"),    Phrase("maybe"),       Phrase("possibly"),         Phrase("optional"),
      Phrase("optionally"), Phrase("if possible"), Phrase("if there is room"), Phrase("if there is space"),
      Phrase("ideally")};
  constexpr std::size_t kMostWords = 8, kMostBefore = 5;
  const auto says = [&](const std::vector<Phrase>& phrases, std::size_t at) {
    return std::ranges::any_of(phrases, [&](const Phrase& one) { return one.MatchAt(tokens_, at, false) > 0; });
  };
  for (std::size_t at = end; at < tokens_.size() && at < end + kMostWords; ++at) {
    if (says(kBehind, at)) return true;
    const std::string& word = tokens_[at].text;
    const bool comma = word == "," && at + 1 < tokens_.size() && says(kBehind, at + 1);
    if ((tokens_[at].kind == Token::Kind::kSign && !comma && word != "(") || word == "and" || word == "with") break;
  }
  for (std::size_t back = 1; back <= kMostBefore && back <= begin; ++back) {
    const std::size_t at = begin - back;
    if (says(kBefore, at)) return true;
    if (tokens_[at].kind == Token::Kind::kSign && tokens_[at].text != ",") break;
    if (tokens_[at].text == "and" || tokens_[at].text == "with" || tokens_[at].text == "is" || used_[at]) break;
  }
  return false;
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
    joined = joined || (around ? IsOneOf(kAround, tokens_[i].text) : IsOneOf(kWith, tokens_[i].text));
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
  if (AsksForFew(tokens_, i)) return {1};
  for (std::size_t back = 1; back <= 3 && back <= i; ++back) {
    const std::size_t at = i - back;
    const Token& token = tokens_[at];
    if (MeasuresThePiece(tokens_, at)) continue;
    if (token.kind == Token::Kind::kNumber) {
      const double number = std::min(token.number, 1e6);
      return {number >= 1 && number == std::floor(number) ? static_cast<int>(number) : 1};
    }
    // "A few" is more than "a".
    std::pair<std::size_t, int> longest = {0, 0};
    for (const hb::CountWord& word : handbook_.contents().count_words()) {
      for (const std::string& text : word.words()) {
        const std::size_t said = Phrase(text).MatchAt(tokens_, at, false);
        if (said > longest.first && at + said <= i && word.count() > 0) longest = {said, word.count()};
      }
    }
    if (longest.first > 0) return {longest.second};
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
