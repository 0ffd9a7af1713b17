// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/opening_reader.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "language_worker/handbook/reading/opening_parts.h"
#include "language_worker/handbook/reading/words.h"

namespace flair::language {

namespace {

class OpeningReader {
 public:
  OpeningReader(const std::vector<Token>& tokens, const std::vector<bool>& room, std::vector<bool>& used,
                OpeningWishes& openings)
      : words_(tokens),
        sites_(words_),
        list_(words_, openings),
        room_(room),
        used_(used),
        things_(used),
        openings_(openings) {
    for (std::size_t i = 0; i < things_.size(); ++i) things_[i] = used[i] && !room[i];
  }

  void Read() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (i < read_to_) continue;
      if (words_.At(i) == "windowless") {
        openings_.no_windows = true;
        Use(i, i + 1);
      } else if (const auto dark = words_.BehindPhrase(i, "no_daylight")) {
        openings_.no_windows = true;
        Use(i, *dark);
      } else if (!ReadAspect(i) && !ReadTheOther(i) && !room_[i]) {
        ReadOpening(i);
      }
    }
    list_.SettleRelations();
    list_.SettleContradictions();
  }

 private:
  // "a south-facing room", "a bedroom facing south": windows look that way, whatever others there are.
  bool ReadAspect(std::size_t i) {
    std::size_t compass = 0, end = 0;
    const auto room_at = [&](std::size_t k) {
      return k < words_.size() && (room_[k] || words_.Is(k, "rooms_that_face"));
    };
    if (words_.Is(i, "compass") && words_.Behind(i, std::string(words_.At(i)) + " facing")) {
      compass = i;
      end = *words_.Behind(i, std::string(words_.At(i)) + " facing");
      if (!room_at(end) && !room_at(end + 1)) return false;
    } else if (i > 0 && room_at(i - 1) && words_.Is(i, "looking") && words_.Is(i + 1, "compass")) {
      compass = i + 1;
      end = i + 2;
    } else {
      return false;
    }
    OpeningWish wish;
    wish.side = words_.At(compass);
    wish.of_many = true;
    wish.said = words_.Quote(i, end);
    Use(i, end);
    list_.Add(wish);
    return true;
  }

  void ReadOpening(std::size_t i) {
    OpeningNoun noun = OpeningNounAt(words_, things_, i);
    if (noun.kind == OpeningNoun::Kind::kNone || noun.any) return;
    if (noun.kind == OpeningNoun::Kind::kOverhead) return NoteOverhead(noun);
    OpeningWish& wish = noun.wish;
    std::size_t end = ReadMeasures(words_, noun.end, wish);
    OpeningSite site;
    const bool after = sites_.ReadAfter(end, wish.door, !noun.related, site);
    if (after && (!noun.related || site.not_read.empty())) end = ReadMeasures(words_, site.end, wish);
    if (noun.related && (site.sides.empty() || !site.not_read.empty())) return NoteRelated(noun);
    if (noun.none) return NoteNone(noun, site, end);
    std::size_t begin = noun.begin;
    const bool own_side = !site.sides.empty() || !wish.side.empty();
    if (!own_side && !noun.related) {
      const OpeningSite before = sites_.ReadBefore(begin);
      site.sides = before.sides;
      if (!before.sides.empty()) begin = before.end;
      if (site.along.at == AlongWall::At::kAny) site.along = before.along;
      // "On the south wall a door and a window."
      if (before.sides.empty() && listed_ && IsJoined(begin)) site.sides = *listed_;
    }
    if (!site.sides.empty()) {
      wish.side.clear();
    } else if (!wish.side.empty()) {
      site.sides = {wish.side};
    }
    if (site.along.at != AlongWall::At::kAny) wish.along = site.along;
    wish.said = words_.Quote(begin, end);
    if (site.sides.empty() && wish.count > 1 && wish.counted && TakeShares(wish, end)) return Use(begin, last_end_);
    if (!Says(noun, site)) return;
    listed_.reset();
    if (begin < noun.begin || (!own_side && !site.sides.empty())) listed_ = site.sides;
    // "a door and a window on the same wall"
    if (site.sides == std::vector<std::string>{"same"}) {
      site.sides = {last_end_ > 0 && IsJoinedByAnd(begin) && last_door_ && !wish.door ? "near" : "far"};
    }
    if (after && own_side && shared_from_ && site.sides[0] != "near" && IsJoinedByAnd(begin)) ShareWithTheLast(site);
    shared_from_ = site.sides.empty() && !noun.related && !openings_.wishes.empty();
    if (!site.not_read.empty()) {
      openings_.not_read.push_back(
          fmt::format("\"{}\": openings can be placed by walls, corners, doors and windows, not by furniture or "
                      "lengths; it is placed where it fits.",
                      wish.said));
    }
    const std::size_t before = openings_.wishes.size();
    if (!site.by_side.empty()) AddTheOther(site, !wish.door);
    if (site.pair && !wish.counted) wish.counted = true;
    if (site.pair) wish.count = std::max(wish.count, 2);
    list_.AddOnSides(noun, site);
    shared_from_ = site.sides.empty() && openings_.wishes.size() > before;
    Use(begin, end);
    last_door_ = wish.door;
    last_end_ = end;
  }

