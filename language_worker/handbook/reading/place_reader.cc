// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_reader.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fmt/format.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/landmark.h"
#include "language_worker/handbook/reading/noun_book.h"
#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/place_details.h"
#include "language_worker/handbook/reading/place_parties.h"
#include "language_worker/handbook/reading/place_patterns.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {
namespace {

constexpr std::size_t kMostPlacesNotKnown = 8;

// Whose place it is and what it is told by depend on what was read last and on pieces that only tell where others go.
class PlaceReader : Reading {
 public:
  PlaceReader(const Reading& reading, const PieceNames& names, const std::vector<Mention>& mentions,
              std::function<int(const hb::Furniture&)> rank)
      : Reading(reading),
        mentions_(mentions),
        landmarks_(tokens(), names, std::move(rank)),
        patterns_(handbook, tokens(), landmarks_),
        named_(tokens(), mentions),
        areas_(AreasIn(text, mentions, named_)),
        by_landmark_(mentions.size(), false),
        subjects_(tokens(), mentions, named_, by_landmark_, landmarks_, areas_),
        targets_(mentions, named_, by_landmark_, facts.places) {}

  void Read() {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      // "A window over the sink" is the sink's place.
      const bool taken = used[i] && text.At(i) != "window";
      if (i < read_to_ || taken || named_.At(i) || tokens()[i].kind != Token::Kind::kWord) continue;
      if (!TakePlace(i)) NoteUnread(i);
    }
    StandTogether(*this, mentions_, named_, areas_, patterns_);
    DropRowsAround(facts.places);
    HangWhatIsFaced(patterns_, facts, LooksToTheFront());
  }

 private:
  using Match = PlacePatterns::Match;
  bool TakePlace(std::size_t i) {
    if (patterns_.IsDenied(i) || IsNoPlace(i)) return false;
    // The longest words first: "on the wall above it" is more than "on the wall".
    std::vector<Match> matches = patterns_.MatchesAt(i);
    const std::optional<Subject> before = subjects_.Before(i);
    const bool of_a_wall = OpensSentence(i) || (before && before->furniture->back() == hb::BACK_RULE_WALL);
    for (Match& match : matches) {
      if (before && match.landmark.kind == Landmark::Kind::kPronoun && !match.landmark.each_other)
        TakeWindowForIt(text, patterns_, mentions_, before->mention, i, match);
    }
    if (const auto match = PlaceByItself(text, i, patterns_, of_a_wall ? targets_.OppositeOfLast() : ""))
      matches.insert(matches.begin(), *match);
    for (auto begin = matches.begin(), end = begin; begin != matches.end(); begin = end) {
      end = std::find_if(begin, matches.end(), [&](const Match& one) { return one.length != begin->length; });
      for (const bool otherwise : {false, true}) {
        if (std::any_of(begin, end, [&](const Match& match) { return Take(match, i, otherwise); })) return true;
      }
    }
    return false;
  }

  // "Accompanied by four chairs" is no place, "placed by the window" is; nor are "three round tables".
  bool IsNoPlace(std::size_t i) const {
    if (i == 0) return false;
    const bool counted = text.IsNumber(i - 1) || NumberWord(text.At(i - 1)) || text.Is(i - 1, "thing_articles");
    if (text.At(i) == "round" && (counted || text.Is(i - 1, "looks"))) return true;
    return text.At(i) == "by" && text.At(i - 1).ends_with("ed") && !text.Is(i - 1, "place_fillers");
  }

  bool Take(const Match& match, std::size_t i, bool otherwise) {
    const std::vector<Subject> subjects = SubjectsOf(match, i, otherwise);
    bool any = false;
    for (const Subject& subject : subjects) any = Put(subject, match, i, otherwise) || any;
    if (!any) return false;
    Use(i, match.end);
    for (std::size_t k = i; k < match.end; ++k) {
      if (const std::optional<std::size_t> m = named_.At(k)) by_landmark_[*m] = true;
    }
    subjects_.Remember(subjects.front(), match.end);
    read_to_ = match.end;
    return true;
  }

