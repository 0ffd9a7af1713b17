// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Tells the size of the room from that of something in it: "a 1.6 m x 0.8 m desk", "a desk of 1.6 m x 0.8 m",
// "canvases of 3 m x 2 m", "a giant who is 4 m tall". The arguments must outlive it.
class SizeOwner {
 public:
  SizeOwner(const std::vector<Token>& tokens, const hb::Handbook& handbook) : tokens_(tokens), handbook_(handbook) {}

  // Whether the size in tokens [start, end) is that of a thing, as far as the words around it say.
  bool IsOfAThing(std::size_t start, std::size_t end) const;

  // The same for a word of size, such as "large": "a large wardrobe", "with large windows", "for a little girl", and
  // the "grand" of a grand piano.
  bool IsWordOfAThing(std::size_t start, std::size_t end) const;

 private:
  struct Names {
    std::vector<Phrase> rooms;
    std::vector<Phrase> things;
  };

  bool IsWithinAThing(std::size_t start, std::size_t end) const;
  bool IsInWhatTheRoomHas(std::size_t start, std::size_t end) const;
  bool ThingFollows(std::size_t end) const;
  bool ThingPrecedes(std::size_t start) const;
  bool RoomAt(std::size_t i) const;
  std::size_t ThingAt(std::size_t i) const;
  bool EndsAt(const std::vector<Phrase>& names, std::size_t end) const;
  bool IsWord(std::size_t i) const { return i < tokens_.size() && tokens_[i].kind == Token::Kind::kWord; }
  const Names& names() const;

  const std::vector<Token>& tokens_;
  const hb::Handbook& handbook_;
  mutable std::optional<Names> names_;  // made when the first size is found
};

}  // namespace flair::language
