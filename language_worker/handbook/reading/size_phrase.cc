// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/size_phrase.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "english/language.h"
#include "english/quantities.h"
#include "english/words.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/size_owner.h"
#include "language_worker/handbook/reading/vocabulary.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

constexpr double kFootM = 0.3048;

// Metres of a number that stands without a unit: people write metres up to 20, then feet, centimetres, millimetres.
double GuessUnit(double value) {
  if (value <= 20) return 1;
  if (value <= 60) return kFootM;
  return value < 1000 ? 0.01 : 0.001;
}

// Width and depth as found in the text.
struct SidePair {
  double width_m = 0;
  double depth_m = 0;
  std::size_t end = 0;  // first token after them
};

// A measure with a sign before it taken as part of it; its unit may come later ("4 x 5 m").
std::optional<english::Measure> MeasureAt(const BriefText& text, std::size_t i) {
  const bool article = text.Is(i, "articles");
  std::optional<english::Measure> measure = article ? std::nullopt : english::MeasureAt(text.tokens(), i);
  const bool minus = i > 0 && i < text.size() && text.At(i - 1) == "-" && text.tokens()[i].glued &&
                     !(i > 1 && text.tokens()[i - 1].glued);
  if (measure && minus) measure->value *= -1;
  return measure;
}

// A side as people say it: "two forty" is 2.4 m.
std::optional<english::Measure> SideAt(const BriefText& text, std::size_t i) {
  constexpr double kMostM = 20, kLeastRest = 10, kMetre = 100;
  const std::optional<english::Measure> side = MeasureAt(text, i);
  const bool spoken = side && side->unit == 0 && text.IsWord(i) && side->value >= 1 && side->value < kMostM;
  const auto rest = spoken ? english::NumberAt(text.tokens(), side->end) : std::nullopt;
  if (!rest || rest->value < kLeastRest || rest->value >= kMetre || side->value != std::floor(side->value)) return side;
  return english::Measure{side->value + rest->value / kMetre, 1, rest->end};
}

// "4m x 5m" and "8m long, 4m wide" from token i on.
std::optional<SidePair> PairAt(const BriefText& text, std::size_t i) {
  const std::optional<english::Measure> first = SideAt(text, i);
  if (!first) return std::nullopt;
  std::size_t next = first->end;
  const bool swapped = text.At(next) == "long";
  if (swapped || text.At(next) == "wide") {
    ++next;
    while (text.Says(next, {",", "and", "by", "x"})) ++next;
  } else if (text.Says(next, {"x", "by", "*"})) {
    ++next;
  } else {
    return std::nullopt;
  }
  if (text.At(next) == "-") ++next;
  const std::optional<english::Measure> second = SideAt(text, next);
  // "Desks 1.4 m wide, two chairs".
  const bool another = text.Says(first->end, {"long", "wide"}) && second && second->unit == 0 && first->unit > 0;
  if (!second || (another && text.IsWord(second->end) && !text.Is(second->end, "dimensions"))) return std::nullopt;
  const double guessed = GuessUnit(std::max(first->value, second->value));
  const double unit = second->unit > 0 ? second->unit : first->unit > 0 ? first->unit : guessed;
  const auto metres = [&](const english::Measure& one) { return one.unit > 0 ? one.value : one.value * unit; };
  SidePair sides{metres(*first), metres(*second), second->end};
  if (swapped) std::swap(sides.width_m, sides.depth_m);
  return sides;
}

constexpr double kLowestM = 1.7;  // ceiling, of a ship's cabin

// A little less than the metre at which the narrowest is drawn.
bool IsASide(double metres) { return metres >= 0.7 && metres <= 100; }

class SizeReader {
 public:
  SizeReader(const std::vector<Token>& tokens, const Handbook& handbook, std::vector<bool>& used)
      : text_(tokens), handbook_(handbook), used_(used), owner_(text_, handbook.vocabulary()) {}

