// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/furniture_reader.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "english/quantities.h"
#include "language_worker/handbook/reading/noun_book.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

class FurnitureReader {
 public:
  FurnitureReader(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used,
                  BriefFacts& facts)
      : handbook_(handbook),
        tokens_(tokens),
        used_(used),
        facts_(facts),
        nouns_(handbook, facts),
        names_(nouns_.names()) {}

  NamedPieces Read() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (used_[i] || IsMeasure(tokens_, i) || IsAVerb(i)) continue;
      const hb::Furniture* partner =
          LongestAt(names_, tokens_, i, /*plural=*/true).second == 1 ? PartnerOf(i) : nullptr;
      const bool seats = SeatsFollow(tokens_, i + 1);
      const bool between = i + 1 < tokens_.size() && (tokens_[i + 1].text == "between" || tokens_[i + 1].text == "in");
      const auto rank = [&](const hb::Furniture& furniture) {
        const bool beside = partner != nullptr && StandsWith(furniture, *partner);
        const bool table = seats && SeatOf(furniture, handbook_) != nullptr;
        // Between two seats stands something small.
        constexpr double kSmallM = 0.6;
        const bool small = beside && between && furniture.width_m().typical() <= kSmallM;
        return (handbook_.IsOwn(furniture) ? 4096 : 0) + nouns_.RankAt(tokens_, i, furniture) + (beside ? 64 : 0) +
               (small ? 32 : 0) + (table ? 128 : 0);
      };
      auto [named, name_length] = BestAt(names_, tokens_, i, /*plural=*/true, rank);
      TakeOverlapping(i, named, name_length);
      const bool own = named != nullptr && handbook_.IsOwn(*named);
      if (const std::size_t other = TakeOtherThing(i, name_length + (own ? 1 : 0)); other > 0) {
        i += other - 1;
        continue;
      }
      if (named != nullptr && named->named_as_said() && !own &&
          (IsOfAPurpose(i) || AnyAt(i + name_length) != nullptr)) {
        i += name_length - 1;
        continue;
      }
      const bool refused = IsRefused(tokens_, i);
      for (std::size_t k = i - std::min<std::size_t>(i, 4); k < i && refused; ++k) {
        if (IsIn("refusing", tokens_[k].text)) counts_.push_back(k);
      }
      const hb::Furniture* furniture = own ? named : nouns_.Modified(tokens_, i, name_length, named);
      if (furniture != nullptr) furniture = handbook_.FindFurniture(furniture->name());
      const std::size_t length = furniture == nullptr ? 0 : nouns_.LengthWithHead(tokens_, i, name_length, *furniture);
      if (length == 0) {
        if (tokens_[i].kind == Token::Kind::kWord && refused) used_[i] = RefuseKind(handbook_, tokens_, i, facts_);
        continue;
      }
      if (refused) {
        AddOnce(facts_.refusals, furniture);
        if (length == 1) RefuseKind(handbook_, tokens_, i, facts_);
        last_.reset();
      } else if (const Wish* meant = MeantBefore(i, length)) {
        mentions_.push_back({meant->furniture, i, i + length, meant->count});
      } else if (!IsSaidTwice(*furniture, i, length)) {
        Wishing(*furniture, i, length);
      }
      Use(i, length);
      i += length - 1;
      if (!mentions_.empty() && mentions_.back().end == i + 1) mentions_.back().end = BehindParts(i + 1);
    }
    // What is asked for by its own name is not refused by a word for all of its kind: "no chairs but two armchairs".
    std::erase_if(facts_.refusals, [this](const hb::Furniture* refusal) {
      return std::ranges::any_of(facts_.wishes, [&](const Wish& wish) { return wish.furniture == refusal; });
    });
    facts_.nothing_else = !facts_.wishes.empty() && AsksForNothingElse(handbook_, tokens_);
    return {std::move(mentions_), std::move(counts_)};
  }

 private:
  // A wish that what follows may belong to: its table, or the chairs that a table follows.
  struct Last {
    std::size_t wish = 0;
    std::size_t end = 0;
    bool seat = false;
  };

  // Of "futon sofa bed", a futon sofa and a sofa bed, the latter.
  void TakeOverlapping(std::size_t i, const hb::Furniture*& named, std::size_t& length) {
    for (std::size_t k = i + 1; k < i + length; ++k) {
      const auto [later, later_length] = LongestAt(names_, tokens_, k, /*plural=*/true);
      if (later == nullptr || k + later_length <= i + length) continue;
      named = later;
      length = k + later_length - i;
      return;
    }
  }

  // Two names right behind each other are one piece: "king size platform bed"; of two kinds, "storage chest", the
  // second is it.
  bool IsSaidTwice(const hb::Furniture& furniture, std::size_t i, std::size_t length) {
    if (mentions_.empty() || mentions_.back().end != i) return false;
    Mention& before = mentions_.back();
    if (furniture.category() == before.furniture->category()) {
      before.end = i + length;
      return true;
    }
    if (facts_.wishes.empty() || facts_.wishes.back().furniture != before.furniture) return false;
    facts_.wishes.pop_back();
    mentions_.pop_back();
    last_.reset();
    return false;
  }

  // "The office showcases a desk".
  bool IsAVerb(std::size_t i) const {
    const BriefText text(tokens_);
    return text.Is(i, "verbs_of_having") && (text.Is(i + 1, "thing_articles") || NumberWord(text.At(i + 1)));
  }

  // "with sliding doors", "without a headboard": words for a part of the piece before them.
  std::size_t BehindParts(std::size_t end) const {
    constexpr std::size_t kMostOfAPart = 4;
    const BriefText text(tokens_);
    if (!text.Says(end, {"with", "without"})) return end;
    for (std::size_t i = end + 1; i < tokens_.size() && i <= end + kMostOfAPart; ++i) {
      if (IsFormIn("parts_of_furniture", text.At(i))) return i + 1;
      if (!text.IsWord(i) && !text.IsHyphen(i) && !text.IsNumber(i)) break;
    }
    return end;
  }

  // "hooks for hats", "a desk for writing letters": small things by which another piece's use is told.
  bool IsOfAPurpose(std::size_t i) const {
    constexpr std::size_t kMostBack = 4;
    const BriefText text(tokens_);
    for (std::size_t back = 1; back <= kMostBack && back <= i; ++back) {
      const std::size_t at = i - back;
      if (text.Says(at, {"for", "of", "to", "like"})) return true;
      if (text.IsSign(at) || text.Is(at, "thing_articles") || NumberWord(text.At(at)) || text.Is(at, "thing_ends"))
        break;
    }
    return false;
  }

  // "a luggage rack": its last word is a class, but the thing is none.
  std::size_t TakeOtherThing(std::size_t i, std::size_t piece_length) {
    const std::size_t length = nouns_.OtherThingAt(tokens_, i);
    if (length == 0 || length < piece_length) return 0;
    const std::string text = BriefText(tokens_).Quote(i, i + length);
    if (!IsRefused(tokens_, i) && !Includes(facts_.not_known, text)) facts_.not_known.push_back(text);
    Use(i, length);
    return length;
  }

  // The piece that a word for several kinds is said together with: "a table in front of the sofa", "a desk and a
  // chair".
  const hb::Furniture* PartnerOf(std::size_t i) {
    constexpr std::size_t kMostWords = 8;
    bool together = false;
    for (std::size_t k = i + 1; k < tokens_.size() && k < i + kMostWords; ++k) {
      const Token& token = tokens_[k];
      if (token.kind == Token::Kind::kSign || token.text == "with" || (token.text == "and" && !together)) break;
      if (token.text == "them") break;
      together = together || IsIn("together", token.text);
      if (const hb::Furniture* piece = AnyAt(k); together && piece != nullptr) return piece;
    }
    if (mentions_.empty() || i - mentions_.back().end > kMostWords) return nullptr;
    for (std::size_t k = mentions_.back().end; k < i; ++k) {
      if (tokens_[k].kind == Token::Kind::kSign && tokens_[k].text != ",") return nullptr;
      if (IsIn("joined", tokens_[k].text)) return mentions_.back().furniture;
    }
    return nullptr;
  }

  const hb::Furniture* AnyAt(std::size_t i) {
    const auto [found, fresh] = any_at_.try_emplace(i, nullptr);
    if (fresh) found->second = LongestAt(names_, tokens_, i, /*plural=*/true).first;
    return found->second;
  }

  // "... a coffee table. The table should be round": the piece of that name that was asked for before. Null where the
  // words ask for another one.
  const Wish* MeantBefore(std::size_t i, std::size_t length) const {
    // "The two beds" are those that were asked for.
    const bool counted = i > 1 && NumberWord(tokens_[i - 1].text) && !IsArticle(tokens_[i - 1].text);
    if (length != 1 || i == 0 || !IsIn("known_before", tokens_[i - (counted ? 2 : 1)].text)) return nullptr;
    const hb::Noun* noun = nouns_.NounAt(tokens_, i, length);
    const auto among = [&](const std::string& name) {
      return noun != nullptr && std::ranges::any_of(noun->options(), [&](const hb::NounOption& option) {
               return option.furniture() == name;
             });
    };
    for (auto wish = facts_.wishes.rbegin(); wish != facts_.wishes.rend(); ++wish) {
      const std::string last = LastWord(wish->furniture->name());
      const bool compound = last.ends_with("chair") && MatchesWord(tokens_[i].text, "chair");
      if (MatchesWord(tokens_[i].text, last) || compound || among(wish->furniture->name())) return &*wish;
    }
    return nullptr;
  }

  void Mentioned(const hb::Furniture& furniture, std::size_t i, std::size_t length, const PieceCount& count) {
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

  void Wishing(const hb::Furniture& furniture, std::size_t i, std::size_t length) {
    PieceCount count = CountBefore(handbook_, tokens_, furniture, i, length);
    for (std::size_t k = i - std::min<std::size_t>(i, 3); k < i; ++k) {
      const bool number = tokens_[k].kind == Token::Kind::kNumber || NumberWord(tokens_[k].text);
      const std::optional<english::Measure> measure = english::MeasureAt(tokens_, k);
      if (number && measure && measure->unit == 0) counts_.push_back(k);
    }
    if (const Rows rows = RowsAround(tokens_, i, length); rows.number > 0) {
      count = {rows.number};
      Use(rows.begin, rows.end - rows.begin);
    }
    if (SeatsTheLast(furniture, count, i, length)) return;
    if (count.number == 1 && !facts_.wishes.empty() && IsOneForEach(tokens_, used_, i, length)) {
      count.number = std::clamp(facts_.wishes.back().count, 1, kMostOfAKind);
    }
    Wish wish{&furniture, count.number, 0, count.said, IsOptional(tokens_, used_, i, i + length)};
    wish.noun = nouns_.NounAt(tokens_, i, length);
    if (IsSeat(furniture)) wish.noun = nouns_.NounAt(tokens_, i + length - 1, 1);
    if (!furniture.companions().empty()) wish.seats = SeatsAfter(tokens_, i + length);
    if (wish.seats > 0) Use(i + length, SeatsNumberAt(tokens_, i + length) + 1 - (i + length));  // not the room's
    if (wish.seats == 0 && TakesTheLastAsSeats(i, wish)) last_.reset();
    const bool further = IsFurther(tokens_, i);
    Mentioned(furniture, i, length, count);
    last_ = Last{AddWish(wish, further), i + length, IsSeat(furniture) && length == 1};
    TakeColourBefore(i, furniture);
    TakeMaterialBefore(i, furniture);
    if (const std::optional<std::size_t> at = PhraseBefore("wall_mounted", tokens_, i)) {
      if (furniture.kind() == hb::FURNITURE_KIND_WALL)
        Use(*at, *BriefText(tokens_).BehindPhrase(*at, "wall_mounted") - *at);
    }
  }

  // "a meeting table with six chairs", "two tables and eight chairs", "four desks with two chairs each".
  bool SeatsTheLast(const hb::Furniture& seat, const PieceCount& count, std::size_t i, std::size_t length) {
    if (!last_ || last_->seat || !OnlyWordsBetween(last_->end, i, /*around=*/false)) return false;
    Wish& host = facts_.wishes[last_->wish];
    const hb::Furniture* usual = SeatOf(*host.furniture, handbook_);
    if (usual == nullptr || host.seats > 0) return false;
    const bool any = length == 1 && seat.category() == usual->category();
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
  bool TakesTheLastAsSeats(std::size_t i, Wish& host) {
    if (!last_ || !last_->seat || SeatOf(*host.furniture, handbook_) == nullptr) return false;
    if (!OnlyWordsBetween(last_->end, i, /*around=*/true)) return false;
    const Wish seats = facts_.wishes[last_->wish];
    facts_.wishes.erase(facts_.wishes.begin() + static_cast<std::ptrdiff_t>(last_->wish));
    if (seats.counted) host.seats = std::min(std::max(1, seats.count / std::max(1, host.count)), kMostSeats);
    return true;
  }

  std::size_t AddWish(const Wish& wish, bool further) {
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
    facts_.wishes.push_back(wish);
    facts_.wishes.back().count = count;
    return facts_.wishes.size() - 1;
  }

  // Whether tokens [from, to) only say that what follows belongs to what came before.
  bool OnlyWordsBetween(std::size_t from, std::size_t to, bool around) const {
    constexpr std::size_t kMostWords = 8;
    bool joined = false;
    if (to < from || to - from > kMostWords) return false;
    for (std::size_t i = from; i < to; ++i) {
      if (used_[i] || tokens_[i].kind == Token::Kind::kSign) return false;
      joined = joined || (around ? IsIn("around_a_table", tokens_[i].text) : IsIn("with_seats", tokens_[i].text));
    }
    return joined;
  }

  // "a green armchair", "two sage green velvet armchairs": the colour is the piece's, not the room's.
  void TakeColourBefore(std::size_t i, const hb::Furniture& furniture) {
    for (std::size_t back = 3; back >= 1; --back) {
      if (back > i || used_[i - back]) continue;
      const auto [colour, length] = LongestAt(handbook_.vocabulary().colours, tokens_, i - back, /*plural=*/false);
      if (length == 0 || length > back) continue;
      for (std::size_t k = i - back + length; k < i; ++k) {
        if (tokens_[k].kind != Token::Kind::kWord || tokens_[k].text == "and" || tokens_[k].text == "with") return;
      }
      facts_.object_colours.emplace_back(&furniture, colour);
      Use(i - back, length);
      return;
    }
  }

  // "a glass coffee table", "an oak and steel desk": the first of them.
  void TakeMaterialBefore(std::size_t i, const hb::Furniture& furniture) {
    constexpr std::size_t kMostBack = 4;
    for (std::size_t at = i; at > 0 && at + kMostBack > i; --at) {
      const Token& token = tokens_[at - 1];
      const bool material = token.kind == Token::Kind::kWord && IsIn("materials", token.text);
      if (!material && (EndsNounPhrase(token) || NumberWord(token.text))) return;
      if (!material || used_[at - 1]) continue;
      facts_.object_materials.emplace_back(&furniture, token.text == "wooden" ? "wood" : token.text);
      Use(at - 1, 1);
      return;
    }
  }

  void Use(std::size_t start, std::size_t length) {
    std::fill_n(used_.begin() + static_cast<std::ptrdiff_t>(start), length, true);
  }

  const Handbook& handbook_;
  const std::vector<Token>& tokens_;
  std::vector<bool>& used_;
  BriefFacts& facts_;
  const NounBook nouns_;
  const std::vector<Saying<hb::Furniture>>& names_;
  std::optional<Last> last_;
  std::vector<Mention> mentions_;
  std::vector<std::size_t> counts_;                     // tokens
  std::map<std::size_t, const hb::Furniture*> any_at_;  // of a token: what it names, whatever the room
};

}  // namespace

