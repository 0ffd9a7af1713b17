// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/piece_mentions.h"

#include <algorithm>
#include <string>

#include "english/wordnet.h"
#include "english/words.h"
#include "language_worker/handbook/reading/meanings.h"
#include "language_worker/handbook/reading/other_words.h"
#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

namespace {

// "A rack for eight bikes", "a stand for his piano", "TV for the football".
bool IsHeld(const BriefText& text, const hb::Furniture& furniture, std::size_t i) {
  std::size_t begin = text.PhraseBegin(i);
  if (begin > 1 && text.At(begin - 1) == "for" && IsFormIn("shows_things", text.At(begin - 2))) return true;
  if (!IsFloorPiece(furniture) || PlacesOn(furniture) > 0) return false;
  const bool known = text.Is(begin, "known_before");
  // "For the vacuum and ironing board".
  const bool counted = text.IsNumber(begin) || NumberWord(text.At(begin)) || text.Is(begin, "vague_numbers");
  if (begin > 1 && text.At(begin - 1) == "and" && !counted) begin = text.PhraseBegin(begin - 2);
  for (std::size_t at = begin - std::min<std::size_t>(begin, 3); at > 0 && at < begin; ++at) {
    const std::size_t end = text.BehindPhrase(at, "made_for").value_or(0);
    if (end < begin || end > i) continue;
    return known ? IsFormIn("holders_of_things", text.At(at - 1)) : IsFormIn("thing_nouns", text.At(at - 1));
  }
  return false;
}

// "Wide enough for prams", "so that prams can pass", "room to turn the chair".
bool IsPassing(const BriefText& text, std::size_t i, std::size_t length) {
  const std::size_t begin = text.PhraseBegin(i);
  if (begin > 0 && text.Is(begin - 1, "turning") && text.Is(begin, "definite")) return true;
  const bool wide = begin > 2 && text.At(begin - 1) == "for" && text.Says(begin - 2, {"enough", "apart"});
  if (wide && (text.Is(begin - 3, "wide_ways") || text.At(begin - 2) == "apart")) return true;
  return text.Is(i + length, "modal_verbs") && text.Is(i + length + 1, "verbs_of_passing");
}

// Whether the word at a token is that for the room behind a door which the brief names, not for a piece: "the back door
// to the toilets", "the closet door". "A door to the toilet" and "a toilet" are two.
bool IsNamedByADoor(const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostWords = 3;
  if (IsBeforeADoor(text, i + 1)) return true;
  const std::size_t at = text.PhraseBegin(i);
  if (at == 0 || !text.Says(at - 1, {"to", "into", "onto", "from"})) return false;
  std::size_t door = at - 1;  // "leading to"
  while (door > 0 && door + kMostWords > at && !text.Is(door, "doors")) --door;
  return text.Is(door, "doors");
}

// "Where customers drop off bikes"; "volunteers mend bikes, toasters, chairs, you name it".
bool IsOfATale(const BriefText& text, std::size_t i) {
  constexpr std::size_t kMostBack = 10;
  if (!text.At(i).ends_with('s') || text.PhraseBegin(i) == 0) return false;
  // "The big table for the mums with prams".
  const bool brought = i > 1 && IsFormIn("brought_by_people", text.At(i)) && text.At(i - 1) == "with";
  if (brought && CountsPeople(text.At(i - 2))) return true;
  bool people = false, listed = false;
  for (std::size_t at = i; at > 0 && i - at < kMostBack; --at) {
    const std::size_t k = at - 1;
    listed = listed || text.IsSign(k);
    if (text.EndsSentence(k) || text.IsNumber(k) || NumberWord(text.At(k)) || text.Is(k, "articles")) return false;
    if (text.Is(k, "works_on") && k > 0 && (text.Is(k - 1, "pronouns") || CountsPeople(text.At(k - 1)))) return true;
    if (text.Is(k, "having") || text.Is(k, "have") || text.Is(k, "verbs_of_being")) return false;
    people = people || CountsPeople(text.At(k));
    if (text.Is(k, "clause_openers")) return people && !listed;
  }
  return false;
}

// "A freestanding bathtub ... opposite the tub": the wish for a class of this brief's own that these words name again.
const Wish* NamedAgain(const BriefText& text, std::size_t i, const hb::Furniture* named, const BriefFacts& facts,
                       const Handbook& handbook) {
  if (named == nullptr || i == 0 || text.At(i - 1) != "the" || named->category() == "box") return nullptr;
  const auto own = std::ranges::find_if(facts.wishes, [&](const Wish& wish) {
    return wish.furniture != named && handbook.IsOwn(*wish.furniture) && !named->category().empty() &&
           wish.furniture->category() == named->category();
  });
  return own == facts.wishes.end() ? nullptr : &*own;
}

class EachReader : Reading {
 public:
  EachReader(const Reading& reading, const std::vector<Mention>& mentions, int people)
      : Reading(reading), mentions_(mentions), people_(people) {}

