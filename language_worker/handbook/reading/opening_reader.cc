// SPDX-License-Identifier: GPL-3.0-or-later
// Over 400 lines: one pass over the words of a brief; what a phrase means depends on the opening that was named last.
#include "language_worker/handbook/reading/opening_reader.h"

#include <algorithm>
#include <utility>

#include "fmt/format.h"
#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

// "south-west" as two words; `places` are where its tokens were.
std::vector<Token> WithoutHyphens(const BriefText& text, std::vector<std::size_t>& places) {
  std::vector<Token> tokens;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.IsHyphen(i)) continue;
    tokens.push_back(text.tokens()[i]);
    places.push_back(i);
  }
  return tokens;
}

class OpeningReader {
 public:
  OpeningReader(const std::vector<Token>& tokens, const std::vector<bool>& room, std::vector<bool>& used,
                OpeningWishes& openings)
      : text_(tokens),
        tokens_(WithoutHyphens(text_, places_)),
        words_(tokens_),
        list_(openings),
        used_(used),
        openings_(openings) {
    for (const std::size_t place : places_) {
      room_.push_back(room[place]);
      things_.push_back(used[place] && !room[place]);
    }
    for (std::size_t i = 0; i < words_.size(); ++i) {
      if (!words_.Is(i, "onlookers")) continue;
      list_.LookOn();
      break;
    }
  }

  void Read() {
    for (std::size_t i = 0; i < words_.size(); i = std::max(i + 1, read_to_)) {
      const bool read =
          ReadDark(i) || ReadWindowWall(i) || ReadAspect(i) || ReadWayIn(i) || ReadWayOut(i) || ReadOneOfThem(i);
      if (!read && !room_[i]) ReadNamed(i);
    }
    list_.Settle();
  }

 private:
  using Sides = std::vector<std::string>;

  // What was read last, as far as the next one may go by it.
  struct Last {
    std::size_t end = 0;
    bool door = false;
    bool open = false;  // it has no wall yet
    Sides sides;        // said before it: "On the south wall a door and a window"
  };

  // "a windowless room", "no daylight"; "the windowless long wall".
  bool ReadDark(std::size_t i) {
    const auto dark = words_.BehindPhrase(i, "no_daylight");
    if (!dark) {
      openings_.other_way_in = openings_.other_way_in || IsOtherWayIn(i);
      return false;
    }
    std::size_t end = *dark;
    const Sides walls = WallsAt(words_, *dark, /*alone=*/true, end);
    if (walls.empty()) openings_.no_windows = true;
    openings_.bare_sides.insert(openings_.bare_sides.end(), walls.begin(), walls.end());
    Use(i, walls.empty() ? *dark : end);
    return true;
  }

  // "A trapdoor as the only entrance": its sentence names no door.
  bool IsOtherWayIn(std::size_t i) const {
    const auto end = words_.BehindPhrase(i, "only_ways_in");
    if (!end) return false;
    for (std::size_t k = *end; !words_.EndsSentence(k); ++k) {
      if (words_.Is(k, "doors")) return false;
    }
    for (std::size_t k = i; k > 0 && !words_.EndsSentence(k - 1); --k) {
      if (words_.Is(k - 1, "ways_through_the_floor")) return true;
    }
    return false;
  }

  // "the window wall": windows are in no other.
  bool ReadWindowWall(std::size_t i) {
    if (!words_.Is(i, "windows") || !words_.Is(i + 1, "wall_nouns")) return false;
    openings_.windows_meant = openings_.one_window_wall = true;
    return true;
  }

  // "a south-facing room", "a bedroom facing south": windows look that way, whatever others there are.
  bool ReadAspect(std::size_t i) {
    const auto room_at = [&](std::size_t k) {
      return k < words_.size() && (room_[k] || words_.Is(k, "rooms_that_face"));
    };
    const bool before = words_.Is(i, "compass") && words_.At(i + 1) == "facing" && (room_at(i + 2) || room_at(i + 3));
    const bool behind = i > 0 && room_at(i - 1) && words_.Is(i, "looking") && words_.Is(i + 1, "compass");
    if (!before && !behind) return false;
    OpeningWish wish;
    wish.of_many = true;
    wish.said = Quote(i, i + 2);
    wish.side = words_.At(before ? i : i + 1);
    list_.Add(wish);
    Use(i, i + 2);
    return true;
  }

