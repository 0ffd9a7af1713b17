// SPDX-License-Identifier: GPL-3.0-or-later
// Where openings are: a wall, an end or corner of one, by other openings, by the way in, and by furniture.
#include <algorithm>
#include <optional>
#include <string>

#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

using At = AlongWall::At;
using Sides = std::vector<std::string>;

// Reads one place after the other from `i` on; each Take moves it behind what it has read.
class SiteReader {
 public:
  SiteReader(const BriefText& words, std::size_t i, OpeningSite& site) : words_(words), i_(i), site_(site) {}

  std::size_t end() const { return i_; }

  // "door on the south wall, near the corner", "door: south wall", "window (north)", "window, which is on the left".
  bool TakeAll(bool door, bool verbs) {
    constexpr int kMostParts = 6, kMostVerbs = 4;
    bool any = false;
    for (int part = 0; part < kMostParts; ++part) {
      const std::size_t start = i_;
      const bool pause = words_.At(i_) == ",", clause = pause && words_.Says(i_ + 1, {"which", "that"});
      const bool list = !any && words_.Says(i_, {":", "(", "-"});
      if (pause || list) ++i_;
      for (int over = 0; over < kMostVerbs && (clause || (verbs && !pause)) && SaysNoPlace(); ++over) ++i_;
      const bool part_only = pause && !clause;
      // Behind a comma a wall may be that of something else; not where a piece told none.
      const bool thing = !site_.not_read.empty();
      if (!TakeFilling() && !TakeEntering() && !TakeFromEnd() && !TakeMiddle() && !(!part_only && TakeOpening(door)) &&
          !TakeWall({.bare = list || thing, .part = part_only}) && !(!any && !pause && TakeThing())) {
        i_ = start;
        break;
      }
      if (list && words_.At(i_) == ")") ++i_;
      any = true;
      site_.end = i_;
    }
    if (!site_.sides.empty()) site_.not_read.clear();
    return any;
  }

  struct Form {
    bool bare = false;  // without a preposition
    bool part = false;  // behind a comma: an end or corner of a wall, or a wall that ends its phrase
  };

  // "on the north wall", "facing south", "on the north and east walls", "take up most of the north wall"; "at the west
  // end of the north wall", "in the north-east corner", "near a corner".
  bool TakeWall(Form form) {
    const auto close = words_.BehindPhrase(i_, "close_to"), fill = words_.BehindPhrase(i_, "occupying_a_wall");
    const bool into = fill || words_.Is(i_, "into"), near = close || words_.Is(i_, "at_or_near");
    std::size_t at = fill ? *fill : close ? *close : into || near ? i_ + 1 : i_;
    const auto whole = words_.BehindPhrase(words_.BehindArticle(at), "whole_length");
    if (into && whole) at = *whole;
    if ((into || near) && (TakeBothEnds(at) || TakePart(at))) return true;
    if (TakeEnd(form, into, at)) return true;
    if (form.part && !form.bare && !words_.Is(i_, "into_a_wall")) return false;
    // "Stage left" is the right of those who look on.
    const std::size_t stage = words_.BehindArticle(at);
    if (words_.Is(stage, "stages") && words_.Says(stage + 1, {"left", "right"})) {
      AddSide(words_.At(stage + 1) == "left" ? "right" : "left");
      i_ = stage + 2;
      return true;
    }
    // "A window north and a door south" has no "on" either.
    if (!into && !form.bare && !words_.Is(at, "compass")) return false;
    const Sides sides = WallsAt(words_, at, /*alone=*/!into, at);
    const bool noun = words_.Is(at - 1, "wall_nouns") || words_.Is(at - 1, "wall_ends");
    if (sides.empty() || (form.part && !(noun && EndsWall(words_, at)))) return false;
    site_.fills = site_.fills || (into && (whole || fill || words_.At(i_) == "across"));
    // "Facing each other in the short walls".
    if (each_other_) site_.sides = sides.size() > 1 ? sides : Sides{sides[0], "across " + sides[0]};
    each_other_ = false;
    if (sides.size() == 1 && site_.sides.size() == 1) {
      const bool hand = IsOneOf(site_.sides[0], {"left", "right"}) && !form.part;
      // "On the left on the north wall"; "at the north-west corner, on the west wall".
      if (hand) site_.along = {At::kEnd, sides[0], {}};
      if (sides[0] == site_.along.end) std::swap(site_.sides[0], site_.along.end);
    }
    for (const std::string& side : sides) AddSide(side);
    i_ = at;
    return true;
  }

