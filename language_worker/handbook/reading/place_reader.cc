// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_reader.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/place_words.h"

namespace flair::language {
namespace {

constexpr std::size_t kMostPlacesNotKnown = 8;

// Words that tell a place whenever they stand in a text about furniture.
constexpr std::array<std::string_view, 23> kPlaceWords = {
    "between", "beside",     "opposite",  "facing",        "behind",   "against", "near",   "underneath",
    "beneath", "under",      "below",     "above",         "flanking", "flanked", "corner", "parallel",
    "backing", "diagonally", "alongside", "perpendicular", "middle",   "centre",  "center"};

// Kinds that a place is for; pieces that stand on the floor when it does not say.
bool IsFor(const hb::AskedPlace& asked, const hb::Furniture& furniture) {
  const bool floor = furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED || furniture.kind() == hb::FURNITURE_KIND_FLOOR;
  if (asked.kinds().empty()) return floor && (!furniture.walk_over() || !AskedNames(asked, "under the {target}"));
  return std::ranges::find(asked.kinds(), static_cast<int>(furniture.kind())) != asked.kinds().end() &&
         (!floor || furniture.walk_over());
}

}  // namespace

PlaceReader::PlaceReader(const Handbook& handbook, const std::vector<Token>& tokens,
                         const std::vector<Saying<hb::Furniture>>& names, const std::vector<Mention>& mentions,
                         std::function<int(const hb::Furniture&)> rank, std::vector<bool>& used, BriefFacts& facts)
    : handbook_(handbook),
      tokens_(tokens),
      mentions_(mentions),
      used_(used),
      facts_(facts),
      landmarks_(tokens, names, std::move(rank)),
      mention_at_(tokens.size(), mentions.size()),
      by_landmark_(mentions.size(), false) {
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    for (std::size_t i = mentions[m].begin; i < mentions[m].end; ++i) mention_at_[i] = m;
  }
  AddPatterns();
}

void PlaceReader::AddPatterns() {
  for (const hb::AskedPlace& asked : handbook_.contents().asked_places()) {
    for (const std::string& words : asked.words()) {
      const std::size_t brace = std::min(words.find('{'), words.size());
      std::string slot = brace < words.size() ? words.substr(brace + 1, words.size() - brace - 2) : "";
      const std::string first = words.substr(0, words.find(' '));
      // "Not" may stand apart from the rest: "must not be placed near the door".
      const std::size_t from = first == "not" ? first.size() : 0;
      patterns_[first].push_back({Phrase(words.substr(from, brace - from)), std::move(slot), &asked});
    }
  }
}

void PlaceReader::Read() {
  for (std::size_t i = 0; i < tokens_.size(); ++i) {
    const bool piece = mention_at_[i] < mentions_.size();
    if (i < read_to_ || used_[i] || piece || tokens_[i].kind != Token::Kind::kWord) continue;
    if (!TakePlace(i)) NoteUnread(i);
  }
}

std::string_view PlaceReader::Word(std::size_t i) const {
  return i < tokens_.size() ? std::string_view(tokens_[i].text) : std::string_view();
}

// The longest first; of equally long ones those that say by what.
std::vector<PlaceReader::Match> PlaceReader::MatchesAt(std::size_t i) const {
  std::vector<Match> matches;
  const bool negated = Denies(i);
  const auto found = patterns_.find(negated ? "not" : tokens_[i].text);
  if (found == patterns_.end()) return matches;
  std::size_t start = i + (negated ? 1 : 0);
  while (negated && start < i + 4 && IncludesWord(kPlaceFillers, Word(start))) ++start;
  for (const Pattern& pattern : found->second) {
    Match match{&pattern, {}, pattern.words.MatchAt(tokens_, start, /*plural=*/false), 0};
    if (match.length == 0) continue;
    match.end = start + match.length;
    if (pattern.slot.empty()) {
      const bool needs_piece = AskedNames(*pattern.asked, "{target}") || AskedNames(*pattern.asked, "{first}");
      if (needs_piece && !EndsPhrase(match.end)) continue;
    } else {
      match.landmark = landmarks_.Read(match.end);
      if (!Fits(pattern, match.landmark)) continue;
      match.end = match.landmark.end;
    }
    matches.push_back(match);
  }
  std::ranges::stable_sort(matches, [](const Match& a, const Match& b) {
    return a.length != b.length ? a.length > b.length : a.end > b.end;
  });
  return matches;
}

// "not", "never", the rest of "isn't".
bool PlaceReader::Denies(std::size_t i) const {
  return Word(i) == "not" || Word(i) == "never" || (Word(i) == "t" && i > 1 && Word(i - 1) == "'");
}

bool PlaceReader::IsDenied(std::size_t i) const {
  constexpr std::size_t kMostWords = 4;
  for (std::size_t at = i; at > 0 && at + kMostWords > i; --at) {
    if (Denies(at - 1)) return true;
    if (!IncludesWord(kPlaceFillers, Word(at - 1))) return false;
  }
  return false;
}

// Whether no noun follows that a place could be told by.
bool PlaceReader::EndsPhrase(std::size_t i) const {
  constexpr std::array<std::string_view, 9> kEnds = {"and",   "with", "but",   "so",  "for",
                                                     "which", "that", "while", "plus"};
  return i >= tokens_.size() || tokens_[i].kind == Token::Kind::kSign || IncludesWord(kEnds, Word(i));
}

