// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/reading/place_details.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include "language_worker/handbook/program/room_program.h"

namespace flair::language {

int WallsIn(const BriefText& text, std::size_t begin, std::size_t end) {
  if (!text.At(end - 1).ends_with('s')) return 1;
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && text.Says(i, {"all", "every", "each", "four"})) return 4;
    if (text.At(i) == "three") return 3;
    const bool listed = text.At(i) == "and" && text.Is(i - 1, "told_sides");
    if (listed || text.Says(i, {"both", "two"})) return 2;
  }
  return 1;
}

int OneForEach(const BriefText& text, const BriefFacts& facts, const Place& place, std::size_t begin, std::size_t end) {
  bool each = false, all = false, which = false;
  for (std::size_t i = begin; i < end; ++i) {
    which = which || text.Is(i, "which_corner");
    each = each || text.Says(i, {"each", "every"});
    all = all || text.Says(i, {"all", "four"});
  }
  // "In each of the back corners".
  if (place.side == "each" && (each || all)) return which ? 2 : 4;
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

std::optional<double> LengthBeside(const BriefText& text, std::size_t begin, std::size_t end, std::vector<bool>& used) {
  constexpr std::size_t kMostBefore = 5, kMostBehind = 4;
  for (std::size_t at = begin - std::min(begin, kMostBefore); at < end + kMostBehind; ++at) {
    std::size_t behind = at;
    const std::optional<double> length_m = at >= begin && at < end ? std::nullopt : text.LengthAt(at, behind);
    if (!length_m) continue;
    for (std::size_t k = at; k < behind; ++k) used[k] = true;
    return length_m;
  }
  return std::nullopt;
}

void TakeWallAcross(const PlacePatterns& patterns, Landmark::Kind kind, Place& place) {
  const bool door = kind == Landmark::Kind::kDoor;
  if (!(door || kind == Landmark::Kind::kWindow) || place.furniture->back() != hb::BACK_RULE_WALL ||
      !AskedNames(*place.asked, "faces the")) {
    return;
  }
  const hb::AskedPlace* wall = patterns.Find("against", "wall", hb::FURNITURE_KIND_FLOOR);
  if (wall == nullptr) return;
  place.asked = wall;
  place.side = door ? "far" : "across window";
}

void TakeCorner(Landmark::Kind kind, BriefFacts& facts, Place& place) {
  if (kind == Landmark::Kind::kDoor) place.side = "across at door";
  if (place.side == "each") place.which = -1;
  if (place.side != "opposite") return;
  for (std::size_t p = facts.places.size(); p-- > 0;) {
    Place& before = facts.places[p];
    if (AskedNames(*before.asked, "{wall}") && before.walls == 2 && before.side.find(' ') != std::string::npos) {
      place.side = "across " + before.side;
      return;
    }
    if (!AskedNames(*before.asked, "in a corner") || before.side == "each") continue;
    if (before.side.empty()) before.side = "far right";
    place.side = "across " + before.side;
    return;
  }
}

void NoteLoosely(const BriefText& text, const Place& place, std::size_t begin, std::size_t end, BriefFacts& facts) {
  const std::string& sentence = place.asked->relation().text();
  const auto note = [&](const std::string& kept) {
    facts.places_loosely_kept.push_back(fmt::format("Not just as asked: \"{}\": it {}", place.Words(), kept));
  };
  if (place.asked->carried() == hb::CARRIED_ALONG) return note("stands on the same top.");
  for (std::size_t k = begin; k < end; ++k) {
    if (!text.Is(k, "exact_directions") || sentence.find(text.At(k)) != std::string::npos) continue;
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

}  // namespace flair::language