  // Whether the words ask for something, or tell something of an opening.
  bool Says(const OpeningNoun& noun, const OpeningSite& site) {
    const OpeningWish& wish = noun.wish;
    const bool told = wish.width_m || wish.height_m || wish.sill_m || wish.swing != v1::DOOR_SWING_UNSPECIFIED ||
                      wish.along.at != AlongWall::At::kAny || wish.outside || !wish.leads_to.empty() ||
                      !wish.kind.empty();
    if (!site.sides.empty() || !site.not_read.empty()) return true;
    if (wish.definite) {
      openings_.window_meant = openings_.window_meant || !wish.door;
      return told;
    }
    if (!noun.bare || told) return true;
    // "with large windows"; a door there is anyway.
    openings_.window_meant = openings_.window_meant || !wish.door;
    return !wish.door && words_.At(noun.noun).ends_with('s');
  }

  void NoteOverhead(const OpeningNoun& noun) {
    if (noun.none) return Use(noun.begin, noun.end);
    openings_.not_read.push_back(fmt::format("\"{}\" is in the ceiling, which has no openings here; it was left out.",
                                             words_.Quote(noun.begin, noun.end)));
    Use(noun.begin, noun.end);
  }

  // "a desk under the window", "near the kitchen door".
  void NoteRelated(const OpeningNoun& noun) {
    openings_.window_meant = openings_.window_meant || !noun.wish.door;
    if (!noun.wish.door || (!noun.wish.outside && noun.wish.leads_to.empty())) return;
    OpeningNoun door = noun;
    door.wish.definite = true;
    door.wish.said = words_.Quote(noun.begin, noun.end);
    list_.AddOnSides(door, {});
  }

  void NoteNone(const OpeningNoun& noun, const OpeningSite& site, std::size_t end) {
    Use(noun.begin, end);
    if (site.sides.empty()) {
      (noun.wish.door ? openings_.no_doors : openings_.no_windows) = true;
    } else if (!noun.wish.door) {
      openings_.bare_sides.insert(openings_.bare_sides.end(), site.sides.begin(), site.sides.end());
    }
  }

