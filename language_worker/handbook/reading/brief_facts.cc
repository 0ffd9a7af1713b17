// SPDX-License-Identifier: GPL-3.0-or-later
// Over 400 lines: one reading of a brief, whose steps share which words the earlier ones have used.
#include "language_worker/handbook/reading/brief_facts.h"

#include <algorithm>
#include <string_view>

#include "english/words.h"
#include "language_worker/handbook/reading/furniture_reader.h"
#include "language_worker/handbook/reading/named_sets.h"
#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/piece_looks.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/place_reader.h"
#include "language_worker/handbook/reading/room_kind.h"
#include "language_worker/handbook/reading/words.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// Reads one brief; each step marks the tokens that it has used, so that "dining room" wishes for no dining table and
// "green room" for no greenhouse.
class BriefReader : Reading {
 public:
  BriefReader(const Handbook& handbook, const std::vector<Token>& tokens)
      : Reading{handbook, text_, used_, facts_}, text_(tokens), used_(tokens.size()) {}

  // With the classes that it takes for what was left over, if asked.
  absl::StatusOr<BriefFacts> Read(std::vector<OwnClass>* own = nullptr) {
    ASSIGN_OR_RETURN(facts.size, ReadSize(tokens(), handbook, used));
    const std::vector<bool> size_words = std::exchange(used, std::vector<bool>(tokens().size()));
    ReadArchetype();
    TakeRoomOfNeeds();
    facts.shape = ReadShape(tokens(), handbook);
    if (IsIn("rooms_with_runs", facts.archetype->name()))
      facts.run_form = ReadRunForm(tokens(), facts.shape, facts.told);
    ReadParts();
    const std::vector<bool> room_words = used;
    ReadFinishes(*this);
    ReadSets(*this);
    const NamedPieces pieces = ReadFurniture(*this);
    counts_ = pieces.counts;
    TakeSizes(*this, pieces.mentions, size_words);
    ReadOtherRooms(pieces.mentions);
    ReadOpenings(tokens(), room_words, used, facts.openings);
    // "Windows to the street" of a house may be in any wall.
    const bool at_the_street = IsIn("rooms_at_the_street", facts.archetype->name());
    for (OpeningWish& opening : facts.openings.wishes) {
      if (opening.side == "street") opening.side = at_the_street ? "near" : "";
      // "A corner shop, glass on two sides": one comes in by one of them.
      const bool two = at_the_street && opening.said.find("two sides") != std::string::npos;
      if (two && opening.side == "far") opening.side = "near";
    }
    ReadPlaces(*this, pieces.mentions);
    NoteOtherNames(text, pieces.mentions, facts);
    ReadThemesAndStyles();
    ReadNeeds();
    if (own != nullptr) *own = OwnClassesOf(handbook, tokens(), pieces.mentions, used);
    facts.reads_as_english = !IsForeign(tokens()) && (facts.archetype_named || ReadsAsEnglish(tokens()));
    if (facts.reads_as_english) {
      for (const std::size_t i : facts.told) used[i] = true;
      Use(facts.shape.begin, facts.shape.end);
      for (const std::size_t i : pieces.counts) used[i] = true;
      for (std::size_t i = 0; i < used.size(); ++i) {
        const bool only = facts.nothing_else && IsOneOf(tokens()[i].text, {"nothing", "else"});
        used[i] = used[i] || size_words[i] || only;
      }
      facts.unheard = UnheardClauses(tokens(), used, handbook.vocabulary());
    }
    return std::move(facts);
  }

 private:
  void UseAll(std::string_view phrase) {
    const Phrase words(phrase);
    for (std::size_t i = 0; i < tokens().size(); ++i) Use(i, i + words.MatchAt(tokens(), i));
  }

