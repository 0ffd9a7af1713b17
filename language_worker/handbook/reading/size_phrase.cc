// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/size_phrase.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "language_worker/handbook/reading/size_owner.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

constexpr double kFootM = 0.3048;
constexpr double kInchM = 0.0254;
constexpr double kTatamiM2 = 1.62;

// A number with its unit as found in the text; the unit may come later ("4 x 5 m").
struct Measure {
  double value = 0;
  double unit_m = 0;    // 0 when none is written
  std::size_t end = 0;  // first token after it
};

double UnitOf(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, double>, 17> kUnits = {{
      {"m", 1},
      {"metre", 1},
      {"metres", 1},
      {"meter", 1},
      {"meters", 1},
      {"mtr", 1},
      {"cm", 0.01},
      {"centimetres", 0.01},
      {"centimeters", 0.01},
      {"mm", 0.001},
      {"ft", kFootM},
      {"foot", kFootM},
      {"feet", kFootM},
      {"'", kFootM},
      {"in", kInchM},
      {"inch", kInchM},
      {"inches", kInchM},
  }};
  for (const auto& [name, unit_m] : kUnits) {
    if (name == word) return unit_m;
  }
  return 0;
}

class Reader {
 public:
  explicit Reader(const std::vector<Token>& tokens) : tokens_(tokens) {}

  const std::string& Text(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : empty_; }
  bool IsNumber(std::size_t i) const { return i < tokens_.size() && tokens_[i].kind == Token::Kind::kNumber; }
  std::size_t size() const { return tokens_.size(); }

  // A measure that begins at i, with a sign before it taken as part of it.
  std::optional<Measure> At(std::size_t i) const {
    if (!IsNumber(i)) return std::nullopt;
    Measure measure{tokens_[i].number, 0, i + 1};
    if (i > 0 && Text(i - 1) == "-" && tokens_[i].glued && !(i > 1 && tokens_[i - 1].glued)) measure.value *= -1;
    if (Text(measure.end) == "-" && tokens_[measure.end].glued && UnitOf(Text(measure.end + 1)) > 0) ++measure.end;
    measure.unit_m = UnitOf(Text(measure.end));
    // "in" is far more often a preposition than inches: "4 in the corner".
    if (Text(measure.end) == "in" && !tokens_[measure.end].glued) measure.unit_m = 0;
    if (measure.unit_m == 0) return measure;
    ++measure.end;
    if (measure.unit_m == kFootM && IsNumber(measure.end)) AddInches(measure);
    return measure;
  }

 private:
  // 12'6", 12 ft 6 in; the inches' mark may be missing after a foot mark.
  void AddInches(Measure& measure) const {
    const std::string& mark = Text(measure.end + 1);
    const bool marked = mark == "\"" || mark == "in" || mark == "inch" || mark == "inches";
    if (!marked && !(tokens_[measure.end].glued && Text(measure.end - 1) == "'")) return;
    measure.value += tokens_[measure.end].number / 12;
    measure.end += marked ? 2 : 1;
  }

  const std::vector<Token>& tokens_;
  const std::string empty_;
};

// Metres of a number that stands without a unit: people write metres up to 20, then feet, centimetres, millimetres.
double GuessUnit(double value) {
  if (value <= 20) return 1;
  if (value <= 60) return kFootM;
  return value < 1000 ? 0.01 : 0.001;
}

absl::Status CheckSide(double side_m) {
  if (side_m >= 1 && side_m <= 100) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format(
      "brief.text: a side of {:g} m cannot be furnished; write sides between 1 m and 100 m, such as \"4m x 5m\"",
      side_m));
}

bool IsTimes(const std::string& text) { return text == "x" || text == "by" || text == "*"; }

// Width and depth as found in the text.
struct Sides {
  double width_m = 0;
  double depth_m = 0;
  std::size_t end = 0;  // first token after them
};