  // "in the middle of the west wall", "centred on it", "midway along the north wall"; not of the room.
  bool TakeMiddle() {
    const auto centred = words_.BehindPhrase(i_, "centred"), middle = words_.BehindPhrase(i_, "in_the_middle");
    if (!centred && !middle) return false;
    std::size_t at = centred ? *centred : *middle;
    if (centred ? words_.Is(at, "centred_on") : words_.At(at) == "of") {
      const auto that = words_.BehindPhrase(++at, "that_wall");
      const Sides sides = WallsAt(words_, at, /*alone=*/true, at);
      if (sides.empty() && !that) return false;
      if (sides.empty()) at = *that;
      if (!sides.empty()) site_.sides = sides;
      site_.that = sides.empty();
    }
    site_.along.at = At::kMiddle;
    i_ = at;
    return true;
  }

 private:
  void AddSide(const std::string& side) {
    if (!Includes(site_.sides, side)) site_.sides.push_back(side);
  }

  // "full width", "wall to wall".
  bool TakeFilling() {
    const auto filling = words_.BehindPhrase(i_, "filling_a_wall");
    if (!filling || words_.At(*filling) == "of") return false;
    site_.fills = true;
    i_ = *filling;
    return true;
  }

  // An end of the wall that was named: "on the south wall at the right", "the door, right hand end", "on the west wall
  // towards the north", "in the north wall, by the west wall".
  bool TakeEnd(Form form, bool into, std::size_t at) {
    const auto toward = words_.BehindPhrase(i_, "toward_an_end");
    WallTarget end = WallTargetAt(words_, toward ? *toward : into ? at : i_);
    if (end.sides.size() == 2 && IsOneOf(end.sides[1], {"left", "right"})) end.sides.erase(end.sides.begin());
    if (end.sides.size() != 1 || !EndsWall(words_, end.end)) return false;
    const std::string& side = end.sides[0];
    const bool hand = IsOneOf(side, {"left", "right"}), told = !site_.sides.empty();
    const bool across = told && AxisOf(side) != '-' && AxisOf(side) != AxisOf(site_.sides.back());
    const bool part = end.end_of_wall || end.corner;
    // "In the south wall on the right side."
    const bool its_side = told && IsIn("compass", site_.sides.back()) && words_.At(end.end - 1) == "side";
    const bool by_hand = hand && (part ? form.part && !into : told && (!end.wall || its_side));
    if (!by_hand && !(toward && told && (hand || across))) return false;
    site_.along = {At::kEnd, side, {}};
    i_ = end.end;
    return true;
  }

  // 'n' for walls in the north or south, 'e' for those in the east or west, '-' where nobody knows.
  static char AxisOf(std::string_view side) {
    if (IsIn("northern_walls", side) || IsIn("southern_walls", side)) return 'n';
    return IsIn("eastern_walls", side) || IsIn("western_walls", side) ? 'e' : '-';
  }

  // "At each end of the south wall": one at the left, one at the right.
  bool TakeBothEnds(std::size_t at) {
    const auto ends = words_.BehindPhrase(at, "both_ends");
    if (!ends) return false;
    std::size_t end = *ends;
    if (words_.At(end) == "of") {
      const auto that = words_.BehindPhrase(end + 1, "that_wall");
      const Sides walls = WallsAt(words_, end + 1, /*alone=*/true, end);
      if (walls.size() == 1) site_.sides = walls;
      if (walls.empty() && that) end = *that;
    }
    if (site_.sides.size() != 1) return false;
    site_.both_ends = true;
    i_ = end;
    return true;
  }

