// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/noun_book.h"
#include "language_worker/handbook/reading/piece_count.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/sayings.h"

namespace flair::language {

// Reads the pieces that a brief asks for and refuses, how many of them, who sits at them, in what colour and where.
// Marks the tokens that it has used. `facts` must know the kind of room: a word for several classes ("chair", "bench")
// means the one that belongs there. The arguments must outlive it.
class FurnitureReader {
 public:
  FurnitureReader(const Handbook& handbook, const std::vector<Token>& tokens, std::vector<bool>& used,
                  BriefFacts& facts);

  void Read();
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
  std::vector<Saying<hb::NamedColour>> colours_;
  std::optional<Last> last_;
  std::vector<Mention> mentions_;
  std::map<std::size_t, const hb::Furniture*> any_at_;  // of a token: what it names, whatever the room
};

// "a green armchair": the words for colours that a handbook knows.
std::vector<Saying<hb::NamedColour>> ColourSayings(const Handbook& handbook);

// The class of the seats that come with a piece; null when none do.
const hb::Furniture* SeatOf(const hb::Furniture& furniture, const Handbook& handbook);

// Whether a class usually stands at, on or beside the other.
bool StandsWith(const hb::Furniture& furniture, const hb::Furniture& partner);

// Whether one sits on it, at something: chairs and stools, not armchairs.
bool IsSeat(const hb::Furniture& furniture);

}  // namespace flair::language
