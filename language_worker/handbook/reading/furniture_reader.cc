// SPDX-License-Identifier: GPL-3.0-or-later
// Over 400 lines: one pass over the words of a brief, whose steps share what the earlier ones have used.
#include "language_worker/handbook/reading/furniture_reader.h"

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <utility>

#include "english/quantities.h"
#include "language_worker/handbook/reading/named_sets.h"
#include "language_worker/handbook/reading/noun_book.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/piece_choices.h"
#include "language_worker/handbook/reading/piece_looks.h"
#include "language_worker/handbook/reading/piece_mentions.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

constexpr double kAtADeskM = 0.65;  // of its width for each of several

class FurnitureReader : Reading {
 public:
  explicit FurnitureReader(const Reading& reading) : Reading(reading), nouns_(handbook, facts), names_(nouns_.names()) {
    std::vector<bool> free = used;
    people_ = ReadPeople(tokens(), free).value_or(0);
  }

  NamedPieces Read() {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      if (used[i] || IsMeasure(text, i) || IsNoNoun(text, i) || IsLikened(text, i) || AreFronts(*this, i)) continue;
      const std::size_t longest = LongestAt(names_, tokens(), i, /*plural=*/true).second;
      const hb::Furniture* partner = longest == 1 ? PartnerOf(i) : nullptr;
      const bool seats = SeatsFollow(text, i + 1), several = CountsSeveral(text, i);
      const hb::Furniture* const chairs = nouns_.ChairsBehind(tokens(), i + longest);
      const auto rank = [&](const hb::Furniture& furniture) {
        const bool beside = partner != nullptr && StandsWith(furniture, *partner);
        const bool its_seats = chairs != nullptr && SeatOf(furniture, handbook) == chairs;
        // "Sewing machines on tables".
        const bool host = partner != nullptr && Includes(partner->hosts(), furniture.name());
        // "Chairs for twelve" are no tables.
        const bool chair = furniture.category() == "recliner" || PlacesOn(furniture) > 0;
        const bool table = seats && !chair && SeatOf(furniture, handbook) != nullptr;
        // Between two seats stands something small.
        constexpr double kSmallM = 0.6;
        const bool small = beside && text.Says(i + 1, {"between", "in"}) && furniture.width_m().typical() <= kSmallM;
        // So many are no armchairs.
        const bool upright = several && IsSeat(furniture);
        return (handbook.IsOwn(furniture) ? 4096 : 0) + 2 * nouns_.RankAt(tokens(), i, furniture) + (beside ? 64 : 0) +
               (small ? 32 : 0) + (table ? 128 : 0) + (host ? 7 : 0) + (upright ? 9 : 0) + (its_seats ? 256 : 0);
      };
      auto [named, name_length] = BestAt(names_, tokens(), i, /*plural=*/true, rank);
      TakeOverlapping(i, named, name_length);
      if (named == nullptr && (named = SeatsAt(i)) != nullptr) name_length = 1;
      if (named != nullptr && (IsInAnotherRoom(*this, i + name_length) || IsOnlyTold(text, *named, i, name_length) ||
                               IsTheLastAsWell(*this, mentions_, *named, i))) {
        Use(i, i + name_length);
        continue;
      }
      const NounBook::Purpose purpose = nouns_.PurposeOf(tokens(), i, i + std::max<std::size_t>(name_length, 1));
      if (purpose.furniture != nullptr) named = purpose.furniture, name_length = std::max<std::size_t>(name_length, 1);
      const bool own = named != nullptr && handbook.IsOwn(*named);
      if (const std::size_t other = TakeOtherThing(i, name_length + (own ? 1 : 0)); other > 0) {
        i += other - 1;
        continue;
      }
      if (named != nullptr && !own &&
          (MakesACompound(text, i, i + name_length) || IsBehindItsDoor(*this, i, i + name_length)))
        continue;
      if (named != nullptr && named->named_as_said() && !own &&
          (IsOfAPurpose(text, i) || AnyAt(i + name_length) != nullptr)) {
        i += name_length - 1;
        continue;
      }
      const bool refused = IsRefused(text, i) && !TakesTurns(i);
      for (std::size_t k = i - std::min<std::size_t>(i, 4); k < i && refused; ++k) {
        if (text.Is(k, "refusing")) counts_.push_back(k);
      }
      const hb::Furniture* furniture =
          own || purpose.furniture != nullptr ? named : nouns_.Modified(tokens(), i, name_length, named);
      // "A table with a chair and a second chair": both are the table's.
      for (const Wish& wish : facts.wishes) {
        const hb::Furniture* seat = wish.seats > 0 && IsFurther(text, i) ? SeatOf(*wish.furniture, handbook) : nullptr;
        if (seat != nullptr && furniture == named && MatchesWord(text.At(i), "chair")) furniture = seat;
      }
      if (furniture != nullptr) furniture = handbook.FindFurniture(furniture->name());
      const std::size_t length = furniture == nullptr ? 0 : nouns_.LengthWithHead(tokens(), i, name_length, *furniture);
      if (length == 0) {
        if (text.IsWord(i) && refused) used[i] = RefuseKind(handbook, text, i, 1, facts);
        // The drawers of "parts cabinets with many small drawers", which nobody knows.
        const std::size_t behind = i + name_length, parts = BehindParts(text, behind);
        if (named != nullptr && parts > behind) i = parts - 1;
        continue;
      }
      if (refused) {
        AddOnce(facts.refusals, furniture);
        RefuseKind(handbook, text, i, length, facts);
        last_.reset();
      } else if (const std::optional<Mention> meant = MeantBefore(text, i, length, nouns_, facts, handbook)) {
        mentions_.push_back(*meant);
        TakeSeatsOfEach(*meant, i, length);
      } else if (const auto again = NamedAgainByItsLook(*this, *furniture, i, length)) {
        mentions_.push_back(*again);
        TakeLooksBefore(*this, *again->furniture, i);
      } else if (!IsSaidTwice(*furniture, i, length)) {
        Wishing(*furniture, i, length);
      }
      if (!text.Is(i, "places_of_people")) Use(i, i + length);  // they count people, too
      i += length - 1;
      if (mentions_.empty() || mentions_.back().end != i + 1) continue;
      mentions_.back().end = BehindParts(text, i + 1);
      // The drawers of a desk are no chest; the cushions of a sofa lie on it.
      const std::size_t behind = mentions_.back().end, noun = i;
      if (text.BehindPhrase(i + 2, "parts_in_two_words") == behind) Use(i + 1, behind);
      const hb::Furniture* part = behind > i + 1 ? AnyAt(behind - 1) : nullptr;
      if (part != nullptr && IsFloorPiece(*part) && part->category() != "mat") {
        Use(i + 1, behind);
        i = behind - 1;
      }
      if (purpose.furniture == nullptr) continue;
      Use(i + 1, purpose.end);
      mentions_.back().end = purpose.end;
      i = purpose.end - 1;
      Wish& wish = *std::ranges::find(facts.wishes, furniture, &Wish::furniture);
      if (wish.count < 3 && text.At(noun).ends_with('s'))
        wish.count = std::max(wish.count, CountAlongWalls(text, *furniture, purpose.end, facts));
    }
    ChooseOne(*this, mentions_);
    MeetLater(text, facts, mentions_);
    // What is asked for by its own name is not refused by a word for all of its kind: "no chairs but two armchairs".
    std::erase_if(facts.refusals, [this](const hb::Furniture* refusal) {
      return std::ranges::any_of(facts.wishes, [&](const Wish& wish) { return wish.furniture == refusal; });
    });
    TakeLooksBehind(*this, mentions_);
    facts.nothing_else = !facts.wishes.empty() && AsksForNothingElse(handbook, text);
    return {std::move(mentions_), std::move(counts_)};
  }

 private:
  // "A table with six chairs, with a bench instead of chairs on the wall side" has chairs.
  bool TakesTurns(std::size_t i) const {
    return i > 1 && text.At(i - 2) == "instead" && text.At(i - 1) == "of" && text.Is(i + 1, "place_prepositions") &&
           !facts.wishes.empty();
  }

  // A wish that what follows may belong to: its table, or the chairs that a table follows.
  struct Last {
    std::size_t wish = 0;
    std::size_t end = 0;
    bool seat = false;
  };

  // Of "futon sofa bed", a futon sofa and a sofa bed, the latter.
  void TakeOverlapping(std::size_t i, const hb::Furniture*& named, std::size_t& length) {
    for (std::size_t k = i + 1; k < i + length; ++k) {
      const auto [later, later_length] = LongestAt(names_, tokens(), k, /*plural=*/true);
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
    if (facts.wishes.empty() || facts.wishes.back().furniture != before.furniture) return false;
    facts.wishes.pop_back();
    mentions_.pop_back();
    last_.reset();
    return false;
  }

  // "Eighteen seats": what the room has for each; at a table that was spoken of its own. Null for other words.
  const hb::Furniture* SeatsAt(std::size_t i) const {
    const std::size_t begin = text.PhraseBegin(i);
    bool counted = false;
    for (std::size_t k = begin; k < i; ++k)
      counted = counted || text.IsNumber(k) || NumberWord(text.At(k)).value_or(0) > 1;
    if (!counted || !text.Is(i, "places_of_people")) return nullptr;
    if (last_ && !last_->seat && OnlyWordsBetween(last_->end, i, /*around=*/false)) {
      return SeatOf(*facts.wishes[last_->wish].furniture, handbook);
    }
    return SeatOfTheRoom(*facts.archetype, handbook);
  }

  // "a luggage rack": its last word is a class, but the thing is none.
  std::size_t TakeOtherThing(std::size_t i, std::size_t piece_length) {
    const std::size_t length = nouns_.OtherThingAt(tokens(), i);
    if (length == 0 || length < piece_length) return 0;
    const std::string said = text.Quote(i, i + length);
    if (!IsRefused(text, i) && !Includes(facts.not_known, said)) facts.not_known.push_back(said);
    Use(i, i + length);
    return length;
  }

  // The piece that a word for several kinds is said together with: "a table in front of the sofa", "a desk and a
  // chair".
  const hb::Furniture* PartnerOf(std::size_t i) {
    constexpr std::size_t kMostWords = 8;
    bool together = false;
    for (std::size_t k = i + 1; k < tokens().size() && k < i + kMostWords; ++k) {
      if (text.IsSign(k) || text.Says(k, {"with", "them"}) || (text.At(k) == "and" && !together)) break;
      together = together || text.Is(k, "together");
      if (const hb::Furniture* piece = AnyAt(k); together && piece != nullptr) return piece;
    }
    if (mentions_.empty()) return nullptr;
    if (mentions_.back().end > i) return mentions_.back().furniture;  // a part of it: "a sofa with cushions"
    if (i - mentions_.back().end > kMostWords) return nullptr;
    const bool bench =
        IsFormIn("seats_at_tables", text.At(i)) && mentions_.back().furniture->category().ends_with("table");
    for (std::size_t k = mentions_.back().end; k < i; ++k) {
      if (text.IsSign(k) && text.At(k) != ",") return nullptr;
      if (bench && text.At(k) == ",") return mentions_.back().furniture;
      if (text.Is(k, "joined") || text.At(k) == "on") return mentions_.back().furniture;
    }
    return nullptr;
  }

  const hb::Furniture* AnyAt(std::size_t i) {
    const auto [found, fresh] = any_at_.try_emplace(i, nullptr);
    if (fresh) found->second = LongestAt(names_, tokens(), i, /*plural=*/true).first;
    return found->second;
  }

  // "... six tables, four pupils at each table".
  void TakeSeatsOfEach(const Mention& mention, std::size_t i, std::size_t length) {
    const SeatsSaid seats = SeatsAround(text, i, length);
    const auto wish = std::ranges::find(facts.wishes, mention.furniture, &Wish::furniture);
    if (!seats.of_each || wish == facts.wishes.end() || mention.furniture->companions().empty()) return;
    wish->seats = std::min(seats.number, kMostSeats);
    Use(seats.begin, seats.end);
  }

  void Mentioned(const hb::Furniture& furniture, std::size_t i, std::size_t length, const PieceCount& count) {
    Mention mention{&furniture, i, i + length, count.number};
    for (const Wish& there : facts.wishes) {
      if (there.furniture != &furniture || !IsFurther(text, i) || count.number != 1) continue;
      // "One desk by the door and another one ...": each has its own place from now on.
      mention.which = there.count;
      for (Mention& earlier : mentions_) {
        if (earlier.furniture == &furniture && there.count == 1) earlier.which = 0;
      }
    }
    mentions_.push_back(mention);
  }

  void Wishing(const hb::Furniture& furniture, std::size_t i, std::size_t length) {
    PieceCount count = CountOf(handbook, text, furniture, i, length);
    if (SaysMany(text, i)) count = {std::min(count.number, SensibleNumber(furniture, AreaOf(facts))), false};
    for (std::size_t k = text.PhraseBegin(i); k < i; ++k) {
      const std::optional<english::Measure> measure = english::MeasureAt(tokens(), k);
      if ((text.IsNumber(k) || NumberWord(text.At(k))) && measure && measure->unit == 0) counts_.push_back(k);
    }
    // "Six pews on each side"; two beds on either side are two.
    if (count.said && count.number > 2 && text.BehindPhrase(i + length, "on_each_side")) count.number *= 2;
    const Groups groups = GroupsAround(text, i, length);
    if (groups.count > 0 && groups.in_each > 0 && !(count.said && groups.begin > i))
      count = {groups.count * groups.in_each};
    if (groups.count == 0 && groups.in_each > 0 && groups.begin < i) count.said = false;
    Use(groups.begin, groups.end);
    if (SeatsTheLast(furniture, count, i, length)) return;
    // "Mismatched wooden chairs": those of the tables, which are counted already.
    for (const Wish& wish : facts.wishes) {
      if (count.said || wish.seats == 0 || SeatOf(*wish.furniture, handbook) != &furniture) continue;
      mentions_.push_back({&furniture, i, i + length, wish.count * wish.seats});
      return TakeLooksBefore(*this, furniture, i);
    }
    // "Our three boys want their own desks."
    if (!count.said && count.number > 1 && people_ > 1 && PhraseBefore("of_ones_own", text, i)) count.number = people_;
    constexpr int kMostForEach = 8;
    NamedSet* const set = SetAt(i, facts);
    if (set != nullptr) {
      count = {std::clamp(count.number * set->count, 1, kMostOfAKind)};
      AddOnce(set->pieces, &furniture);
    } else if (count.number <= kMostForEach) {
      const int times = TimesForEach(*this, i, i + length, mentions_, people_);
      count.number = std::clamp(count.number * times, 1, kMostOfAKind);
    }
    if (!count.said) count.number = std::max(count.number, CountAlongWalls(text, furniture, i + length, facts));
    // "Four chairs facing mirrors", "four chairs with mirrors".
    if (const std::size_t end = mentions_.empty() ? 0 : mentions_.back().end; !count.said && end > 0) {
      const bool each = text.BehindPhrase(end, text.At(end) == "with" ? "having" : "facing_it") == text.PhraseBegin(i);
      if (each) count.number = std::max(count.number, mentions_.back().count);
    }
    if (count.said) count.number += MoreBehind(i + length);
    // "Chairs for twelve": one each.
    SeatsSaid seats = SeatsAround(text, i, length);
    if (!count.said && count.number > 1 && IsSeat(furniture) && seats.begin >= i && seats.number > 1)
      count = {std::min(seats.number, kMostOfAKind)};
    Wish wish{&furniture, count.number, 0, count.said, IsOptional(text, used, i, i + length)};
    if (groups.end > 0) wish.in_each = groups.InEach(count.number);
    wish.in_rows = groups.rows;
    wish.noun = nouns_.NounAt(tokens(), i, length);
    if (IsSeat(furniture)) wish.noun = nouns_.NounAt(tokens(), i + length - 1, 1);
    const bool desk = furniture.category() == "desk";
    if (const auto at = PhraseBefore("desks_for_two", text, i); desk && at) seats = {2, *at, *at + 1};
    if ((!furniture.companions().empty() || furniture.category().ends_with("table")) && seats.number > 0) {
      wish.seats = std::min(seats.number, kMostSeats);
      wish.counted = wish.counted && !seats.of_each;
      if (desk && (seats.of_each || seats.number > 1)) wish.size.width_m = kAtADeskM * seats.number;
      Use(seats.begin, seats.end);  // not the room's
    } else if (PlacesOn(furniture) > 0 && !IsSeat(furniture) && furniture.category() != "bed" && seats.number > 0) {
      const double width_m = furniture.width_m().typical();
      wish.size.width_m = std::max(width_m, seats.number * width_m / PlacesOn(furniture));
      Use(seats.begin, seats.end);
    }
    if (wish.seats == 0 && TakesTheLastAsSeats(i, wish)) last_.reset();
    if (count.said && i > 0) TellSizesApart(i, length, wish);
    const bool further = IsFurther(text, i);
    Mentioned(furniture, i, length, count);
    const std::size_t end =
        std::max(i + length, groups.begin < i ? 0 : groups.end);  // "desks in two rows, each with ..."
    last_ = Last{AddWish(wish, further), end, IsSeat(furniture) && length == 1};
    TakeLooksBefore(*this, furniture, i);
    if (const std::optional<std::size_t> at = PhraseBefore("wall_mounted", text, i)) {
      if (furniture.kind() == hb::FURNITURE_KIND_WALL) Use(*at, *text.BehindPhrase(*at, "wall_mounted"));
    }
  }

  // "Twelve mats in three rows and one more up front".
  int MoreBehind(std::size_t end) {
    constexpr std::size_t kMostWords = 8;
    for (std::size_t k = end; k < end + kMostWords && !text.EndsSentence(k) && AnyAt(k) == nullptr; ++k) {
      const std::optional<int> more = text.Says(k, {"and", "plus"}) ? NumberWord(text.At(k + 1)) : std::nullopt;
      if (!more || !text.Says(k + 2, {"more", "extra"}) || AnyAt(k + 3) != nullptr) continue;
      Use(k, k + 3);
      return *more;
    }
    return 0;
  }

  // "a meeting table with six chairs", "two tables and eight chairs", "four desks with two chairs each".
  bool SeatsTheLast(const hb::Furniture& seat, const PieceCount& count, std::size_t i, std::size_t length) {
    if (!last_ || last_->seat || !OnlyWordsBetween(last_->end, i, /*around=*/false)) return false;
    Wish& host = facts.wishes[last_->wish];
    const hb::Furniture* usual = SeatOf(*host.furniture, handbook);
    if (usual == nullptr || host.seats > 0) return false;
    const hb::Noun* noun = nouns_.NounAt(tokens(), i, length);
    const auto is_usual = [&](const hb::NounOption& option) { return option.furniture() == usual->name(); };
    const bool any = length == 1 && (seat.category() == usual->category() ||
                                     (noun != nullptr && std::ranges::any_of(noun->options(), is_usual)));
    if (usual != &seat && !any) return false;
    const bool each = text.At(i + length) == "each";
    Mentioned(*host.furniture, i, length, {host.count});
    mentions_.back().seats = true;
    if (count.said) {
      const bool shared = !each && count.number >= host.count && count.number % host.count == 0;
      host.seats = std::min(shared ? count.number / host.count : count.number, kMostSeats);
    }
    last_.reset();
    return true;
  }

  // "six chairs round a table".
  bool TakesTheLastAsSeats(std::size_t i, Wish& host) {
    if (!last_ || !last_->seat || SeatOf(*host.furniture, handbook) == nullptr) return false;
    if (!OnlyWordsBetween(last_->end, i, /*around=*/true)) return false;
    const Wish seats = facts.wishes[last_->wish];
    // Stools at a table for chairs stay stools.
    if (seats.furniture->category() != SeatOf(*host.furniture, handbook)->category()) return false;
    facts.wishes.erase(facts.wishes.begin() + static_cast<std::ptrdiff_t>(last_->wish));
    if (seats.counted) host.seats = std::min(std::max(1, seats.count / std::max(1, host.count)), kMostSeats);
    return true;
  }

  // "Six tables for two and one big table": as many sit at each of its two sizes.
  void TellSizesApart(std::size_t i, std::size_t length, Wish& wish) {
    constexpr int kAtASmall = 2, kAtAUsual = 4, kAtALarge = 8;
    const std::string& category = wish.furniture->category();
    if (!category.ends_with("table") || SeatOf(*wish.furniture, handbook) == nullptr) return;
    const auto says = [&](const char* list) {
      return text.Is(i - 1, list) ||
             std::ranges::any_of(std::views::iota(i, i + length), [&](std::size_t k) { return text.Is(k, list); });
    };
    const bool large = says("large_pieces");
    const int usual = says("small") ? kAtASmall : kAtAUsual;
    const auto there = std::ranges::find(facts.wishes, wish.furniture, &Wish::furniture);
    if (there == facts.wishes.end()) {
      large_table_ = large && wish.count == 1 ? wish.furniture : nullptr;
      usual_seats_ = usual;
    } else if (large && wish.count == 1 && wish.seats == 0 && there->count > 1) {
      wish.seats = kAtALarge;
      if (there->seats == 0) there->seats = usual_seats_;
    } else if (!large && wish.count > 1 && there->seats == 0 && large_table_ == wish.furniture) {
      there->seats = kAtALarge;
      if (wish.seats == 0) wish.seats = usual;
    }
  }

  std::size_t AddWish(const Wish& wish, bool further) {
    const int most = MostOf(*wish.furniture), count = std::min(wish.count, most);
    if (wish.count > most) AddOnce(facts.too_many, wish.furniture);
    for (std::size_t i = 0; i < facts.wishes.size(); ++i) {
      Wish& there = facts.wishes[i];
      const bool other_size = there.seats > 0 && wish.seats > 0 && there.seats != wish.seats;
      if (there.furniture != wish.furniture || other_size) continue;  // "four tables for four, three for two"
      there.count = further ? std::min(there.count + count, most) : std::max(there.count, count);
      there.optional = there.optional && wish.optional;
      there.counted = there.counted || wish.counted;
      if (there.in_each == 0) there.in_each = wish.in_each, there.in_rows = wish.in_rows;
      there.seats = std::max(there.seats, wish.seats);
      return i;
    }
    facts.wishes.push_back(wish);
    facts.wishes.back().count = count;
    return facts.wishes.size() - 1;
  }

  // Whether tokens [from, to) only say that what follows belongs to what came before.
  bool OnlyWordsBetween(std::size_t from, std::size_t to, bool around) const {
    constexpr std::size_t kMostWords = 8;
    bool joined = false;
    if (to < from || to - from > kMostWords) return false;
    for (std::size_t i = from; i < to; ++i) {
      if (used[i] || (text.IsSign(i) && !text.Says(i + 1, {"each", "every"}))) return false;
      joined = joined || text.Is(i, around ? "around_a_table" : "with_seats");
    }
    return joined;
  }

  const NounBook nouns_;
  const PieceNames& names_;
  std::optional<Last> last_;
  const hb::Furniture* large_table_ = nullptr;  // "one long table", of which there may be others
  int usual_seats_ = 0;                         // at each of the first tables
  int people_ = 0;                              // as far as they are counted
  std::vector<Mention> mentions_;
  std::vector<std::size_t> counts_;                     // tokens
  std::map<std::size_t, const hb::Furniture*> any_at_;  // of a token: what it names, whatever the room
};

}  // namespace

NamedPieces ReadFurniture(const Reading& reading) { return FurnitureReader(reading).Read(); }

}  // namespace flair::language