  void ReadArchetype() {
    kind_ = ReadRoomKind(tokens(), handbook);
    facts.archetype = kind_.room.archetype;
    // "A triclinium for a museum": the room that nobody named is the first, if its word means one.
    for (std::size_t i = 0; facts.archetype != nullptr && i < kind_.room.begin && !text.Is(i, "pronouns"); ++i) {
      if (!text.Is(i, "for_whom")) continue;
      if (const hb::Archetype* first = handbook.vocabulary().meanings->RoomOf(text.Quote(text.BehindArticle(0), i))) {
        facts.archetype = first;
        facts.room_words = text.Quote(text.BehindArticle(0), i);
        Use(0, i);
        return;
      }
    }
    facts.archetype_named = facts.archetype != nullptr;
    if (!facts.archetype_named) return GuessArchetype();
    facts.room_words = Quote(kind_.room);
    // "The tavern's back room" is not the taproom.
    facts.archetype_named = text.At(kind_.room.end) != "'s";
    // "The back room of a tavern".
    const std::size_t before = text.PhraseBegin(kind_.room.begin);
    if (before > 2 && text.At(before - 1) == "of" && text.Is(before - 2, "room_words")) {
      facts.archetype_named = false;
      facts.room_words = text.Quote(before - 2, kind_.room.end);
    }
    Use(kind_.room.begin, kind_.room.end);
    for (const NamedRoom& one : kind_.also) {
      Use(one.begin, one.end);
      facts.also.push_back({one.archetype});
    }
  }

  // "A bedroom for our twins, aged five" is a child's, and its words mean what they mean there.
  void TakeRoomOfNeeds() {
    for (const hb::Need& need : handbook.contents().needs()) {
      int people = 0;
      const hb::Archetype* becomes = handbook.FindArchetype(need.changes().becomes_room());
      if (becomes == nullptr || need.min_people() > 0 || !Applies(need, people)) continue;
      facts.archetype = becomes;
      for (const std::string& keyword : need.keywords()) {
        const Phrase words(keyword);
        for (std::size_t i = 0; i < tokens().size(); ++i) Tell(i, i + words.MatchAt(tokens(), i));
      }
      return;
    }
  }

