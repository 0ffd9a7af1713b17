// SPDX-License-Identifier: GPL-3.0-or-later
// The words for one opening or several: number, kind, names and what is said of them before and behind.
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

constexpr int kMostOpenings = 40;
constexpr double kLarge = 1.5, kSmall = 0.6;
constexpr double kWholeWallM = 100;  // "a wall of windows": cut to the wall

// A measure that words for an opening stand for where no number tells it.
struct Trait {
  const char* words;  // a list
  bool door;
  std::optional<double> OpeningWish::*measure;
  double value_m;
};
constexpr std::array kTraits = std::to_array<Trait>({
    {"high_windows", false, &OpeningWish::sill_m, 1.6},
    {"clerestory_windows", false, &OpeningWish::sill_m, 1.9},
    {"low_windows", false, &OpeningWish::sill_m, 0.4},
    {"tall_windows", false, &OpeningWish::height_m, 2.0},
    {"shop_windows", false, &OpeningWish::width_m, 2.0},
    {"very_wide_doors", true, &OpeningWish::width_m, 2.4},
    {"portholes", false, &OpeningWish::width_m, 0.4},
    {"portholes", false, &OpeningWish::height_m, 0.4},
    {"portholes", false, &OpeningWish::sill_m, 1.3},
    {"patio_doors", true, &OpeningWish::width_m, 1.8},
    {"wide_doors", true, &OpeningWish::width_m, 1.5},
});

// Takes what one word before a door or window says of it: "large", "sliding", "bay", "north". `wish.door` must be set.
void Describe(std::string_view word, OpeningWish& wish) {
  for (const Trait& trait : kTraits) {
    std::optional<double>& measure = wish.*trait.measure;
    if (trait.door == wish.door && IsIn(trait.words, word)) measure = measure.value_or(trait.value_m);
  }
  if (IsIn("large", word)) wish.width_factor = kLarge;
  if (IsIn("small", word)) wish.width_factor = kSmall;
  if (IsIn("end_walls", word)) wish.side = "short";
  if (wish.side.empty() && IsIn(wish.door ? "compass" : "sides_of_windows", word)) wish.side = word;
  if (!wish.door) {
    if (word == "corner") wish.along.at = AlongWall::At::kEnd;
    if (!IsIn("windows_built_out", word)) return;
    wish.kind = std::string(word) + " window";
    wish.width_factor = kLarge;
    return;
  }
  if (IsIn("sliding", word)) wish.swing = v1::DOOR_SWING_SLIDING;
  if (word == "open") wish.swing = v1::DOOR_SWING_NONE;
  wish.outside = wish.outside || IsIn("open_air", word) || word == "french";
  if (IsIn("ways_in", word)) wish.name = word;
  if (IsIn("open_air", word)) wish.leads_to = word;
  const bool inner = IsIn("inner_rooms", word) || (IsIn("room_endings", word) && wish.leads_to.empty()) ||
                     word.ends_with("room") || wish.leads_to == "room";
  if (inner) wish.leads_to = std::string(word) + (wish.leads_to.empty() ? "" : " ") + wish.leads_to;
}

class NounReader {
 public:
  NounReader(const BriefText& words, const std::vector<bool>& things, std::size_t noun)
      : words_(words), things_(things), noun_(noun) {
    found_.begin = noun;
    found_.end = noun + 1;
  }

  OpeningNoun Read() {
    const std::string_view head = words_.At(noun_);
    const bool window = IsIn("windows", head), glass = IsIn("glazing", head);
    const bool overhead = IsIn("skylights", head) || (window && words_.At(noun_ - 1) == "roof");
    // "A full glass front": of the room the wall where one comes in.
    const bool front = IsIn("glazed", head) && words_.Is(noun_ + 1, "house_fronts");
    if (things_[noun_] || !(overhead || window || glass || front || IsIn("doors", head))) return {};
    const bool stage = words_.Is(noun_ + 1, "stages") && words_.Is(noun_ + 2, "sides_from_the_door");
    if (noun_ + 1 < words_.size() && !stage && (things_[noun_ + 1] || words_.Is(noun_ + 1, "not_openings"))) return {};
    if (noun_ > 0 && words_.Is(noun_ - 1, "doors_of_other_kinds")) return {};
    found_.kind = overhead ? OpeningNoun::Kind::kOverhead : OpeningNoun::Kind::kOpening;
    found_.plural = head.ends_with('s') && !glass;
    found_.glass = glass;
    OpeningWish& wish = found_.wish;
    // French windows are doors.
    wish.door = !(window || glass || front) || words_.At(noun_ - 1) == "french";
    if (glass || front) wish.width_m = kWholeWallM;
    found_.bare = !ReadBack();
    ReadDenial();
    if (front) {
      ++found_.end;
      found_.wish.sill_m = found_.wish.sill_m.value_or(0);
    }
    if ((front || IsIn("house_fronts", head)) && wish.side.empty()) wish.side = "near";
    if (IsOfAPiece(front)) {
      found_.kind = OpeningNoun::Kind::kOfAPiece;
      return found_;
    }
    const std::size_t before = words_.At(found_.begin - 1) == "all" ? found_.begin - 1 : found_.begin;
    found_.related = before > 0 && words_.Is(before - 1, "relating");
    // A hatch to the kitchen is no door, nor an arch.
    if (IsIn("open_passages", head) || (IsIn("hatches", head) && !wish.leads_to.empty()))
      wish.swing = v1::DOOR_SWING_NONE;
    if (IsIn("portholes", head)) {
      Describe(head, wish);
      wish.kind = "porthole";
    }
    SetCount();
    return found_;
  }