  // "You come in from the west", "it is entered on the short side"; "open on the south side", as wide as that is.
  bool ReadWayIn(std::size_t i) {
    const bool open = words_.At(i) == "open" && !words_.Is(i - std::min<std::size_t>(i, 1), "doors");
    const auto behind = open ? std::optional(i + 1) : words_.BehindPhrase(i, "coming_in");
    if (!behind || !words_.Says(*behind, {"from", "on", "at", "through"})) return false;
    OpeningSite site;
    if (!ReadSiteAfter(words_, *behind, /*door=*/true, /*verbs=*/false, site) || site.sides.size() != 1) return false;
    OpeningWish wish{.door = true, .definite = true, .side = site.sides[0], .along = site.along, .fills = open};
    if (open) wish.swing = v1::DOOR_SWING_NONE;
    wish.said = Quote(i, site.end);
    list_.Add(wish);
    Use(i, site.end);
    return true;
  }

  // "The way to the balcony": there is a door.
  bool ReadWayOut(std::size_t i) {
    if (!words_.Is(i, "ways_out")) return false;
    OpeningNoun noun;
    noun.wish.door = noun.wish.definite = true;
    const std::size_t end = ReadMeasures(words_, i + 1, noun);
    if (!noun.wish.outside) return false;
    noun.wish.said = Quote(i, end);
    Name(i, noun.wish);
    list_.Add(noun, {});
    Use(i, end);
    return true;
  }

  // "a four-door cabinet", "a window-seat".
  bool IsPartOfAName(std::size_t i) const {
    const std::size_t place = places_[i];
    const bool counted =
        i > 0 && (words_.IsNumber(i - 1) || NumberWord(words_.At(i - 1))) && places_[i - 1] + 1 < place;
    return text_.IsHyphen(place + 1) || counted;
  }

  void ReadNamed(std::size_t i) {
    if (IsPartOfAName(i)) return;
    OpeningNoun noun = OpeningNounAt(words_, things_, i);
    if (noun.kind == OpeningNoun::Kind::kNone) return;
    if (noun.kind == OpeningNoun::Kind::kOverhead) return NoteOverhead(noun);
    OpeningSite site;
    const std::size_t end = ReadBehind(noun, noun.end, site);
    // The doors of a piece are on no two walls.
    if (noun.kind == OpeningNoun::Kind::kOfAPiece && site.sides.size() < 2) return Use(noun.begin, noun.end);
    if (!noun.wish.door && !noun.none && !noun.glass)
      (noun.plural || noun.any ? openings_.windows_meant : openings_.window_meant) = true;
    if (noun.any) return;
    Name(i, noun.wish);
    const bool told = !site.sides.empty() || !noun.wish.side.empty() || site.fills;
    if (noun.glass && !noun.whole_wall && !told) return;
    if (noun.related && (!told || !site.not_read.empty())) return NoteRelated(noun);
    if (noun.none) return NoteNone(noun, site, end);
    Place(noun, site, end);
  }

  // "Kitchen hatch", "street door".
  void Name(std::size_t head, OpeningWish& wish) const {
    if (!wish.door) return;
    if (wish.leads_to == "room") wish.leads_to.clear();
    const bool named = words_.Is(head, "named_openings");
    const std::string of = wish.leads_to.empty() ? wish.name : wish.leads_to;
    if (!named && of.empty()) return;
    wish.name = of + (of.empty() ? "" : " ") + (named ? std::string(words_.At(head)) : "door");
  }

  // "one on the north wall and one to the larder", "the other is on the west wall", right behind openings.
  bool ReadOneOfThem(std::size_t i) {
    constexpr std::size_t kMostLinks = 3;
    if (!last_ || i < last_->end || i > last_->end + kMostLinks) return false;
    for (std::size_t k = last_->end; k < i; ++k) {
      if (!words_.Is(k, "share_links")) return false;
    }
    std::size_t at = words_.At(i) == "the" ? i + 1 : i;
    OpeningNoun noun;
    noun.wish.door = last_->door;
    noun.wish.counted = noun.part = true;
    const std::optional<int> number = NumberWord(words_.At(at));
    if (number == 2 || number == 3) noun.wish.count = *number;
    if (noun.wish.count == 1 && !words_.Is(at, "shares")) return false;
    while (words_.Is(++at, "of_them")) {
    }
    noun.begin = i;
    OpeningSite site;
    const std::size_t end = ReadBehind(noun, at, site);
    Name(i, noun.wish);
    const bool leads = noun.wish.outside || !noun.wish.leads_to.empty() || !noun.wish.name.empty();
    if ((site.sides.empty() && !leads) || !site.not_read.empty()) return false;
    noun.wish.along = site.along;
    noun.wish.said = Quote(i, end);
    list_.Add(noun, site);
    Use(i, end);
    last_->end = end;
    return true;
  }

