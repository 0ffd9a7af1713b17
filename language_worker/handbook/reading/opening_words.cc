// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/opening_words.h"

#include <array>
#include <utility>

namespace flair::language {
namespace {

constexpr double kFootInM = 0.3048;
constexpr double kInchInM = 0.0254;

double UnitInMetres(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, double>, 7> kUnits = {{
      {"m metre metres meter meters", 1},
      {"cm centimetre centimetres centimeter centimeters", 0.01},
      {"mm millimetres millimeters", 0.001},
      {"ft foot feet", kFootInM},
      {"'", kFootInM},
      {"in inch inches", kInchInM},
      {"\"", kInchInM},
  }};
  for (const auto& [names, unit_m] : kUnits) {
    if (IsAmong(names, word)) return unit_m;
  }
  return 0;
}

}  // namespace

bool IsAmong(std::string_view words, std::string_view word) {
  if (word.empty()) return false;
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

std::string_view OpeningWords::At(std::size_t i) const {
  return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view();
}

bool OpeningWords::IsSign(std::size_t i) const { return i < size() && tokens_[i].kind == Token::Kind::kSign; }

bool OpeningWords::IsNumber(std::size_t i) const { return i < size() && tokens_[i].kind == Token::Kind::kNumber; }

double OpeningWords::NumberAt(std::size_t i) const { return i < size() ? tokens_[i].number : 0; }

bool OpeningWords::IsHyphen(std::size_t i) const { return IsSign(i) && At(i) == "-" && tokens_[i].glued; }

bool OpeningWords::EndsSentence(std::size_t i) const { return i >= size() || (IsSign(i) && IsAmong(". ; ! ?", At(i))); }

std::optional<std::size_t> OpeningWords::Behind(std::size_t i, std::string_view phrase) const {
  std::size_t from = 0;
  bool first = true;
  while (from < phrase.size()) {
    const std::size_t space = std::min(phrase.find(' ', from), phrase.size());
    if (!first && IsHyphen(i)) ++i;
    if (At(i) != phrase.substr(from, space - from)) return std::nullopt;
    first = false;
    ++i;
    from = space + 1;
  }
  return i;
}

std::optional<std::size_t> OpeningWords::BehindOneOf(std::size_t i, std::string_view phrases) const {
  for (std::size_t from = 0; from < phrases.size();) {
    const std::size_t bar = std::min(phrases.find('|', from), phrases.size());
    if (const auto behind = Behind(i, phrases.substr(from, bar - from))) return behind;
    from = bar + 1;
  }
  return std::nullopt;
}

std::size_t OpeningWords::BehindArticle(std::size_t i) const {
  return IsAmong("the a an one your my our its their this that", At(i)) ? i + 1 : i;
}

std::optional<double> OpeningWords::LengthAt(std::size_t i, std::size_t& end) const {
  if (!IsNumber(i)) return std::nullopt;
  const std::size_t unit = IsHyphen(i + 1) ? i + 2 : i + 1;
  // "4 in the corner" is no inches.
  if (At(unit) == "in" && !tokens_[unit].glued) return std::nullopt;
  const double unit_m = UnitInMetres(At(unit));
  if (unit_m == 0) return std::nullopt;
  end = unit + 1;
  return tokens_[i].number * unit_m;
}

std::string OpeningWords::Quote(std::size_t begin, std::size_t end) const {
  std::string text;
  for (std::size_t i = begin; i < end && i < size(); ++i) {
    text += (i > begin && !tokens_[i].glued ? " " : "") + tokens_[i].text;
  }
  return text;
}

}  // namespace flair::language