  // Whose place it is: one piece, or several that are named together.
  std::vector<Subject> SubjectsOf(const Match& match, std::size_t i, bool otherwise) const {
    const hb::AskedPlace& asked = *match.asked;
    if (asked.target_first()) {
      const std::optional<std::size_t> first = named_.From(match.end);
      return first ? Together(*first, +1, asked, match.landmark.kind) : std::vector<Subject>();
    }
    // "Space to walk round the bed": it is said of the bed alone.
    const bool alone = match.landmark.kind == Landmark::Kind::kPiece && !AskedNames(asked, "{target}") &&
                       !AskedNames(asked, "{first}");
    for (std::size_t k = i; alone && k < match.end; ++k) {
      if (const std::optional<std::size_t> m = named_.At(k)) return {subjects_.Of(*m)};
    }
    if (!asked.category().empty()) {
      for (std::size_t m = mentions_.size(); m-- > 0;) {
        if (mentions_[m].end <= i && mentions_[m].furniture->category() == asked.category()) return {subjects_.Of(m)};
      }
      return {};
    }
    std::optional<Subject> subject = subjects_.After(i, match.end);
    const bool after = subject.has_value();
    if (!after) subject = subjects_.Before(i, match.landmark.kind == Landmark::Kind::kPronoun);
    if (!subject) return {};
    if (!otherwise && match.landmark.kind != Landmark::Kind::kWall) TakeStand(*this, match, subject->furniture);
    const std::optional<Subject> holder = after ? std::nullopt : subjects_.HolderOf(*subject);
    // "A basin with a mirror on the right wall": nobody tells the mirror's wall apart from the basin's.
    const bool of_both = holder && !match.landmark.side.empty() && AskedNames(asked, "{wall}") &&
                         IsOnTheFloor(*holder->furniture) && !IsOnTheFloor(*subject->furniture);
    if (of_both && !otherwise && !IsFor(asked, *holder->furniture, false)) return {};
    if (holder && IsFor(asked, *holder->furniture, otherwise) && !IsSideOfItsTable(match, *subject) &&
        (!IsFor(asked, *subject->furniture, otherwise) ||
         IsOfTheHolder(match, *subject->furniture, *holder->furniture))) {
      subject = holder;
    }
    if (!IsFor(asked, *subject->furniture, otherwise)) return {};
    if (asked.carried() == hb::CARRIED_ALONG) return {*subject};
    if (after && OpensSentence(i) && IsPartOfTheRoom(match.landmark)) return ListedBehind(*subject, match);
    if (!GoesAlong(*subject->furniture, match.landmark.kind)) {
      const bool shares = !after && !AskedNames(asked, "{first}") && asked.relation().pairing() != hb::PAIRING_TOGETHER;
      const std::optional<Subject> other = shares ? subjects_.SharerOf(*subject) : std::nullopt;
      if (!other || !IsFor(asked, *other->furniture, otherwise)) return {*subject};
      return {*subject, *other};
    }
    std::vector<Subject> all = Together(subject->mention, after ? +1 : -1, asked, match.landmark.kind);
    all.front() = *subject;
    return all;
  }

  std::size_t BeginOfSentence(std::size_t i) const {
    constexpr std::size_t kMostWords = 40;
    const std::size_t least = i - std::min(i, kMostWords);
    while (i > least && !OpensSentence(i)) --i;
    return i;
  }

  bool OpensSentence(std::size_t i) const { return i == 0 || text.EndsSentence(i - 1); }

  // "On the right wall a desk with a chair, a TV and a cabinet": all that stand on the floor and have no place of their
  // own behind them.
  std::vector<Subject> ListedBehind(const Subject& first, const Match& match) const {
    std::vector<Subject> all = {first};
    for (std::size_t m = first.mention + 1; m < mentions_.size() && named_.AreListed(m - 1, m); ++m) {
      Subject one = subjects_.Of(m);
      // "Wall bars, a mat in front of them and a rack": the mat's place is at that wall, too.
      if (const auto place = OwnPlace(m); place && place->landmark.kind != Landmark::Kind::kPronoun) break;
      if (OwnPlace(m)) continue;
      TakeStand(*this, match, one.furniture);
      if (!subjects_.HolderOf(one) && IsFor(*match.asked, *one.furniture, false)) all.push_back(one);
    }
    return all;
  }