  // "One nightstand and one visitor's chair per bed", "a chair at each".
  std::optional<int> Behind(std::size_t end) const {
    constexpr std::size_t kMostToPer = 9, kMostWords = 5, kMostListed = 14;
    for (std::size_t k = end; k < end + kMostToPer && !text.EndsSentence(k) && text.At(k) != "with"; ++k) {
      if (text.At(k) == "per" && !text.Is(k + 1, "unit_words")) return Of(CountsPeople(text.At(k + 1)));
    }
    // "Three boys, a bed, a desk and a chair each": so many of all that is listed.
    bool listed = false;
    for (std::size_t k = end; k < end + (listed ? kMostListed : kMostWords) && k < text.size(); ++k) {
      const bool joint = people_ > 1 && text.Says(k, {",", "and"}) && text.Is(k + 1, "thing_articles");
      listed = listed || joint;
      if (!joint && (used[k] || text.IsSign(k) || text.Says(k, {"and", "with"}))) break;
      if (!IsEach(k) || !text.Says(k, {"each", "every"})) continue;
      const bool closes = k + 1 >= text.size() || text.IsSign(k + 1);
      if (listed) return closes && !text.Is(k - 1, "unit_words") ? std::optional(people_) : std::nullopt;
      const bool ends =
          text.Says(k + 1, {"one", "of", "table", "desk", "bed", "seat"}) || closes || text.Is(k + 1, "thing_ends");
      if (ends || CountsPeople(text.At(k + 1))) return Of(text.At(k - 1) == "for");
    }
    return std::nullopt;
  }

  // "Each needs his own bed, own desk and own shelf", "three guests, each with a microphone", "both want an own desk".
  std::optional<int> Before(std::size_t begin) const {
    for (std::size_t at = begin; at > 0 && !text.EndsSentence(at - 1); --at) {
      const bool both = text.At(at - 1) == "both";
      if (!both && !IsEach(at - 1)) continue;
      constexpr std::size_t kMostToVerb = 4;
      std::size_t verb = at;
      while (verb < at + kMostToVerb && !text.Is(verb, "getting")) ++verb;
      if (verb == at + kMostToVerb || verb >= begin || EndsBetween(verb, begin)) return std::nullopt;
      // "We both need a sofa" is for one sofa, "both need their own desk" for two desks.
      while (both && verb < begin && text.At(verb) != "own") ++verb;
      return verb == begin ? std::nullopt : both ? std::optional(2) : Sharers(at - 1, verb);
    }
    return std::nullopt;
  }

 private:
  bool IsEach(std::size_t i) const {
    const bool corners = text.At(i + 1) == "of" && (text.Is(i + 3, "corners") || text.Is(i + 4, "corners"));
    return text.Is(i, "each_words") && !text.Says(i + 1, {"side", "end", "wall", "corner", "other", "way"}) && !corners;
  }

  // Of the people, or of what was asked for last.
  std::optional<int> Of(bool people) const {
    if ((people || (!facts.wishes.empty() && facts.wishes.back().count == 1)) && people_ > 0) return people_;
    return facts.wishes.empty() ? std::nullopt : std::optional<int>(facts.wishes.back().count);
  }

  // Whether a list of what each has, which begins at `verb`, is over before `i`: ", with a curtain between them".
  bool EndsBetween(std::size_t verb, std::size_t i) const {
    for (std::size_t k = verb + 1; k < i; ++k) {
      if (text.At(k) != ",") continue;
      const std::size_t next = text.At(k + 1) == "and" ? k + 2 : k + 1;
      if (text.At(next) == "with") return true;
      if (text.At(verb) == "with" && !text.Says(next, {"its", "their", "his", "her", "own"})) return true;
    }
    return false;
  }

