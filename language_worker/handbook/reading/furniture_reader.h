// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

// What words for several classes mean in one kind of room: the "chair" of an office is none of a dining room. The
// handbook must outlive it.
class NounBook {
 public:
  // `facts` must know the kind of room, and its size if the brief says it.
  NounBook(const Handbook& handbook, const BriefFacts& facts);

  // Every word that names a class, words for several of them before the others.
  const std::vector<Saying<hb::Furniture>>& names() const { return vocabulary_.names; }

  // How much a class belongs to the room; 0 when not at all. Of two that a word may mean the higher is meant.
  int RankOf(const hb::Furniture& furniture) const;

  // The same for a class that is named at a token, by a noun that may mean another one in this kind of room.
  int RankAt(const std::vector<Token>& tokens, std::size_t i, const hb::Furniture& furniture) const;

  // The class that the words before a noun make of it: of "a comfy leather chair" an armchair, of "a two-seat sofa" a
  // loveseat. The noun is `length` tokens at `noun`; `named` where nothing is said, null where it is a thing that
  // nobody knows: "a proofing cabinet".
  const hb::Furniture* Modified(const std::vector<Token>& tokens, std::size_t noun, std::size_t length,
                                const hb::Furniture* named) const;

  // Number of tokens of a name with the nouns that only repeat it: "sectional" is followed by "sofa", "wingback" by
  // "chair". `length` where there are none.
  std::size_t LengthWithHead(const std::vector<Token>& tokens, std::size_t start, std::size_t length,
                             const hb::Furniture& furniture) const;

  // Number of tokens of a thing that only sounds like a class: "luggage rack"; 0 when there is none.
  std::size_t OtherThingAt(const std::vector<Token>& tokens, std::size_t start) const;

 private:
  const Vocabulary::Head* HeadAt(const std::vector<Token>& tokens, std::size_t i, std::size_t length) const;

  const Vocabulary& vocabulary_;
  const hb::Archetype& room_;
  std::map<std::string_view, int> ranks_;  // of a class by its name
};

// Reads the pieces that a brief asks for and refuses, how many of them, who sits at them, in what colour and where.
// Marks the tokens that it has used. `facts` must know the kind of room: a word for several classes ("chair", "bench")
// means the one that belongs there. The arguments must outlive it.
class FurnitureReader {
 public:
  FurnitureReader(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used,
                  BriefFacts& facts);

  void Read();
  // Marks the numbers and denials that belong to pieces, to be called when all else is read.
  void MarkCounts() {
    for (const std::size_t i : counts_) used_[i] = true;
  }
  // To be called behind Read, when all other words that may name a place have been used.
  void ReadPlaces();

 private:
  // A wish that what follows may belong to: its table, or the chairs that a table follows.
  struct Last {
    std::size_t wish = 0;
    std::size_t end = 0;
    bool seat = false;
  };

  int RankOf(const hb::Furniture& furniture) const;
  std::size_t TakeOtherThing(std::size_t i, std::size_t piece_length);
  const hb::Furniture* PartnerOf(std::size_t i);
  const hb::Furniture* AnyAt(std::size_t i);
  const Wish* MeantBefore(std::size_t i, std::size_t length) const;
  void Mentioned(const hb::Furniture& furniture, std::size_t i, std::size_t length, const PieceCount& count);
  void Wishing(const hb::Furniture& furniture, std::size_t i, std::size_t length);
  bool SeatsTheLast(const hb::Furniture& seat, const PieceCount& count, std::size_t i, std::size_t length);
  bool TakesTheLastAsSeats(std::size_t i, Wish& host);
  std::size_t AddWish(const Wish& wish, bool further);
  bool OnlyWordsBetween(std::size_t from, std::size_t to, bool around) const;
  void TakeColourBefore(std::size_t i, const hb::Furniture& furniture);
  void Use(std::size_t start, std::size_t length);

  const Handbook& handbook_;
  const std::vector<Token>& tokens_;
  std::vector<bool>& used_;
  BriefFacts& facts_;
  const NounBook nouns_;
  const std::vector<Saying<hb::Furniture>>& names_;
  const std::vector<Saying<hb::NamedColour>>& colours_;
  std::optional<Last> last_;
  std::vector<Mention> mentions_;
  std::vector<std::size_t> counts_;                     // tokens
  std::map<std::size_t, const hb::Furniture*> any_at_;  // of a token: what it names, whatever the room
};

// The class of the seats that come with a piece; null when none do.
const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook);

// Whether a class usually stands at, on or beside the other.
bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner);

// Whether one sits on it, at something: chairs and stools, not armchairs.
bool IsSeat(const hb::Furniture& furniture);

}  // namespace flair::language
