// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_details.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "language_worker/handbook/reading/own_classes.h"
#include "language_worker/handbook/reading/piece_words.h"

namespace flair::language {
namespace {

bool Stands(const Mention& mention) {
  return !mention.seats && IsOnTheFloor(*mention.furniture) && !mention.furniture->walk_over();
}

bool BelongsToAWall(const hb::Furniture& furniture) {
  return furniture.back() == hb::BACK_RULE_WALL || furniture.back() == hb::BACK_RULE_CORNER;
}

// "A rocking chair stands by the window with a side table": the chair, of the table.
std::optional<std::size_t> HolderOf(const BriefText& text, const std::vector<Mention>& mentions,
                                    const MentionList& named, const std::vector<bool>& used, std::size_t held) {
  while (held > 0 && named.AreListed(held - 1, held)) --held;
  std::size_t at = text.PhraseBegin(mentions[held].begin);
  if (at == 0 || text.At(at - 1) != "with") return std::nullopt;
  for (--at; at > 0 && !named.At(at - 1) && (used[at - 1] || text.Is(at - 1, "place_fillers"));) --at;
  return named.EndingAt(at);
}

}  // namespace

bool IsPartOfTheRoom(const Landmark& landmark) {
  using Kind = Landmark::Kind;
  return landmark.kind == Kind::kWall || landmark.kind == Kind::kWindow || landmark.kind == Kind::kDoor;
}

bool GoesAlong(const hb::Furniture& furniture, Landmark::Kind kind) {
  return IsOnATop(furniture) || (kind == Landmark::Kind::kWall && furniture.run() != hb::RUN_PART_UNSPECIFIED);
}

bool IsOfTheHolder(const PlacePatterns::Match& match, const hb::Furniture& held, const hb::Furniture& holder) {
  // "A table with six chairs and a sideboard on the left wall".
  const bool at_wall = match.landmark.kind == Landmark::Kind::kWall && held.back() == hb::BACK_RULE_WALL;
  if (at_wall && IsOnTheFloor(held) && holder.back() != hb::BACK_RULE_WALL) return false;
  switch (match.landmark.kind) {
    case Landmark::Kind::kPronoun:
      return false;
    case Landmark::Kind::kPiece:
      return IsOnATop(held);
    case Landmark::Kind::kNone:
      return !AskedNames(*match.asked, "{target}") && !AskedNames(*match.asked, "{first}") &&
             match.asked->relation().pairing() != hb::PAIRING_TOGETHER;
    default:
      return true;
  }
}

void TakeStand(const Reading& reading, const PlacePatterns::Match& match, const hb::Furniture*& piece) {
  if (piece->kind() != hb::FURNITURE_KIND_SURFACE || piece->companions().empty() || match.asked->carried() != 0) return;
  const std::string& side = match.landmark.side;
  if (match.landmark.kind == Landmark::Kind::kWall && (side.empty() || side == "opposite")) return;
  const hb::Furniture* stand = reading.handbook.FindFurniture(piece->companions(0).furniture());
  // On a dresser that is asked for, too.
  const auto host = std::ranges::find_if(reading.facts.wishes, [&](const Wish& wish) {
    return Includes(piece->hosts(), wish.furniture->name()) && wish.furniture->back() == hb::BACK_RULE_WALL;
  });
  if (host != reading.facts.wishes.end()) stand = host->furniture;
  if (stand != nullptr && IsOnTheFloor(*stand) && !IsFor(*match.asked, *piece, false) &&
      IsFor(*match.asked, *stand, false))
    piece = stand;
}

const hb::Furniture* StorageAlong(const Reading& reading, std::size_t i, const hb::AskedPlace& asked,
                                  const hb::Furniture& piece) {
  const auto& [handbook, text, used, facts] = reading;
  constexpr double kTallM = 1.5;
  constexpr int kCases = 3;
  if (!text.Is(i, "along_a_wall") || !AskedNames(asked, "{wall}") || !IsOnATop(piece)) return &piece;
  for (const std::string& name : piece.hosts()) {
    const hb::Furniture* host = handbook.FindFurniture(name);
    if (host == nullptr || host->back() != hb::BACK_RULE_WALL || host->height_m().typical() < kTallM) continue;
    facts.wishes.push_back({.furniture = host, .count = kCases, .counted = false});
    return host;
  }
  return &piece;
}

std::string SeenByAnAudience(std::string side) {
  for (const auto& [said, seen] : {std::pair("front", "far"), std::pair("back", "near"), std::pair("rear", "near")}) {
    const std::size_t at = side.find(said);
    if (at != std::string::npos) return side.replace(at, std::string_view(said).size(), seen);
  }
  return side;
}

int WallsIn(const BriefText& text, std::size_t begin, std::size_t end) {
  const bool every = text.Says(end - 2, {"every", "each"}) && text.Is(end - 1, "wall_nouns");
  if (!text.At(end - 1).ends_with('s')) return every ? 4 : 1;
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && text.Says(i, {"all", "every", "each", "four"})) return 4;
    if (text.At(i) == "three") return 3;
    const bool listed = text.At(i) == "and" && text.Is(i - 1, "told_sides");
    if (listed || text.Says(i, {"both", "two"})) return 2;
  }
  return 1;
}

