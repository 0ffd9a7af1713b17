// SPDX-License-Identifier: GPL-3.0-or-later
// The words for one opening or several: number, kind, names and what is said of them before and behind.
#include <algorithm>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/opening_parts.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

namespace {

constexpr int kMostOpenings = 40;

class NounReader {
 public:
  NounReader(const BriefText& words, const std::vector<bool>& things, std::size_t noun)
      : words_(words), things_(things) {
    found_.noun = found_.begin = noun;
    found_.end = noun + 1;
  }

  OpeningNoun Read() {
    const std::size_t noun = found_.noun;
    const std::string_view head = words_.At(noun);
    const bool door = IsIn("doors", head), window = IsIn("windows", head);
    const bool overhead = IsIn("skylights", head) || (window && words_.At(noun - 1) == "roof");
    if (things_[noun] || !(door || window || overhead)) return {};
    const std::size_t behind = words_.IsHyphen(noun + 1) ? noun + 2 : noun + 1;
    if (behind < words_.size() && (things_[behind] || words_.Is(behind, "not_openings"))) return {};
    if (noun > 0 && words_.Is(noun - 1, "doors_of_other_kinds")) return {};
    OpeningWish& wish = found_.wish;
    wish.door = door;
    ReadBack();
    // French windows are doors.
    if (window && wish_french_) {
      wish.door = true;
      Describe("french", wish);
    }
    if (found_.kind == OpeningNoun::Kind::kNone) return {};
    if (overhead) found_.kind = OpeningNoun::Kind::kOverhead;
    if (head == "archway") wish.swing = v1::DOOR_SWING_NONE;
    if (head.starts_with("porthole")) wish = Porthole(wish);
    SetMeasures();
    const bool plural = head.ends_with('s');
    const bool one_pair =
        wish.door && plural && (!wish.counted || pair_) &&
        (wish.width_m || wish.swing != v1::DOOR_SWING_UNSPECIFIED || wish.outside || glazed_ || pair_);
    if (one_pair) {
      wish.count = 1;
      wish.counted = true;
      wish.width_m = wish.width_m.value_or(1.5);
    } else if (plural && !wish.counted) {
      wish.count = 2;
    }
    return found_;
  }

 private:
  static OpeningWish Porthole(OpeningWish wish) {
    wish.kind = "porthole";
    wish.width_m = 0.4;
    wish.height_m = 0.4;
    wish.sill_m = 1.3;
    return wish;
  }

  // Over what describes the opening, back to its article or number.
  void ReadBack() {
    constexpr std::size_t kMostBack = 10;
    found_.kind = OpeningNoun::Kind::kOpening;
    found_.bare = true;
    OpeningWish& wish = found_.wish;
    std::size_t at = found_.noun;
    for (std::size_t steps = 0; at > 0 && steps < kMostBack; ++steps) {
      const std::size_t before = at - 1;
      const std::string_view word = words_.At(before);
      if (words_.IsHyphen(before)) {
        at = before;
        continue;
      }
      if (TakeMeasureBefore(at)) continue;
      if (words_.At(before) == "of" && before > 0 && TakeQuantity(before)) return Determined(found_.begin);
      if (words_.IsSign(before) || (things_[before] && !IsIn("inner_rooms", word))) break;
      if (word == "no" || word == "without" || (word == "any" && before > 0 && words_.At(before - 1) == "without") ||
          word == "zero") {
        found_.none = true;
        return Determined(word == "any" ? before - 1 : before);
      }
      if (word == "one" || IsIn("one_of_several", word)) found_.part = true;
      if (IsIn("any_of_them", word)) {
        found_.any = true;
        return Determined(before);
      }
      if (word == "only" || word == "single" || word == "just") {
        wish.counted = wish.counted || word == "single";
        at = before;
        continue;
      }
      if (IsIn("definite", word)) {
        wish.definite = true;
        if (word == "both") {
          wish.count = 2;
          wish.counted = true;
        }
        return Determined(before);
      }
      if (const std::optional<int> number = NumberAt(before)) {
        wish.count = *number;
        wish.counted = true;
        // "the two windows"
        if (before > 0 && words_.Is(before - 1, "definite")) {
          wish.definite = true;
          return Determined(before - 1);
        }
        return Determined(before);
      }
      if (IsIn("several", word)) {
        wish.count = 3;
        return Determined(before);
      }
      // "a south-facing window"
      if (word == "facing" && TakeAspect(before)) {
        at = before;
        continue;
      }
      if (IsIn("relating", word) || IsIn("opening_stops", word)) {
        if (!(word == "to" && TakeFloorToCeiling(at))) break;
        continue;
      }
      Word(word);
      at = before;
    }
    found_.begin = at;
    Relate();
  }

  void Determined(std::size_t begin) {
    found_.bare = false;
    found_.begin = begin;
    if (begin > 0 && words_.At(begin - 1) == "only") found_.begin = begin - 1;
    Relate();
  }

  void Relate() {
    std::size_t at = found_.begin;
    TakeDenial(at);
    if (at > 0 && words_.At(at - 1) == "all") --at;
    found_.related = at > 0 && words_.Is(at - 1, "relating") && !IsOfACupboard(at);
    if (IsOfACupboard(at)) found_.kind = OpeningNoun::Kind::kNone;
  }

  // "without a window", "does not have any windows".
  void TakeDenial(std::size_t& at) {
    std::size_t before = at;
    if (before > 1 && words_.Is(before - 1, "have")) --before;
    if (before == 0) return;
    const bool without = before == at && words_.At(before - 1) == "without";
    const bool has_not = before < at && (words_.At(before - 1) == "not" || words_.At(before - 1) == "t");
    if (!without && !has_not) return;
    found_.none = true;
    found_.any = false;
    at = found_.begin = before - 1;
  }