  // What stands behind a noun: measures, then places, then measures again.
  std::size_t ReadBehind(OpeningNoun& noun, std::size_t at, OpeningSite& site) const {
    const std::size_t end = ReadMeasures(words_, at, noun);
    if (!ReadSiteAfter(words_, end, noun.wish.door, /*verbs=*/!noun.related, site)) return end;
    return noun.related && !site.not_read.empty() ? end : ReadMeasures(words_, site.end, noun);
  }

  // Settles where an opening is by what stands before it and by what was named last, and lists it.
  void Place(OpeningNoun& noun, OpeningSite& site, std::size_t end) {
    OpeningWish& wish = noun.wish;
    if (!wish.side.empty() && site.sides == Sides{"street"}) site.sides = {wish.side};
    const bool behind = !site.sides.empty(), own = behind || !wish.side.empty();
    std::size_t begin = noun.begin;
    Sides listed;
    if (!own && !noun.related) {
      const OpeningSite before = ReadSiteBefore(words_, begin);
      site.sides = listed = before.sides;
      if (!before.sides.empty()) begin = before.end;
      if (site.along.at == AlongWall::At::kAny) site.along = before.along;
      if (before.sides.empty() && last_ && Joins(begin)) site.sides = listed = last_->sides;
    }
    if (site.sides.empty() && !wish.side.empty()) site.sides = {wish.side};
    if (site.sides.empty() && site.that && last_ && !openings_.wishes.empty())
      site.sides = {openings_.wishes.back().side};
    // "A low door with a tiny window on either side".
    const bool linked = last_ && last_->door && begin > 0 && words_.At(begin - 1) == "with" && begin <= last_->end + 2;
    if (linked && !wish.door && site.sides == Sides{"left", "right"}) {
      site.sides = {"beside"};
      site.pair = true;
    }
    wish.side.clear();
    if (site.along.at != AlongWall::At::kAny) wish.along = site.along;
    wish.fills = site.fills;
    if (wish.door && wish.fills) wish.width_m.reset();  // as wide as its wall lets it
    wish.said = Quote(begin, end);
    if (!Says(noun, site)) {
      if (wish.door && wish.definite) unsaid_ = {noun, end};
      return;
    }
    // "With the door and a window in the short wall": of a door that nothing else is said of.
    if (unsaid_ && behind && words_.At(unsaid_->second) == "and" && begin <= unsaid_->second + 2) {
      list_.Add(unsaid_->first, {});
      last_ = Last{unsaid_->second, true, true, {}};
      unsaid_.reset();
    }
    const bool anded = last_ && begin <= last_->end + 2 && begin > last_->end && words_.At(last_->end) == "and";
    // "a door and a window on the same wall"
    if (site.sides == Sides{"same"}) site.sides = {wish.door || (last_ && last_->door) ? "near" : "far"};
    if (anded && behind && last_->open && site.sides.size() == 1 && site.sides[0] != "near") Share(wish, site);
    NoteUnread(noun, site, end);
    if (site.pair) {
      wish.count = std::max(wish.count, 2);
      wish.counted = wish.flanks = true;
    }
    const std::size_t before = openings_.wishes.size();
    list_.Add(noun, site);
    Use(begin, end);
    last_ = Last{end, wish.door, site.sides.empty() && openings_.wishes.size() > before, listed};
  }

  // "a door and a window on the north wall": both; of "the short wall" the same one.
  void Share(const OpeningWish& wish, OpeningSite& site) {
    OpeningWish& other = openings_.wishes.back();
    if (!other.side.empty() || other.count != 1) return;
    other.side = site.sides[0];
    if (!IsIn("long_or_short", site.sides[0]) || wish.door == other.door) return;
    const bool in = other.door ? !other.outside && other.leads_to.empty() : !wish.outside && wish.leads_to.empty();
    if (!in) return;
    if (other.door) {
      site.sides = {"near"};
    } else {
      other.side = "near";
    }
  }

  // Whether nothing but commas and "and" is between the last one and this.
  bool Joins(std::size_t begin) const {
    std::size_t at = last_->end;
    while (at < begin && words_.Says(at, {",", "and", "also"})) ++at;
    return at == begin;
  }

  // Whether the words ask for something, or tell something of an opening.
  static bool Says(const OpeningNoun& noun, const OpeningSite& site) {
    const OpeningWish& wish = noun.wish;
    const bool told = wish.width_m || wish.height_m || wish.sill_m || wish.swing != v1::DOOR_SWING_UNSPECIFIED ||
                      wish.along.at != AlongWall::At::kAny || wish.outside || !wish.leads_to.empty() ||
                      !wish.name.empty() || !wish.kind.empty();
    if (!site.sides.empty() || !site.not_read.empty()) return true;
    if (!wish.definite && (!noun.bare || told)) return true;
    // "with large windows"; a door there is anyway.
    return wish.definite ? told : !wish.door && noun.plural;
  }

