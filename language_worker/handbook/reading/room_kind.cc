// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/room_kind.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/piece_words.h"
#include "language_worker/handbook/reading/vocabulary.h"

namespace flair::language {

namespace {

// "It should feel like a home, not like a hospital": no word for what the room is.
bool IsCompared(const BriefText& text, std::size_t i) { return IsRefused(text, i) || IsLikened(text, i); }

class RoomKindReader {
 public:
  RoomKindReader(const std::vector<Token>& tokens, const Handbook& handbook)
      : tokens_(tokens), words_(tokens), handbook_(handbook) {}

  RoomKind Read() {
    FindNames();
    const std::size_t best = Best();
    if (best == found_.size()) return {};
    RoomKind kind;
    kind.room = found_[best].room;
    AddOthers(best, kind);
    TakeTogether(kind);
    AddPlaces(kind);
    return kind;
  }

 private:
  struct Found {
    NamedRoom room;
    bool within = false;   // behind "with"
    bool had = false;      // right behind it: "with a home office"
    bool outside = false;  // "a door to the kitchen", "next to the kitchen"
    bool use = false;      // "living" of a list
    bool closed = false;   // no noun follows
    std::size_t list = 0;  // those of one list have the same number
  };

  void FindNames() {
    const std::vector<Saying<hb::Archetype>>& names = handbook_.vocabulary().rooms;
    bool within = false;
    std::size_t list = 0;
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      if (words_.EndsSentence(i) && found_.empty()) within = false;
      within = within || words_.Is(i, "having");
      // What follows the first clause tells what is in the room: "a classroom, with tables and a reading corner".
      const bool parted = words_.IsSign(i) && words_.Says(i, {",", ":", ".", ";"}) && !words_.IsNumber(i + 1);
      const bool lists =
          words_.Is(i + 1, "listing") || UseAt(i + 1).use || LongestAt(names, tokens_, i + 1, false).second > 0;
      within = within || (parted && !found_.empty() && found_.back().closed && !lists);
      Found found;
      auto [archetype, length] = LongestAt(names, tokens_, i, /*plural=*/false);
      found.room = {archetype, i, i + length};
      // A "kitchen diner" is no diner.
      const Found use = UseAt(i);
      const bool joined = use.use && !found_.empty() &&
                          (IsListed(found_.back().room.end, i) || IsOpenPlan(found_.back().room, use.room));
      if (length == 0 || (length == 1 && joined)) {
        found = use;
        length = 0;
      }
      if (found.room.archetype == nullptr || IsADoor(found.room) || IsCompared(words_, i)) continue;
      found.within = within;
      found.outside =
          IsOutside(found.room) || IsOfAPiece(found.room) || BecomesAnother(found.room.end) || IsTheHome(found.room);
      const bool became = !found_.empty() && BecomesAnother(found_.back().room.end) && i < found_.back().room.end + 12;
      if (became) found.outside = IsOfAPiece(found.room);
      found.closed = Closes(found.room.end);
      found.had = found.within && IsHad(i);
      const bool open_plan = !found_.empty() && IsOpenPlan(found_.back().room, found.room);
      if (open_plan) found_.back().closed = true;
      if (found_.empty() || !(open_plan || IsListed(found_.back().room.end, i))) ++list;
      found.list = list;
      found_.push_back(found);
      // Names within names do not count, but what follows may be longer: "studio office".
      if (length > 1) Skip(names, i, length);
    }
    // Of a "kindergarten cloakroom" the second is the room, the first tells whose.
    for (std::size_t i = found_.size(); i > 1; --i) {
      const Found &first = found_[i - 2], &second = found_[i - 1];
      if (first.room.end == second.room.begin && !first.use && !second.use && first.list != second.list) {
        found_.erase(found_.begin() + static_cast<std::ptrdiff_t>(i - 2));
      }
    }
    // "A flat with a 5.5 x 4.2 m living room": a room with a size of its own is meant, not the dwelling.
    const auto sized = [&](const Found& one) {
      const std::size_t at = one.room.begin;
      return at > 1 && words_.IsNumber(at - 2) && words_.Is(at - 1, "unit_words");
    };
    for (Found& one : found_) {
      const bool dwelling = words_.Is(one.room.begin, "houses") && one.room.end == one.room.begin + 1;
      one.outside = one.outside || (dwelling && std::ranges::any_of(found_, sized));
    }
    // A use alone is none, "living" of "living plants", unless the brief begins with its area: "Open dining area next
    // to the kitchen".
    const bool area = !found_.empty() && found_[0].use && found_[0].room.end == found_[0].room.begin + 2 &&
                      words_.BehindArticle(0) + 1 >= found_[0].room.begin &&
                      std::all_of(found_.begin() + 1, found_.end(), [](const Found& one) { return one.outside; });
    std::erase_if(found_, [&](const Found& one) {
      return one.use && !area && (!one.closed || std::ranges::count(found_, one.list, &Found::list) < 2);
    });
  }