  std::optional<Match> OwnPlace(std::size_t m) const {
    std::size_t end = mentions_[m].end;
    while (end < tokens().size() && text.Is(end, "place_fillers")) ++end;
    const std::vector<Match> matches = end < tokens().size() ? patterns_.MatchesAt(end) : std::vector<Match>();
    return matches.empty() ? std::nullopt : std::optional(matches.front());
  }

  // Whether the place of what is listed before or behind it is its place, too: small things that have none of their
  // own.
  bool GoesWithOthers(std::size_t m, int step, const hb::AskedPlace& asked, Landmark::Kind kind) const {
    const hb::Furniture& furniture = *mentions_[m].furniture;
    const bool carried = asked.carried() != hb::CARRIED_UNSPECIFIED;
    if (!IsFor(asked, furniture, false) && !(carried && IsFor(asked, furniture, true))) return false;
    if (!carried && !GoesAlong(furniture, kind)) return false;
    const bool placed = std::ranges::any_of(facts.places, [&](const Place& place) {
      return place.furniture == &furniture && place.asked->carried() != hb::CARRIED_UNSPECIFIED;
    });
    return !placed && !(step > 0 && OwnPlace(m));
  }

  // The mention and its neighbours to one side that are listed with it: "a vase, a wooden tray and two candles".
  std::vector<Subject> Together(std::size_t mention, int step, const hb::AskedPlace& asked, Landmark::Kind kind) const {
    std::vector<Subject> all;
    for (std::size_t m = mention; m < mentions_.size(); m += static_cast<std::size_t>(step)) {
      const std::size_t first = step > 0 ? m - 1 : m, second = first + 1;
      if (m != mention &&
          (by_landmark_[m] || !named_.AreListed(first, second) || !GoesWithOthers(m, step, asked, kind)))
        break;
      all.push_back(subjects_.Of(m));
      if (step < 0 && m == 0) break;
    }
    return all;
  }

  // "An island with two stools on one side".
  bool IsSideOfItsTable(const Match& match, const Subject& subject) const {
    const bool sits = mentions_[subject.mention].seats || subject.furniture->category() == "bench";
    return sits && AskedNames(*match.asked, "{wall}") && text.Says(match.end - 1, {"side", "sides"});
  }

  // Whether the piece got the place.
  bool Put(const Subject& subject, const Match& match, std::size_t i, bool otherwise) {
    const hb::AskedPlace& asked = *match.asked;
    if (!IsFor(asked, *subject.furniture, otherwise)) return false;
    if (AskedNames(asked, "{first}") && match.landmark.beside != Landmark::Kind::kNone) {
      return PutNearBoth(subject, match, i);
    }
    // Seats at a table face each other, and are in a row, as it is.
    const bool together = mentions_[subject.mention].seats && asked.relation().pairing() == hb::PAIRING_TOGETHER;
    if (together || IsSideOfItsTable(match, subject)) return true;
    Place place;
    place.furniture = otherwise ? StorageAlong(*this, i, asked, *subject.furniture) : subject.furniture;
    place.asked = &asked;
    place.which = subject.which;
    const std::size_t m = subject.mention;
    if ((m == 0 || BeginOfSentence(i) >= mentions_[m - 1].end) &&
        PutBetweenWindows(text, patterns_, BeginOfSentence(i), i, match.end, place, facts.openings)) {
      Keep(place, subject, i, match.end);
      return true;
    }
    if (!(asked.target_first() ? TakeCarrier(i, place) : targets_.Find(subject.mention, match, place))) {
      // Seats that are counted with their table stand there anyway.
      return asked.target_first() && place.target == place.furniture;
    }
    if (m > 0 && mentions_[m].count == 1 && named_.AreListed(m - 1, m)) {
      TakeTwo(*mentions_[m - 1].furniture, patterns_, place);
    }
    // Benches "on both sides" of a table are along it.
    const bool bench = place.furniture->category() == "bench" && place.target != nullptr &&
                       StandsWith(*place.furniture, *place.target) && text.Says(match.end - 1, {"side", "sides", "it"});
    if (bench && place.target->category().ends_with("table")) return true;
    TakeWhatHangs(patterns_, place, LooksToTheFront());
    TakeWallAcross(patterns_, match.landmark.kind, text.Is(i, "looking"), facts.openings, place);
    if (AskedNames(*place.asked, "in a corner")) TakeCorner(match.landmark.kind, facts, place);
    // Where people sit in rows, the front is what they look at; elsewhere, as in a shop, it is where one comes in.
    if (LooksToTheFront()) place.side = SeenByAnAudience(place.side);
    if (AskedNames(asked, "{wall}")) place.walls = WallsIn(text, i, match.end);
    if (asked.length_m() > 0) place.length_m = LengthBeside(*this, i, match.end).value_or(asked.length_m());
    if (subject.further) {
      for (Place& before : facts.places) {
        if (before.furniture == place.furniture && before.which < 0) before.which = 0;
      }
    }
    Keep(place, subject, i, match.end);
    NoteLoosely(*this, place, i, i + match.length);
    // "A lamp on either side" makes two of one, "a nightstand with a lamp on either side" two of both.
    const hb::Furniture* with = ComesWith(text, mentions_, m);
    for (Wish& wish : facts.wishes) {
      const int least =
          std::max({place.asked->relation().condition().min_count(), OneForEach(*this, place, i, match.end),
                    subject.further ? 2 : 1, place.walls > 1 && !wish.counted ? 2 * place.walls : 1});
      if (wish.furniture == place.furniture || wish.furniture == with) wish.count = std::max(wish.count, least);
    }
    return true;
  }

