// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/read_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "absl/strings/ascii.h"
#include "llm/answers/choices.h"
#include "llm/answers/field_facts.h"
#include "llm/answers/quantity.h"

namespace flair::llm {
namespace {

using nlohmann::json;

// The metres that a number beyond all metres is in centimetres, or beyond those in millimetres.
std::optional<double> LengthMeant(double number, const NumberRange& range_m) {
  constexpr double kMostCentimetres = 1000;
  if (!(number > range_m.most)) return std::nullopt;
  const double length_m = number <= kMostCentimetres ? number / 100 : number / 1000;
  return length_m >= range_m.least && length_m <= range_m.most ? std::optional(length_m) : std::nullopt;
}

// A quantity that is not a bare number as a text: "160 cm", also of {"value": 160, "unit": "cm"}.
std::optional<std::string> QuantityText(const json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_object() || value.size() != 2) return std::nullopt;
  const auto number = value.find("value"), unit = value.find("unit");
  if (number == value.end() || unit == value.end() || !unit->is_string()) return std::nullopt;
  const std::optional<double> plain = PlainNumber(*number);
  return plain ? std::optional(fmt::format("{} {}", *plain, unit->get_ref<const std::string&>())) : std::nullopt;
}

// What a range means: fewest of things, the middle of lengths. Nothing for other texts.
std::optional<double> OfRange(const json& value, const google::protobuf::FieldDescriptor& field) {
  const std::string& unit = FactsOf(field).unit();
  if (!value.is_string()) return std::nullopt;
  const std::optional<QuantityRange> range = ReadRange(value.get_ref<const std::string&>(), unit);
  if (!range) return std::nullopt;
  return IsWhole(field) ? range->least : (range->least + range->most) / 2;
}

// A share of one in words: "50%", "center".
std::optional<double> ShareOf(const json& value, const NumberRange& range) {
  if (!value.is_string() || range.least != 0 || range.most != 1) return std::nullopt;
  std::string_view text = value.get_ref<const std::string&>();
  const std::string word = Bare(text);
  if (word == "center" || word == "centre" || word == "middle" || word == "centered") return 0.5;
  if (!text.ends_with('%')) return std::nullopt;
  text.remove_suffix(1);
  const std::optional<double> percent = ReadQuantity(text, "");
  return percent ? std::optional(*percent / 100) : std::nullopt;
}

}  // namespace

std::string Shown(const json& value) {
  if (value.is_string()) return Quoted(value.get_ref<const std::string&>());
  if (value.is_object()) return "an object";
  if (value.is_array()) return fmt::format("a list of {}", value.size());
  return value.dump();
}

std::optional<double> PlainNumber(const json& value) {
  if (value.is_number()) return value.get<double>();
  return value.is_string() ? ReadQuantity(value.get_ref<const std::string&>(), "") : std::nullopt;
}

bool SaysNothing(const json& value) {
  return value.is_string() && SaysNothing(std::string_view(value.get_ref<const std::string&>()));
}

bool SaysNothing(std::string_view text) {
  const std::string word = absl::AsciiStrToLower(absl::StripAsciiWhitespace({text.data(), text.size()}));
  constexpr std::string_view kWords[] = {"", "-", "n/a", "na", "nil", "none", "null", "unknown", "not applicable"};
  return std::ranges::find(kWords, word) != std::end(kWords);
}

std::optional<double> ReadNumber(const json& value, const google::protobuf::FieldDescriptor& field,
                                 const std::string& path, const LengthUnit* bare_unit, std::vector<Fault>& faults) {
  const std::string& unit = FactsOf(field).unit();
  std::optional<double> number;
  if (value.is_number()) number = value.get<double>();
  if (const std::optional<std::string> text = QuantityText(value)) {
    number = IsWhole(field) && unit.empty() ? ReadCount(*text) : ReadQuantity(*text, unit);
  }
  const bool converts = bare_unit != nullptr && unit == "m";
  if (number && converts && PlainNumber(value)) *number *= bare_unit->metres;
  const NumberRange range = RangeOf(field);
  if (!number) number = ShareOf(value, range);
  const std::optional<double> of_range = number ? std::nullopt : OfRange(value, field);
  if (of_range) {
    number = of_range;
    if (converts && ReadRange(value.get_ref<const std::string&>(), "")) *number *= bare_unit->metres;
  }
  const bool whole = !IsWhole(field) || (number && *number == std::floor(*number));
  if (number && std::isfinite(*number) && whole && *number >= range.least && *number <= range.most) {
    if (of_range) {
      faults.push_back({path, fmt::format("is {}; one number would be right; taken as {:g}", Shown(value), *number),
                        FaultKind::kMended});
    }
    return number;
  }
  // No choices: those are for texts.
  std::string fault = fmt::format("is {}; {} would be right", Shown(value), RightFor(field, {}));
  std::optional<double> length_m;
  if (number && unit == "m" && !converts) length_m = LengthMeant(*number, range);
  // A rug that is no more than flat.
  constexpr double kThin_m = 0.005;
  if (number && unit == "m" && *number >= 0 && *number < range.least && range.least <= kThin_m) length_m = range.least;
  if (length_m) {
    faults.push_back({path, fmt::format("{}; taken as {}", fault, *length_m), FaultKind::kDoubtful});
  } else {
    faults.push_back({path, std::move(fault), FaultKind::kWrong});
  }
  return length_m;
}

}  // namespace flair::llm