// "4m x 5m" and "8m long, 4m wide" from token i on.
std::optional<Sides> ReadPair(const Reader& reader, std::size_t i) {
  const std::optional<Measure> first = reader.At(i);
  if (!first) return std::nullopt;
  std::size_t next = first->end;
  bool swapped = false;
  if (reader.Text(next) == "wide" || reader.Text(next) == "long") {
    swapped = reader.Text(next) == "long";
    ++next;
    while (reader.Text(next) == "," || reader.Text(next) == "and") ++next;
  } else if (IsTimes(reader.Text(next))) {
    ++next;
  } else {
    return std::nullopt;
  }
  if (reader.Text(next) == "-") ++next;
  std::optional<Measure> second = reader.At(next);
  if (!second) return std::nullopt;
  double unit1 = first->unit_m, unit2 = second->unit_m;
  if (unit1 == 0) unit1 = unit2 > 0 ? unit2 : GuessUnit(std::max(first->value, second->value));
  if (unit2 == 0) unit2 = unit1;
  Sides sides{first->value * unit1, second->value * unit2, second->end};
  if (swapped) std::swap(sides.width_m, sides.depth_m);
  return sides;
}

// Square metres from token i on: "20 square metres", "20 m2", "215 sq ft", "6 tatami".
std::optional<double> ReadArea(const Reader& reader, std::size_t i) {
  if (!reader.IsNumber(i)) return std::nullopt;
  const double value = reader.At(i)->value;
  std::size_t next = i + 1;
  const std::string& word = reader.Text(next);
  if (word == "sqm" || word == "qm") return value;
  if (word == "sqft") return value * kFootM * kFootM;
  if (word == "tatami" || word == "jo") return value * kTatamiM2;
  if (word == "square" || word == "sq") {
    next += reader.Text(next + 1) == "." ? 2 : 1;
    const double unit_m = UnitOf(reader.Text(next));
    return unit_m > 0 ? std::optional(value * unit_m * unit_m) : std::nullopt;
  }
  const double unit_m = UnitOf(word);
  if (unit_m > 0 && (reader.Text(next + 1) == "2" || (reader.Text(next + 1) == "^" && reader.Text(next + 2) == "2"))) {
    return value * unit_m * unit_m;
  }
  return std::nullopt;
}

// "height 2.4 m", "room height: 2.4 m", "a ceiling of 2.4 m", "the ceiling is at 2.4 m".
bool IsHeightBefore(const Reader& reader, std::size_t i) {
  constexpr std::size_t kMostBetween = 4;
  for (std::size_t back = 1; back <= kMostBetween && back <= i; ++back) {
    const std::string& word = reader.Text(i - back);
    if (word == "ceiling" || word == "ceilings") return true;
    // The height of a shelf is none of the room.
    if (word == "height") {
      const std::string& whose = i > back ? reader.Text(i - back - 1) : word;
      return i == back || whose == "room" || whose == "ceiling" || whose == "a" || whose == "," || whose == "." ||
             whose == "and" || whose == "with" || whose == "the" || whose == ";";
    }
    const bool between = word == "of" || word == "is" || word == "at" || word == ":" || word == "a" ||
                         word == "height" || word == "about" || word == "=";
    if (!between) return false;
  }
  return false;
}

// A single length with what it belongs to: "5 m square", "12-foot room", "6 m long", "2.7m ceiling".
void ReadSingle(const Reader& reader, const SizeOwner& owner, std::size_t i, SizeRequest& size) {
  const std::optional<Measure> measure = reader.At(i);
  if (!measure || measure->unit_m == 0) return;
  const double length_m = measure->value * measure->unit_m;
  const std::string& word = reader.Text(measure->end);
  const bool ceiling = word == "ceiling" || word == "ceilings" || reader.Text(measure->end + 1) == "ceiling";
  if (IsHeightBefore(reader, i)) {
    size.height_m = length_m;
    return;
  }
  if (!ceiling && owner.IsOfAThing(i, measure->end + 1)) return;
  if (word == "ceiling" || word == "ceilings" || word == "high" || word == "tall") {
    size.height_m = length_m;
  } else if (word == "wide") {
    size.width_m = length_m;
  } else if (word == "long" || word == "deep") {
    size.depth_m = length_m;
  } else if (word == "square" || reader.Text(measure->end + 1) == "room" || word == "room" || word == "bedroom") {
    size.width_m = size.depth_m = length_m;
  }
}

