// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/shape_phrase.h"

#include <algorithm>
#include <optional>
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
      if (const auto narrowing = NarrowingAt(i)) return *narrowing;
    }
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const auto [letter, length] = LetterAt(i);
      if (length > 0 && IsOfRoom(i, i + length).value_or(true)) return Said(OfLetter(letter), i, length);
      if (text_.Is(i, "sloped_rooms") && IsOfRoom(i, i + 1).value_or(true))
        return Said({RoomShape::kRectangle, tokens_[i].text}, i, 1);
      // "All year round": without a room such words mean something else.
      for (const auto& [list, shape] : kShapes) {
        if (!text_.Is(i, list) || !(StandsAlone(i) || IsOfRoom(i, i + 1).value_or(false))) continue;
        return Said({shape, shape == RoomShape::kRectangle ? tokens_[i].text : ""}, i, 1);
      }
    }
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (text_.Is(i, "round_buildings")) return Said({RoomShape::kRound, ""}, i, 1);
    }
    return {};
  }

 private:
  // "The stern end narrower than the other", "it narrows towards the north".
  std::optional<ShapeRequest> NarrowingAt(std::size_t i) const {
    const auto end = text_.BehindPhrase(i, "narrowing_ends");
    if (!end) return std::nullopt;
    const bool before = i > 0 && text_.Is(i - 1, "wall_sides");
    ShapeRequest request{.shape = RoomShape::kNarrowing, .begin = before ? i - 1 : i, .end = *end};
    request.narrow_end = text_.At(before ? i - 1 : text_.BehindArticle(*end));
    while (text_.Says(request.end, {"than", "the", "other", "end", "one", request.narrow_end})) ++request.end;
    return request;
  }

  static constexpr std::pair<const char*, RoomShape> kShapes[] = {
      {"round_shapes", RoomShape::kRound},         {"oval_shapes", RoomShape::kOval},
      {"octagonal_shapes", RoomShape::kOctagon},   {"hexagonal_shapes", RoomShape::kHexagon},
      {"narrowing_shapes", RoomShape::kNarrowing}, {"shapes", RoomShape::kRectangle}};

  static ShapeRequest Said(ShapeRequest request, std::size_t i, std::size_t length) {
    request.begin = i;
    request.end = i + length;
    return request;
  }

  // "A tower study, circular, 6 m across", before any piece is named.
  bool StandsAlone(std::size_t i) const {
    const auto ends = [&](std::size_t k) { return k >= tokens_.size() || (EndsClause(k) && text_.IsSign(k)); };
    if (i == 0 || !ends(i - 1) || !ends(i + 1)) return false;
    for (std::size_t k = 0; k < i; ++k) {
      if (LongestAt(vocabulary_.names, tokens_, k, /*plural=*/true).second > 0) return false;
    }
    return true;
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
    // "A sofa in an L shape".
    std::size_t told = start;
    while (told > 0 && (text_.Is(told - 1, "articles") || text_.Says(told - 1, {"in", "of"}))) --told;
    // "A metre of space all round", "floor to turn round": how, not what the floor is.
    if (told == start && start > 0 && !EndsClause(start - 1) && !text_.Says(start - 1, {"is", "be", "was"}))
      return noun;
    for (i = start > kReach ? start - kReach : 0; i < start; ++i) {
      if (EndsClause(i) && i < told) noun.reset();
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

RunForm ReadRunForm(const std::vector<Token>& tokens, ShapeRequest& shape, std::vector<std::size_t>& told) {
  constexpr std::size_t kMostLooks = 6;
  const BriefText text(tokens);
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto tell = [&](std::size_t begin, std::size_t end, RunForm form) {
      for (std::size_t k = begin; k < end; ++k) told.push_back(k);
      return form;
    };
    if (const auto end = text.BehindPhrase(i, "runs_in_line")) return tell(i, *end, RunForm::kStraight);
    if (const auto end = text.BehindPhrase(i, "runs_that_face")) return tell(i, *end, RunForm::kFacing);
    if (!text.Says(i, {"l", "u"})) continue;
    std::size_t noun = text.IsHyphen(i + 1) ? i + 2 : i + 1;
    const bool shaped = text.Says(noun, {"shaped", "shape"});
    const bool in =
        i > 1 && text.Says(i - 1, {"a", "an"}) && text.Says(i - 2, {"in", "as", "forming", "form", "forms"});
    for (noun += shaped ? 1 : 0; noun < i + kMostLooks && !text.Is(noun, "kitchen_units") && text.IsWord(noun);) ++noun;
    if (!in && !(shaped && text.Is(noun, "kitchen_units"))) continue;
    if (shape.begin <= i && i < shape.end) shape = {.parts = shape.parts};
    const std::size_t begin = in ? i - (i > 2 && text.Is(i - 3, "kitchen_units") ? 3 : 2) : i;
    return tell(begin, in ? i + 1 : noun + 1, text.At(i) == "l" ? RunForm::kRoundCorner : RunForm::kRoundTwoCorners);
  }
  return RunForm::kAny;
}

ShapeRequest ReadShape(const std::vector<Token>& tokens, const Handbook& handbook) {
  return ShapeReader(tokens, handbook).Read();
}

}  // namespace flair::language
