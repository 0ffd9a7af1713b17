// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_reader.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

// Whether the sentence of a place speaks of that slot: "{target}".
bool AskedNames(const hb::AskedPlace& asked, std::string_view slot) {
  return asked.relation().text().find(slot) != std::string::npos;
}

constexpr std::size_t kMostPlacesNotKnown = 8;

// Kinds that a place is for; pieces that stand on the floor when it does not say.
bool IsFor(const hb::AskedPlace& asked, const hb::Furniture& furniture) {
  const bool floor = furniture.kind() == hb::FURNITURE_KIND_UNSPECIFIED || furniture.kind() == hb::FURNITURE_KIND_FLOOR;
  if (asked.kinds().empty()) return floor && (!furniture.walk_over() || !AskedNames(asked, "under the {target}"));
  return std::ranges::find(asked.kinds(), static_cast<int>(furniture.kind())) != asked.kinds().end() &&
         (!floor || furniture.walk_over());
}

class PlaceReader {
 public:
  PlaceReader(const Handbook& handbook, const std::vector<Token>& tokens,
              const std::vector<Saying<hb::Furniture>>& names, const std::vector<Mention>& mentions,
              std::function<int(const hb::Furniture&)> rank, std::vector<bool>& used, BriefFacts& facts)
      : handbook_(handbook),
        tokens_(tokens),
        text_(tokens),
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

