// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind the words for an opening and tells of itself.
#include <algorithm>
#include <string>
#include <string_view>

#include "language_worker/handbook/reading/opening_parts.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

namespace {

constexpr double kLarge = 1.5, kSmall = 0.6;

}  // namespace

void Describe(std::string_view word, OpeningWish& wish) {
  if (IsIn("large", word)) {
    wish.width_factor = kLarge;
  } else if (IsIn("small", word)) {
    wish.width_factor = kSmall;
  }
  if (!wish.door) {
    if (IsIn("compass", word) && wish.side.empty()) wish.side = word;
    if (IsOneOf(word, {"clerestory"})) wish.sill_m = 1.9;
    if (word == "bay" || word == "bow" || word == "oriel") {
      wish.kind = std::string(word) + " window";
      wish.width_factor = kLarge;
    }
    if (word == "corner") wish.along.at = AlongWall::At::kEnd;
    return;
  }
  if (IsIn("sliding", word)) wish.swing = v1::DOOR_SWING_SLIDING;
  if (IsIn("folding", word)) {
    wish.swing = v1::DOOR_SWING_SLIDING;
    wish.width_m = wish.width_m.value_or(2.4);
  }
  if (word == "double") wish.width_m = wish.width_m.value_or(1.5);
  if (word == "garage") wish.width_m = wish.width_m.value_or(2.4);
  if (IsIn("open_air", word) || word == "french") {
    wish.outside = true;
    if (word != "balcony") wish.width_m = wish.width_m.value_or(word == "patio" ? 1.8 : 1.5);
    if (word == "patio") wish.swing = v1::DOOR_SWING_SLIDING;
    if (word != "french") wish.leads_to = word;
  } else if (IsIn("inner_rooms", word)) {
    wish.leads_to = std::string(word) + (wish.leads_to.empty() ? "" : " " + wish.leads_to);
  }
}

namespace {

// "to the kitchen", "leading out to the garden", "onto the balcony".
bool TakeLeads(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (words.Says(at, {"that", "which"})) ++at;
  if (words.Is(at, "leading")) ++at;
  if (words.Says(at, {"out", "on", "through"}) && words.Says(at + 1, {"to", "onto", "into"})) ++at;
  if (!words.Is(at, "leads_to")) return false;
  at = words.BehindArticle(at + 1);
  if (words.Is(at, "before_other_rooms")) {
    if (!words.Is(at + 1, "open_air") && !words.Is(at + 1, "inner_rooms") && !words.Is(at + 1, "ways_in") &&
        words.At(at + 1) != "room") {
      return false;
    }
    ++at;
  }
  const std::string_view word = words.At(at);
  const bool open_air = IsIn("open_air", word), inner = IsIn("inner_rooms", word) || word == "room";
  if (!open_air && !inner && !IsIn("ways_in", word)) return false;
  // "a door to the side wall" is none that leads to a side.
  if (IsIn("sides_of_a_house", word)) return false;
  std::size_t end = at + 1;
  if (words.IsHyphen(end)) ++end;
  if (words.Is(end, "room_endings")) ++end;
  if (open_air) {
    wish.outside = true;
    if (word != "balcony") wish.width_m = wish.width_m.value_or(wish.count == 1 ? 0.9 : 1.5);
  }
  if (open_air || inner) wish.leads_to = words.Quote(at, end);
  i = end;
  return true;
}

// "1.2 m wide", "of 1.2 m x 1.5 m", "(90 cm)", "with a sill at 1.1 m".
bool TakeLengths(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (words.At(at) == ",") ++at;
  const bool bracket = words.At(at) == "(";
  if (bracket) ++at;
  bool sill = false;
  for (int over = 0; over < 6 && words.Is(at, "before_opening_sizes"); ++over) {
    sill = sill || words.At(at) == "sill";
    if (sill && words.Says(at, {"low", "high"})) return false;
    ++at;
  }
  std::size_t end = 0;
  const std::optional<double> first = words.LengthAt(at, end);
  if (!first || *first <= 0) return false;
  if (words.Says(end, {"from", "off"}) || words.At(end) == "away" || words.Says(end, {"to", "left", "right"}))
    return false;
  if (sill || words.BehindPhrase(end, "above_the_floor")) {
    wish.sill_m = *first;
    i = sill ? end : end + 3;
    return true;
  }
  if (words.Says(end, {"high", "tall"})) {
    wish.height_m = *first;
  } else {
    wish.width_m = *first;
  }
  at = words.Is(end, "opening_dimensions") ? end + 1 : end;
  if (words.Says(at, {"x", "by", "and"})) {
    const std::optional<double> second = words.LengthAt(at + 1, end);
    if (second && *second > 0) {
      wish.height_m = *second;
      at = words.Says(end, {"high", "tall"}) ? end + 1 : end;
    }
  }
  if (bracket && words.At(at) == ")") ++at;
  i = at;
  return true;
}

// "opening outwards", "that swings into the room", "reaching the floor".
bool TakeSwing(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  for (int over = 0; over < 3 && words.Is(at, "before_swings"); ++over) ++at;
  if (wish.door) {
    if (!words.Is(at, "swinging")) return false;
    const auto out = words.BehindPhrase(at + 1, "outwards");
    const auto in = words.BehindPhrase(at + 1, "inwards");
    if (!out && !in) return false;
    if (words.Says(out.value_or(*in), {"to", "onto", "the"})) return false;
    wish.swing = out ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
    i = out.value_or(in.value_or(at));
    return true;
  }
  const auto full = words.BehindPhrase(at, "floor_to_ceiling");
  if (!full) return false;
  wish.sill_m = 0;
  wish.to_ceiling = words.Quote(at, *full).find("ceiling") != std::string::npos;
  i = *full;
  return true;
}

}  // namespace

std::size_t ReadMeasures(const BriefText& words, std::size_t i, OpeningWish& wish) {
  constexpr int kMostParts = 4;
  for (int part = 0; part < kMostParts; ++part) {
    if (!(wish.door && TakeLeads(words, i, wish)) && !TakeLengths(words, i, wish) && !TakeSwing(words, i, wish)) break;
  }
  return i;
}

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