  // "a wardrobe with two sliding doors".
  bool IsOfACupboard(std::size_t at) const {
    if (!found_.wish.door || at < 2) return false;
    return words_.Is(at - 1, "of_a_cupboard") && things_[at - 2];
  }

  void Word(std::string_view word) {
    if (word == "french") wish_french_ = true;
    if (IsOneOf(word, {"glass", "glazed"})) glazed_ = true;
    if (IsOneOf(word, {"ceiling"})) ceiling_ = true;
    if (IsIn("full_height", word) && !found_.wish.door) ++full_;
    if (word == "high" && !measured_) high_ = true;
    if (word == "low" && !measured_) low_ = true;
    if (word == "tall" && !measured_) tall_ = true;
    if (word == "open" && found_.wish.door) found_.wish.swing = v1::DOOR_SWING_NONE;
    if (IsIn("one_of_several", word)) {
      found_.wish.count = 1;
      found_.wish.counted = true;
    }
    Describe(word, found_.wish);
  }

  // "1.2 m" before a token, perhaps with "wide" behind it: the last one said comes first.
  bool TakeMeasureBefore(std::size_t& at) {
    for (const std::size_t length : {2u, 3u}) {
      if (at < length) continue;
      std::size_t end = 0;
      const std::optional<double> metres = words_.LengthAt(at - length, end);
      if (!metres || end != at) continue;
      measured_ = true;
      measures_.push_back({*metres, std::string(words_.At(at))});
      at -= length;
      // "1.2 m x 1.5 m", "1.2 x 1.5 m".
      if (at >= 2 && words_.Says(at - 1, {"x", "by"})) {
        --at;
        measures_.back().dimension = "high";
        if (words_.IsNumber(at - 1)) {
          const double number = words_.NumberAt(at - 1);
          measures_.push_back({number * (*metres / words_.NumberAt(at + 1)), "wide"});
          --at;
        }
      }
      return true;
    }
    return false;
  }

  // "a pair of windows", "a set of patio doors", "a wall of windows", "lots of windows".
  bool TakeQuantity(std::size_t of) {
    const std::string_view word = words_.At(of - 1);
    OpeningWish& wish = found_.wish;
    std::size_t begin = of - 1;
    if (IsOneOf(word, {"pair", "set"})) {
      pair_ = found_.wish.door;
      wish.count = word == "pair" && !wish.door ? 2 : 1;
    } else if (IsOneOf(word, {"couple"})) {
      wish.count = 2;
    } else if (IsIn("rows_of", word)) {
      wish.count = 3;
    } else if (IsOneOf(word, {"wall"}) && !wish.door) {
      wish.count = 1;
      wish.width_m = 100;
    } else {
      return false;
    }
    wish.counted = true;
    if (begin > 0 && words_.Is(begin - 1, "whole")) --begin;
    found_.begin = begin;
    return true;
  }

  bool TakeAspect(std::size_t facing) {
    std::size_t at = facing;
    if (at > 0 && words_.IsHyphen(at - 1)) --at;
    return at > 0 && words_.Is(at - 1, "compass");
  }

  // "floor to ceiling windows"
  bool TakeFloorToCeiling(std::size_t& at) {
    if (at < 2 || words_.At(at - 1) != "to") return false;
    std::size_t floor = at - 2;
    if (words_.IsHyphen(floor) && floor > 0) --floor;
    if (words_.At(floor) != "floor" || !ceiling_) return false;
    full_ = 2;
    at = floor;
    return true;
  }

  std::optional<int> NumberAt(std::size_t i) const {
    if (words_.IsNumber(i)) {
      const double number = words_.NumberAt(i);
      if (number != static_cast<int>(std::min(number, 100.0)) || number < 1) return std::nullopt;
      return std::min(static_cast<int>(number), kMostOpenings);
    }
    const std::optional<int> named = NumberWord(words_.At(i));
    return named ? std::optional<int>(std::min(*named, kMostOpenings)) : std::nullopt;
  }

  void SetMeasures() {
    OpeningWish& wish = found_.wish;
    for (const Measured& one : measures_) {
      const bool high = IsOneOf(one.dimension, {"high", "tall", "height"});
      if (high) {
        wish.height_m = one.metres;
      } else {
        wish.width_m = one.metres;
      }
    }
    // "1.2 m wide" is not wide.
    if (wish.width_m) wish.width_factor = 1;
    if (!wish.door && full_ >= 2) {
      wish.sill_m = 0;
      wish.to_ceiling = ceiling_ || full_ >= 2;
    }
    if (!wish.door && high_) wish.sill_m = 1.6;
    if (!wish.door && low_) wish.sill_m = 0.4;
    if (!wish.door && tall_ && !wish.sill_m) {
      wish.sill_m = 0.4;
      wish.height_m = wish.height_m.value_or(2.0);
    }
  }

  struct Measured {
    double metres = 0;
    std::string dimension;  // the word behind it
  };

  const BriefText& words_;
  const std::vector<bool>& things_;
  OpeningNoun found_;
  std::vector<Measured> measures_;
  bool wish_french_ = false, glazed_ = false, ceiling_ = false, high_ = false, low_ = false, tall_ = false;
  bool measured_ = false, pair_ = false;
  int full_ = 0;
};

}  // namespace

OpeningNoun OpeningNounAt(const BriefText& words, const std::vector<bool>& things, std::size_t i) {
  const std::string_view word = words.At(i);
  if (!IsIn("doors", word) && !IsIn("windows", word) && !IsIn("skylights", word)) return {};
  return NounReader(words, things, i).Read();
}

}  // namespace flair::language
