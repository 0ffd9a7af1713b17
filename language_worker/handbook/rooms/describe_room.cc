// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/describe_room.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "language_worker/handbook/objects/fit_floor.h"
#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/reading/shape_phrase.h"
#include "language_worker/handbook/reading/words.h"
#include "language_worker/handbook/rooms/openings.h"
#include "language_worker/handbook/rooms/room_floor.h"
#include "language_worker/handbook/rooms/walls.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

int UsualWindowCount(const hb::OpeningRules& rules, double area_m2) {
  for (const hb::WindowCount& limit : rules.window_counts()) {
    if (limit.max_area_m2() == 0 || area_m2 < limit.max_area_m2()) return limit.count();
  }
  if (area_m2 > 40) return 3;
  return area_m2 < 14 ? 1 : 2;
}

OpeningPlan PlanOpenings(const BriefFacts& facts, const hb::Archetype& archetype, double area_m2) {
  OpeningPlan plan;
  plan.rules = archetype.openings();
  plan.window_count = UsualWindowCount(plan.rules, area_m2);
  plan.door_width_m = plan.rules.door_width_m() > 0 ? plan.rules.door_width_m() : 0.9;
  for (const hb::Changes* changes : AllChanges(facts)) {
    if (changes->door_width_m() > 0) plan.door_width_m = changes->door_width_m();
    if (changes->has_window_count()) plan.window_count = changes->window_count();
    if (changes->has_window_sill_m()) plan.rules.set_window_sill_m(changes->window_sill_m());
  }
  plan.rules.set_door_height_m(std::max(plan.rules.door_height_m(), std::min(2.05 * plan.door_width_m / 0.9, 3.0)));
  plan.asked = facts.openings;
  plan.room_type = archetype.name();
  const auto seen = [&](const std::string& side) {
    plan.seen_from_the_door = plan.seen_from_the_door || GoesByTheDoor(side);
    plan.left_and_right = plan.left_and_right || side.find("left") != side.npos || side.find("right") != side.npos;
  };
  for (const Place& place : facts.places) {
    const std::string& text = place.asked->relation().text();
    plan.worktop_at_window = plan.worktop_at_window || (text.find("under the window") != text.npos &&
                                                        place.furniture->run() != hb::RUN_PART_UNSPECIFIED);
    if (text.find("door") != text.npos || text.find("window") != text.npos || place.side.empty() ||
        place.side == "opposite")
      continue;
    // What is "blank" else is known when the openings are made.
    const std::string side = place.side.starts_with("blank ") ? place.side.substr(6) : place.side;
    if (text.find("{wall}") != text.npos && !side.starts_with("window")) plan.sides_of_pieces.push_back(side);
    seen(place.side);
  }
  // "Two desks under the window": one that is wide enough for both.
  for (const Place& place : facts.places) {
    constexpr double kWidestM = 3;
    const auto wish = std::ranges::find(facts.wishes, place.furniture, &Wish::furniture);
    const bool under = place.asked->relation().text().find("is under the window") != std::string::npos;
    if (!under || place.which >= 0 || wish == facts.wishes.end() || wish->count < 2 || plan.asked.windows_meant)
      continue;
    const double pieces_m = wish->count * wish->size.width_m.value_or(place.furniture->width_m().typical());
    plan.rules.set_window_width_m(std::max(plan.rules.window_width_m(), std::min(pieces_m, kWidestM)));
  }
  for (const OpeningWish& wish : plan.asked.wishes) {
    if (wish.side != "near") seen(wish.side);
  }
  // "By the window": there is one, unless the brief speaks of several.
  if (plan.asked.window_meant && !plan.asked.windows_meant) plan.window_count = 1;
  if (plan.asked.windows_meant) plan.window_count = std::max(plan.window_count, 1);
  for (const OpeningWish& wish : plan.asked.wishes) {
    if (wish.door || !wish.side.empty()) continue;
    // "with large windows": as many as usual.
    plan.window_count = wish.counted ? wish.count : plan.window_count;
  }
  if (plan.asked.no_windows) plan.window_count = 0;
  plan.window_count = std::clamp(plan.window_count, 0, kMostOfAKind);
  return plan;
}

void Remark(v1::Severity severity, const char* code, const std::string& message, v1::Room& room) {
  v1::Diagnostic& diagnostic = *room.add_diagnostics();
  diagnostic.set_severity(severity);
  diagnostic.set_code(code);
  diagnostic.set_message(message);
}