NamedPieces ReadFurniture(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used,
                          BriefFacts& facts) {
  return FurnitureReader(handbook, tokens, used, facts).Read();
}

void ReadPlaces(const Handbook& handbook, const std::vector<Token>& tokens, const std::vector<Mention>& mentions,
                std::vector<bool>& used, BriefFacts& facts) {
  const NounBook nouns(handbook, facts);
  const auto rank = [&](const hb::Furniture& furniture) {
    // What is wished for first is most often what is spoken of again.
    constexpr std::ptrdiff_t kMost = 200;
    const auto wish = std::ranges::find(facts.wishes, &furniture, &Wish::furniture);
    const auto after = std::min(kMost, wish - facts.wishes.begin());
    const bool wished = wish != facts.wishes.end();
    return nouns.RankOf(furniture) + (wished ? static_cast<int>(1024 + 2 * (kMost - after)) : 0);
  };
  // "The sofa" is also a corner sofa that was asked for.
  std::vector<Saying<hb::Furniture>> names = nouns.names();
  for (const Wish& wish : facts.wishes) names.push_back({Phrase(LastWord(wish.furniture->name())), wish.furniture});
  for (const Vocabulary::Head& head : handbook.vocabulary().heads) {
    for (const Wish& wish : facts.wishes) {
      if (!Includes(head.options, wish.furniture)) continue;
      for (const Phrase& word : head.words) names.push_back({word, wish.furniture});
    }
  }
  ReadPlaces(handbook, tokens, names, mentions, rank, used, facts);
}

}  // namespace flair::language
