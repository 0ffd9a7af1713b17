// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

// Where a brief names a piece.
struct Mention {
  const hb::Furniture* furniture = nullptr;
  std::size_t begin = 0;
  std::size_t end = 0;
  int count = 1;
  int which = -1;  // "another desk": the second; -1 for all of them
};

// Reads where the brief wants its pieces: which piece, how, and by what ("a lamp between them"). Places that it finds
// words for and cannot read go into `facts.places_not_known`. Marks the tokens that it has used. The arguments must
// outlive it; `mentions` are in the order of the text.
class PlaceReader {
 public:
  PlaceReader(const Handbook& handbook, const std::vector<Token>& tokens,
              const std::vector<Saying<hb::Furniture>>& names, const std::vector<Mention>& mentions,
              std::function<int(const hb::Furniture&)> rank, std::vector<bool>& used, BriefFacts& facts);

  void Read();

 private:
  // Words for a place, without what follows them, and what follows.
  struct Pattern {
    Phrase words;
    std::string slot;  // "door", "window", "wall", "corner", "target", "targets"; empty when nothing follows
    const hb::AskedPlace* asked = nullptr;
  };
  struct Match {
    const Pattern* pattern = nullptr;
    Landmark landmark;
    std::size_t length = 0;  // of the words alone
    std::size_t end = 0;
  };
  // Whose place is told.
  struct Subject {
    const hb::Furniture* furniture = nullptr;
    std::size_t mention = 0;
    int which = -1;         // of several: the first, the second; -1 for all
    std::size_t begin = 0;  // of the words that name it
  };
  // What was read last: its subject, and where it ends.
  struct Last {
    Subject subject;
    std::size_t end = 0;
  };

  void AddPatterns();
  std::vector<Match> MatchesAt(std::size_t i) const;
  bool Denies(std::size_t i) const;
  bool IsDenied(std::size_t i) const;
  bool EndsPhrase(std::size_t i) const;
  bool Fits(const Pattern& pattern, const Landmark& landmark) const;
  std::optional<Subject> SubjectBefore(std::size_t i) const;
  std::optional<Subject> SubjectAfter(std::size_t begin, std::size_t end) const;
  std::optional<Subject> LooseSubjectBefore(std::size_t i) const;
  std::optional<std::size_t> MentionEndingAt(std::size_t end) const;
  std::optional<std::size_t> LastMentionBefore(std::size_t i) const;
  bool Resolve(const Subject& subject, const Match& match, Place& place) const;
  bool TakePair(const Subject& subject, const Match& match, Place& place) const;
  bool TakePronoun(const Subject& subject, bool plural, Place& place) const;
  bool TakePlace(std::size_t i);
  void NoteUnread(std::size_t i);
  bool SpeaksOfAPiece(std::size_t i) const;
  std::string Quote(std::size_t begin, std::size_t end) const;
  std::string_view Word(std::size_t i) const;

  const Handbook& handbook_;
  const std::vector<Token>& tokens_;
  const std::vector<Mention>& mentions_;
  std::vector<bool>& used_;
  BriefFacts& facts_;
  const LandmarkReader landmarks_;
  std::map<std::string, std::vector<Pattern>, std::less<>> patterns_;  // by their first word
  std::vector<std::size_t> mention_at_;  // of a token: the mention that covers it, or mentions_.size()
  std::vector<bool> by_landmark_;        // of a mention: it only tells where another one goes
  std::optional<Last> last_;
  std::size_t read_to_ = 0;
};

}  // namespace flair::language