// Whether the word is said of the room.
bool IsSaid(const std::string& word, const std::vector<Token>& tokens, const SizeOwner& owner) {
  const Phrase phrase(word);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::size_t length = phrase.MatchAt(tokens, i);
    if (length > 0 && !owner.IsWordOfAThing(i, i + length)) return true;
  }
  return false;
}

// "a square room of 20 square metres": a "square" that no unit follows and no number precedes.
bool IsSquare(const std::vector<Token>& tokens) {
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].text != "square") continue;
    const bool unit = i + 1 < tokens.size() && (UnitOf(tokens[i + 1].text) > 0 || tokens[i + 1].text == "metre");
    if (!unit && !(i > 0 && tokens[i - 1].kind == Token::Kind::kNumber)) return true;
  }
  return false;
}

void ReadSizeWords(const std::vector<Token>& tokens, const hb::Handbook& handbook, const SizeOwner& owner,
                   SizeRequest& size) {
  for (const hb::SizeWord& entry : handbook.size_words()) {
    const bool said = std::any_of(entry.words().begin(), entry.words().end(),
                                  [&](const std::string& word) { return IsSaid(word, tokens, owner); });
    if (!said) continue;
    if (entry.area_factor() > 0) size.area_factor = entry.area_factor();
    // The "square" of "20 square metres" says nothing about the shape.
    const bool of_area = size.area_m2.has_value() && entry.side_ratio() == 1 && !IsSquare(tokens);
    if (entry.side_ratio() > 0 && !of_area) size.side_ratio = entry.side_ratio();
    if (entry.width_m() > 0 && !size.in_numbers()) {
      size.width_m = entry.width_m();
      size.depth_m = entry.depth_m();
    }
  }
}

absl::Status Check(const SizeRequest& size) {
  for (const auto& side_m : {size.width_m, size.depth_m}) {
    if (!side_m) continue;
    RETURN_IF_ERROR(CheckSide(*side_m));
  }
  if (size.area_m2 && (*size.area_m2 < 1.5 || *size.area_m2 > 2000)) {
    return absl::InvalidArgumentError(fmt::format(
        "brief.text: a floor of {:g} m2 cannot be furnished; write an area between 1.5 and 2000 m2", *size.area_m2));
  }
  if (size.height_m && (*size.height_m < 2 || *size.height_m > 12)) {
    return absl::InvalidArgumentError(fmt::format(
        "brief.text: a ceiling at {:g} m is not possible; write a height between 2 and 12 m", *size.height_m));
  }
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<SizeRequest> ReadSize(const std::vector<Token>& tokens, const hb::Handbook& handbook) {
  const Reader reader(tokens);
  SizeRequest size;
  const SizeOwner owner(tokens, handbook);
  for (std::size_t i = 0; i < reader.size() && !size.in_numbers(); ++i) {
    if (const auto sides = ReadPair(reader, i)) {
      if (owner.IsOfAThing(i, sides->end)) {
        i = sides->end - 1;
        continue;
      }
      size.width_m = sides->width_m;
      size.depth_m = sides->depth_m;
    } else if (const auto area = ReadArea(reader, i)) {
      size.area_m2 = area;
    }
  }
  const bool sides_known = size.in_numbers();
  for (std::size_t i = 0; i < reader.size(); ++i) {
    SizeRequest single;
    ReadSingle(reader, owner, i, single);
    if (single.height_m && !size.height_m) size.height_m = single.height_m;
    if (sides_known) continue;
    if (single.width_m && !size.width_m) size.width_m = single.width_m;
    if (single.depth_m && !size.depth_m) size.depth_m = single.depth_m;
  }
  ReadSizeWords(tokens, handbook, owner, size);
  RETURN_IF_ERROR(Check(size));
  return size;
}

}  // namespace flair::language