bool PlaceReader::Fits(const Pattern& pattern, const Landmark& landmark) const {
  using Kind = Landmark::Kind;
  const std::string& slot = pattern.slot;
  if (slot == "door") return landmark.kind == Kind::kDoor;
  if (slot == "window") return landmark.kind == Kind::kWindow;
  if (slot == "wall") return landmark.kind == Kind::kWall;
  if (slot == "corner") return landmark.kind == Kind::kCorner;
  if (slot == "target") return landmark.kind == Kind::kPiece || landmark.kind == Kind::kPronoun;
  const bool two = landmark.second != nullptr || landmark.plural;
  return slot == "targets" && two && (landmark.kind == Kind::kPiece || landmark.kind == Kind::kPronoun);
}

bool PlaceReader::TakePlace(std::size_t i) {
  if (IsDenied(i)) return false;
  for (Match& match : MatchesAt(i)) {
    std::optional<Subject> subject = SubjectAfter(i, match.end);
    if (!subject) subject = SubjectBefore(i);
    if (!subject) subject = LooseSubjectBefore(i);
    if (!subject || !IsFor(*match.pattern->asked, *subject->furniture)) continue;
    Place place{subject->furniture, match.pattern->asked};
    place.which = subject->which;
    if (!Resolve(*subject, match, place)) continue;
    place.said = Quote(i, match.end);
    facts_.places.push_back(place);
    // "A lamp on either side" makes two of one.
    for (Wish& wish : facts_.wishes) {
      const int least = match.pattern->asked->relation().condition().min_count();
      if (wish.furniture == subject->furniture) wish.count = std::max(wish.count, least);
    }
    std::fill(used_.begin() + static_cast<std::ptrdiff_t>(i), used_.begin() + static_cast<std::ptrdiff_t>(match.end),
              true);
    for (std::size_t k = i; k < match.end; ++k) {
      if (mention_at_[k] < mentions_.size()) by_landmark_[mention_at_[k]] = true;
    }
    last_ = Last{*subject, match.end};
    read_to_ = match.end;
    return true;
  }
  return false;
}

// Words for a place of which nothing could be made, so that they do not go unheard.
void PlaceReader::NoteUnread(std::size_t i) {
  static const std::vector<Phrase> kPhrases = {
      Phrase("next to"),        Phrase("in front of"),  Phrase("across from"),  Phrase("close to"),
      Phrase("away from"),      Phrase("far from"),     Phrase("back to back"), Phrase("side by side"),
      Phrase("on either side"), Phrase("both sides"),   Phrase("each side"),    Phrase("on opposite"),
      Phrase("on the left"),    Phrase("on the right"), Phrase("to the left"),  Phrase("to the right"),
      Phrase("in rows"),        Phrase("in two rows"),  Phrase("in a row"),     Phrase("on top of"),
      Phrase("by the"),         Phrase("at the end"),   Phrase("at one end"),   Phrase("on the wall"),
      Phrase("over the"),       Phrase("around the"),   Phrase("round the"),    Phrase("at an angle"),
      Phrase("in line with"),   Phrase("in the alcove")};
  const bool phrase =
      std::ranges::any_of(kPhrases, [&](const Phrase& one) { return one.MatchAt(tokens_, i, /*plural=*/false) > 0; });
  if (!phrase && !IncludesWord(kPlaceWords, tokens_[i].text)) return;
  if (i + 1 < tokens_.size() && tokens_[i + 1].kind == Token::Kind::kNumber) return;  // "under 20 m2"
  std::size_t begin = i;
  while (begin > 0 &&
         (IncludesWord(kPlaceFillers, Word(begin - 1)) || Word(begin - 1) == "in" || Word(begin - 1) == "the"))
    --begin;
  std::optional<Subject> subject = SubjectBefore(i);
  if (!subject) subject = LooseSubjectBefore(i);
  if (!subject && !SubjectAfter(i, i + 1) && !SpeaksOfAPiece(i)) return;
  std::size_t end = i + 1;
  constexpr std::size_t kMostWords = 8;
  while (end < tokens_.size() && end < i + kMostWords && tokens_[end].text != "," && tokens_[end].text != "and" &&
         tokens_[end].text != "with" && !EndsSentence(tokens_[end])) {
    ++end;
  }
  read_to_ = end;
  if (!subject) begin = i - std::min<std::size_t>(i, 4);
  while (!subject && begin < i && (tokens_[begin].kind == Token::Kind::kSign || Word(begin) == "and")) ++begin;
  std::string said = Quote(subject ? i : begin, end);
  if (subject) said = subject->furniture->name() + " " + said;
  if (facts_.places_not_known.size() < kMostPlacesNotKnown && !IncludesWord(facts_.places_not_known, said)) {
    facts_.places_not_known.push_back(std::move(said));
  }
}

// Whether a place without a piece of its own most likely tells of one whose name is not known: "plants in the far left
// corner".
bool PlaceReader::SpeaksOfAPiece(std::size_t i) const {
  constexpr std::array<std::string_view, 9> kSure = {"between", "beside",   "opposite", "behind", "underneath",
                                                     "beneath", "flanking", "flanked",  "backing"};
  constexpr std::array<std::string_view, 8> kWhich = {"far",   "left",     "right", "back",
                                                      "other", "opposite", "hand",  "front"};
  if (mentions_.empty()) return false;
  const bool corner = landmarks_.FeatureAt(i) == Landmark::Kind::kCorner && i > 0 && IncludesWord(kWhich, Word(i - 1));
  return corner || IncludesWord(kSure, Word(i));
}

std::string PlaceReader::Quote(std::size_t begin, std::size_t end) const {
  std::string text;
  for (std::size_t i = begin; i < end; ++i) text += (i > begin && !tokens_[i].glued ? " " : "") + tokens_[i].text;
  return text;
}

}  // namespace flair::language
