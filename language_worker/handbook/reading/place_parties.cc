// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_parties.h"

#include <algorithm>

#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {

bool TargetFinder::Find(std::size_t subject, const PlacePatterns::Match& match, Place& place) const {
  place.side = match.landmark.side;
  if (place.side == "opposite" && AskedNames(*match.asked, "{wall}") && !OppositeOfLast().empty())
    place.side = OppositeOfLast();
  if (AskedNames(*match.asked, "{first}")) return FindPair(subject, match.landmark, place);
  if (!AskedNames(*match.asked, "{target}")) return true;
  // "A king bed with a bench at the foot", "a nightstand on the left": of what it usually stands by.
  const hb::Furniture& piece = *mentions_[subject].furniture;
  if (match.landmark.each_other) {
    place.target = &piece;
    return true;
  }
  // "At the foot" is a bed's; "the fridge at the end" is at no other piece.
  const bool foot =
      match.landmark.kind == Landmark::Kind::kNone && AskedNames(*match.asked, "next to the front of the {target}");
  if (match.landmark.kind == Landmark::Kind::kNone && IsOnTheFloor(piece)) {
    place.target = Partner(piece);
    if (place.target != nullptr) return !foot || place.target->category() == "bed";
    if (AskedNames(*match.asked, "side of the {target}") && match.asked->relation().condition().min_count() < 2)
      return false;
  }
  if (match.landmark.kind != Landmark::Kind::kPiece)
    return FindNamedBefore(subject, match.landmark.plural, place) && (!foot || place.target->category() == "bed");
  place.target = match.landmark.piece;
  return place.target != mentions_[subject].furniture;
}