// Which kind of room was taken for that of the brief.
void RemarkOnKind(const BriefFacts& facts, const hb::Archetype& archetype, v1::Room& room) {
  if (!facts.archetype_named) {
    Remark(v1::SEVERITY_WARNING, "room_type_assumed",
           facts.room_words.empty()
               ? fmt::format("The brief names no kind of room; it is furnished as a {}.", archetype.name())
               : fmt::format("The handbook knows no kind of room called \"{}\"; it is furnished as a {}.",
                             facts.room_words, archetype.name()),
           room);
  } else if (facts.room_words != archetype.name()) {
    Remark(v1::SEVERITY_NOTE, "room_type_taken",
           fmt::format("\"{}\" is furnished as a {}.", facts.room_words, archetype.name()), room);
  }
}

// What of the brief was read otherwise, or not at all.
void RemarkOnBrief(const BriefFacts& facts, const hb::Archetype& archetype, v1::Room& room) {
  if (!facts.reads_as_english) {
    Remark(v1::SEVERITY_WARNING, "language_not_known",
           fmt::format("The brief does not read as English, the only language of the handbook: its numbers were read, "
                       "and it is furnished as a {}. A language model understands other languages.",
                       archetype.name()),
           room);
    return;
  }
  RemarkOnKind(facts, archetype, room);
  if (!facts.other_rooms.empty()) {
    Remark(v1::SEVERITY_WARNING, "other_rooms_named",
           fmt::format("One room is designed ({}); \"{}\" was left out, {}.", archetype.name(),
                       fmt::join(facts.other_rooms, "\", \""),
                       facts.other_rooms.size() > 1 ? "rooms of their own" : "a room of its own"),
           room);
  }
  for (const hb::Furniture* furniture : facts.too_many) {
    Remark(v1::SEVERITY_WARNING, "too_many_asked",
           fmt::format("More of \"{}\" are asked for than the handbook's limit of {} of a kind; {} are placed.",
                       furniture->name(), MostOf(*furniture), MostOf(*furniture)),
           room);
  }
  for (const std::string& said : facts.sizes_not_had) {
    Remark(v1::SEVERITY_WARNING, "piece_size_not_had",
           fmt::format("\"{}\" is far from what such a piece can be; it has its usual size.", said), room);
  }
  for (const std::string& said : facts.places_loosely_kept) {
    Remark(v1::SEVERITY_NOTE, "place_loosely_kept", said, room);
  }
  for (const std::string& said : facts.places_not_known) {
    Remark(v1::SEVERITY_WARNING, "place_not_understood",
           fmt::format("The position of a piece was not understood: \"{}\". These words were ignored.", said), room);
  }
  for (const Correction& correction : facts.corrections) {
    Remark(v1::SEVERITY_NOTE, "word_corrected", fmt::format("Read \"{}\" as {}.", correction.written, correction.read),
           room);
  }
  if (!facts.other_names.empty()) {
    Remark(v1::SEVERITY_NOTE, "thing_taken",
           fmt::format("Read as what the handbook has: {}.", fmt::join(facts.other_names, ", ")), room);
  }
  if (!facts.made_plain.empty()) {
    Remark(v1::SEVERITY_NOTE, "thing_made_plain",
           fmt::format("The handbook does not know \"{}\": drawn as a plain block, of a size that may be wrong.",
                       fmt::join(facts.made_plain, "\", \"")),
           room);
  }
  if (!facts.not_known.empty()) {
    Remark(v1::SEVERITY_WARNING, "words_not_known",
           fmt::format("The handbook does not know \"{}\"; it was left out. A language model may know it.",
                       fmt::join(facts.not_known, "\", \"")),
           room);
  }
  if (!facts.unheard.empty()) {
    Remark(v1::SEVERITY_WARNING, "words_not_heard",
           fmt::format("Not understood, and ignored: \"{}\".", fmt::join(facts.unheard, "\", \"")), room);
  }
}