  void Read() {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const bool piece = mention_at_[i] < mentions_.size();
      if (i < read_to_ || used_[i] || piece || tokens_[i].kind != Token::Kind::kWord) continue;
      if (!TakePlace(i)) NoteUnread(i);
    }
  }

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
    int which = -1;  // of several: the first, the second; -1 for all
  };
  // What was read last: its subject, and where it ends.
  struct Last {
    Subject subject;
    std::size_t end = 0;
  };

  void AddPatterns() {
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

  // The longest first; of equally long ones those that say by what.
  std::vector<Match> MatchesAt(std::size_t i) const {
    std::vector<Match> matches;
    const bool negated = Denies(i);
    const auto found = patterns_.find(negated ? "not" : tokens_[i].text);
    if (found == patterns_.end()) return matches;
    std::size_t start = i + (negated ? 1 : 0);
    while (negated && start < i + 4 && IsIn("place_fillers", text_.At(start))) ++start;
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

  bool Denies(std::size_t i) const { return text_.Says(i, {"not", "never"}); }

  bool IsDenied(std::size_t i) const {
    constexpr std::size_t kMostWords = 4;
    for (std::size_t at = i; at > 0 && at + kMostWords > i; --at) {
      if (Denies(at - 1)) return true;
      if (!IsIn("place_fillers", text_.At(at - 1))) return false;
    }
    return false;
  }

  // Whether no noun follows that a place could be told by.
  bool EndsPhrase(std::size_t i) const {
    return i >= tokens_.size() || tokens_[i].kind == Token::Kind::kSign || IsIn("place_ends", text_.At(i));
  }

  bool Fits(const Pattern& pattern, const Landmark& landmark) const {
    using Kind = Landmark::Kind;
    const std::string& slot = pattern.slot;
    const Kind kind = landmark.kind;
    for (const auto& [name, feature] : {std::pair("door", Kind::kDoor), std::pair("window", Kind::kWindow),
                                        std::pair("wall", Kind::kWall), std::pair("corner", Kind::kCorner)}) {
      if (slot == name) return kind == feature;
    }
    const bool piece = kind == Kind::kPiece || kind == Kind::kPronoun;
    const bool two = landmark.second != nullptr || landmark.plural;
    return piece && (slot == "target" || (slot == "targets" && two));
  }

  Subject SubjectOf(std::size_t mention, int which) const { return {mentions_[mention].furniture, mention, which}; }

  // What stands right before the place, over verbs, commas and what was said of its place before.
  std::optional<Subject> SubjectBefore(std::size_t i) const {
    constexpr std::size_t kMostFillers = 10;
    bool joined = false;
    for (std::size_t at = i; at > 0 && at + kMostFillers > i; --at) {
      if (last_ && last_->end == at) {
        const std::optional<std::size_t> m = MentionEndingAt(at);
        if (!m || joined) return last_->subject;
      }
      if (const std::optional<std::size_t> m = MentionEndingAt(at)) return SubjectOf(*m, mentions_[*m].which);
      const Token& before = tokens_[at - 1];
      const std::optional<std::size_t> earlier = LastMentionBefore(at - 1);
      const bool other = before.text == "other" || before.text == "another" || before.text == "second";
      if (earlier && (before.text == "one" || other) && mentions_[*earlier].count > 1) {
        const bool again = last_ && last_->subject.which == 0 && last_->subject.mention == *earlier;
        return SubjectOf(*earlier, other || again ? 1 : 0);
      }
      if (earlier && (IsIn("singular_pronouns", before.text) || IsIn("plural_pronouns", before.text))) {
        return SubjectOf(*earlier, mentions_[*earlier].which);
      }
      joined = joined || before.text == "," || before.text == "and" || before.text == "but";
      const bool sign = before.kind == Token::Kind::kSign && !text_.EndsSentence(at - 1) && before.text != "(";
      const bool filler = IsIn("place_fillers", before.text) || IsIn("group_fillers", before.text) ||
                          before.text == "and" || before.text == "but" || before.text == "the" || before.text == "of";
      if (!sign && !filler && before.kind != Token::Kind::kNumber) return std::nullopt;
    }
    return std::nullopt;
  }

  // "Under the window a desk", "next to the bed there is a nightstand".
  std::optional<Subject> SubjectAfter(std::size_t begin, std::size_t end) const {
    constexpr std::size_t kMostBetween = 6;
    const bool first = begin == 0 || text_.EndsSentence(begin - 1) || tokens_[begin - 1].text == ":";
    const bool aside = begin > 1 && text_.At(begin - 1) == "," && IsIn("place_openers", text_.At(begin - 2));
    const bool opens = first || tokens_[begin - 1].text == "," || IsIn("place_openers", tokens_[begin - 1].text);
    if (!opens || end >= tokens_.size()) return std::nullopt;
    int others = 0;
    bool noun_phrase = false;
    for (std::size_t i = end; i < tokens_.size() && i < end + kMostBetween; ++i) {
      if (mention_at_[i] < mentions_.size()) {
        const std::size_t m = mention_at_[i];
        if (!first && !noun_phrase) return std::nullopt;
        return SubjectOf(m, mentions_[m].which);
      }
      const Token& token = tokens_[i];
      if (token.kind == Token::Kind::kSign && !((first || aside) && token.text == ",")) return std::nullopt;
      if (token.text == "and" || token.text == "with" || token.text == "or") return std::nullopt;
      const bool known =
          IsIn("before_subjects", token.text) || token.kind == Token::Kind::kSign || NumberWord(token.text);
      noun_phrase = noun_phrase || NumberWord(token.text) || token.text == "the" || token.kind == Token::Kind::kNumber;
      // Words for its looks.
      if (!known && (!noun_phrase || ++others > 2)) return std::nullopt;
    }
    return std::nullopt;
  }

  // "a desk for writing letters by the window": the last piece of the sentence when nothing else can stand there.
  std::optional<Subject> LooseSubjectBefore(std::size_t i) const {
    constexpr std::size_t kMostWords = 12;
    for (std::size_t at = i; at > 0 && at + kMostWords > i; --at) {
      if (text_.EndsSentence(at - 1)) return std::nullopt;
      if (const std::optional<std::size_t> m = MentionEndingAt(at)) {
        if (by_landmark_[*m]) return std::nullopt;
        return SubjectOf(*m, mentions_[*m].which);
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

  std::optional<std::size_t> MentionEndingAt(std::size_t end) const {
    if (end == 0 || mention_at_[end - 1] == mentions_.size()) return std::nullopt;
    return mention_at_[end - 1];
  }

  std::optional<std::size_t> LastMentionBefore(std::size_t i) const {
    for (std::size_t m = mentions_.size(); m-- > 0;) {
      if (mentions_[m].end <= i && !by_landmark_[m]) return m;
    }
    return std::nullopt;
  }

  // Finds what the landmark stands for; false when there is no such thing.
  bool Resolve(const Subject& subject, const Match& match, Place& place) const {
    const hb::AskedPlace& asked = *match.pattern->asked;
    place.side = match.landmark.side;
    if (AskedNames(asked, "{first}")) return TakePair(subject, match, place);
    if (!AskedNames(asked, "{target}")) return true;
    if (match.landmark.kind != Landmark::Kind::kPiece) return TakePronoun(subject, match.landmark.plural, place);
    place.target = match.landmark.piece;
    return place.target != subject.furniture;
  }

  // "between the sofa and the fireplace", "between the armchairs", "between them".
  bool TakePair(const Subject& subject, const Match& match, Place& place) const {
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
  bool TakePronoun(const Subject& subject, bool plural, Place& place) const {
    for (std::size_t m = subject.mention; m-- > 0;) {
      const Mention& mention = mentions_[m];
      if (mention.furniture == subject.furniture) continue;
      if (place.target == nullptr || (plural && mention.count > 1)) place.target = mention.furniture;
      if (!plural || mention.count > 1) break;
    }
    return place.target != nullptr;
  }

  bool TakePlace(std::size_t i) {
    if (IsDenied(i)) return false;
    for (Match& match : MatchesAt(i)) {
      std::optional<Subject> subject = SubjectAfter(i, match.end);
      if (!subject) subject = SubjectBefore(i);
      if (!subject) subject = LooseSubjectBefore(i);
      if (!subject || !IsFor(*match.pattern->asked, *subject->furniture)) continue;
      Place place;
      place.furniture = subject->furniture;
      place.asked = match.pattern->asked;
      place.which = subject->which;
      if (!Resolve(*subject, match, place)) continue;
      place.said = text_.Quote(i, match.end);
      facts_.places.push_back(place);
      NoteLoosely(place, i, i + match.length);
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

  // Directions that the sentence does not have: of "to the left of the window" only "near the window" is left.
  void NoteLoosely(const Place& place, std::size_t begin, std::size_t end) {
    const std::string& text = place.asked->relation().text();
    for (std::size_t k = begin; k < end; ++k) {
      if (!IsIn("exact_directions", text_.At(k)) || text.find(text_.At(k)) != std::string::npos) continue;
      facts_.places_loosely_kept.push_back(
          fmt::format("\"{} {}\": it {}", place.furniture->name(), place.said, text.substr(text.find('}') + 2)));
      return;
    }
  }

  // Words for a place of which nothing could be made, so that they do not go unheard.
  void NoteUnread(std::size_t i) {
    const bool phrase = std::ranges::any_of(
        PhrasesOf("place_phrases"), [&](const Phrase& one) { return one.MatchAt(tokens_, i, /*plural=*/false) > 0; });
    if (!phrase && !IsIn("place_words", tokens_[i].text)) return;
    if (i + 1 < tokens_.size() && tokens_[i + 1].kind == Token::Kind::kNumber) return;  // "under 20 m2"
    std::size_t begin = i;
    while (begin > 0 &&
           (IsIn("place_fillers", text_.At(begin - 1)) || text_.At(begin - 1) == "in" || text_.At(begin - 1) == "the"))
      --begin;
    std::optional<Subject> subject = SubjectBefore(i);
    if (!subject) subject = LooseSubjectBefore(i);
    if (!subject && !SubjectAfter(i, i + 1) && !SpeaksOfAPiece(i)) return;
    std::size_t end = i + 1;
    constexpr std::size_t kMostWords = 8;
    while (end < tokens_.size() && end < i + kMostWords && tokens_[end].text != "," && tokens_[end].text != "and" &&
           tokens_[end].text != "with" && !text_.EndsSentence(end)) {
      ++end;
    }
    read_to_ = end;
    for (std::size_t k = i; k < end; ++k) facts_.told.push_back(k);
    if (!subject) begin = i - std::min<std::size_t>(i, 4);
    while (!subject && begin < i && (tokens_[begin].kind == Token::Kind::kSign || text_.At(begin) == "and")) ++begin;
    std::string said = text_.Quote(subject ? i : begin, end);
    if (subject) said = subject->furniture->name() + " " + said;
    if (facts_.places_not_known.size() < kMostPlacesNotKnown && !Includes(facts_.places_not_known, said)) {
      facts_.places_not_known.push_back(std::move(said));
    }
  }

  // Whether a place without a piece of its own most likely tells of one whose name is not known: "plants in the far
  // left corner".
  bool SpeaksOfAPiece(std::size_t i) const {
    if (mentions_.empty()) return false;
    const bool corner =
        landmarks_.FeatureAt(i) == Landmark::Kind::kCorner && i > 0 && IsIn("which_corner", text_.At(i - 1));
    return corner || IsIn("sure_places", text_.At(i));
  }

  const Handbook& handbook_;
  const std::vector<Token>& tokens_;
  const BriefText text_;
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

}  // namespace

void ReadPlaces(const Handbook& handbook, const std::vector<Token>& tokens,
                const std::vector<Saying<hb::Furniture>>& names, const std::vector<Mention>& mentions,
                std::function<int(const hb::Furniture&)> rank, std::vector<bool>& used, BriefFacts& facts) {
  PlaceReader(handbook, tokens, names, mentions, std::move(rank), used, facts).Read();
}

}  // namespace flair::language