 private:
  // Over what describes the opening, back to its article or number, if there is one.
  bool ReadBack() {
    constexpr std::size_t kMostBack = 10;
    std::size_t& at = found_.begin;
    for (std::size_t steps = 0; at > 0 && steps < kMostBack; ++steps) {
      const std::string_view word = words_.At(at - 1);
      if (TakeMeasure() || TakeFloorToCeiling()) continue;
      if (TakeNearlyAll()) return true;
      if (word == "of" && TakeQuantity()) return true;
      const bool told =
          IsIn("inner_rooms", word) || IsIn("shop_windows", word) || IsIn("ways_in", word) || IsIn("swinging", word);
      // "The slaves' entrance".
      const bool owner = words_.Says(at - 1, {"'", "'s"}) && at < noun_ + 1 && at > 1 && words_.IsWord(at - 2);
      if ((words_.IsSign(at - 1) && !owner) || (things_[at - 1] && !told)) return false;
      found_.part = found_.part || word == "one" || IsIn("one_of_several", word);
      found_.further = found_.further || IsIn("further_ones", word);
      if (TakeDeterminer()) return true;
      const bool aspect = word == "facing" && at > 1 && words_.Is(at - 2, "compass");
      const bool side = at == noun_ && !found_.wish.door && IsIn("sides_of_windows", word);
      if (!aspect && !side && (IsIn("relating", word) || IsIn("opening_stops", word))) return false;
      if (IsIn("one_of_several", word)) {
        found_.wish.count = 1;
        found_.wish.counted = true;
      }
      double_ = double_ || IsIn("two_leaves", word);
      full_height_ += IsIn("full_height", word) ? 1 : 0;
      Describe(word, found_.wish);
      --at;
    }
    return false;
  }

  // "no", "each", "the two", "three", "several" before the words read so far.
  bool TakeDeterminer() {
    std::size_t& at = found_.begin;
    OpeningWish& wish = found_.wish;
    const std::string_view word = words_.At(at - 1);
    const std::optional<int> number = OpeningCountAt(words_, at - 1);
    found_.none = word == "no" || word == "without" || word == "zero";
    found_.any = IsIn("any_of_them", word);
    wish.definite = IsIn("definite", word);
    if (number) {
      wish.count = *number;
      wish.counted = true;
      if (at > 1 && words_.Is(at - 2, "definite")) {
        wish.definite = true;
        --at;
      }
    } else if (IsIn("several", word)) {
      wish.count = 3;
    } else if (!found_.none && !found_.any && !wish.definite) {
      return false;
    }
    --at;
    return true;
  }

  // "a pair of windows", "a set of patio doors", "a wall of windows", "lots of windows".
  bool TakeQuantity() {
    std::size_t& at = found_.begin;
    if (at < 2) return false;
    const std::string_view word = words_.At(at - 2);
    OpeningWish& wish = found_.wish;
    const bool wall = word == "wall" && !wish.door;
    if (IsIn("two_leaves", word)) {
      double_ = wish.door;
      wish.count = word == "pair" && !wish.door ? 2 : 1;
    } else if (IsIn("rows_of", word)) {
      wish.count = 3;
    } else if (wall || word == "couple") {
      wish.count = wall ? 1 : 2;
      if (wall) wish.width_m = kWholeWallM;
    } else {
      return false;
    }
    wish.counted = true;
    at -= at > 2 && words_.Is(at - 3, "whole") ? 3 : 2;
    return true;
  }