  // Parts of a room that no outline has: "behind a half wall".
  void ReadParts() {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      const auto end = text.BehindPhrase(i, "parts_not_drawn");
      if (!end || LongestAt(handbook.vocabulary().names, tokens(), i, /*plural=*/true).second > 0) continue;
      if (facts.size.leg && text.BehindPhrase(i, "recesses")) continue;
      facts.shape.parts.push_back(text.Quote(i, *end));
      Tell(i, *end);
      i = *end - 1;
    }
  }

  // Rooms that the room has, unless their words mean a piece ("with a bar"): a corner of it, or a room of their own.
  void ReadOtherRooms(const std::vector<Mention>& pieces) {
    for (const NamedRoom& one : kind_.named) {
      constexpr double kCorner = 0.4;
      if (used[one.begin] || text.At(one.end) == "of") continue;  // "a bank of tall units"
      const bool same = std::ranges::any_of(handbook.contents().needs(), [&](const hb::Need& need) {
        return need.changes().becomes_room() == facts.archetype->name() &&
               Includes(need.condition().rooms(), one.archetype->name());
      });
      const bool own = one.archetype->serving() || facts.archetype->serving();
      if (!own && !same) facts.also.push_back({one.archetype, kCorner});
      if (own) facts.other_rooms.push_back(Quote(one));
      Use(one.begin, one.end);
    }
    // Where in the room one of its uses lies: "kitchen at the east end".
    for (const NamedRoom& one : kind_.placed) {
      const bool piece =
          std::ranges::any_of(pieces, [&](const Mention& mention) { return mention.begin == one.begin; });
      if (!piece) facts.places_not_known.push_back(Quote(one));
    }
  }

  std::string Quote(const NamedRoom& room) const { return text.Quote(room.begin, room.end); }

  // The kind of room that most words of the brief hint at. Its first words name the kind that nobody knows: "a tea room
  // with six tables".
  void GuessArchetype() {
    const std::size_t begin = text.BehindArticle(0);
    std::size_t end = begin;
    while (text.IsWord(end) && !text.Is(end, "after_a_room")) ++end;
    if (text.Is(end, "rooms_by_head")) ++end;
    // "Six foot by nine", "the girls share", "my son is 15 and his room ..." name none.
    const bool none = text.IsNumber(begin) || NumberWord(text.At(begin)) || text.Is(begin, "pronouns") ||
                      CountsPeople(text.At(begin)) || (end > begin && CountsPeople(text.At(end - 1)));
    if (!text.Is(begin, "rooms_by_head") && !none) facts.room_words = text.Quote(begin, end);
    // That it is not known is told once.
    bool pieces = false;
    for (std::size_t i = begin; i < end; ++i) pieces = pieces || NamesAPiece(i, i + 1);
    if (!pieces) Tell(begin, end);
    const auto taken = [&](const hb::Archetype* archetype) {
      if (archetype != nullptr) facts.archetype = archetype;
      return archetype != nullptr;
    };
    const Meanings& meanings = *handbook.vocabulary().meanings;
    if ((!NamesAPiece(begin, end) && taken(meanings.RoomOf(text.Quote(begin, end)))) ||
        taken(MostHintedAt(handbook, tokens())))
      return;
    // "A breakfast room", "a sleeping module": what goes on there.
    for (std::size_t i = end; end > begin && text.Is(end - 1, "room_like_nouns") && i - 1 > begin; --i) {
      if (text.IsWord(i - 2) && taken(meanings.RoomFor(text.At(i - 2)))) return;
    }
    facts.archetype = &KindOfPieces(handbook, tokens());
  }

  bool NamesAPiece(std::size_t begin, std::size_t end) const {
    for (std::size_t i = begin; i < end; ++i) {
      if (LongestAt(handbook.vocabulary().names, tokens(), i, /*plural=*/true).second + i >= end) return true;
    }
    return false;
  }

  void ReadThemesAndStyles() {
    for (const hb::Theme& theme : handbook.contents().themes()) {
      const bool of_its_time = theme.changes().year() != 0;
      if (!theme.fallback() && OccursUnused(theme.keywords(), of_its_time)) AddOnce(facts.themes, &theme);
    }
    for (const hb::Style& style : handbook.contents().styles()) {
      if (OccursUnused(style.name())) AddOnce(facts.styles, &style);
    }
    const auto& colours = handbook.vocabulary().colours;
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      const auto [colour, length] = LongestAt(colours, tokens(), i, /*plural=*/false);
      if (length == 0 || used[i] || IsOfAThing(i + length)) continue;
      AddOnce(IsRefusedLook(i) ? facts.refused_colours : facts.colours, colour);
      Use(i, i + length);
      i += length - 1;
    }
    for (const hb::Theme* theme : facts.themes) {
      for (const std::string& keyword : theme->keywords()) UseAll(keyword);
    }
    for (const hb::Style* style : facts.styles) UseAll(style->name());
  }

  // "No pink", "nothing rustic", "not hospital white".
  bool IsRefusedLook(std::size_t i) const {
    constexpr std::size_t kMostBack = 3;
    for (std::size_t back = 1; back <= std::min(i, kMostBack) && !text.IsSign(i - back); ++back) {
      if (text.Is(i - back, "refusing_looks")) return true;
    }
    return IsRefused(text, i);
  }

  // "Black taps": the colour of something small that is not drawn, not the room's.
  bool IsOfAThing(std::size_t i) const {
    return text.IsWord(i) && !text.Is(i, "coloured_rooms") && english::IsPlural(text.At(i)) &&
           handbook.vocabulary().meanings->ThingOf(text.At(i)).known;
  }

  void ReadNeeds() {
    // Needs look at the same words.
    std::vector<bool> peoples_words = used;
    facts.year = ReadYear(tokens(), peoples_words);
    // A "wizard's study" is of his time, though the words name the kind of room.
    for (const hb::Theme& theme : handbook.contents().themes()) {
      const int year = theme.changes().year();
      for (std::size_t i = kind_.room.begin; i < kind_.room.end && year != 0 && !facts.year; ++i) {
        for (const std::string& word : theme.keywords())
          if (Phrase(word).MatchAt(tokens(), i) > 0) facts.year = year;
      }
    }
    const std::vector<bool> before = peoples_words;
    facts.people = ReadPeople(tokens(), peoples_words);
    for (std::size_t i = 0; i < tokens().size() && facts.people; ++i) {
      if (peoples_words[i] && !before[i])
        facts.people_said += (facts.people_said.empty() ? "" : " ") + tokens()[i].text;
    }
    if (facts.people) facts.people_in = ReadPeopleInGroups(tokens(), peoples_words);
    std::vector<const hb::Need*> found;
    for (const hb::Need& need : handbook.contents().needs()) {
      int people = 0;
      if (!Applies(need, people)) continue;
      found.push_back(&need);
      if (people > 0 && need.min_people() > 0 && !facts.people) facts.people = people;
    }
    used = std::move(peoples_words);
    for (const hb::Need* need : found) {
      const bool overridden = std::ranges::any_of(found, [&](const hb::Need* other) {
        return std::find(other->overrides().begin(), other->overrides().end(), need->name()) !=
               other->overrides().end();
      });
      if (!overridden) facts.needs.push_back(need);
    }
    for (const hb::Need* need : found) {
      for (const std::string& keyword : need->keywords()) UseAll(keyword);
    }
  }

  bool Applies(const hb::Need& need, int& people) const {
    const auto& rooms = need.condition().rooms();
    if (!rooms.empty() && std::find(rooms.begin(), rooms.end(), facts.archetype->name()) == rooms.end()) return false;
    if (!need.also_keywords().empty() && !OccursAny(need.also_keywords())) return false;
    for (const std::string& keyword : need.keywords()) {
      int number = 0;
      if (!OccursFree(Phrase(keyword), number)) continue;
      if (number > 0 && need.min_people() > 0 && number < need.min_people()) continue;
      if (number > 0 && need.max_people() > 0 && number > need.max_people()) continue;
      people = number;
      return true;
    }
    // "A team of eight", "twelve desks": however their number was said.
    const int counted = facts.people.value_or(DesksForMany());
    return need.min_people() > 0 && counted >= need.min_people() &&
           (need.max_people() == 0 || counted <= need.max_people());
  }

  // How many have a place of their own in the room; 0 where that makes no crowd.
  int DesksForMany() const {
    constexpr int kMany = 5;
    const auto one = std::ranges::find_if(facts.wishes, [&](const Wish& wish) {
      return wish.furniture->name() == facts.archetype->per_person() && wish.counted && wish.count >= kMany;
    });
    return one == facts.wishes.end() ? 0 : one->count;
  }

  // Whether it occurs without a number that belongs to something else.
  bool OccursFree(const Phrase& phrase, int& number) const {
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      int found = 0;
      const std::size_t length = phrase.MatchAt(tokens(), i, true, &found);
      if (length == 0 || (found > 0 && used[i]) || IsAWish(i, length)) continue;
      // "Not too many plants", or no paintings, make nobody a gardener or painter, "twin beds" are for no twins.
      if (AsksForFew(text, i) || IsRefused(text, i)) continue;
      if (phrase.MatchAt(tokens(), i, /*plural=*/false) == 0 && NamesAPiece(i + length, i + length + 1)) continue;
      number = found;
      return true;
    }
    return false;
  }

  // "A painting" is a piece and "white paint" on the walls: neither makes anybody a painter.
  bool IsAWish(std::size_t i, std::size_t length) const {
    if (std::ranges::any_of(facts.finishes, [&](const auto& one) { return one.begin <= i && i < one.end; }))
      return true;
    // "Two plants", not "a few plants".
    if (used[i] && i > 0 && Includes(counts_, i - 1) && !IsIn("vague_numbers", tokens()[i - 1].text)) return true;
    return used[i] && std::ranges::any_of(facts.wishes, [&](const Wish& wish) {
             return Phrase(wish.furniture->name()).MatchAt(tokens(), i) == length;
           });
  }

  // As OccursAny, but not within words that name the room or its furniture: a king bed makes no king.
  bool OccursUnused(const google::protobuf::RepeatedPtrField<std::string>& phrases, bool of_the_room) const {
    return std::ranges::any_of(phrases, [&](const std::string& one) { return OccursUnused(one, of_the_room); });
  }

  // Fairy lights make no fairy's room.
  bool OccursUnused(const std::string& words, bool of_the_room = false) const {
    const Phrase phrase(words);
    for (std::size_t i = 0; i < tokens().size(); ++i) {
      const std::size_t length = phrase.MatchAt(tokens(), i);
      if (length > 0 && IsRefusedLook(i)) continue;
      for (std::size_t k = i; k < i + length; ++k) {
        if (!used[k] && !(of_the_room && IsOfTheHouse(i, length))) return true;
      }
    }
    return false;
  }

  // "In a Victorian terrace" is where the room is today.
  bool IsOfTheHouse(std::size_t i, std::size_t length) const {
    const std::size_t before = i > 0 && text.Is(i - 1, "articles") ? i - 1 : i;
    return before > 0 && text.Is(before - 1, "into_a_wall") && text.Is(i + length, "houses");
  }

  bool OccursAny(const google::protobuf::RepeatedPtrField<std::string>& phrases) const {
    return std::ranges::any_of(phrases, [&](const std::string& phrase) { return Phrase(phrase).Occurs(tokens()); });
  }

  const BriefText text_;
  std::vector<bool> used_;
  RoomKind kind_;
  std::vector<std::size_t> counts_;  // tokens: the numbers of pieces
  BriefFacts facts_;
};

}  // namespace