  // How many "each" at `at` speaks of: the pieces, or groups of them, that stand right by it, else people.
  std::optional<int> Sharers(std::size_t at, std::size_t verb) const {
    constexpr std::size_t kMostBetween = 12;
    for (auto mention = mentions_.rbegin(); mention != mentions_.rend(); ++mention) {
      if (mention->begin > at && mention->begin < verb) return mention->count;
      const bool near = mention->end <= at && at - mention->end <= (text.At(verb) == "with" ? kMostBetween : 2);
      if (!near || EndsSentenceBetween(mention->end, at) || CountsPeople(text.At(at + 1))) continue;
      const auto wish = std::ranges::find(facts.wishes, mention->furniture, &Wish::furniture);
      if (wish != facts.wishes.end() && wish->in_each > 0 && IsInGroups(mention->begin))
        return wish->count / wish->in_each;
      return mention->count;
    }
    return people_ > 1 ? std::optional<int>(people_) : std::nullopt;
  }

  bool EndsSentenceBetween(std::size_t begin, std::size_t end) const {
    while (begin < end && !text.EndsSentence(begin)) ++begin;
    return begin < end;
  }

  // "Groups of three armchairs".
  bool IsInGroups(std::size_t noun) const {
    constexpr std::size_t kMostBack = 4;
    for (std::size_t k = noun - std::min(noun, kMostBack); k < noun; ++k) {
      if (IsFormIn("groups_of_pieces", text.At(k))) return true;
    }
    return false;
  }

  const std::vector<Mention>& mentions_;
  const int people_;
};

// What is told of walls: how many of them, and which sides of the room they are.
struct Walls {
  int count = 0;
  bool is_long = false, is_short = false;
};

// "Along the long wall", "on three walls", "lining the walls"; pieces "on the wall" are not a row of them.
Walls WallsBehind(const BriefText& text, std::size_t end) {
  constexpr std::size_t kMostWords = 7;
  constexpr int kAll = 3;  // the fourth has the door
  Walls walls;
  bool along = false, all = false;
  int number = 0;
  for (std::size_t i = end; i < end + kMostWords && i < text.size() && !text.IsSign(i); ++i) {
    // A couch that can be reached from all four sides is one.
    if (text.Says(i, {"and", "with", "for"}) || text.Is(i, "says_reached")) break;
    along = along || text.Is(i, "along_walls");
    all = all || text.Says(i, {"all", "every", "each"});
    walls.is_long = walls.is_long || text.At(i) == "long";
    walls.is_short = walls.is_short || text.At(i) == "short";
    if (const auto said = NumberWord(text.At(i)); said && !text.Is(i, "articles")) number = *said;
    if (text.At(i) == "both") number = 2;
    if (!IsFormIn("wall_nouns", text.At(i)) || IsFormIn("wall_nouns", text.At(i + 1))) continue;  // "both side walls"
    const bool many = text.At(i).ends_with('s') || number > 1;
    if (!many) {
      walls.count = along ? 1 : 0;
    } else {
      walls.count = number > 0 ? std::min(number, kAll) : (all || along ? kAll : 0);
    }
    break;
  }
  return walls;
}

}  // namespace

bool IsNoNoun(const BriefText& text, std::size_t i) {
  // "A trolley can pass".
  if (i > 0 && text.Is(i - 1, "modal_verbs")) return true;
  const std::size_t next = text.IsHyphen(i + 1) ? i + 2 : i + 1;
  return (text.Is(i, "verbs_of_having") && (text.Is(i + 1, "thing_articles") || NumberWord(text.At(i + 1)))) ||
         text.Says(next, {"shaped", "shape"}) || (text.At(next) == "of" && IsFormIn("groups_of_pieces", text.At(i)));
}

bool IsOnlyTold(const BriefText& text, const hb::Furniture& furniture, std::size_t i, std::size_t length) {
  // "Keep 80 cm clear round bed" speaks of the bed.
  if (text.At(i) == "round" && i > 0 && text.Is(i - 1, "says_reached")) return true;
  return IsHeld(text, furniture, i) || IsPassing(text, i, length) ||
         IsBorne(text, i, furniture.kind() == hb::FURNITURE_KIND_SURFACE) || IsOfATale(text, i + length - 1) ||
         (length == 1 && IsBehindADoor(text, i));
}