  SizeRequest Read() {
    // Sides that no room has are another's, or no sides, where others are written.
    std::optional<std::pair<std::size_t, SidePair>> odd;
    ReadLeg();
    for (std::size_t i = 0; i < text_.size() && !size_.in_numbers(); ++i) {
      if (used_[i]) continue;  // of its leg
      if (const std::optional<SidePair> sides = PairAt(text_, i)) {
        // There is one room: "140 x 70 cm each" is said of pieces, "2 by 2 m of bare floor" of a part of it.
        const double shorter_m = std::min(sides->width_m, sides->depth_m);
        if (owner_.IsOfAThing(i, sides->end) || owner_.IsRightBehindAThing(i, shorter_m) ||
            text_.Says(sides->end, {"each", "apiece"}) || IsSaidOfEach(i) || IsOfFreeFloor(sides->end)) {
          i = sides->end - 1;
          continue;
        }
        if (!odd && !(IsASide(sides->width_m) && IsASide(sides->depth_m))) {
          odd = {i, *sides};
          i = sides->end - 1;
          continue;
        }
        TakeSides(i, *sides);
      } else if (const auto area = english::MeasureAt(text_.tokens(), i, english::v1::Unit::KIND_AREA);
                 area && area->unit > 0 && !owner_.IsOfAThing(i, area->end) && !IsOfFreeFloor(area->end)) {
        size_.area_m2 = area->value;
        Mark(i, area->end, used_);
      }
    }
    if (odd && !size_.in_numbers()) TakeSides(odd->first, odd->second);
    const bool sides_known = size_.in_numbers();
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const SizeRequest single = SingleAt(i);
      if (single.height_m || ((single.width_m || single.depth_m) && !sides_known))
        Mark(i, MeasureAt(text_, i)->end + 1, used_);
      if (single.height_m && !size_.height_m) size_.height_m = single.height_m;
      if (sides_known) continue;
      if (single.width_m && !size_.width_m) size_.width_m = single.width_m;
      if (single.depth_m && !size_.depth_m) size_.depth_m = single.depth_m;
    }
    ReadSizeWords();
    return size_;
  }

 private:
  void TakeSides(std::size_t begin, const SidePair& sides) {
    size_.width_m = sides.width_m;
    size_.depth_m = sides.depth_m;
    Mark(begin, sides.end, used_);
  }

  // "The leg that sticks out on the north east is 2.5 by 2.5", "a 1.5 x 0.8 m alcove in the north wall": with the sides
  // that stand right before the word, or behind it in its sentence.
  void ReadLeg() {
    constexpr std::size_t kBack = 6, kReach = 14;
    const bool is_l = Phrase("l shaped").Occurs(text_.tokens()) || Phrase("l shape").Occurs(text_.tokens());
    for (std::size_t i = 0; i < text_.size() && !size_.leg; ++i) {
      const bool recess = text_.BehindPhrase(i, "recesses").has_value();
      if (!recess && !(is_l && text_.BehindPhrase(i, "legs_of_rooms"))) continue;
      RoomLeg leg{.of_an_l = !recess};
      std::optional<SidePair> sides;
      std::size_t begin = i, k = i - std::min(i, kBack);
      for (; k < i + kReach && !(k > i && text_.EndsSentence(k)); ++k) {
        if (k > i && text_.Is(k, "compass")) (leg.wall.empty() ? leg.wall : leg.end) = text_.At(k);
        const auto pair = sides ? std::nullopt : PairAt(text_, k);
        if (!pair || (k < i && pair->end != i)) continue;
        sides = pair;
        begin = std::min(begin, k);
        k = std::max(k, pair->end - 1);
      }
      if (!sides || (recess && leg.wall.empty())) continue;
      // An alcove's width is along its wall.
      const bool along_y = recess && (IsIn("eastern_walls", leg.wall) || IsIn("western_walls", leg.wall));
      leg.width_m = along_y ? sides->depth_m : sides->width_m;
      leg.depth_m = along_y ? sides->width_m : sides->depth_m;
      size_.leg = leg;
      Mark(begin, k, used_);
    }
  }

  // "2 by 2 m of bare floor"; "6 by 5 m, open to the hall" is the room.
  bool IsOfFreeFloor(std::size_t end) const { return !text_.IsSign(end) && text_.Is(end + 1, "free_floors"); }

  // "Six desks, each 1.6 x 0.8 m".
  bool IsSaidOfEach(std::size_t i) const {
    while (i > 0 && text_.Is(i - 1, "size_links")) --i;
    return i > 0 && text_.Is(i - 1, "each_words");
  }

  // "height 2.4 m", "room height: 2.4 m", "a ceiling of 2.4 m", "the ceiling is at 2.4 m". The height of a shelf is
  // none of the room.
  bool IsHeightBefore(std::size_t i) const {
    constexpr std::size_t kMostBetween = 4;
    for (std::size_t back = 1; back <= kMostBetween && back <= i; ++back) {
      if (text_.Says(i - back, {"ceiling", "ceilings"})) return true;
      if (text_.At(i - back) == "height") return i == back || text_.Is(i - back - 1, "before_heights");
      if (!text_.Is(i - back, "height_links")) return false;
    }
    return false;
  }

  // "Width 4.2 m", "length: 5 m"; not "door width 0.9 m".
  bool IsBehindSide(std::size_t i, std::string_view side) const {
    while (i > 0 && text_.Says(i - 1, {":", "of", "is", "="})) --i;
    return i > 0 && text_.At(i - 1) == side && (i == 1 || !text_.IsWord(i - 2) || text_.Is(i - 2, "before_sides"));
  }

  // A single length with what it belongs to: "5 m square", "12-foot room", "6 m long", "2.7m ceiling".
  SizeRequest SingleAt(std::size_t i) const {
    SizeRequest size;
    const std::optional<english::Measure> measure = MeasureAt(text_, i);
    if (!measure || measure->unit == 0) return size;
    const std::size_t end = measure->end;
    // "75 cm deep" is a shelf against three walls, never a room.
    constexpr double kLeastSideM = 1;
    if (measure->value < kLeastSideM) return size;
    const bool ceiling = text_.Says(end, {"ceiling", "ceilings"});
    if (IsHeightBefore(i)) {
      size.height_m = measure->value;
    } else if (!ceiling && text_.At(end + 1) != "ceiling" &&
               (owner_.IsOfAThing(i, end + 1) || owner_.IsBehindAThing(i, measure->value))) {
      return size;
    } else if (ceiling || (text_.Says(end, {"high", "tall"}) && measure->value >= kLowestM)) {
      size.height_m = measure->value;
    } else if (IsBehindSide(i, "width") || text_.At(end) == "wide" ||
               (text_.Is(end, "wall_nouns") && text_.At(end + 1) != "of")) {
      // "The 14 ft wall" is one of the room's.
      size.width_m = measure->value;
    } else if (IsBehindSide(i, "length") || IsBehindSide(i, "depth") || text_.Says(end, {"long", "deep"})) {
      size.depth_m = measure->value;
    } else if (text_.Says(end, {"square", "across", "diameter", "room", "bedroom"}) || text_.At(end + 1) == "room" ||
               text_.At(end + 1) == "diameter" || text_.BehindPhrase(end, "from_side_to_side")) {
      size.width_m = size.depth_m = measure->value;
    }
    return size;
  }

  // Whether the word is said of the room.
  bool IsSaid(const std::string& word) const {
    const Phrase phrase(word);
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const std::size_t length = phrase.MatchAt(text_.tokens(), i);
      if (length > 0 && !owner_.IsWordOfAThing(i, i + length)) return true;
    }
    return false;
  }

  // "a square room of 20 square metres": a "square" that no unit follows and no number precedes.
  bool IsSquare() const {
    for (std::size_t i = 0; i < text_.size(); ++i) {
      const bool measures =
          (i > 0 && text_.IsNumber(i - 1)) || english::Language::Get().FindUnit(text_.At(i + 1)) != nullptr;
      if (text_.At(i) == "square" && !measures) return true;
    }
    return false;
  }

  void ReadSizeWords() {
    for (const hb::SizeWord& entry : handbook_.contents().size_words()) {
      if (!std::ranges::any_of(entry.words(), [&](const std::string& word) { return IsSaid(word); })) continue;
      if (entry.area_factor() > 0) size_.area_factor = entry.area_factor();
      // The "square" of "20 square metres" says nothing about the shape.
      const bool of_area = size_.area_m2.has_value() && entry.side_ratio() == 1 && !IsSquare();
      if (entry.side_ratio() > 0 && !of_area) size_.side_ratio = entry.side_ratio();
      if (entry.width_m() > 0 && !size_.in_numbers()) {
        size_.width_m = entry.width_m();
        size_.depth_m = entry.depth_m();
      }
    }
  }

  const BriefText text_;
  const Handbook& handbook_;
  std::vector<bool>& used_;
  const SizeOwner owner_;
  SizeRequest size_;
};

