// SPDX-License-Identifier: GPL-3.0-or-later
// What one says of pieces that the room has not: "add a desk with a chair, next to the window".
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/object_list.pb.h"

namespace flair::session {

// The piece of a name in the singular, lower case, such as "floor plant"; nothing when there is none to add.
using FindPiece = std::function<std::optional<v1::Object>(const std::string& name)>;
// Whether the room has something of that name.
using HasPiece = std::function<bool(const std::string& name)>;

// More at once nobody means, and it would take long.
inline constexpr std::size_t kMostAddedAtOnce = 12;

// A piece that is to be added.
struct PieceWish {
  v1::Object object;
  // Which one of the wishes it comes with, such as the chair of a desk; -1 for none.
  int goes_with = -1;
  // The sentence that asks for it, and what it calls the piece.
  std::string said, called = {};
};

// What is to be true: "The {} is next to the sofa".
struct WishedSentence {
  std::string text = {};
  // The wish for which "{}" stands; -1 for none.
  int piece = -1;
  // The sentence that says it.
  std::string said = {};
  // Pieces of the room for which "{}" stands when it is no wish.
  std::vector<std::string> about = {};
};

// What can be added to a room.
struct Catalogue {
  FindPiece find;
  // Some of it, as words: "a sofa, a bed".
  std::string some;
};

// What a text asks for, sentence by sentence.
struct Wishes {
  std::vector<PieceWish> pieces;
  std::vector<WishedSentence> sentences;
  // Names of what was asked for and cannot be added.
  std::vector<std::string> unknown;
};

// Splits into sentences at full stops and semicolons that are none of numbers.
std::vector<std::string> SplitSentences(std::string_view text);

// Linear in the length of the text, but for the names that it looks up.
Wishes ReadWishes(std::string_view text, const FindPiece& find, const HasPiece& has);

}  // namespace flair::session
