// SPDX-License-Identifier: GPL-3.0-or-later
// Whose place words tell, and by which piece.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/place_patterns.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

// Where a brief names its pieces, and which of them it names together. Mentions are told by their index; the arguments
// must outlive it.
class MentionList {
 public:
  MentionList(const std::vector<Token>& tokens, const std::vector<Mention>& mentions);

  // The mention that covers a token, that ends right before one.
  std::optional<std::size_t> At(std::size_t token) const;
  std::optional<std::size_t> EndingAt(std::size_t end) const { return end == 0 ? std::nullopt : At(end - 1); }

  // The first from a token on, over words for its looks.
  std::optional<std::size_t> From(std::size_t token) const;

  // Whether between two there are only a comma or "and", and words for the looks of the second: "a vase, a wooden
  // tray".
  bool AreListed(std::size_t first, std::size_t second) const;

  // "A table with a vase and a lamp": the table, of the lamp.
  std::optional<std::size_t> HolderOf(std::size_t held) const;

 private:
  bool Describes(std::size_t token) const;

  const BriefText text_;
  const std::vector<Mention>& mentions_;
  std::vector<std::size_t> at_;  // of a token; the number of mentions for none
};

// Whether it stands on tops, or may do so.
inline bool IsOnATop(const hb::Furniture& furniture) {
  return furniture.kind() == hb::FURNITURE_KIND_SURFACE || IsOfAnyKind(furniture);
}

// Finds by what a brief tells a place: the piece that it names there, or one that it named before. The arguments must
// outlive it.
class TargetFinder {
 public:
  // `by_landmark`: of a mention, whether it only tells where another one goes.
  TargetFinder(const std::vector<Mention>& mentions, const MentionList& named, const std::vector<bool>& by_landmark,
               const std::vector<Place>& places)
      : mentions_(mentions), named_(named), by_landmark_(by_landmark), places_(places) {}

  // Sets what the sentence of the place needs, for the piece of a mention; false when there is no such thing.
  bool Find(std::size_t subject, const PlacePatterns::Match& match, Place& place) const;

  // Of the wall where a piece was put last the one across the room; empty where no wall was named.
  std::string OppositeOfLast() const;

 private:
  bool FindPair(std::size_t subject, const Landmark& landmark, Place& place) const;
  bool FindNamedBefore(std::size_t subject, bool plural, Place& place) const;
  const hb::Furniture* Partner(const hb::Furniture& piece) const;

  const std::vector<Mention>& mentions_;
  const MentionList& named_;
  const std::vector<bool>& by_landmark_;
  const std::vector<Place>& places_;  // those read so far
};

// A part of the room that a brief names with what stands there.
struct NamedArea {
  std::size_t word = 0;             // the token of "corner" or "area"
  std::size_t first = 0, last = 0;  // the mentions that it lists
  std::size_t main = 0;             // that which the others stand by
  bool corner = false;
};

// Whose place is told.
struct Subject {
  const hb::Furniture* furniture = nullptr;
  std::size_t mention = 0;
  int which = -1;        // of several: the first, the second; -1 for all
  bool further = false;  // "... and one on the right": one more of it
};

// Finds whose place the words of a place tell: the piece that its clause speaks of. The arguments must outlive it.
class SubjectFinder {
 public:
  // `by_landmark`: of a mention, whether it only tells where another one goes.
  SubjectFinder(const std::vector<Token>& tokens, const std::vector<Mention>& mentions, const MentionList& named,
                const std::vector<bool>& by_landmark, const LandmarkReader& landmarks,
                const std::vector<NamedArea>& areas)
      : text_(tokens),
        mentions_(mentions),
        named_(named),
        by_landmark_(by_landmark),
        landmarks_(landmarks),
        areas_(areas) {}

  Subject Of(std::size_t mention) const { return {mentions_[mention].furniture, mention, mentions_[mention].which}; }

  // "A desk under the window", "a narrow bed that he never makes in the corner, by the stove": the piece before words
  // that begin at a token, over what else is said of it. `of_it`: the place is told by a pronoun, so that what comes
  // with a piece is not that piece's own: "a fire with two dogs in front of it".
  std::optional<Subject> Before(std::size_t i, bool of_it = false) const;

  // "Under the window a desk", "next to the bed there is a nightstand": the piece behind words for a place.
  std::optional<Subject> After(std::size_t begin, std::size_t end) const;

  // "A table with six chairs in the middle": the table, of the chairs.
  std::optional<Subject> HolderOf(const Subject& held) const;

  // "Sink and dishwasher on the window wall": the sink, of the dishwasher; not of "a sink and a dishwasher".
  std::optional<Subject> SharerOf(const Subject& subject) const;

  // The place that was read last: its subject, and where its words end.
  void Remember(const Subject& subject, std::size_t end) { last_ = Last{subject, end}; }
  bool EndedAt(std::size_t i) const { return last_ && last_->end == i; }
  const Subject& last() const { return last_->subject; }

 private:
  struct Last {
    Subject subject;
    std::size_t end = 0;
  };

  std::optional<Subject> Counted(std::size_t at) const;
  std::optional<std::size_t> LastMentionBefore(std::size_t i) const;
  bool IsFiller(std::size_t i) const;
  // "A lounge corner by the window with a sofa": the sofa, of the area that is named at a token.
  std::optional<Subject> MainOfArea(std::size_t i) const;

  const BriefText text_;
  const std::vector<Mention>& mentions_;
  const MentionList& named_;
  const std::vector<bool>& by_landmark_;
  const LandmarkReader& landmarks_;
  const std::vector<NamedArea>& areas_;
  std::optional<Last> last_;
};

}  // namespace flair::language