  // Goes on behind a name, unless a longer one begins within it.
  void Skip(const std::vector<Saying<hb::Archetype>>& names, std::size_t& i, std::size_t length) const {
    for (std::size_t k = i + 1; k < i + length; ++k) {
      if (LongestAt(names, tokens_, k, /*plural=*/false).second > length) return;
    }
    i += length - 1;
  }

  Found UseAt(std::size_t i) const {
    Found found;
    for (const hb::Archetype& archetype : handbook_.contents().archetypes()) {
      if (!Includes(archetype.uses(), words_.At(i))) continue;
      found.use = true;
      found.room = {&archetype, i, words_.Says(i + 1, {"area", "space"}) ? i + 2 : i + 1};
      break;
    }
    return found;
  }

  // "The entrance is on the south wall", "a bookshop with the entrance at the front".
  bool IsADoor(const NamedRoom& room) const {
    return words_.Says(room.begin, {"entrance", "entry", "entryway"}) && room.end == room.begin + 1 && room.begin > 0 &&
           words_.Says(room.begin - 1, {"the", "an", "its"}) && (!found_.empty() || words_.Is(room.end, "door_verbs"));
  }

  // The kitchen door, next to the kitchen.
  bool IsOutside(const NamedRoom& room) const {
    const std::size_t next = words_.IsHyphen(room.end) ? room.end + 1 : room.end;
    if (words_.Is(next, "openings")) return true;
    std::size_t at = room.begin;
    while (at > 0 && words_.Is(at - 1, "before_a_room")) --at;
    return at > 0 && words_.Is(at - 1, "on_the_way_to");
  }

  // "A bathroom in an old flat", "we rent a flat with a living room": where the room is.
  bool IsTheHome(const NamedRoom& room) const {
    if (room.end != room.begin + 1 || !IsFormIn("houses", words_.At(room.begin))) return false;
    const std::size_t begin = words_.PhraseBegin(room.begin);
    return begin > 0 && words_.Is(begin - 1, "before_the_home");
  }

  // "Turning the garage into a bedroom", "a barn converted to a studio": what it was.
  bool BecomesAnother(std::size_t end) const {
    // "Converting the garage (5.5 x 3 m) into a gym".
    constexpr std::size_t kUsual = 3, kBehindBrackets = 9;
    const std::size_t most = words_.At(end) == "(" ? kBehindBrackets : kUsual;
    for (std::size_t i = end; i < end + most && !words_.EndsSentence(i); ++i) {
      if (words_.Is(i, "becoming")) return true;
    }
    return false;
  }

  // The "bar" of a grab bar or a bar stool.
  bool IsOfAPiece(const NamedRoom& room) const {
    for (std::size_t i = room.begin - std::min<std::size_t>(room.begin, 2); i <= room.begin; ++i) {
      const std::size_t end = i + LongestAt(handbook_.vocabulary().names, tokens_, i, /*plural=*/true).second;
      if (end >= room.end && end - i > room.end - room.begin) return true;
    }
    return false;
  }

  bool Closes(std::size_t i) const {
    return i >= words_.size() || words_.IsSign(i) || words_.IsNumber(i) || words_.Is(i, "after_a_room") ||
           words_.At(i).ends_with("ing");  // "a classroom seating 30"
  }

  // "with a small home office", "with a library and a piano": not "with a view of the church".
  bool IsHad(std::size_t i) const {
    constexpr std::size_t kMostWords = 4;
    for (std::size_t back = 1; back <= kMostWords && back <= i; ++back) {
      const std::string_view word = words_.At(i - back);
      if (IsIn("having", word) || IsOneOf(word, {"and", ",", "plus"})) return word != "without";
      if (IsIn("not_in_a_list", word) || words_.EndsSentence(i - back)) return false;
    }
    return false;
  }

  // Whether nothing but "/", "and" and an article lies between.
  bool IsListed(std::size_t from, std::size_t to) const {
    if (to < from || to > from + 5) return false;
    bool joined = false;
    for (std::size_t i = from; i < to; ++i) {
      // "a study that doubles as a guest room"
      const bool between = words_.Is(i, "room_list_signs") || words_.Says(i, {"cum", "doubles", "doubling"});
      joined = joined || between;
      if (!between && !words_.Is(i, "between_uses")) return false;
    }
    return joined;
  }

  // "kitchen diner", "kitchen living room".
  static bool IsOpenPlan(const NamedRoom& a, const NamedRoom& b) {
    const auto is_living = [](const NamedRoom& one) {
      return IsIn("open_plan", std::string_view(one.archetype->name()).substr(0, one.archetype->name().find(' ')));
    };
    return a.end == b.begin && is_living(a) && is_living(b);
  }

  // The rank of a name as that of the room itself: the higher, the likelier.
  static int RankOf(const Found& found) {
    const int length = static_cast<int>(std::min<std::size_t>(found.room.end - found.room.begin, 100));
    const int head = found.outside ? 0 : found.within ? 1 : 2;
    const int own = found.room.archetype->serving() ? 0 : 1;
    return ((head * 2 + own) * 2 + (found.use ? 0 : 1)) * 128 + length;
  }