absl::Status Check(const SizeRequest& size) {
  for (const std::optional<double>& side_m : {size.width_m, size.depth_m}) {
    if (!side_m || IsASide(*side_m)) continue;
    return absl::InvalidArgumentError(fmt::format(
        "brief.text: a side of {:g} m cannot be furnished; write sides between 1 m and 100 m, such as \"4m x 5m\"",
        *side_m));
  }
  if (size.area_m2 && (*size.area_m2 < 1.5 || *size.area_m2 > 2000)) {
    return absl::InvalidArgumentError(fmt::format(
        "brief.text: a floor of {:g} m2 cannot be furnished; write an area between 1.5 and 2000 m2", *size.area_m2));
  }
  if (size.height_m && (*size.height_m < kLowestM || *size.height_m > 12)) {
    return absl::InvalidArgumentError(
        fmt::format("brief.text: a ceiling at {:g} m is not possible; write a height between {:g} and 12 m",
                    *size.height_m, kLowestM));
  }
  return absl::OkStatus();
}

// The size of a piece whose words begin at a token: a pair of sides, or one length with what it is the length of.
PieceSize PieceSizeAt(const BriefText& text, std::size_t i) {
  PieceSize size;
  size.begin = i;
  if (const std::optional<SidePair> sides = PairAt(text, i)) {
    size.long_m = std::max(sides->width_m, sides->depth_m);
    size.short_m = std::min(sides->width_m, sides->depth_m);
    size.end = text.Is(sides->end, "dimensions") ? sides->end + 1 : sides->end;
    return size;
  }
  const std::optional<english::Measure> measure = MeasureAt(text, i);
  if (!measure || text.Is(measure->end, "after_distances")) return {};
  size.end = text.IsHyphen(measure->end) ? measure->end + 1 : measure->end;
  // "Bed 180", "a 1.40 bed": the width of one, in centimetres or metres.
  if (measure->unit == 0) {
    constexpr double kMostCm = 400;
    const double number = measure->value;
    const bool alone = text.IsNumber(i) && !(text.IsWord(size.end) && english::IsPlural(text.At(size.end)));
    if (alone && number >= kLeastCm && number <= kMostCm) size.width_m = number / 100;
    if (alone && number < kLeastCm && number != std::floor(number)) size.width_m = number;
    if (size.width_m && text.Says(size.end, {"wide", "width"})) ++size.end;
    return size.width_m ? size : PieceSize();
  }
  // The inches of a screen are its diagonal.
  constexpr double kInchM = 0.0254;
  const bool said = text.Is(size.end, "dimensions");
  if (!said && measure->unit == kInchM) return {};
  std::optional<double>& side = text.Is(size.end, "heights")              ? size.height_m
                                : text.Says(size.end, {"deep", "depth"})  ? size.depth_m
                                : text.Says(size.end, {"long", "length"}) ? size.long_m
                                                                          : size.width_m;
  side = measure->value;
  if (text.Says(size.end, {"square", "diameter"})) size.depth_m = measure->value;
  if (said) ++size.end;
  return size;
}

}  // namespace

