// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/quantity.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace flair::llm {
namespace {

struct UnitName {
  std::string_view unit;
  std::string_view name;
  double factor;
};

constexpr UnitName kUnits[] = {
    {"m", "m", 1},         {"m", "metres", 1},   {"m", "meters", 1}, {"m", "cm", 0.01}, {"m", "mm", 0.001},
    {"deg", "degrees", 1}, {"deg", "degree", 1}, {"deg", "deg", 1},  {"deg", "°", 1},
};

std::string_view Stripped(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::optional<double> ReadQuantity(std::string_view written, std::string_view unit) {
  const std::string_view text = Stripped(written);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view rest = Stripped(text.substr(static_cast<size_t>(stop - text.data())));
  if (rest.empty()) return value;
  const auto* const found = std::ranges::find_if(
      kUnits, [&](const UnitName& candidate) { return candidate.unit == unit && candidate.name == rest; });
  return found == std::end(kUnits) ? std::nullopt : std::optional(value * found->factor);
}

}  // namespace flair::llm