  // "the west end of the north wall", "the north-east corner", "a corner", "the left of the south wall".
  bool TakePart(std::size_t at) {
    WallTarget target = WallTargetAt(words_, at);
    std::size_t end = target.end;
    bool of_wall = false;
    if (words_.At(end) == "of") {
      const auto that = words_.BehindPhrase(end + 1, "that_wall");
      std::size_t behind = 0;
      const Sides walls = WallsAt(words_, end + 1, /*alone=*/true, behind);
      of_wall = !walls.empty() || (that && !site_.sides.empty());
      // "One of the long walls" is no part of one.
      if (of_wall && !target.corner && !target.end_of_wall && target.sides.empty()) return false;
      if (!walls.empty()) site_.sides = walls;
      if (of_wall) end = walls.empty() ? *that : behind;
    }
    if (!of_wall) {
      // The wall itself, or "a window at the north end" of a room; "a glass front with the door at its left end".
      const bool its = words_.At(at) == "its" && site_.sides.empty();
      if (!target.corner && !(target.end_of_wall && !target.wall && (its || !site_.sides.empty()))) return false;
      site_.that = its && target.end_of_wall;
      if (target.corner && target.sides.size() == 2 && site_.sides.empty()) {
        site_.sides = {target.sides[0]};
        target.sides.erase(target.sides.begin());
      }
    }
    site_.along = {At::kEnd, "", {}};
    // Of "the north-east corner of the north wall" the east one.
    for (const std::string& one : target.sides) {
      if (site_.sides.empty() || one != site_.sides[0]) site_.along.end = one;
    }
    i_ = end;
    return true;
  }

  // "50 cm from the left corner", "1 m from the west wall".
  bool TakeFromEnd() {
    std::size_t at = 0;
    const std::optional<double> length_m = words_.LengthAt(i_, at);
    const std::optional<std::size_t> from = length_m ? words_.BehindPhrase(at, "measured_from") : std::nullopt;
    if (!from) return false;
    const WallTarget target = WallTargetAt(words_, *from);
    if (!target.wall && !target.corner && !target.end_of_wall && target.sides.empty()) return false;
    site_.along = {At::kEnd, target.sides.empty() ? "" : target.sides[0], length_m};
    i_ = target.end;
    if (words_.At(i_) != "of") return true;
    std::size_t end = 0;
    const Sides walls = WallsAt(words_, i_ + 1, /*alone=*/true, end);
    if (walls.empty()) return true;
    site_.sides = walls;
    i_ = end;
    return true;
  }

  // "opposite the door", "either side of the door", "next to the window", "opposite each other". Where a wall was said
  // already it holds.
  bool TakeOpening(bool door) {
    const auto across = words_.BehindPhrase(i_, "opposite_openings");
    const auto beside = words_.BehindPhrase(i_, "beside_openings");
    if (!across && !beside) return false;
    std::size_t at = words_.BehindArticle(across ? *across : *beside);
    if (across && words_.Behind(at, "each other")) {
      if (site_.sides.size() == 1) AddSide("across " + site_.sides[0]);
      each_other_ = site_.sides.empty();
      if (each_other_) site_.sides = {"left", "right"};
      i_ = at + 2;
      return true;
    }
    // "two windows opposite", "a door beside it": of what was named last.
    const auto closes = [&](std::size_t k) {
      return k >= words_.size() || words_.IsSign(k) || words_.Says(k, {"and", "with"});
    };
    const bool of_it = words_.At(at) == "it" || (words_.Says(at, {"first", "other"}) && closes(at + 1));
    if ((across && closes(at)) || of_it) {
      site_.sides = {across ? "opposite" : "beside"};
      i_ = of_it ? at + 1 : at;
      return true;
    }
    if (words_.At(at) == "other") ++at;
    if (words_.Is(at, "which_door") && words_.Is(at + 1, "openings")) ++at;
    if (!words_.Is(at, "openings")) return false;
    const bool window = words_.At(at).starts_with("window");
    site_.pair = beside && words_.BehindPhrase(i_, "on_both_sides").has_value();
    // What is said of that one is read with it.
    i_ = at;
    // A window by a window and a door by a door go by the last one of their kind, a window by the door by the way in.
    const std::string its = window != door ? "same" : window ? "window" : "near";
    if (site_.sides.empty()) site_.sides = {!across ? its : its == "near" ? "far" : "across " + its};
    return true;
  }