  std::size_t Best() const {
    // A serving room before "with" is the room all the same: "a bathroom with a dressing room".
    std::size_t best = found_.size();
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (best == found_.size() || RankOf(found_[i]) > RankOf(found_[best])) best = i;
    }
    // "Hall door in the west wall" alone names none.
    return best < found_.size() && found_[best].outside && IsOutside(found_[best].room) ? found_.size() : best;
  }

  void AddOthers(std::size_t best, RoomKind& kind) const {
    const auto known = [&](const hb::Archetype* one) {
      const auto is = [&](const NamedRoom& room) { return room.archetype == one; };
      return is(kind.room) || std::ranges::any_of(kind.also, is) || std::ranges::any_of(kind.named, is);
    };
    const Found& head = found_[best];
    for (const Found& one : found_) {
      if (known(one.room.archetype) || one.outside || !one.closed) continue;
      const bool nested = one.room.begin >= kind.room.begin && one.room.end <= kind.room.end;
      if (nested) continue;
      const bool listed = one.list == head.list && head.closed && !one.within;
      const bool serving = one.room.archetype->serving() || kind.room.archetype->serving();
      if (listed && !serving) {
        kind.also.push_back(one.room);
      } else if (listed || one.had) {
        kind.named.push_back(one.room);
      }
    }
  }

  // "Living/dining" is a kind of its own where the handbook has a name for both together.
  void TakeTogether(RoomKind& kind) const {
    std::vector<NamedRoom> all = {kind.room};
    all.insert(all.end(), kind.also.begin(), kind.also.end());
    for (const NamedRoom& a : all) {
      for (const NamedRoom& b : all) {
        const std::string both = a.archetype->name() + " and " + b.archetype->name();
        for (const hb::Archetype& archetype : handbook_.contents().archetypes()) {
          if (std::ranges::find(archetype.synonyms(), both) == archetype.synonyms().end()) continue;
          std::erase_if(all, [first = a.archetype, second = b.archetype](const NamedRoom& one) {
            return one.archetype == first || one.archetype == second;
          });
          kind.room.archetype = &archetype;
          kind.also = std::move(all);
          return;
        }
      }
    }
  }

  void AddPlaces(RoomKind& kind) const {
    for (const Found& one : found_) {
      if (one.outside) continue;
      std::size_t at = one.room.end;
      while (words_.Is(at, "parts_of_a_room")) ++at;
      if (!words_.Is(at, "at_places")) continue;
      at = words_.BehindArticle(at + 1);
      if (!words_.Is(at, "ends_of_rooms") || !words_.Is(at + 1, "room_ends")) continue;
      kind.placed.push_back({one.room.archetype, one.room.begin, at + 2});
    }
  }

  const std::vector<Token>& tokens_;
  const BriefText words_;
  const Handbook& handbook_;
  std::vector<Found> found_;
};

}  // namespace

RoomKind ReadRoomKind(const std::vector<Token>& tokens, const Handbook& handbook) {
  return RoomKindReader(tokens, handbook).Read();
}

const hb::Archetype* MostHintedAt(const Handbook& handbook, const std::vector<Token>& tokens) {
  const BriefText text(tokens);
  const hb::Archetype* hinted = nullptr;
  int most = 0;
  for (const hb::Archetype& archetype : handbook.contents().archetypes()) {
    int hints = 0;
    for (const std::string& hint : archetype.hints()) {
      const Phrase words(hint);
      std::size_t i = 0;
      while (i < tokens.size() && (words.MatchAt(tokens, i) == 0 || IsCompared(text, i))) ++i;
      hints += i < tokens.size() ? 1 : 0;
    }
    if (hints <= most) continue;
    most = hints;
    hinted = &archetype;
  }
  return hinted;
}

const hb::Archetype& KindOfPieces(const Handbook& handbook, const std::vector<Token>& tokens) {
  constexpr int kFirst = 4, kMainPiece = 2;
  std::vector<std::string> named;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const auto [furniture, length] = LongestAt(handbook.vocabulary().names, tokens, i, /*plural=*/true);
    if (furniture == nullptr) continue;
    named.push_back(furniture->name());
    i += length - 1;
  }
  const hb::Archetype* kind = &handbook.fallback_archetype();
  int most = 0;
  for (const hb::Archetype& archetype : handbook.contents().archetypes()) {
    if (archetype.fallback() || archetype.zones().empty()) continue;
    int score = 0;
    bool any_main = false;
    for (const std::string& name : named) {
      const auto& usual = archetype.bands(archetype.bands_size() / 2).objects();
      const bool is_usual = std::ranges::find(usual, name, &hb::ObjectEntry::furniture) != usual.end();
      const int worth = Includes(archetype.zones(0).primaries(), name) ? kMainPiece : is_usual ? 1 : 0;
      any_main = any_main || worth == kMainPiece;
      score += worth * (&name == &named.front() ? kFirst : 1);
    }
    if (!any_main || score <= most) continue;
    most = score;
    kind = &archetype;
  }
  return *kind;
}

}  // namespace flair::language