int OneForEach(const Reading& reading, const Place& place, std::size_t begin, std::size_t end) {
  const auto& [handbook, text, used, facts] = reading;
  bool each = false, all = false, which = false;
  for (std::size_t i = begin; i < end; ++i) {
    which = which || text.Is(i, "which_corner");
    each = each || text.Says(i, {"each", "every"});
    all = all || text.Says(i, {"all", "four"});
  }
  // "In each of the back corners".
  const bool told = place.side.starts_with("each ");
  if (told || (place.side == "each" && (each || all))) return told || which ? 2 : 4;
  // "A barre along both long walls".
  if (place.walls > 1) return place.walls;
  const auto target = std::ranges::find(facts.wishes, place.target, &Wish::furniture);
  return each && place.target != nullptr && target != facts.wishes.end() ? target->count : 0;
}

const hb::Furniture* ComesWith(const BriefText& text, const std::vector<Mention>& mentions, std::size_t m) {
  for (const std::size_t first : {m - 1, m}) {
    if (first >= mentions.size() || first + 1 == mentions.size() || text.At(mentions[first].end) != "with") continue;
    const Mention& carried = mentions[first + 1];
    const bool one = carried.furniture->kind() == hb::FURNITURE_KIND_SURFACE && carried.count == 1 &&
                     text.PhraseBegin(carried.begin) == mentions[first].end + 1;
    if (one) return mentions[first == m ? m + 1 : first].furniture;
  }
  return nullptr;
}

std::optional<double> LengthBeside(const Reading& reading, std::size_t begin, std::size_t end) {
  constexpr std::size_t kMostBefore = 5, kMostBehind = 4;
  for (std::size_t at = begin - std::min(begin, kMostBefore); at < end + kMostBehind; ++at) {
    std::size_t behind = at;
    const std::optional<double> length_m = at >= begin && at < end ? std::nullopt : reading.text.LengthAt(at, behind);
    if (!length_m) continue;
    reading.Use(at, behind);
    return length_m;
  }
  return std::nullopt;
}

std::optional<PlacePatterns::Match> PlaceByItself(const BriefText& text, std::size_t i, const PlacePatterns& patterns,
                                                  const std::string& across) {
  const bool corner = text.Says(i, {"front", "back", "rear", "far", "near"}) && text.Says(i + 1, {"left", "right"});
  const bool wall = text.At(i) == "opposite" && !across.empty() && !text.Says(i - std::min<std::size_t>(i, 1), {"the"});
  PlacePatterns::Match match;
  // "A bookcase left as you come in".
  const bool side = text.Says(i, {"left", "right"}) && i > 0 && !text.Is(i - 1, "determiners");
  if (const auto entering = side ? text.BehindPhrase(i + 1, "entering") : std::nullopt) {
    match = {patterns.Find("against", "wall", hb::FURNITURE_KIND_FLOOR), {}, 1, *entering};
    match.landmark.kind = Landmark::Kind::kWall;
    match.landmark.end = *entering;
    match.landmark.side = text.At(i);
    return match;
  }
  match.length = corner ? 2 : 1;
  const std::size_t end = match.landmark.end = match.end = i + match.length;
  const bool sign = end >= text.size() || (text.IsSign(end) && !text.IsHyphen(end));
  const bool ends = sign || text.Is(end, "place_ends") || text.BehindPhrase(end, "of_the_room");
  if (!(corner && ends) && !(wall && (ends || text.Says(end, {"a", "an", "is", "are"})))) return std::nullopt;
  match.asked = patterns.Find(corner ? "in" : "against", corner ? "corner" : "wall", hb::FURNITURE_KIND_FLOOR);
  match.landmark.kind = corner ? Landmark::Kind::kCorner : Landmark::Kind::kWall;
  match.landmark.side = corner ? text.Quote(i, end) : across;
  return match.asked == nullptr ? std::nullopt : std::optional(match);
}

