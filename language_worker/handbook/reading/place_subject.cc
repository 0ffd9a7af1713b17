// SPDX-License-Identifier: GPL-3.0-or-later
// Whose place a brief tells, and what it tells it by.
#include <array>
#include <string_view>

#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/place_words.h"

namespace flair::language {
namespace {

constexpr std::array<std::string_view, 5> kGroupFillers = {"both", "each", "all", "them", "themselves"};
constexpr std::array<std::string_view, 4> kSingular = {"it", "this", "one", "he"};
constexpr std::array<std::string_view, 3> kPlural = {"they", "these", "those"};
// Before a place that opens its clause: "with a bed and, under the window, a desk".
constexpr std::array<std::string_view, 12> kOpeners = {"and",  "with",  "put",   "place", "have", "where",
                                                       "then", "there", "while", "but",   "also", "want"};

}  // namespace

std::optional<std::size_t> PlaceReader::MentionEndingAt(std::size_t end) const {
  if (end == 0 || mention_at_[end - 1] == mentions_.size()) return std::nullopt;
  return mention_at_[end - 1];
}

std::optional<std::size_t> PlaceReader::LastMentionBefore(std::size_t i) const {
  for (std::size_t m = mentions_.size(); m-- > 0;) {
    if (mentions_[m].end <= i && !by_landmark_[m]) return m;
  }
  return std::nullopt;
}

// What stands right before the place, over verbs, commas and what was said of its place before.
std::optional<PlaceReader::Subject> PlaceReader::SubjectBefore(std::size_t i) const {
  constexpr std::size_t kMostFillers = 10;
  const auto of = [&](std::size_t m, int which, std::size_t begin) {
    return Subject{mentions_[m].furniture, m, which, begin};
  };
  bool joined = false;
  for (std::size_t at = i; at > 0 && at + kMostFillers > i; --at) {
    if (last_ && last_->end == at) {
      const std::optional<std::size_t> m = MentionEndingAt(at);
      if (!m || joined) return last_->subject;
    }
    if (const std::optional<std::size_t> m = MentionEndingAt(at))
      return of(*m, mentions_[*m].which, mentions_[*m].begin);
    const Token& before = tokens_[at - 1];
    const std::optional<std::size_t> earlier = LastMentionBefore(at - 1);
    const bool other = before.text == "other" || before.text == "another" || before.text == "second";
    if (earlier && (before.text == "one" || other) && mentions_[*earlier].count > 1) {
      const bool again = last_ && last_->subject.which == 0 && last_->subject.mention == *earlier;
      return of(*earlier, other || again ? 1 : 0, at - 1);
    }
    if (earlier && (IncludesWord(kSingular, before.text) || IncludesWord(kPlural, before.text))) {
      return of(*earlier, mentions_[*earlier].which, mentions_[*earlier].begin);
    }
    joined = joined || before.text == "," || before.text == "and" || before.text == "but";
    const bool sign = before.kind == Token::Kind::kSign && !EndsSentence(before) && before.text != "(";
    const bool filler = IncludesWord(kPlaceFillers, before.text) || IncludesWord(kGroupFillers, before.text) ||
                        before.text == "and" || before.text == "but" || before.text == "the" || before.text == "of";
    if (!sign && !filler && before.kind != Token::Kind::kNumber) return std::nullopt;
  }
  return std::nullopt;
}

// "Under the window a desk", "next to the bed there is a nightstand".
std::optional<PlaceReader::Subject> PlaceReader::SubjectAfter(std::size_t begin, std::size_t end) const {
  constexpr std::array<std::string_view, 16> kBetween = {"there", "is", "are", "stands", "stand", "goes",
                                                         "a",     "an", "the", "put",    "place", "i",
                                                         "want",  "we", "two", "one"};
  constexpr std::size_t kMostBetween = 6;
  const bool first = begin == 0 || EndsSentence(tokens_[begin - 1]) || tokens_[begin - 1].text == ":";
  const bool aside = begin > 1 && Word(begin - 1) == "," && IncludesWord(kOpeners, Word(begin - 2));
  const bool opens = first || tokens_[begin - 1].text == "," || IncludesWord(kOpeners, tokens_[begin - 1].text);
  if (!opens || end >= tokens_.size()) return std::nullopt;
  int others = 0;
  bool noun_phrase = false;
  for (std::size_t i = end; i < tokens_.size() && i < end + kMostBetween; ++i) {
    if (mention_at_[i] < mentions_.size()) {
      const std::size_t m = mention_at_[i];
      if (!first && !noun_phrase) return std::nullopt;
      return Subject{mentions_[m].furniture, m, mentions_[m].which, mentions_[m].begin};
    }
    const Token& token = tokens_[i];
    if (token.kind == Token::Kind::kSign && !((first || aside) && token.text == ",")) return std::nullopt;
    if (token.text == "and" || token.text == "with" || token.text == "or") return std::nullopt;
    const bool known = IncludesWord(kBetween, token.text) || token.kind == Token::Kind::kSign || NumberWord(token.text);
    noun_phrase = noun_phrase || NumberWord(token.text) || token.text == "the" || token.kind == Token::Kind::kNumber;
    // Words for its looks.
    if (!known && (!noun_phrase || ++others > 2)) return std::nullopt;
  }
  return std::nullopt;
}

// "a desk for writing letters by the window": the last piece of the sentence when nothing else can stand there.
std::optional<PlaceReader::Subject> PlaceReader::LooseSubjectBefore(std::size_t i) const {
  constexpr std::size_t kMostWords = 12;
  for (std::size_t at = i; at > 0 && at + kMostWords > i; --at) {
    if (EndsSentence(tokens_[at - 1])) return std::nullopt;
    if (const std::optional<std::size_t> m = MentionEndingAt(at)) {
      if (by_landmark_[*m]) return std::nullopt;
      return Subject{mentions_[*m].furniture, *m, mentions_[*m].which, mentions_[*m].begin};
    }
    // A window or some other thing of its own: the place is that thing's.
    const std::string& word = tokens_[at - 1].text;
    if (landmarks_.FeatureAt(at - 1) != Landmark::Kind::kNone || word == "," || word == "and" || word == "a" ||
        word == "with" || word == "room" || word == "but") {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

// Finds what the landmark stands for; false when there is no such thing.
bool PlaceReader::Resolve(const Subject& subject, const Match& match, Place& place) const {
  const hb::AskedPlace& asked = *match.pattern->asked;
  place.side = match.landmark.side;
  if (AskedNames(asked, "{first}")) return TakePair(subject, match, place);
  if (!AskedNames(asked, "{target}")) return true;
  if (match.landmark.kind != Landmark::Kind::kPiece) return TakePronoun(subject, match.landmark.plural, place);
  place.target = match.landmark.piece;
  return place.target != subject.furniture;
}

// "between the sofa and the fireplace", "between the armchairs", "between them".
bool PlaceReader::TakePair(const Subject& subject, const Match& match, Place& place) const {
  const Landmark& landmark = match.landmark;
  if (landmark.kind == Landmark::Kind::kPiece) {
    place.target = landmark.piece;
    place.other = landmark.second != nullptr ? landmark.second : landmark.piece;
    return place.target != subject.furniture && place.other != subject.furniture;
  }
  // The two that were named last before it, those first that do not only tell where others go.
  for (const bool landmarks_too : {false, true}) {
    place.target = place.other = nullptr;
    for (std::size_t m = subject.mention; m-- > 0;) {
      const Mention& mention = mentions_[m];
      if (mention.furniture == subject.furniture || mention.furniture == place.other) continue;
      if (by_landmark_[m] && !landmarks_too) continue;
      if (place.other == nullptr && mention.count > 1) {
        place.target = place.other = mention.furniture;
        return true;
      }
      (place.other == nullptr ? place.other : place.target) = mention.furniture;
      if (place.target != nullptr) return true;
    }
  }
  return false;
}

// "next to it": the piece that was named before.
bool PlaceReader::TakePronoun(const Subject& subject, bool plural, Place& place) const {
  for (std::size_t m = subject.mention; m-- > 0;) {
    const Mention& mention = mentions_[m];
    if (mention.furniture == subject.furniture) continue;
    if (place.target == nullptr || (plural && mention.count > 1)) place.target = mention.furniture;
    if (!plural || mention.count > 1) break;
  }
  return place.target != nullptr;
}

}  // namespace flair::language