// What could not be had of the doors and windows that it asks for, or is drawn as something else.
void RemarkOnOpenings(const BriefFacts& facts, const std::vector<std::string>& not_had, v1::Room& room) {
  for (const std::string& sentence : facts.openings.not_read) {
    Remark(v1::SEVERITY_WARNING, "opening_not_understood", sentence, room);
  }
  for (const std::string& sentence : not_had) Remark(v1::SEVERITY_WARNING, "opening_not_made", sentence, room);
  for (const OpeningWish& wish : facts.openings.wishes) {
    if (wish.kind.empty()) continue;
    Remark(v1::SEVERITY_NOTE, "opening_simplified",
           fmt::format("\"{}\": a {} is drawn as a plain window of its width.", wish.said, wish.kind), room);
  }
  if (facts.openings.no_doors) {
    Remark(v1::SEVERITY_NOTE, "opening_simplified", "The brief asks for no door; the entrance is an open passage.",
           room);
  }
  const auto doors = std::ranges::count(room.openings(), v1::OPENING_KIND_DOOR, &v1::Opening::kind);
  for (const Place& place : facts.places) {
    const bool opening = place.asked->relation().text().find(" door") != std::string::npos;
    if (!opening || place.side.empty() || doors < 2 || OpeningOf(room, v1::OPENING_KIND_DOOR, place.side) != nullptr)
      continue;
    Remark(v1::SEVERITY_NOTE, "door_taken",
           fmt::format("\"{}\" is read as the room's nearest door: which one it means is not told.", place.said), room);
  }
}

}  // namespace

absl::StatusOr<v1::Room> DescribeRoom(const v1::Brief& brief, const Handbook& handbook) {
  if (brief.has_room()) return brief.room();
  ASSIGN_OR_RETURN(BriefFacts facts, ReadBrief(brief, handbook));
  // "Round, 6 m across".
  if (facts.shape.shape == RoomShape::kRound && !facts.size.depth_m) facts.size.depth_m = facts.size.width_m;
  const hb::Archetype& archetype = EffectiveArchetype(facts, handbook);
  const Choice choice(brief.seed(), brief.text());
  const RoomSize size = ChooseRoomSize(facts, handbook, choice);
  v1::Room room;
  room.set_room_type(archetype.name());
  room.set_title(TitleOf(brief.text()));
  room.set_height_m(size.height_m);
  SetFloor(facts.shape, facts.size, size, choice, room);
  const std::vector<std::string> not_made = AddOpenings(PlanOpenings(facts, archetype, FloorArea(room)), choice, room);
  if (!size.assumption.empty()) Remark(v1::SEVERITY_NOTE, "size_assumed", size.assumption, room);
  RemarkOnBrief(facts, archetype, room);
  RemarkOnOpenings(facts, not_made, room);
  return room;
}

absl::StatusOr<v1::ZonePlan> PlanZones(const v1::Brief& brief, const v1::Room& room, const Handbook& handbook) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  const RoomProgram program = MakeRoomProgram(facts, facts.HandbookOr(handbook), FloorArea(room), choice);
  std::vector<LeftOut> left_out;
  const std::vector<SizedItem> fitting = FitFloor(program, facts.HandbookOr(handbook), ExtentOf(room), left_out);
  v1::ZonePlan plan;
  for (const hb::ZoneSpec& spec : program.zones) {
    // A zone whose furniture does not fit is none; the first one stays whatever happens.
    const bool furnished = std::any_of(fitting.begin(), fitting.end(),
                                       [&](const SizedItem& sized) { return sized.item.zone == spec.name(); });
    if (!furnished && &spec != &program.zones.front()) continue;
    v1::Zone& zone = *plan.add_zones();
    zone.set_id(IdOf(spec.name()));
    zone.set_name(spec.name());
    if (spec.purposes_size() > 0) {
      zone.set_purpose(spec.purposes(
          static_cast<int>(choice.Index("zone." + spec.name(), static_cast<std::size_t>(spec.purposes_size())))));
    }
  }
  return plan;
}

std::string TitleOf(const std::string& text) {
  constexpr std::size_t kMost = 120;
  std::string title = text.substr(0, text.find_first_of("\n\r"));
  if (title.size() > kMost) {
    const std::size_t space = title.rfind(' ', kMost);
    title = title.substr(0, space == std::string::npos ? 0 : space) + " ...";
  }
  while (!title.empty() && (title.back() == '.' || title.back() == ' ')) title.pop_back();
  return title;
}

double FloorArea(const v1::Room& room) {
  double twice_m2 = 0;
  const auto& vertices = room.floor().vertices();
  for (int i = 0; i < vertices.size(); ++i) {
    const v1::Point2 &a = vertices[i], &b = vertices[(i + 1) % vertices.size()];
    twice_m2 += a.x_m() * b.y_m() - a.y_m() * b.x_m();
  }
  return std::abs(twice_m2) / 2;
}

std::string IdOf(std::string_view name) {
  std::string id;
  for (const char c : name) {
    const bool word = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (word)
      id += c;
    else if (c != '\'' && !id.empty() && id.back() != '_')
      id += '_';
  }
  while (!id.empty() && id.back() == '_') id.pop_back();
  return id.empty() ? "unnamed" : id;
}

}  // namespace flair::language
