// SPDX-License-Identifier: GPL-3.0-or-later
// What stands behind the words for an opening and tells of itself: where it leads, its size, its number, how it opens.
#include <optional>
#include <string>
#include <vector>

#include "language_worker/handbook/reading/opening_parts.h"

namespace flair::language {

namespace {

// A place that a door can lead to; `end` is 0 where none is named.
struct Lead {
  std::size_t begin = 0;
  std::size_t end = 0;
};

// "kitchen", "the small waiting room". `any`: also a word that names none of those that are known, "to the bakehouse".
Lead LeadAt(const BriefText& words, std::size_t i, bool any) {
  std::size_t at = words.BehindArticle(i);
  const bool article = at > i;
  const auto known = [&](std::size_t k) {
    return words.Is(k, "open_air") || IsFormIn("inner_rooms", words.At(k)) || words.Is(k, "ways_in") ||
           words.At(k).ends_with("room");
  };
  if (words.Is(at, "before_other_rooms") && known(at + 1)) ++at;
  // "a door to the side wall" is none that leads to a side.
  if (words.Is(at, "sides_of_a_house") || words.Is(at, "wall_sides")) return {};
  // "On the street side."
  if (words.Is(at, "street_walls") && (words.Is(at + 1, "wall_nouns") || words.Is(at + 1, "wall_ends"))) return {};
  const bool roomy = words.IsWord(at) && words.Is(at + 1, "room_endings");
  const bool unknown = any && article && words.IsWord(at) && !words.Is(at, "wall_nouns") &&
                       !words.Is(at, "wall_ends") && !words.Is(at, "corners") && !words.Is(at, "openings") &&
                       (words.IsSign(at + 1) || at + 1 >= words.size() || words.Is(at + 1, "after_a_wall"));
  if (!known(at) && !(any && roomy) && !unknown) return {};
  return {at, at + (words.Is(at + 1, "room_endings") ? 2 : 1)};
}

void TakeLead(const BriefText& words, const Lead& lead, OpeningWish& wish) {
  if (words.Is(lead.begin, "open_air") || words.Is(lead.end - 1, "open_air")) {
    wish.outside = true;
    if (words.At(lead.begin) != "balcony") wish.width_m = wish.width_m.value_or(wish.count == 1 ? 0.9 : kPairOfLeavesM);
  } else {
    wish.outside = false;  // glass doors between rooms
  }
  (words.Is(lead.begin, "ways_in") ? wish.name : wish.leads_to) = words.Quote(lead.begin, lead.end);
}

// "to the kitchen", "leading out to the garden", "onto the balcony", ", to the prep room".
bool TakeLeads(const BriefText& words, std::size_t& i, OpeningNoun& noun) {
  std::size_t at = words.At(i) == "," ? i + 1 : i;
  const bool pause = at > i;
  if (words.Says(at, {"that", "which"})) ++at;
  if (words.Is(at, "leading")) ++at;
  if (words.Says(at, {"out", "on", "through"}) && words.Says(at + 1, {"to", "onto", "into"})) ++at;
  const bool to = words.Says(at, {"to", "onto", "into"});
  if (!words.Is(at, "leads_to") || (pause && !to)) return false;
  if (const auto rest = words.BehindPhrase(at + 1, "the_rest_of_the_house"); rest && to) {
    i = *rest;
    return true;
  }
  const Lead lead = LeadAt(words, at + 1, to);
  if (lead.end == 0) return false;
  TakeLead(words, lead, noun.wish);
  i = lead.end;
  const Lead other = noun.plural && words.At(i) == "and" ? LeadAt(words, i + 1, false) : Lead{};
  if (other.end == 0) return true;
  noun.leads = {words.Quote(lead.begin, lead.end), words.Quote(other.begin, other.end)};
  i = other.end;
  return true;
}

// Of several doors: ", bedroom and bathroom,", "(hall, kitchen and garden)".
bool TakeRoomList(const BriefText& words, std::size_t& i, OpeningNoun& noun) {
  if (!noun.plural || !words.Says(i, {",", ":", "(", "-"})) return false;
  std::vector<std::string> all;
  std::size_t at = i + 1;
  for (Lead lead = LeadAt(words, at, false); lead.end > 0; lead = LeadAt(words, at, false)) {
    all.push_back(words.Quote(lead.begin, lead.end));
    at = lead.end;
    if (!words.Is(at, "and_signs") || LeadAt(words, at + 1, false).end == 0) break;
    ++at;
  }
  if (all.size() < 2) return false;
  noun.leads = all;
  noun.wish.count = std::max(noun.wish.count, static_cast<int>(all.size()));
  i = words.Says(at, {",", ")"}) ? at + 1 : at;
  return true;
}

// "1.2 m wide", "of 1.2 m x 1.5 m", "(90 cm)", "with a sill at 1.1 m".
bool TakeLengths(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  if (words.At(at) == ",") ++at;
  const bool bracket = words.At(at) == "(";
  if (bracket) ++at;
  bool sill = false;
  for (int over = 0; over < 6 && words.Is(at, "before_opening_sizes"); ++over)
    sill = words.At(at++).starts_with("sill") || sill;
  std::size_t end = 0;
  std::optional<double> first = words.LengthAt(at, end);
  // "80 x 60 cm": only the last has a unit.
  if (!first && words.IsNumber(at) && words.Says(at + 1, {"x", "by"}) && words.NumberAt(at + 2) > 0) {
    first = words.LengthAt(at + 2, end);
    if (first) *first *= words.NumberAt(at) / words.NumberAt(at + 2);
    end = at + 1;
  }
  const std::optional<std::size_t> above = words.BehindPhrase(end, "above_the_floor");
  if (!first || *first <= 0 || (words.Is(end, "after_distances") && !above)) return false;
  // "..., 4 m x 3 m" is the room.
  constexpr double kLeastRoomM = 2.5;
  if (words.At(i) == "," && *first >= kLeastRoomM && words.Says(end, {"x", "by"})) return false;
  if (sill || above) {
    wish.sill_m = first;
    i = above.value_or(end);
    return true;
  }
  (words.Is(end, "heights") ? wish.height_m : wish.width_m) = first;
  wish.width_factor = 1;
  at = words.Is(end, "opening_dimensions") ? end + 1 : end;
  const std::optional<double> second = words.Says(at, {"x", "by", "and"}) ? words.LengthAt(at + 1, end) : std::nullopt;
  if (second && *second > 0) {
    wish.height_m = second;
    at = words.Is(end, "heights") ? end + 1 : end;
  }
  i = bracket && words.At(at) == ")" ? at + 1 : at;
  return true;
}

// ", high,".
bool TakeHeight(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  constexpr double kHighM = 1.5, kLowM = 0.4;
  if (const auto up = words.BehindPhrase(i, "high_up"); up && !wish.door) return wish.sill_m = kHighM, i = *up, true;
  const bool high = words.Is(i + 1, "high_windows");
  const bool ends = i + 2 >= words.size() || words.IsSign(i + 2);
  if (wish.door || words.At(i) != "," || !ends || !(high || words.Is(i + 1, "low_windows"))) return false;
  wish.sill_m = high ? kHighM : kLowM;
  i += 2;
  return true;
}

// "(there are three)", "(3)".
bool TakeNumber(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i + 1;
  if (words.At(i) != "(") return false;
  while (words.Is(at, "there_is") || words.At(at) == "'s") ++at;
  const std::optional<int> number = OpeningCountAt(words, at);
  if (!number || words.At(at + 1) != ")") return false;
  wish.count = *number;
  wish.counted = true;
  i = at + 2;
  return true;
}

// "opening outwards", "that swings into the room", "reaching the floor".
bool TakeSwing(const BriefText& words, std::size_t& i, OpeningWish& wish) {
  std::size_t at = i;
  for (int over = 0; over < 3 && words.Is(at, "before_swings"); ++over) ++at;
  if (!wish.door) {
    const auto full = words.BehindPhrase(at, "floor_to_ceiling");
    if (!full) return false;
    wish.sill_m = 0;
    wish.to_ceiling = words.At(*full - 1) == "ceiling";
    i = *full;
    return true;
  }
  if (!words.Is(at, "swinging")) return false;
  const auto out = words.BehindPhrase(at + 1, "outwards"), in = words.BehindPhrase(at + 1, "inwards");
  const auto behind = out ? out : in;
  // "opening out to the garden" tells where it leads.
  if (!behind || words.Says(*behind, {"to", "onto", "the"})) return false;
  wish.swing = out ? v1::DOOR_SWING_OUTWARD : v1::DOOR_SWING_INWARD;
  i = *behind;
  return true;
}

}  // namespace

std::size_t ReadMeasures(const BriefText& words, std::size_t i, OpeningNoun& noun) {
  constexpr int kMostParts = 4;
  OpeningWish& wish = noun.wish;
  for (int part = 0; part < kMostParts; ++part) {
    const bool leads = wish.door && (TakeRoomList(words, i, noun) || TakeLeads(words, i, noun));
    if (!leads && !TakeNumber(words, i, wish) && !TakeLengths(words, i, wish) && !TakeHeight(words, i, wish) &&
        !TakeSwing(words, i, wish))
      break;
  }
  return i;
}

}  // namespace flair::language