bool IsBorne(const BriefText& text, std::size_t i, bool small) {
  constexpr std::size_t kMostBack = 6, kMostToPeople = 2;
  if (!text.At(i).ends_with('s')) return false;
  if (small && i > 1 && text.At(i - 1) == "with" && CountsPeople(text.At(i - 2))) return true;
  const std::size_t begin = text.PhraseBegin(i);
  for (std::size_t at = begin; at > 0 && at + kMostBack > begin; --at) {
    const std::size_t k = at - 1;
    if (text.EndsSentence(k) || text.Is(k, "clause_openers")) return false;
    const auto end = text.BehindPhrase(k, "bearing");
    if (!end || *end > begin) continue;
    for (std::size_t who = k; who > 0 && who + kMostToPeople > k; --who) {
      if (CountsPeople(text.At(who - 1)) && !text.Is(who - 1, "places_of_people")) return true;
    }
  }
  return false;
}

bool IsBehindADoor(const BriefText& text, std::size_t i) {
  const std::string_view room = text.At(i);
  if (!IsFormIn("inner_rooms", room) && !text.Is(i, "open_air") && !room.ends_with("room")) return false;
  if (IsNamedByADoor(text, i)) return true;
  if (i == 0 || !text.Is(i - 1, "definite")) return false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (MatchesWord(text.At(k), english::Singular(room)) && IsNamedByADoor(text, k)) return true;
  }
  return false;
}

bool IsBeforeADoor(const BriefText& text, std::size_t end) {
  const std::size_t door = text.At(end) == "room" ? end + 1 : end;
  return text.Is(door, "doors") && !text.At(door).ends_with('s');
}

bool MakesACompound(const BriefText& text, std::size_t begin, std::size_t end) {
  // "A table seating twelve" is no table-seating.
  const auto goes_on = [&](std::size_t i) {
    return text.IsWord(i) && !text.Is(i, "thing_ends") && !NumberWord(text.At(i));
  };
  // "In camera view", "at desk height": one of them would have an article.
  const bool joined =
      text.Is(end, "behind_bare_nouns") || text.Is(begin - std::min<std::size_t>(begin, 1), "before_bare_nouns");
  const bool bare = text.PhraseBegin(begin) == begin && joined && !text.At(end - 1).ends_with('s') &&
                    !english::WordNet::Get().SensesOf(text.At(end)).empty() && !IsFormIn("thing_nouns", text.At(end));
  return goes_on(end) &&
         (bare || (text.At(end).ends_with("ing") && goes_on(end + 1) && !text.Is(end + 1, "along_walls")) ||
          MeansPeople(text.At(end)));
}

std::size_t BehindParts(const BriefText& text, std::size_t end) {
  constexpr std::size_t kMostOfAPart = 4;
  const bool stands = text.At(end) == "on";
  if (!stands && !text.Says(end, {"with", "without"})) return end;
  for (std::size_t i = end + 1; i < text.size() && i <= end + kMostOfAPart; ++i) {
    if (const auto behind = text.BehindPhrase(i, "parts_in_two_words"); behind && !stands) return *behind;
    if (stands ? text.Is(i, "parts_to_stand_on") : IsFormIn("parts_of_furniture", text.At(i))) return i + 1;
    const bool word = text.IsWord(i) || text.IsHyphen(i) || text.IsNumber(i);
    if (!word || (stands && text.Is(i, "articles"))) break;
  }
  return end;
}

bool IsOfAPurpose(const BriefText& text, std::size_t i) {
  const std::size_t begin = text.PhraseBegin(i);
  const bool article = begin < i && (text.Is(begin, "thing_articles") || NumberWord(text.At(begin)));
  return begin > 0 && !article && text.Says(begin - 1, {"for", "of", "to", "like"});
}