void TakeWindowForIt(const BriefText& text, const PlacePatterns& patterns, const std::vector<Mention>& mentions,
                     std::size_t m, std::size_t i, PlacePatterns::Match& match) {
  constexpr std::size_t kMostBack = 18;
  const std::size_t begin = text.PhraseBegin(mentions[m].begin);
  const std::size_t least = std::max(m > 0 ? mentions[m - 1].end : 0, begin - std::min(begin, kMostBack));
  for (std::size_t k = begin; k > least && !text.EndsSentence(k - 1); --k) {
    if (!text.Is(k - 1, "windows")) continue;
    const std::size_t window = text.PhraseBegin(k - 1);
    if (window > 0 && text.Is(window - 1, "relating")) return;
    const hb::AskedPlace* asked = patterns.Find(text.Quote(i, match.end - 1), "window", mentions[m].furniture->kind());
    const bool before = text.Says(i, {"in", "before"});
    if (asked == nullptr || !(before || AskedNames(*asked, "under the window"))) return;
    match.asked = asked;
    match.landmark.kind = Landmark::Kind::kWindow;
    return;
  }
}

bool PutBetweenWindows(const BriefText& text, const PlacePatterns& patterns, std::size_t before, std::size_t begin,
                       std::size_t end, Place& place, OpeningWishes& openings) {
  const auto says_windows = [&](std::size_t from, std::size_t to) {
    while (from < to && text.At(from) != "windows") ++from;
    return from < to;
  };
  // "Two windows with a desk between them".
  const bool them = text.Says(end - 1, {"them", "between", "two"}) && says_windows(before, begin);
  if (!text.Says(begin, {"between", "in"}) || text.At(begin + 1) == "front" || !(them || says_windows(begin, end)))
    return false;
  const hb::AskedPlace* middle = patterns.Find("in the middle of", "wall", place.furniture->kind());
  if (middle == nullptr) middle = patterns.Find("in the middle of", "wall", hb::FURNITURE_KIND_FLOOR);
  if (middle == nullptr) return false;
  place.asked = middle;
  place.side = "window";
  const auto is_window = [](const OpeningWish& one) { return !one.door; };
  auto windows = std::ranges::find_if(openings.wishes, is_window);
  if (windows == openings.wishes.end()) {
    openings.wishes.push_back({.count = 2, .said = text.Quote(begin, end)});
    windows = openings.wishes.end() - 1;
  }
  // All of them are in one wall.
  if (windows->side.empty() && windows->count > 1) windows->side = "far";
  return true;
}

void TakeWallAcross(const PlacePatterns& patterns, Landmark::Kind kind, bool looks, const OpeningWishes& openings,
                    Place& place) {
  if (looks && kind == Landmark::Kind::kWall && PlacesOn(*place.furniture) > 0 && IsIn("compass", place.side)) {
    const bool window = std::ranges::any_of(
        openings.wishes, [&](const OpeningWish& one) { return !one.door && one.side == place.side; });
    const hb::AskedPlace* at_it = patterns.Find("facing", "window", hb::FURNITURE_KIND_FLOOR);
    // Who sits at a desk that "faces the north wall" has that wall ahead.
    if (!window && !place.furniture->sat_at()) place.side = "across " + place.side;
    if (window && at_it != nullptr) place.asked = at_it;
    return;
  }
  const bool door = kind == Landmark::Kind::kDoor;
  if (!(door || kind == Landmark::Kind::kWindow) || place.furniture->back() != hb::BACK_RULE_WALL ||
      place.furniture->sat_at() || !AskedNames(*place.asked, "faces the")) {
    return;
  }
  const hb::AskedPlace* wall = patterns.Find("against", "wall", hb::FURNITURE_KIND_FLOOR);
  if (wall == nullptr) return;
  place.asked = wall;
  place.side = door ? "far" : "across window";
}