  // "two windows, one on the north wall and one on the east wall".
  bool TakeShares(const OpeningWish& all, std::size_t end) {
    constexpr std::size_t kMostShares = 4;
    std::size_t at = end;
    std::vector<OpeningWish> shares;
    while (shares.size() < kMostShares) {
      std::size_t next = at;
      for (int over = 0; over < 3 && words_.Is(next, "share_links"); ++over) ++next;
      if (words_.At(next) == "the") ++next;
      int count = 1;
      if (const std::optional<int> number = NumberWord(words_.At(next)); number && *number > 1 && *number < 4) {
        count = *number;
      } else if (!words_.Is(next, "shares")) {
        break;
      }
      ++next;
      for (int over = 0; over < 2 && (words_.Says(next, {"one", "of", "them"}) ||
                                      words_.At(next).starts_with(all.door ? "door" : "window"));
           ++over) {
        ++next;
      }
      OpeningSite site;
      OpeningWish share = all;
      next = ReadMeasures(words_, next, share);
      if (!sites_.ReadAfter(next, all.door, /*verbs=*/true, site) || site.sides.empty()) break;
      share.count = count;
      share.side = site.sides[0];
      share.along = site.along;
      share.said = words_.Quote(next, site.end);
      shares.push_back(share);
      at = site.end;
    }
    if (shares.empty()) return false;
    int left = all.count;
    for (OpeningWish& share : shares) {
      share.said = fmt::format("{}: {}", all.said, share.said);
      left -= share.count;
      list_.Add(share);
    }
    if (left > 0) {
      OpeningWish rest = all;
      rest.count = left;
      list_.Add(rest);
    }
    last_end_ = at;
    last_door_ = all.door;
    return true;
  }

  // "the other is on the east wall", "another on the west side", behind one that was read.
  bool ReadTheOther(std::size_t i) {
    constexpr std::size_t kFarthest = 4;
    if (!last_end_ || i > last_end_ + kFarthest || !words_.Says(i, {"other", "another", "second"})) return false;
    const std::size_t next = words_.At(i + 1) == "one" ? i + 2 : i + 1;
    OpeningNoun noun;
    noun.wish.door = last_door_;
    noun.wish.counted = true;
    noun.part = true;
    OpeningSite site;
    if (!sites_.ReadAfter(next, last_door_, /*verbs=*/true, site) || site.sides.empty() || !site.not_read.empty()) {
      return false;
    }
    noun.wish.along = site.along;
    noun.wish.said = words_.Quote(i, site.end);
    list_.AddOnSides(noun, site);
    Use(i, site.end);
    last_end_ = site.end;
    return true;
  }

  bool IsJoined(std::size_t begin) const {
    std::size_t at = last_end_;
    while (at < begin && words_.Says(at, {",", "and", "also"})) ++at;
    return at == begin;
  }
  bool IsJoinedByAnd(std::size_t begin) const { return begin == last_end_ + 1 && words_.At(last_end_) == "and"; }

  // "a door and a window on the north wall": both.
  void ShareWithTheLast(const OpeningSite& site) {
    OpeningWish& last = openings_.wishes.back();
    if (last.side.empty() && last.count == 1 && site.sides.size() == 1) last.side = site.sides[0];
  }

  // "opposite the window on the east wall" tells of a window, too.
  void AddTheOther(const OpeningSite& site, bool door) {
    OpeningNoun other;
    other.wish.door = door;
    other.wish.definite = true;
    other.wish.counted = true;
    other.wish.said = site.by_side;
    OpeningSite there;
    there.sides = {site.by_side};
    list_.AddOnSides(other, there);
  }

  void Use(std::size_t begin, std::size_t end) {
    end = std::min(end, used_.size());
    for (std::size_t i = begin; i < end; ++i) used_[i] = true;
    read_to_ = std::max(read_to_, end);
  }

  const BriefText words_;
  const OpeningSiteReader sites_;
  OpeningList list_;
  const std::vector<bool>& room_;
  std::vector<bool>& used_;
  std::vector<bool> things_;
  OpeningWishes& openings_;
  std::optional<std::vector<std::string>> listed_;  // walls of the last one, when they were said before it
  bool shared_from_ = false;                        // the last one has no wall yet
  bool last_door_ = false;
  std::size_t last_end_ = 0;
  std::size_t read_to_ = 0;
};

}  // namespace

void ReadOpenings(const std::vector<Token>& tokens, const std::vector<bool>& room, std::vector<bool>& used,
                  OpeningWishes& openings) {
  OpeningReader(tokens, room, used, openings).Read();
}

}  // namespace flair::language