  // A place that goes by furniture, or words for a wall of which nothing was made.
  void NoteUnread(const OpeningNoun& noun, const OpeningSite& site, std::size_t end) {
    constexpr std::size_t kMostWords = 6;
    // "A window over the sink": the sink goes under it.
    const bool taken =
        !noun.wish.door && words_.Says(noun.end, {"over", "above"}) &&
        std::any_of(things_.begin() + static_cast<std::ptrdiff_t>(noun.end),
                    things_.begin() + static_cast<std::ptrdiff_t>(end), [](bool thing) { return thing; });
    if (taken) return;
    if (!site.not_read.empty()) {
      openings_.not_read.push_back(
          fmt::format("\"{}\": openings can be placed by walls, corners, doors and windows, not by furniture or "
                      "lengths; it is placed where it fits.",
                      noun.wish.said));
      return;
    }
    if (noun.related || !site.sides.empty()) return;
    for (std::size_t i = end; i < end + kMostWords && i < words_.size(); ++i) {
      if (words_.IsSign(i) || things_[i] || words_.Is(i, "clause_starts") || words_.Is(i, "articles_of_others")) return;
      if (!words_.Is(i, "wall_sides") && !words_.Is(i, "wall_nouns") && !words_.Is(i, "corners")) continue;
      openings_.not_read.push_back(fmt::format(
          "\"{}\": where it is to be was not understood; it is placed where it fits.", Quote(noun.begin, i + 1)));
      return;
    }
  }

  void NoteOverhead(const OpeningNoun& noun) {
    if (!noun.none) {
      openings_.not_read.push_back(fmt::format("\"{}\" is in the ceiling, which has no openings here; it was left out.",
                                               Quote(noun.begin, noun.end)));
    }
    Use(noun.begin, noun.end);
  }

  // "a desk under the window", "near the kitchen door", "on the long wall opposite the windows".
  void NoteRelated(OpeningNoun& noun) {
    OpeningWish& wish = noun.wish;
    wish.definite = true;
    wish.said = Quote(noun.begin, noun.end);
    const std::string side = WallBefore(words_, noun.begin);
    const bool named = wish.door && (wish.outside || !wish.leads_to.empty() || !wish.name.empty());
    const bool told = !wish.door && (wish.sill_m || wish.height_m || !wish.kind.empty() || wish.width_m);
    if (!side.empty()) {
      list_.Hint(noun, side);
    } else if (named || told) {
      list_.Add(noun, {});
    }
  }

  void NoteNone(OpeningNoun& noun, const OpeningSite& site, std::size_t end) {
    Use(noun.begin, end);
    // "No door that opens inwards": it opens the other way.
    v1::DoorSwing& swing = noun.wish.swing;
    if (swing == v1::DOOR_SWING_INWARD || swing == v1::DOOR_SWING_OUTWARD) {
      swing = swing == v1::DOOR_SWING_INWARD ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
      noun.wish.said = Quote(noun.begin, end);
      noun.wish.definite = true;
      list_.Add(noun, site);
      return;
    }
    if (site.sides.empty()) {
      (noun.wish.door ? openings_.no_doors : openings_.no_windows) = true;
    } else if (!noun.wish.door) {
      openings_.bare_sides.insert(openings_.bare_sides.end(), site.sides.begin(), site.sides.end());
    }
  }

  // The brief's own words, with their hyphens.
  std::string Quote(std::size_t begin, std::size_t end) const {
    return begin < end ? text_.Quote(places_[begin], places_[end - 1] + 1) : "";
  }

  void Use(std::size_t begin, std::size_t end) {
    Mark(places_[begin], places_[end - 1] + 1, used_);
    read_to_ = std::max(read_to_, end);
  }

  const BriefText text_;
  std::vector<std::size_t> places_;
  const std::vector<Token> tokens_;
  const BriefText words_;
  OpeningList list_;
  std::vector<bool> room_, things_;
  std::vector<bool>& used_;
  OpeningWishes& openings_;
  std::optional<Last> last_;
  std::optional<std::pair<OpeningNoun, std::size_t>> unsaid_;  // a door that nothing was said of, and its end
  std::size_t read_to_ = 0;
};

}  // namespace

void ReadOpenings(const std::vector<Token>& tokens, const std::vector<bool>& room, std::vector<bool>& used,
                  OpeningWishes& openings) {
  OpeningReader(tokens, room, used, openings).Read();
}

}  // namespace flair::language
