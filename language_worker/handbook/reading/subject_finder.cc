// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/subject_finder.h"

#include <algorithm>

namespace flair::language {

// Goes back from the words to the piece that their clause speaks of. What is not known on the way must be of that
// piece: behind a comma or "and" it would be a thing of its own, with a place of its own.
std::optional<Subject> SubjectFinder::Before(std::size_t i, bool of_it) const {
  constexpr std::size_t kMostWords = 14;
  bool joined = false, relative = false, unknown = false;
  for (std::size_t at = i; at > 0 && at + kMostWords > i; --at) {
    const std::optional<std::size_t> m = named_.EndingAt(at);
    if (EndedAt(at) && (!m || (joined && !relative))) {
      return unknown ? std::nullopt : std::optional(last_->subject);
    }
    if (m) {
      const bool aside = unknown && (by_landmark_[*m] || (joined && !relative));
      return aside ? std::nullopt : std::optional(Of(*m));
    }
    if (const std::optional<Subject> main = MainOfArea(at - 1)) return main;
    if (const std::optional<Subject> counted = Counted(at)) return counted;
    const std::string_view before = text_.At(at - 1);
    if (before == "nothing" || text_.EndsSentence(at - 1)) return std::nullopt;
    const std::optional<std::size_t> earlier = LastMentionBefore(at - 1);
    const bool pronoun = text_.Is(at - 1, "singular_pronouns") || text_.Is(at - 1, "plural_pronouns");
    if (earlier && (pronoun || (at == i && before == "them"))) return Of(*earlier);
    if (before == ")") {
      while (at > 1 && text_.At(at - 1) != "(") --at;
      continue;
    }
    relative = relative || text_.Is(at - 1, "relative_pronouns");
    if (text_.Says(at - 1, {",", "and", "but"})) {
      if (unknown && !relative) return std::nullopt;
      joined = true;
    } else if (text_.Says(at - 1, {"with", "without"}) && !of_it) {
      unknown = false;  // "a bed with pots of herbs by the window": the bed's
    } else if (text_.IsSign(at - 1) ? before == ":" : !IsFiller(at - 1)) {
      // A thing of its own: "a quilt on the", "the window on the".
      const bool feature = landmarks_.FeatureAt(at - 1) != Landmark::Kind::kNone;
      if (feature || text_.Says(at - 1, {"a", "an", "with", "room", ":"})) return std::nullopt;
      unknown = true;
    }
  }
  return std::nullopt;
}

// "Two desks, one by the window and the other by the door", "a lamp on the left and one on the right".
std::optional<Subject> SubjectFinder::Counted(std::size_t at) const {
  const std::optional<std::size_t> earlier = LastMentionBefore(at - 1);
  const bool one = text_.At(at - 1) == "one", other = text_.Says(at - 1, {"other", "another", "second"});
  if (earlier && (one || other) && mentions_[*earlier].count > 1) {
    const bool again = last_ && last_->subject.which == 0 && last_->subject.mention == *earlier;
    Subject subject = Of(*earlier);
    subject.which = other || again ? 1 : 0;
    return subject;
  }
  constexpr std::size_t kMostBetween = 3;
  if (!one || !last_ || last_->subject.which >= 1 || last_->end >= at || last_->end + kMostBetween < at)
    return std::nullopt;
  Subject further = last_->subject;
  further.which = 1;
  further.further = true;
  return further;
}

bool SubjectFinder::IsFiller(std::size_t i) const {
  const std::string_view word = text_.At(i);
  // "At least a metre of".
  const bool least = word == "least" || (word == "at" && text_.At(i + 1) == "least");
  const bool metre = text_.Says(i, {"a", "an"}) && text_.Is(i + 1, "metres");
  const bool size = least || metre || text_.IsNumber(i) || (NumberWord(word) && !text_.Says(i, {"a", "an"})) ||
                    word == "x" || text_.Is(i, "unit_words") || (word[0] >= '0' && word[0] <= '9');
  return size || text_.Is(i, "place_fillers") || text_.Is(i, "pronouns") || text_.Is(i, "group_fillers") ||
         word.ends_with("ed") || word.ends_with("ing") || word.ends_with("ly") || text_.Says(i, {"the", "of", "in"}) ||
         IsFormIn("groups_of_pieces", word);
}

std::optional<Subject> SubjectFinder::After(std::size_t begin, std::size_t end) const {
  constexpr std::size_t kMostBetween = 9;
  const bool first = begin == 0 || text_.EndsSentence(begin - 1) || text_.At(begin - 1) == ":";
  const bool aside = begin > 1 && text_.At(begin - 1) == "," && text_.Is(begin - 2, "place_openers");
  const bool opens = first || text_.At(begin - 1) == "," || text_.Is(begin - 1, "place_openers");
  if (!opens || end >= text_.size()) return std::nullopt;
  int others = 0;
  bool noun_phrase = false;
  for (std::size_t i = end; i < text_.size() && i < end + kMostBetween; ++i) {
    if (const std::optional<std::size_t> m = named_.At(i)) {
      // "..., on the right wall shelves".
      const bool bare = i == end && text_.At(begin - 1) == "," && text_.At(mentions_[*m].end - 1).ends_with('s');
      return first || noun_phrase || bare ? std::optional(Of(*m)) : std::nullopt;
    }
    if (const std::optional<Subject> main = MainOfArea(i)) return main;
    if (text_.IsSign(i) && !((first || aside) && text_.At(i) == ",")) return std::nullopt;
    if (text_.Says(i, {"and", "with", "or"})) return std::nullopt;
    const bool number = NumberWord(text_.At(i)) || text_.IsNumber(i);
    const bool known = number || text_.IsSign(i) || text_.Is(i, "before_subjects") || text_.Is(i, "place_fillers");
    noun_phrase = noun_phrase || number || text_.At(i) == "the";
    // Words for its looks.
    if (!known && (!noun_phrase || ++others > 2)) return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Subject> SubjectFinder::MainOfArea(std::size_t i) const {
  const auto area = std::ranges::find(areas_, i, &NamedArea::word);
  return area == areas_.end() ? std::nullopt : std::optional(Of(area->main));
}

std::optional<Subject> SubjectFinder::HolderOf(const Subject& held) const {
  const std::optional<std::size_t> holder = named_.HolderOf(held.mention);
  if (!holder) return std::nullopt;
  for (std::size_t i = mentions_[*holder].end; i < mentions_[held.mention].begin; ++i) {
    if (text_.At(i) == "," && !IsOnATop(*held.furniture)) return std::nullopt;  // "..., a hammock": not the table's
  }
  return Of(*holder);
}

std::optional<Subject> SubjectFinder::SharerOf(const Subject& subject) const {
  const std::size_t m = subject.mention;
  const auto has_determiner = [&](std::size_t mention) {
    const std::size_t begin = text_.PhraseBegin(mentions_[mention].begin);
    for (std::size_t i = begin - (begin > 0 ? 1 : 0); i < mentions_[mention].begin; ++i) {
      if (text_.Is(i, "thing_articles") || text_.Is(i, "articles") || text_.IsNumber(i) || NumberWord(text_.At(i)))
        return true;
    }
    return false;
  };
  if (m == 0 || subject.which >= 0 || by_landmark_[m - 1] || has_determiner(m)) return std::nullopt;
  if (mentions_[m - 1].furniture == subject.furniture || !named_.AreListed(m - 1, m)) return std::nullopt;
  for (std::size_t i = mentions_[m - 1].end; i < mentions_[m].begin; ++i) {
    if (text_.At(i) == ",") return std::nullopt;
  }
  // The last two of a longer list.
  if (m > 1 && named_.AreListed(m - 2, m - 1) && !(last_ && last_->end > mentions_[m - 2].end)) return std::nullopt;
  return last_ && last_->end > mentions_[m - 1].begin ? std::nullopt : std::optional(Of(m - 1));
}

std::optional<std::size_t> SubjectFinder::LastMentionBefore(std::size_t i) const {
  for (std::size_t m = mentions_.size(); m-- > 0;) {
    if (mentions_[m].end <= i && !by_landmark_[m]) return m;
  }
  return std::nullopt;
}

}  // namespace flair::language