  void Keep(Place& place, const Subject& subject, std::size_t begin, std::size_t end) {
    place.said = text.Quote(begin, end);
    place.called = text.Quote(mentions_[subject.mention].begin, mentions_[subject.mention].end);
    facts.places.push_back(place);
  }

  // "Between the sofa and the window": no sentence asks for it, but near both it is between them, more or less.
  bool PutNearBoth(const Subject& subject, const Match& match, std::size_t i) {
    const bool door = match.landmark.beside == Landmark::Kind::kDoor;
    for (const std::string_view slot : {"target", door ? "door" : "window"}) {
      Place place;
      place.asked = patterns_.Find("near", slot, hb::FURNITURE_KIND_FLOOR);
      if (place.asked == nullptr || !IsOnTheFloor(*subject.furniture)) return false;
      place.furniture = subject.furniture;
      place.which = subject.which;
      if (slot == "target") place.target = match.landmark.piece;
      if (place.target == place.furniture) return false;
      Keep(place, subject, i, match.end);
    }
    facts.places_loosely_kept.push_back(
        fmt::format("Not just as asked: \"{}\": it is near both.", facts.places.back().Words()));
    return true;
  }

  bool LooksToTheFront() const { return IsIn("look_to_the_front", facts.archetype->per_person()); }

  // What stands before "holds": right before it, else the last in the sentence that is no thing on a top itself.
  bool TakeCarrier(std::size_t i, Place& place) const {
    const auto take = [&](const hb::Furniture* carrier) {
      place.target = carrier;
      if (AskedNames(*place.asked, "{first}")) place.other = carrier;
      return carrier != place.furniture;
    };
    std::optional<Subject> before = subjects_.Before(i);
    if (subjects_.EndedAt(i) && before && by_landmark_[before->mention]) before = subjects_.last();
    if (before) return take(before->furniture);
    for (std::size_t at = i; at > 0 && !text.EndsSentence(at - 1); --at) {
      const std::optional<std::size_t> m = named_.EndingAt(at);
      if (m && !IsOnATop(*mentions_[*m].furniture)) return take(mentions_[*m].furniture);
    }
    return false;
  }

