// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/shape_phrase.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {
namespace {

// How far from the word the noun may stand that it speaks of.
constexpr std::size_t kReach = 8;

class ShapeReader {
 public:
  ShapeReader(const std::vector<Token>& tokens, const Handbook& handbook)
      : text_(tokens), tokens_(tokens), vocabulary_(handbook.vocabulary()) {}

  ShapeRequest Read() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto [letter, length] = LetterAt(i);
      if (length > 0 && IsOfRoom(i, i + length).value_or(true)) return OfLetter(letter);
      if (text_.Is(i, "sloped_rooms") && IsOfRoom(i, i + 1).value_or(true))
        return {RoomShape::kRectangle, tokens_[i].text};
      // "all year round": without a room such words mean something else.
      if (text_.Is(i, "shapes") && IsOfRoom(i, i + 1).value_or(false)) return {RoomShape::kRectangle, tokens_[i].text};
    }
    return {};
  }

 private:
  static ShapeRequest OfLetter(char letter) {
    if (letter == 'l') return {RoomShape::kL, ""};
    if (letter == 't') return {RoomShape::kT, ""};
    if (letter == 'u') return {RoomShape::kU, ""};
    return {RoomShape::kRectangle, std::string(1, static_cast<char>(letter - 'a' + 'A')) + "-shaped"};
  }

  // "l-shaped", "l shape", "shaped like an l" from token i on: the letter and how many tokens say it.
  std::pair<char, std::size_t> LetterAt(std::size_t i) const {
    const auto letter = [&](std::size_t k) {
      return text_.At(k).size() == 1 && text_.At(k)[0] >= 'a' && text_.At(k)[0] <= 'z' ? text_.At(k)[0] : '\0';
    };
    const std::size_t after = text_.At(i + 1) == "-" ? i + 2 : i + 1;
    const bool shape = text_.At(after) == "shaped" || text_.At(after) == "shape";
    const bool known = letter(i) == 'l' || letter(i) == 't' || letter(i) == 'u';
    // "where I shape clay" and "its shape" speak of no letter.
    if (letter(i) != '\0' && shape && (known || after == i + 2)) return {letter(i), after + 1 - i};
    const bool like = text_.At(i) == "shaped" && (text_.At(i + 1) == "like" || text_.At(i + 1) == "as");
    const bool article = text_.At(i + 2) == "a" || text_.At(i + 2) == "an" || text_.At(i + 2) == "the";
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
    const std::size_t word = text_.Is(i, "room_words") ? 1 : 0;
    const std::size_t room = std::max(word, LongestAt(vocabulary_.rooms, tokens_, i, /*plural=*/true).second);
    const std::size_t piece = LongestAt(vocabulary_.names, tokens_, i, /*plural=*/true).second;
    if (room == 0 && piece == 0) return 0;
    noun = room >= piece;
    return std::max(room, piece) - 1;
  }

  bool EndsClause(std::size_t i) const {
    return tokens_[i].kind == Token::Kind::kSign ? text_.At(i) != "-" : text_.Is(i, "shape_ends");
  }

  const BriefText text_;
  const std::vector<Token>& tokens_;
  const Vocabulary& vocabulary_;
};

}  // namespace

ShapeRequest ReadShape(const std::vector<Token>& tokens, const Handbook& handbook) {
  return ShapeReader(tokens, handbook).Read();
}

}  // namespace flair::language