double AreaOf(const BriefFacts& facts) {
  if (facts.size.area_m2) return *facts.size.area_m2;
  const hb::Archetype& room = *facts.archetype;
  return facts.size.width_m.value_or(room.width_m().typical()) * facts.size.depth_m.value_or(room.depth_m().typical());
}

absl::StatusOr<BriefFacts> ReadBrief(const v1::Brief& brief, const Handbook& handbook) {
  std::vector<Token> tokens = TokensOf(brief.text());
  std::vector<Correction> corrections;
  if (ReadsAsEnglish(tokens)) corrections = handbook.vocabulary().speller->Correct(tokens);
  std::vector<OwnClass> own;
  ASSIGN_OR_RETURN(BriefFacts facts, BriefReader(handbook, tokens).Read(&own));
  const auto read_with_own = [&]() -> absl::StatusOr<BriefFacts> {
    std::vector<hb::Furniture> classes;
    for (const OwnClass& one : own) classes.push_back(one.furniture);
    const auto with_own = std::make_shared<const Handbook>(handbook, std::move(classes));
    ASSIGN_OR_RETURN(BriefFacts read, BriefReader(*with_own, tokens).Read());
    read.own_handbook = with_own;
    for (const OwnClass& one : own) {
      read.base_of_own[one.furniture.name()] = one.base;
      if (one.plain) read.made_plain.push_back(one.furniture.name());
    }
    return read;
  };
  // Which of them have a place shows when all of them are read.
  if (std::ranges::any_of(own, &OwnClass::unplaced)) {
    ASSIGN_OR_RETURN(const BriefFacts tried, read_with_own());
    own = Placed(std::move(own), tried, handbook);
  }
  if (!own.empty()) {
    ASSIGN_OR_RETURN(facts, read_with_own());
  }
  if (const std::vector<OwnClass> otherwise = OtherwiseCarried(facts); !otherwise.empty()) {
    for (const OwnClass& one : otherwise) {
      std::erase_if(own, [&](const OwnClass& other) { return other.furniture.name() == one.furniture.name(); });
      own.push_back(one);
    }
    ASSIGN_OR_RETURN(facts, read_with_own());
  }
  facts.corrections = std::move(corrections);
  return facts;
}

}  // namespace flair::language