  // Words for a place of which nothing could be made, so that they do not go unheard.
  void NoteUnread(std::size_t i) {
    // "A store room behind the kitchen": where it lies in the house.
    for (std::size_t k = i + 1; k < i + 4 && !subjects_.Before(i); ++k) {
      const bool room = LongestAt(handbook.vocabulary().rooms, tokens(), k, /*plural=*/false).second > 0;
      if (!room || landmarks_.FeatureAt(k) != Landmark::Kind::kNone || named_.At(k)) continue;
      Tell(i, k + 1);
      return;
    }
    const bool phrase = std::ranges::any_of(
        PhrasesOf("place_phrases"), [&](const Phrase& one) { return one.MatchAt(tokens(), i, /*plural=*/false) > 0; });
    const auto named = [&](const Match& match) { return match.length > 1; };
    if (!phrase && !IsIn("place_words", tokens()[i].text) && std::ranges::none_of(patterns_.MatchesAt(i), named))
      return;
    if (i + 1 < tokens().size() && tokens()[i + 1].kind == Token::Kind::kNumber) return;  // "under 20 m2"
    // "Under or between the windows", "people can walk between them".
    if (text.At(i + 1) == "or" && !patterns_.MatchesAt(i + 2).empty()) return;
    if (i > 0 && text.Is(i - 1, "verbs_of_passing")) return;
    std::size_t begin = i;
    while (begin > 0 &&
           (IsIn("place_fillers", text.At(begin - 1)) || text.At(begin - 1) == "in" || text.At(begin - 1) == "the"))
      --begin;
    const std::optional<Subject> subject = subjects_.Before(i);
    if (!subject && !subjects_.After(i, i + 1) && !SpeaksOfAPiece(i)) return;
    std::size_t end = i + 1;
    constexpr std::size_t kMostWords = 8;
    while (end < tokens().size() && end < i + kMostWords && tokens()[end].text != "," && tokens()[end].text != "and" &&
           tokens()[end].text != "with" && !text.EndsSentence(end)) {
      ++end;
    }
    read_to_ = end;
    Tell(i, end);
    if (!subject) begin = i - std::min<std::size_t>(i, 4);
    while (!subject && begin < i && (tokens()[begin].kind == Token::Kind::kSign || text.At(begin) == "and")) ++begin;
    std::string said = text.Quote(subject ? i : begin, end);
    if (subject) said = subject->furniture->name() + " " + said;
    if (facts.places_not_known.size() < kMostPlacesNotKnown && !Includes(facts.places_not_known, said)) {
      facts.places_not_known.push_back(std::move(said));
    }
  }

  // Whether a place without a piece of its own most likely tells of one whose name is not known: "plants in the far
  // left corner".
  bool SpeaksOfAPiece(std::size_t i) const {
    if (mentions_.empty()) return false;
    const bool corner =
        landmarks_.FeatureAt(i) == Landmark::Kind::kCorner && i > 0 && IsIn("which_corner", text.At(i - 1));
    return corner || IsIn("sure_places", text.At(i));
  }

  const std::vector<Mention>& mentions_;
  const LandmarkReader landmarks_;
  const PlacePatterns patterns_;
  const MentionList named_;
  const std::vector<NamedArea> areas_;
  std::vector<bool> by_landmark_;  // of a mention: it only tells where another one goes
  SubjectFinder subjects_;
  const TargetFinder targets_;
  std::size_t read_to_ = 0;
};

}  // namespace

void ReadPlaces(const Reading& reading, const std::vector<Mention>& mentions) {
  const auto& [handbook, text, used, facts] = reading;
  const NounBook nouns(handbook, facts);
  const auto rank = [&](const hb::Furniture& furniture) {
    // What is wished for first is most often what is spoken of again.
    constexpr std::ptrdiff_t kMost = 200;
    const auto wish = std::ranges::find(facts.wishes, &furniture, &Wish::furniture);
    const auto after = std::min(kMost, wish - facts.wishes.begin());
    const bool wished = wish != facts.wishes.end();
    return nouns.RankOf(furniture) + (wished ? static_cast<int>(1024 + 2 * (kMost - after)) : 0);
  };
  // "The sofa" is also a corner sofa that was asked for.
  PieceNames names = nouns.names();
  for (const Wish& wish : facts.wishes)
    names.more.push_back({Phrase(LastWord(wish.furniture->name())), wish.furniture});
  for (const Vocabulary::Head& head : handbook.vocabulary().heads) {
    for (const Wish& wish : facts.wishes) {
      if (!Includes(head.options, wish.furniture)) continue;
      for (const Phrase& word : head.words) names.more.push_back({word, wish.furniture});
    }
  }
  PlaceReader(reading, names, mentions, rank).Read();
}

}  // namespace flair::language