void TakeCorner(Landmark::Kind kind, BriefFacts& facts, Place& place) {
  if (kind == Landmark::Kind::kDoor) place.side = "across at door";
  if (place.side.starts_with("each")) place.which = -1;
  if (place.side != "opposite") return;
  for (std::size_t p = facts.places.size(); p-- > 0;) {
    Place& before = facts.places[p];
    if (AskedNames(*before.asked, "{wall}") && before.walls == 2 && before.side.find(' ') != std::string::npos) {
      place.side = "across " + before.side;
      return;
    }
    if (!AskedNames(*before.asked, "in a corner") || before.side.starts_with("each")) continue;
    if (before.side.empty()) before.side = "far right";
    place.side = "across " + before.side;
    return;
  }
}

void NoteLoosely(const Reading& reading, const Place& place, std::size_t begin, std::size_t end) {
  const auto& [handbook, text, used, facts] = reading;
  const std::string& sentence = place.asked->relation().text();
  const auto note = [&](const std::string& kept) {
    facts.places_loosely_kept.push_back(fmt::format("Not just as asked: \"{}\": it {}", place.Words(), kept));
  };
  if (place.asked->carried() == hb::CARRIED_ALONG) return note("stands on the same top.");
  for (std::size_t k = begin; k < end; ++k) {
    if (!text.Is(k, "exact_directions") || sentence.find(text.At(k)) != std::string::npos) continue;
    if (place.side.find(text.At(k)) != std::string::npos) continue;
    // "Right in the centre", "just inside the door".
    if (text.Is(k + 1, "right_before_places") || text.Is(k - 1, "just_words")) continue;
    if (sentence.find("left") != std::string::npos || sentence.find("right") != std::string::npos) {
      return facts.places_loosely_kept.push_back(
          fmt::format("\"{}\" is read as one sees it who looks at the front.", place.Words()));
    }
    std::string kept = sentence.substr(sentence.find('}') + 2);
    if (const std::size_t slot = kept.find("{target}"); slot != std::string::npos && place.target != nullptr) {
      kept.replace(slot, std::string_view("{target}").size(), place.target->name());
    }
    return note(kept);
  }
}

void DropRowsAround(std::vector<Place>& places) {
  std::erase_if(places, [&](const Place& row) {
    return row.asked->relation().text().find("side by side") != std::string::npos &&
           std::ranges::any_of(
               places, [&](const Place& one) { return one.target == row.furniture && one.other == row.furniture; });
  });
}

std::vector<NamedArea> AreasIn(const BriefText& text, const std::vector<Mention>& mentions, const MentionList& named) {
  constexpr std::size_t kMostBetween = 10;
  std::vector<NamedArea> areas;
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (!text.Is(i, "areas_of_rooms") || named.At(i)) continue;
    const bool corner = text.Says(i, {"corner", "nook"}), plain = text.Says(i - 1, {"a", "an"});
    if (text.Is(i - 1, "told_sides") || (text.Is(i - 1, "determiners") && !(corner && plain))) continue;
    for (std::size_t k = i + 1; k < i + kMostBetween && !text.EndsSentence(k) && !named.At(k); ++k) {
      if (!text.Is(k, "listing_an_area")) continue;
      const std::optional<std::size_t> first = named.From(k + 1);
      if (!first) break;
      NamedArea area{i, *first, *first, *first, corner};
      // "With a bookshelf and a lamp, and a dining table": the last is the room's again.
      const auto joins = [&](std::size_t m, bool behind_a_comma) {
        for (std::size_t j = mentions[m].end; j < mentions[m + 1].begin; ++j) {
          if (text.At(j) == "and" && (text.At(j - 1) == ",") == behind_a_comma) return true;
        }
        return false;
      };
      bool closed = false;
      while (area.last + 1 < mentions.size() && named.AreListed(area.last, area.last + 1)) {
        if (closed && joins(area.last, true)) break;
        closed = closed || joins(area.last, false);
        ++area.last;
      }
      for (std::size_t m = area.last + 1; m-- > area.first;) {
        const bool stands = Stands(mentions[m]) && mentions[m].count == 1;
        if (stands && (!corner || BelongsToAWall(*mentions[m].furniture))) area.main = m;
      }
      areas.push_back(area);
      break;
    }
  }
  return areas;
}