  // "1.2 m", "1.2 m wide", "1.2 m x 1.5 m", "1.2 x 1.5 m" before the words read so far.
  bool TakeMeasure() {
    std::size_t& at = found_.begin;
    OpeningWish& wish = found_.wish;
    for (std::size_t length = 2; length <= std::min<std::size_t>(at, 4); ++length) {
      std::size_t end = 0;
      const std::optional<double> metres = words_.LengthAt(at - length, end);
      if (!metres || end != at) continue;
      const bool second = at > length + 1 && words_.Says(at - length - 1, {"x", "by"});
      if (second || words_.Is(at, "heights")) {
        wish.height_m = metres;
        wish.sill_m.reset();  // "1.5 m high" is not high in the wall
      } else {
        wish.width_m = metres;
      }
      wish.width_factor = 1;
      at -= length;
      if (second && words_.IsNumber(at - 2)) {
        // Of both numbers only the last may have a unit.
        wish.width_m = words_.NumberAt(at - 2) * *metres / words_.NumberAt(at);
        at -= 2;
      } else if (second) {
        --at;
      }
      return true;
    }
    return false;
  }

  // "The short wall is nearly all window."
  bool TakeNearlyAll() {
    std::size_t& at = found_.begin;
    if (found_.wish.door || found_.plural) return false;
    for (std::size_t length = std::min<std::size_t>(at, 3); length > 0; --length) {
      if (words_.BehindPhrase(at - length, "nearly_all") != at) continue;
      found_.wish.width_m = kWholeWallM;
      found_.wish.counted = found_.whole_wall = true;
      at -= length;
      return true;
    }
    return false;
  }

  bool TakeFloorToCeiling() {
    constexpr std::size_t kWords = 3;
    std::size_t& at = found_.begin;
    if (at < kWords || words_.BehindPhrase(at - kWords, "floor_to_ceiling") != at) return false;
    full_height_ = 2;
    at -= kWords;
    return true;
  }

  // "without a window", "does not have any windows".
  void ReadDenial() {
    std::size_t before = found_.begin;
    if (before > 1 && words_.Is(before - 1, "have")) --before;
    if (before == 0) return;
    const bool without = before == found_.begin && words_.At(before - 1) == "without";
    if (!without && !(before < found_.begin && words_.At(before - 1) == "not")) return;
    found_.none = true;
    found_.any = false;
    found_.begin = before - 1;
  }

  // "a wardrobe with two sliding doors", "a wardrobe without doors", "a cabinet with a glass front".
  bool IsOfAPiece(bool front) {
    const std::size_t at = found_.begin;
    if (!(found_.wish.door || front) || at == 0) return false;
    // "The wardrobe doors", where it has a wardrobe.
    for (std::size_t k = 0; k < words_.size() && found_.plural; ++k) {
      if (things_[k] && words_.At(k) == words_.At(noun_ - 1) && !words_.Is(k, "materials")) return true;
    }
    if (found_.none) return things_[at - 1];
    const bool had = at > 1 && words_.Is(at - 1, "of_a_cupboard") && things_[at - 2] && !found_.wish.definite;
    if (had) --found_.begin;
    return had;
  }

  void SetCount() {
    OpeningWish& wish = found_.wish;
    if (!wish.door && full_height_ >= 2) {
      wish.sill_m = 0;
      wish.to_ceiling = true;
    }
    const bool leaves = wish.width_m || wish.swing != v1::DOOR_SWING_UNSPECIFIED || wish.outside || double_;
    // "Sliding glass doors" are to the open air, unless they lead elsewhere.
    wish.outside = wish.outside || (double_ && found_.plural && wish.swing == v1::DOOR_SWING_SLIDING);
    if (wish.door && found_.plural && (!wish.counted || double_) && leaves) {
      wish.count = 1;
      wish.counted = true;
      wish.width_m = wish.width_m.value_or(kPairOfLeavesM);
    } else if (found_.plural && !wish.counted) {
      wish.count = std::max(wish.count, 2);
    }
  }

  const BriefText& words_;
  const std::vector<bool>& things_;
  const std::size_t noun_;
  OpeningNoun found_;
  bool double_ = false;  // its plural is a pair of leaves
  int full_height_ = 0;  // words for "floor to ceiling"
};

}  // namespace

std::optional<int> OpeningCountAt(const BriefText& words, std::size_t i) {
  if (!words.IsNumber(i)) {
    const std::optional<int> named = NumberWord(words.At(i));
    return named ? std::optional<int>(std::min(*named, kMostOpenings)) : std::nullopt;
  }
  const double number = words.NumberAt(i);
  if (number != static_cast<int>(std::min(number, 100.0)) || number < 1) return std::nullopt;
  return std::min(static_cast<int>(number), kMostOpenings);
}

OpeningNoun OpeningNounAt(const BriefText& words, const std::vector<bool>& things, std::size_t i) {
  return NounReader(words, things, i).Read();
}

}  // namespace flair::language