  // "on the left as you enter", "straight ahead when you come in".
  bool TakeEntering() {
    const std::size_t at = words_.BehindPhrase(i_, "entering").value_or(i_);
    for (const auto& [list, side] : {std::pair("ahead", "far"), std::pair("on_the_left", "left"),
                                     std::pair("on_the_right", "right"), std::pair("behind_you", "near")}) {
      const auto way = words_.BehindPhrase(at, list);
      if (!way) continue;
      // "on the left of", "on the left-hand wall".
      if (words_.Is(*way, "wall_nouns") || words_.Says(*way, {"of", "hand", "end", "corner"})) return false;
      const bool hand = IsOneOf(side, {"left", "right"});
      if (!site_.sides.empty() && !hand) return false;
      if (site_.sides.empty()) {
        site_.sides = {side};
      } else {
        site_.along = {At::kEnd, side, {}};
      }
      i_ = words_.BehindPhrase(words_.At(*way) == "," ? *way + 1 : *way, "entering").value_or(*way);
      return true;
    }
    return false;
  }

  // "above the sink", "behind the sofa": a place that goes by a piece of furniture.
  bool TakeThing() {
    constexpr std::size_t kMostWords = 4;
    const auto by = words_.BehindPhrase(i_, "by_a_thing");
    if (!by) return false;
    std::size_t at = *by;
    while (at < *by + kMostWords && at < words_.size() && !words_.IsSign(at) && !words_.Is(at, "thing_stops")) ++at;
    if (at == *by) return false;
    site_.not_read = words_.Quote(i_, at);
    i_ = at;
    return true;
  }

  // "is", "to be", the "right" of "right opposite": before the words for a place.
  bool SaysNoPlace() const {
    if (words_.At(i_) == "to") return words_.At(i_ + 1) == "be";
    if (words_.At(i_) == "right") return words_.Is(i_ + 1, "right_before_places");
    return words_.Is(i_, "site_verbs") && !words_.BehindPhrase(i_, "occupying_a_wall");
  }

  const BriefText& words_;
  std::size_t i_;
  OpeningSite& site_;
  bool each_other_ = false;
};

}  // namespace

bool ReadSiteAfter(const BriefText& words, std::size_t i, bool door, bool verbs, OpeningSite& site) {
  return SiteReader(words, i, site).TakeAll(door, verbs);
}

OpeningSite ReadSiteBefore(const BriefText& words, std::size_t begin) {
  constexpr std::size_t kMostWords = 10;
  for (std::size_t start = begin - std::min(begin, kMostWords); start < begin; ++start) {
    const bool opens =
        start == 0 || (words.IsSign(start - 1) && words.At(start - 1) != "'") || words.Is(start - 1, "clause_starts");
    if (!opens) continue;
    OpeningSite site;
    SiteReader reader(words, start, site);
    if (!(reader.TakeMiddle() || reader.TakeWall({.bare = true})) || site.sides.empty()) continue;
    // "On the south wall there is", "the south wall has", "the short wall is nearly all window".
    bool linked = words.Is(start, "into");
    std::size_t at = reader.end();
    for (; at < begin &&
           (words.Is(at, "there_is") || words.Is(at, "blank_walls") ||
            (words.At(at) == "and" && words.Is(at - 1, "blank_walls")) || words.Says(at, {",", ":", "-", "'s", "'"}));
         ++at) {
      linked = linked || words.Says(at, {"has", "have", "is", "with", ":"});
    }
    if (!linked || at < begin) continue;
    site.end = start;
    return site;
  }
  return {};
}

std::string WallBefore(const BriefText& words, std::size_t begin) {
  constexpr std::size_t kMostWords = 7;
  for (std::size_t start = begin - std::min(begin, kMostWords); start < begin; ++start) {
    if (!words.Is(start, "articles")) continue;
    const WallTarget target = WallTargetAt(words, start);
    if (!target.wall || target.sides.size() != 1 || target.end >= begin) continue;
    const std::string& side = target.sides[0];
    // An article of the opening stands between.
    const auto across = words.BehindPhrase(target.end, "opposite_openings");
    const auto beside = words.BehindPhrase(target.end, "walls_of_openings");
    if (across && words.BehindArticle(*across) >= begin && *across <= begin) return "across " + side;
    if (beside && words.BehindArticle(*beside) >= begin && *beside <= begin) return side;
  }
  return "";
}

}  // namespace flair::language
