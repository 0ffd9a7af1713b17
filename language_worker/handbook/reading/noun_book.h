// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/vocabulary.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// What words for several classes mean in one kind of room: the "chair" of an office is none of a dining room. The
// handbook must outlive it.
class NounBook {
 public:
  // `facts` must know the kind of room, and its size if the brief says it.
  NounBook(const Handbook& handbook, const BriefFacts& facts);

  // Every word that names a class, words for several of them before the others; with those by which the room's own
  // pieces are called there, "bath" for a dog bath.
  const PieceNames& names() const { return names_; }

  // How much a class belongs to the room; 0 when not at all. Of two that a word may mean the higher is meant.
  int RankOf(const hb::Furniture& furniture) const;

  // The same for a class that is named at a token, by a noun that may mean another one in this kind of room; below 0
  // for what it means in other rooms alone.
  int RankAt(const std::vector<Token>& tokens, std::size_t i, const hb::Furniture& furniture) const;

  // The class that the words before a noun make of it: of "a comfy leather chair" an armchair, of "a two-seat sofa" a
  // loveseat. The noun is `length` tokens at `noun`; `named` where nothing is said, null where it is a thing that
  // nobody knows: "a proofing cabinet".
  const hb::Furniture* Modified(const std::vector<Token>& tokens, std::size_t noun, std::size_t length,
                                const hb::Furniture* named) const;

  // A "rack for eight bikes" is a bike rack, a "cupboard for linen" a linen cupboard: the class that what the words for
  // a piece in [begin, end) are for makes of it, and where those words end; null where they make no name.
  struct Purpose {
    const hb::Furniture* furniture = nullptr;
    std::size_t end = 0;
  };
  Purpose PurposeOf(const std::vector<Token>& tokens, std::size_t begin, std::size_t end) const;

  // "... with four child-size chairs", behind a table: not the usual ones. Null where none are named, or no more than
  // that.
  const hb::Furniture* ChairsBehind(const std::vector<Token>& tokens, std::size_t end) const;

  // The noun for several classes that these tokens are; null for others.
  const hb::Noun* NounAt(const std::vector<Token>& tokens, std::size_t i, std::size_t length) const;

  // Number of tokens of a name with the nouns that only repeat it: "sectional" is followed by "sofa", "wingback" by
  // "chair". `length` where there are none.
  std::size_t LengthWithHead(const std::vector<Token>& tokens, std::size_t start, std::size_t length,
                             const hb::Furniture& furniture) const;

  // Number of tokens of a thing that only sounds like a class: "luggage rack"; 0 when there is none.
  std::size_t OtherThingAt(const std::vector<Token>& tokens, std::size_t start) const;

 private:
  // Whether the noun means that class in this kind of room.
  bool IsOfTheRoom(const hb::Noun& noun, const hb::Furniture& furniture) const;

  const Vocabulary::Head* HeadAt(const std::vector<Token>& tokens, std::size_t i, std::size_t length) const;

  const Vocabulary& vocabulary_;
  const hb::Archetype& room_;
  PieceNames names_;
  std::map<std::string_view, int> ranks_;  // of a class by its name
};

}  // namespace flair::language