PieceSize PieceSize::For(const hb::Furniture& furniture) const {
  PieceSize size = *this;
  const bool wide = furniture.width_m().typical() >= furniture.depth_m().typical();
  if (long_m) (wide ? size.width_m : size.depth_m) = long_m;
  if (short_m) (wide ? size.depth_m : size.width_m) = short_m;
  return size;
}

PieceSize ReadPieceSize(const std::vector<Token>& tokens, std::size_t begin, std::size_t end,
                        const std::vector<bool>& taken) {
  constexpr std::size_t kMostBefore = 9, kMostAdjectives = 3, kMostLinks = 4;
  const BriefText text(tokens);
  const auto free = [&](const PieceSize& size) {
    return size.any() && std::none_of(taken.begin() + static_cast<std::ptrdiff_t>(size.begin),
                                      taken.begin() + static_cast<std::ptrdiff_t>(size.end), std::identity());
  };
  for (std::size_t i = begin - std::min(begin, kMostBefore); i < begin; ++i) {
    const PieceSize size = PieceSizeAt(text, i);
    if (!free(size) || size.end > begin || begin - size.end > kMostAdjectives) continue;
    bool adjectives = true;
    for (std::size_t k = size.end; k < begin; ++k) {
      adjectives = adjectives && (!taken[k] || text.Is(k, "materials")) &&
                   (text.IsHyphen(k) || (text.IsWord(k) && !text.Is(k, "noun_phrase_ends")));
    }
    if (adjectives) return size;
  }
  std::size_t at = end;
  // "A single bed, though a wide one, 120 x 200".
  const bool pause = text.At(at) == ",";
  if (text.Says(pause ? at + 1 : at, {"though", "but"}) && text.At(at + (pause ? 4 : 3)) == "one") at += pause ? 5 : 4;
  end = at;
  while (at < end + kMostLinks && (text.Is(at, "size_links") || text.Is(at, "each_words") || text.At(at) == ",")) ++at;
  const PieceSize behind = PieceSizeAt(text, at);
  // "a couch, 2 m table": a comma alone does not join them.
  const bool said = behind.long_m || text.Is(behind.end - 1, "dimensions") || text.At(at - 1) != ",";
  return said && free(behind) ? behind : PieceSize();
}

absl::StatusOr<SizeRequest> ReadSize(const std::vector<Token>& tokens, const Handbook& handbook,
                                     std::vector<bool>& used) {
  const SizeRequest size = SizeReader(tokens, handbook, used).Read();
  RETURN_IF_ERROR(Check(size));
  return size;
}

}  // namespace flair::language
