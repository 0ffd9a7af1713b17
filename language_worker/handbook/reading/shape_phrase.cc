// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/shape_phrase.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace flair::language {
namespace {

// Outlines that people ask for and that the handbook does not draw.
constexpr std::array<std::string_view, 17> kUnknown = {
    "round",       "circular",     "oval",      "elliptical",  "hexagonal", "octagonal",
    "pentagonal",  "triangular",   "trapezoid", "trapezoidal", "polygonal", "irregular",
    "irregularly", "semicircular", "curved",    "diamond",     "rhombic"};
// The same, said by naming a part of the house.
constexpr std::array<std::string_view, 3> kPlaces = {"attic", "mansard", "garret"};

// How far from the word the noun may stand that it speaks of.
constexpr std::size_t kReach = 8;

class ShapeReader {
 public:
  ShapeReader(const std::vector<Token>& tokens, const Handbook& handbook) : tokens_(tokens), handbook_(handbook) {}

  ShapeRequest Read() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto [letter, length] = LetterAt(i);
      if (length > 0 && IsOfRoom(i, i + length).value_or(true)) return OfLetter(letter);
      if (Is(i, kPlaces) && IsOfRoom(i, i + 1).value_or(true)) return {RoomShape::kRectangle, tokens_[i].text};
      // "all year round": without a room such words mean something else.
      if (Is(i, kUnknown) && IsOfRoom(i, i + 1).value_or(false)) return {RoomShape::kRectangle, tokens_[i].text};
    }
    return {};
  }

 private:
  const std::string& Text(std::size_t i) const { return i < tokens_.size() ? tokens_[i].text : empty_; }

  template <std::size_t N>
  bool Is(std::size_t i, const std::array<std::string_view, N>& words) const {
    return std::find(words.begin(), words.end(), Text(i)) != words.end();
  }

  static ShapeRequest OfLetter(char letter) {
    if (letter == 'l') return {RoomShape::kL, ""};
    if (letter == 't') return {RoomShape::kT, ""};
    if (letter == 'u') return {RoomShape::kU, ""};
    return {RoomShape::kRectangle, std::string(1, static_cast<char>(letter - 'a' + 'A')) + "-shaped"};
  }

  // "l-shaped", "l shape", "shaped like an l" from token i on: the letter and how many tokens say it.
  std::pair<char, std::size_t> LetterAt(std::size_t i) const {
    const auto letter = [&](std::size_t k) {
      return Text(k).size() == 1 && Text(k)[0] >= 'a' && Text(k)[0] <= 'z' ? Text(k)[0] : '\0';
    };
    const std::size_t after = Text(i + 1) == "-" ? i + 2 : i + 1;
    const bool shape = Text(after) == "shaped" || Text(after) == "shape";
    const bool known = letter(i) == 'l' || letter(i) == 't' || letter(i) == 'u';
    // "where I shape clay" and "its shape" speak of no letter.
    if (letter(i) != '\0' && shape && (known || after == i + 2)) return {letter(i), after + 1 - i};
    const bool like = Text(i) == "shaped" && (Text(i + 1) == "like" || Text(i + 1) == "as");
    const bool article = Text(i + 2) == "a" || Text(i + 2) == "an" || Text(i + 2) == "the";
    if (like && article && letter(i + 3) != '\0') return {letter(i + 3), 4};
    return {'\0', 0};
  }

  // Whether the words at [start, end) speak of the room: by the noun behind them or, where none is, the one before them
  // in the clause; nothing when there is neither.
  std::optional<bool> IsOfRoom(std::size_t start, std::size_t end) const {
    std::optional<bool> noun;
    std::size_t i = end;
    for (; i < std::min(end + kReach, tokens_.size()) && !EndsClause(i); ++i) i += ReadNoun(i, noun);
    if (noun) return noun;
    // "with a round" and then a noun that nobody knows, say a barrel.
    if (end < tokens_.size() && tokens_[end].kind == Token::Kind::kWord && !EndsClause(end)) return false;
    for (i = start > kReach ? start - kReach : 0; i < start; ++i) {
      if (EndsClause(i)) noun.reset();
      i += ReadNoun(i, noun);
    }
    return noun;
  }

  // Sets `noun` when one that is known begins at i: true for the room, false for furniture. How many tokens it has
  // besides the first.
  std::size_t ReadNoun(std::size_t i, std::optional<bool>& noun) const {
    const std::size_t room = RoomWordAt(i), piece = FurnitureAt(i);
    if (room == 0 && piece == 0) return 0;
    noun = room >= piece;
    return std::max(room, piece) - 1;
  }

  bool EndsClause(std::size_t i) const {
    static constexpr std::array<std::string_view, 12> kEnds = {"with",  "of",  "and", "for", "that", "which",
                                                               "where", "but", "in",  "on",  "at",   "without"};
    return tokens_[i].kind == Token::Kind::kSign ? Text(i) != "-" : Is(i, kEnds);
  }

  std::size_t FurnitureAt(std::size_t i) const {
    std::size_t longest = 0;
    for (const hb::Furniture& furniture : handbook_.contents().furniture()) {
      longest = std::max(longest, Phrase(furniture.name()).MatchAt(tokens_, i));
      for (const std::string& other : furniture.synonyms())
        longest = std::max(longest, Phrase(other).MatchAt(tokens_, i));
    }
    return longest;
  }

  std::size_t RoomWordAt(std::size_t i) const {
    static constexpr std::array<std::string_view, 11> kWords = {
        "room", "space", "floor", "plan", "layout", "flat", "house", "area", "studio", "apartment", "loft"};
    std::size_t longest = Is(i, kWords) ? 1 : 0;
    for (const hb::Archetype& archetype : handbook_.contents().archetypes()) {
      longest = std::max(longest, Phrase(archetype.name()).MatchAt(tokens_, i));
      for (const std::string& other : archetype.synonyms())
        longest = std::max(longest, Phrase(other).MatchAt(tokens_, i));
    }
    return longest;
  }

  const std::vector<Token>& tokens_;
  const Handbook& handbook_;
  const std::string empty_;
};

}  // namespace

ShapeRequest ReadShape(const std::vector<Token>& tokens, const Handbook& handbook) {
  return ShapeReader(tokens, handbook).Read();
}

}  // namespace flair::language