// "between the sofa and the fireplace", "between the armchairs", "between them".
bool TargetFinder::FindPair(std::size_t subject, const Landmark& landmark, Place& place) const {
  const hb::Furniture* piece = mentions_[subject].furniture;
  if (landmark.kind == Landmark::Kind::kPiece) {
    place.target = landmark.piece;
    place.other = landmark.second != nullptr ? landmark.second : landmark.piece;
    return place.target != piece && place.other != piece;
  }
  // "A sofa facing the fire, a low table between": those two.
  if (!places_.empty() && places_.back().target != nullptr && AskedNames(*places_.back().asked, "faces the {target}") &&
      places_.back().furniture != piece && places_.back().target != piece) {
    place.target = places_.back().furniture;
    place.other = places_.back().target;
    return true;
  }
  // Two of a kind, "two beds, each with a nightstand, a curtain in between"; else the two that were named last before
  // it, those first that do not only tell where others go.
  for (std::size_t m = subject; m-- > 0;) {
    if (mentions_[m].count != 2 || mentions_[m].furniture == piece || by_landmark_[m]) continue;
    place.target = place.other = mentions_[m].furniture;
    return true;
  }
  for (const bool landmarks_too : {false, true}) {
    place.target = place.other = nullptr;
    for (std::size_t m = subject; m-- > 0;) {
      const Mention& mention = mentions_[m];
      if (mention.furniture == piece || mention.furniture == place.other) continue;
      if (by_landmark_[m] && !landmarks_too) continue;
      // "A basin with a mirror, and the toilet between them".
      if (IsOnTheFloor(*piece) && !IsOnTheFloor(*mention.furniture)) continue;
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

// The piece of the brief that it usually stands by; null for none.
const hb::Furniture* TargetFinder::Partner(const hb::Furniture& piece) const {
  const auto partner = std::ranges::find_if(mentions_, [&](const Mention& mention) {
    return mention.furniture != &piece && IsOnTheFloor(*mention.furniture) && StandsWith(piece, *mention.furniture);
  });
  return partner == mentions_.end() ? nullptr : partner->furniture;
}

std::string TargetFinder::OppositeOfLast() const {
  for (std::size_t i = places_.size(); i-- > 0;) {
    const std::string& side = places_[i].side;
    if (side.empty() || !AskedNames(*places_[i].asked, "{wall}")) continue;
    return side.find(' ') == std::string::npos ? "across " + side : "";
  }
  return "";
}

// "next to it", "on top": the piece that was named before; for what is carried the last that has a top, best one for
// several things.
bool TargetFinder::FindNamedBefore(std::size_t subject, bool plural, Place& place) const {
  const hb::Furniture& piece = *mentions_[subject].furniture;
  const hb::Carried carried = place.asked->carried();
  const bool carries = carried == hb::CARRIED_ON || carried == hb::CARRIED_IN;
  if (const std::optional<std::size_t> holder = carries ? named_.HolderOf(subject) : std::nullopt) {
    if (!IsOnATop(*mentions_[*holder].furniture)) place.target = mentions_[*holder].furniture;
  }
  const bool on_a_top = carries || piece.kind() == hb::FURNITURE_KIND_CEILING;
  for (const int tops : {plural ? 2 : 1, 1, 0}) {
    for (std::size_t m = subject; m-- > 0 && place.target == nullptr;) {
      const hb::Furniture& target = *mentions_[m].furniture;
      if (&target == &piece || (plural && !on_a_top && mentions_[m].count < 2 && tops > 0)) continue;
      // "It" is one piece, where there is one.
      if (!plural && mentions_[m].count > 1 && tops > 0 && !on_a_top) continue;
      const bool has_top = target.top_places() >= tops && (tops > 0 || carried == hb::CARRIED_IN);
      const bool faced = target.kind() == hb::FURNITURE_KIND_WALL && AskedNames(*place.asked, "faces the {target}");
      const bool may_be = faced || IsOnTheFloor(target) ? !on_a_top || has_top : !on_a_top && !IsOnTheFloor(piece);
      if (may_be) place.target = &target;
    }
  }
  // "A board, the desk to the side of it."
  if (place.target == nullptr && subject > 0 && AskedNames(*place.asked, "m of the {target}") && IsOnTheFloor(piece) &&
      mentions_[subject - 1].furniture->kind() == hb::FURNITURE_KIND_WALL)
    place.target = mentions_[subject - 1].furniture;
  return place.target != nullptr;
}

MentionList::MentionList(const std::vector<Token>& tokens, const std::vector<Mention>& mentions)
    : text_(tokens), mentions_(mentions), at_(tokens.size(), mentions.size()) {
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    for (std::size_t i = mentions[m].begin; i < mentions[m].end; ++i) at_[i] = m;
  }
}

std::optional<std::size_t> MentionList::At(std::size_t token) const {
  return token < at_.size() && at_[token] < mentions_.size() ? std::optional(at_[token]) : std::nullopt;
}

std::optional<std::size_t> MentionList::From(std::size_t token) const {
  constexpr std::size_t kMostBetween = 6;
  for (std::size_t i = token; i < text_.size() && i < token + kMostBetween; ++i) {
    if (At(i)) return At(i);
    if (!Describes(i)) break;
  }
  return std::nullopt;
}

bool MentionList::AreListed(std::size_t first, std::size_t second) const {
  constexpr std::size_t kMostBetween = 7;
  const std::size_t begin = mentions_[first].end, end = mentions_[second].begin;
  if (end <= begin || end - begin > kMostBetween) return false;
  bool joined = false;
  for (std::size_t i = begin; i < end; ++i) {
    const bool joint = text_.Says(i, {",", "and"});
    joined = joined || joint;
    if (!joint && !Describes(i)) return false;
  }
  return joined;
}

std::optional<std::size_t> MentionList::HolderOf(std::size_t held) const {
  std::size_t first = held;
  while (first > 0 && AreListed(first - 1, first)) --first;
  if (first == 0) return std::nullopt;
  // "A carpet with cushions": where its words go on as those of a part.
  if (mentions_[first - 1].end >= mentions_[first].end) return first - 1;
  bool with = false;
  for (std::size_t i = mentions_[first - 1].end; i < mentions_[first].begin; ++i) {
    with = with || text_.At(i) == "with";
    if (text_.At(i) != "with" && !Describes(i)) return std::nullopt;
  }
  return with ? std::optional(first - 1) : std::nullopt;
}

// Whether a token may stand before the noun of a piece.
bool MentionList::Describes(std::size_t token) const {
  if (text_.IsHyphen(token) || text_.Is(token, "thing_articles") || NumberWord(text_.At(token))) return true;
  return !text_.IsSign(token) && !text_.Is(token, "thing_ends");
}

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
