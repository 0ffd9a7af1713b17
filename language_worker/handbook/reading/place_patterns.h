// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/vocabulary.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Whether the sentence of a place speaks of that slot: "{target}".
inline bool AskedNames(const hb::AskedPlace& asked, std::string_view slot) {
  return asked.relation().text().find(slot) != std::string::npos;
}

// Finds the handbook's words for places in a brief. The arguments must outlive it.
class PlacePatterns {
 public:
  PlacePatterns(const Handbook& handbook, const std::vector<Token>& tokens, const LandmarkReader& landmarks);

  struct Match {
    const hb::AskedPlace* asked = nullptr;
    Landmark landmark;       // of kind kNone where the words need none
    std::size_t length = 0;  // of the words alone
    std::size_t end = 0;
  };

  // Those that begin at a token: the longest first; of equally long ones those that say by what.
  std::vector<Match> MatchesAt(std::size_t i) const;

  // What words ask for that a slot follows: "next to" a "target". Null when the handbook has no such place.
  const hb::AskedPlace* Find(std::string_view words, std::string_view slot, hb::FurnitureKind kind) const;

  // "not near the door": whether a place that begins at a token is denied, over words that say nothing.
  bool IsDenied(std::size_t i) const;

 private:
  bool Denies(std::size_t i) const { return text_.Says(i, {"not", "never"}); }
  bool EndsPhrase(std::size_t i) const;
  bool Complete(const PlaceWords& words, Match& match) const;
  std::size_t LengthAt(const PlaceWords& words, std::size_t i) const;

  const std::vector<Token>& tokens_;
  const BriefText text_;
  const LandmarkReader& landmarks_;
  // The tokens without hyphens within words; of each token its index there, and back.
  std::vector<Token> plain_;
  std::vector<std::size_t> plain_at_, token_at_;
  const std::vector<PlaceWords>& places_;
};

// Whether a piece can be carried as a place asks for, though its class usually is not.
bool MayBeCarriedOtherwise(const hb::Furniture& furniture, const hb::AskedPlace& asked);

// Whether a place is for pieces of the class's kind: for those that stand on the floor when it does not say; or, where
// `otherwise`, for a kind that it can be as well; see Carried.
bool IsFor(const hb::AskedPlace& asked, const hb::Furniture& furniture, bool otherwise);

// "A washing machine and a dryer side by side": what is said of several of a kind, of a piece and the `other` listed
// before it, is that the piece stands by the other.
void TakeTwo(const hb::Furniture& other, const PlacePatterns& patterns, Place& place);

// "A dresser under a mirror", "a lectern by the screen": what hangs there is above the other, or near it.
// `at_the_front`: it hangs where all look, and the other stands near that wall.
void TakeWhatHangs(const PlacePatterns& patterns, Place& place, bool at_the_front);

// "Desks facing a screen": what hangs on a wall hangs where they look. One piece looks somewhere; several need a wall
// that is told.
void HangWhatIsFaced(const PlacePatterns& patterns, BriefFacts& facts, bool at_the_front);

}  // namespace flair::language