void StandTogether(const Reading& reading, const std::vector<Mention>& mentions, const MentionList& named,
                   const std::vector<NamedArea>& areas, const PlacePatterns& patterns) {
  const auto& [handbook, text, used, facts] = reading;
  constexpr double kSmallM2 = 1.5, kTableM2 = 0.36;
  const hb::AskedPlace* near = patterns.Find("near", "target", hb::FURNITURE_KIND_FLOOR);
  const hb::AskedPlace* in_corner = patterns.Find("in", "corner", hb::FURNITURE_KIND_FLOOR);
  const hb::AskedPlace* before = patterns.Find("at the foot of", "target", hb::FURNITURE_KIND_FLOOR);
  if (near == nullptr || in_corner == nullptr) return;
  const auto is_placed = [&](const Mention& mention) {
    return std::ranges::find(facts.places, mention.furniture, &Place::furniture) != facts.places.end();
  };
  const auto put = [&](const Mention& mention, const hb::AskedPlace* asked, const hb::Furniture* target,
                       std::string said) {
    if (!Stands(mention) || mention.furniture == target || is_placed(mention)) return;
    const int which = target == nullptr && mention.count > 1 ? 0 : -1;
    facts.places.push_back({.furniture = mention.furniture,
                            .asked = asked,
                            .target = target,
                            .which = which,
                            .said = std::move(said),
                            .called = text.Quote(mention.begin, mention.end)});
  };
  for (const NamedArea& area : areas) {
    const std::size_t begin = text.BehindArticle(text.PhraseBegin(area.word));
    const std::string said = "in the " + text.Quote(begin, area.word + 1);
    if (area.corner) put(mentions[area.main], in_corner, nullptr, said);
    for (std::size_t m = area.first; m <= area.last; ++m) put(mentions[m], near, mentions[area.main].furniture, said);
  }
  // What is in a set stands by its largest piece.
  for (NamedSet& set : facts.sets) {
    const hb::Furniture* main = nullptr;
    for (const Mention& mention : mentions) {
      if (mention.begin <= set.noun && set.noun < mention.end) AddOnce(set.pieces, mention.furniture);
    }
    const auto area_m2 = [](const hb::Furniture& one) { return one.width_m().typical() * one.depth_m().typical(); };
    for (const hb::Furniture* piece : set.pieces) {
      const bool larger = main == nullptr || area_m2(*piece) > area_m2(*main);
      if (IsFloorPiece(*piece) && larger) main = piece;
    }
    // "Working stations" of a nail studio that say nothing of the table have the room's own.
    const hb::Furniture* usual = handbook.FindFurniture(facts.archetype->per_person());
    const bool has_usual = usual != nullptr && IsFloorPiece(*usual) && PlacesOn(*usual) == 0;
    if (main != nullptr && has_usual && IsFormIn("stations", set.name) && area_m2(*main) < kTableM2) {
      main = usual;
      AddOnce(set.pieces, usual);
      facts.wishes.push_back({.furniture = usual, .count = set.count});
    }
    if (main == nullptr) continue;
    std::ranges::partition(set.pieces, [&](const hb::Furniture* piece) { return piece == main; });
    const std::string& category = main->category();
    const bool table = category.ends_with("table") || category.ends_with("bench") || category == "desk";
    for (const Mention& mention : mentions) {
      if (!Includes(set.pieces, mention.furniture) || StandsWith(*mention.furniture, *main)) continue;
      const hb::AskedPlace* where = table && before != nullptr && IsSeat(*mention.furniture) ? before : near;
      put(mention, where, main, "at each " + (set.name.empty() ? main->name() : set.name));
    }
  }
  for (std::size_t m = 0; m < mentions.size(); ++m) {
    const hb::Furniture& furniture = *mentions[m].furniture;
    const std::optional<std::size_t> holder = HolderOf(text, mentions, named, used, m);
    const bool small = furniture.width_m().typical() * furniture.depth_m().typical() <= kSmallM2;
    if (!holder || !small || !Stands(mentions[*holder]) || furniture.run() != hb::RUN_PART_UNSPECIFIED) continue;
    put(mentions[m], near, mentions[*holder].furniture,
        "with the " + text.Quote(mentions[*holder].begin, mentions[*holder].end));
  }
}

}  // namespace flair::language