void MeetLater(const BriefText& text, BriefFacts& facts, std::vector<Mention>& mentions) {
  for (std::size_t i = 0; i < facts.wishes.size(); ++i) {
    const hb::Furniture* vague = facts.wishes[i].furniture;
    const auto mention = std::ranges::find(mentions, vague, &Mention::furniture);
    const bool by_noun = facts.wishes[i].noun != nullptr && mention != mentions.end() &&
                         mention->end == mention->begin + 1 && mention->begin > 0;
    const bool the = by_noun && text.At(mention->begin - 1) == "the" && facts.wishes[i].count == 1;
    // "Separate beds now. Two twin beds with ..."
    const bool plural = by_noun && !facts.wishes[i].counted && facts.wishes[i].seats == 0;
    if (!(the || plural) || vague->category() == "box") continue;
    const auto later = std::ranges::find_if(
        facts.wishes.begin() + static_cast<std::ptrdiff_t>(i) + 1, facts.wishes.end(), [&](const Wish& wish) {
          return wish.furniture->category() == vague->category() && (the || (wish.counted && wish.count > 1));
        });
    if (later == facts.wishes.end()) continue;
    for (Mention& one : mentions) {
      if (one.furniture == vague) one.furniture = later->furniture;
    }
    facts.wishes.erase(facts.wishes.begin() + static_cast<std::ptrdiff_t>(i--));
  }
}

std::optional<Mention> MeantBefore(const BriefText& text, std::size_t i, std::size_t length, const NounBook& nouns,
                                   const BriefFacts& facts, const Handbook& handbook) {
  // "The two beds" are those that were asked for.
  const bool counted = i > 1 && NumberWord(text.At(i - 1)) && !text.Says(i - 1, {"a", "an", "the"});
  const std::size_t before = i - std::min<std::size_t>(i, counted ? 2 : 1);
  const bool bare = text.PhraseBegin(i) == i && !text.At(i).ends_with('s') && text.Is(before, "before_known");
  const Wish* own =
      NamedAgain(text, i, LongestAt(nouns.names(), text.tokens(), i, /*plural=*/true).first, facts, handbook);
  if (own != nullptr) return Mention{own->furniture, i, i + length, own->count};
  if (length != 1 || i == 0 || !(text.Is(before, "known_before") || bare)) return std::nullopt;
  const hb::Noun* noun = nouns.NounAt(text.tokens(), i, length);
  const auto is_meant = [&](const hb::Furniture& furniture) {
    const std::string last = LastWord(furniture.name());
    const bool compound = last.ends_with("chair") && MatchesWord(text.tokens()[i].text, "chair");
    return MatchesWord(text.tokens()[i].text, last) || compound ||
           (noun != nullptr && std::ranges::any_of(noun->options(), [&](const hb::NounOption& option) {
              return option.furniture() == furniture.name();
            }));
  };
  for (auto wish = facts.wishes.rbegin(); wish != facts.wishes.rend(); ++wish) {
    if (is_meant(*wish->furniture)) return Mention{wish->furniture, i, i + length, wish->count};
    const hb::Furniture* seat = SeatOf(*wish->furniture, handbook);
    if (seat != nullptr && wish->seats > 0 && is_meant(*seat)) {
      Mention seats{wish->furniture, i, i + length, wish->count};
      seats.seats = true;
      return seats;
    }
  }
  return std::nullopt;
}

int TimesForEach(const Reading& reading, std::size_t begin, std::size_t end, const std::vector<Mention>& mentions,
                 int people) {
  const EachReader reader(reading, mentions, people);
  const std::optional<int> behind = reader.Behind(end);
  return std::max(1, behind ? *behind : reader.Before(begin).value_or(1));
}

int CountAlongWalls(const BriefText& text, const hb::Furniture& furniture, std::size_t end, const BriefFacts& facts) {
  constexpr double kShareOfWall = 0.65, kShareOfFloor = 0.14;
  constexpr int kMostAtAWall = 6;
  if (!IsFloorPiece(furniture) || furniture.back() != hb::BACK_RULE_WALL || PlacesOn(furniture) > 0) return 0;
  const Walls walls = WallsBehind(text, end);
  if (walls.count == 0) return 0;
  const hb::Archetype& room = *facts.archetype;
  const double width_m = facts.size.width_m.value_or(room.width_m().typical());
  const double depth_m = facts.size.depth_m.value_or(room.depth_m().typical());
  const double side_m = walls.is_long    ? std::max(width_m, depth_m)
                        : walls.is_short ? std::min(width_m, depth_m)
                                         : (width_m + depth_m) / 2;
  const double piece_m = furniture.width_m().typical(), piece_m2 = piece_m * furniture.depth_m().typical();
  const int at_each = std::clamp(static_cast<int>(kShareOfWall * side_m / piece_m), 2, kMostAtAWall);
  const int most = static_cast<int>(kShareOfFloor * width_m * depth_m / piece_m2);
  return std::max(2, std::min(walls.count * at_each, most));
}

}  // namespace flair::language
