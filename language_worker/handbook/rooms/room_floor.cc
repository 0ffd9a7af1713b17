// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/rooms/room_floor.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "language_worker/handbook/program/room_program.h"

namespace flair::language {
namespace {

constexpr double kLowestM = 2;  // ceiling
constexpr double kShortestM = 1;

// Of the floor of a further kind that a room is, what remains where ways are shared.
constexpr double kShared = 0.8;

// Sides of a given area: shorter by longer as asked or as usual, never below what can be furnished.
void SidesOf(double area_m2, double ratio, bool deeper, RoomSize& size) {
  const double shorter_m = std::max(1.2, RoundToStep(std::sqrt(area_m2 * ratio)));
  const double longer_m = std::max(1.2, RoundToStep(area_m2 / shorter_m));
  size.width_m = deeper ? shorter_m : longer_m;
  size.depth_m = deeper ? longer_m : shorter_m;
}

// How much larger a room is for more people than it usually has: each takes a place of their own and shares the ways.
double CrowdFactor(const BriefFacts& facts, const hb::Archetype& archetype, const Handbook& handbook) {
  constexpr double kShareOfPlaces = 0.6, kEach_m2 = 3, kEachInARow_m2 = 1.3;
  if (!facts.people || archetype.per_person().empty()) return 1;
  const double usual_m2 = archetype.width_m().typical() * archetype.depth_m().typical();
  for (const hb::Band& band : archetype.bands()) {
    if (band.max_area_m2() > 0 && usual_m2 >= band.max_area_m2()) continue;
    for (const hb::ObjectEntry& entry : band.objects()) {
      if (entry.furniture() != archetype.per_person()) continue;
      const hb::Furniture* place = handbook.FindFurniture(entry.furniture());
      const int sharing = place == nullptr ? 1 : std::max(1, PlacesOn(*place));
      const double usual = std::max(1, entry.count()) * sharing;
      const double more = std::max(0.0, *facts.people / usual - 1);
      const double each_m2 = sharing > 1 ? kEachInARow_m2 : kEach_m2;
      // Few have most of a room to themselves; many take what a place and its share of the ways need.
      return 1 + std::min(kShareOfPlaces * more, each_m2 * usual * more / usual_m2);
    }
    break;
  }
  return 1;
}

struct FloorRange {
  double least_m2 = 0;
  double most_m2 = 0;
};

// The least floor on which what the brief asks for can be used, and the most that it furnishes where it lists what is
// there. [Handbook facts] furniture covers 20 to 29 % of the floor in the recorded rooms and up to 49 % in small
// bedrooms; some of that comes without being asked for.
FloorRange FloorForWishes(const BriefFacts& facts, const Handbook& handbook, double area_m2, const Choice& choice) {
  constexpr double kMostCovered = 0.33, kMostCoveredIfSmall = 0.4, kLeastCovered = 0.2;
  constexpr double kLargest_m2 = 400, kRowsTake = 2, kLeastOfUsual = 0.5;
  double asked_m2 = 0, all_m2 = 0;
  const RoomProgram program = MakeRoomProgram(facts, handbook, area_m2, choice);
  for (const ProgramItem& item : program.floor_items) {
    const hb::Furniture& furniture = *item.furniture;
    const double each_m2 = furniture.width_m().typical() * furniture.depth_m().typical();
    all_m2 += item.count * each_m2;
    // Between rows one walks, and before them somebody stands.
    const bool in_rows = std::ranges::any_of(
        program.archetype->rows(), [&](const hb::Rows& rows) { return rows.furniture() == furniture.name(); });
    const bool for_people = facts.people && in_rows && furniture.name() == program.archetype->per_person();
    if ((!item.requested && !for_people) || item.optional) continue;
    asked_m2 += item.count * each_m2 * (in_rows ? kRowsTake : 1);
  }
  FloorRange range;
  range.least_m2 = std::min(kLargest_m2, asked_m2 / (facts.size.area_factor < 1 ? kMostCoveredIfSmall : kMostCovered));
  // Some rooms are for what is done on their floor.
  range.most_m2 = program.listed ? std::max(kLeastOfUsual * area_m2, all_m2 / kLeastCovered) : kLargest_m2;
  return range;
}

}  // namespace

RoomSize ChooseRoomSize(const BriefFacts& facts, const Handbook& handbook, const Choice& choice) {
  const hb::Archetype& archetype = EffectiveArchetype(facts, handbook);
  const SizeRequest& asked = facts.size;
  double area_factor = asked.area_factor, height_m = archetype.height_m() > 0 ? archetype.height_m() : 3.0;
  for (const hb::Changes* changes : AllChanges(facts)) {
    if (changes->area_factor() > 0) area_factor *= changes->area_factor();
    if (changes->room_height_m() > 0) height_m = std::max(height_m, changes->room_height_m());
  }
  RoomSize size;
  size.height_m = asked.height_m.value_or(height_m);
  const double width_m = archetype.width_m().typical(), depth_m = archetype.depth_m().typical();
  const double usual_ratio = std::min(width_m, depth_m) / std::max(width_m, depth_m);
  const bool deeper = depth_m >= width_m;
  if (asked.width_m && asked.depth_m) {
    size.width_m = *asked.width_m;
    size.depth_m = *asked.depth_m;
  } else if (asked.area_m2) {
    SidesOf(*asked.area_m2, asked.side_ratio.value_or(0.8), deeper, size);
    // Just what was asked for, to a centimetre.
    double& longer_m = size.depth_m > size.width_m ? size.depth_m : size.width_m;
    longer_m = std::max(longer_m / 2, std::round(100 * *asked.area_m2 / std::min(size.width_m, size.depth_m)) / 100);
  } else if (asked.width_m || asked.depth_m) {
    const double given_m = asked.width_m.value_or(asked.depth_m.value_or(0));
    // A usual area, in sides that are not too unlike.
    const double usual_m = std::clamp(width_m * depth_m * area_factor / given_m, 0.8 * given_m, 1.6 * given_m);
    const double other_m = std::max(1.2, RoundToStep(usual_m));
    size.width_m = asked.width_m ? given_m : other_m;
    size.depth_m = asked.depth_m ? given_m : other_m;
    size.assumption = fmt::format("Only one side is given; the other is taken as {:g} m.", other_m);
  } else {
    const bool named = archetype.name() != handbook.fallback_archetype().name();
    area_factor *= CrowdFactor(facts, archetype, handbook);
    double all_m2 = width_m * depth_m;
    const std::vector<FurtherKind> also = AlsoOf(facts, archetype);
    for (const FurtherKind& one : also) all_m2 += kShared * one.share * UsualArea(*one.archetype);
    const double usual_m2 = all_m2 * area_factor;
    const FloorRange range = FloorForWishes(facts, handbook, usual_m2, choice);
    const bool other = range.least_m2 > usual_m2 || range.most_m2 < usual_m2 || !also.empty();
    SidesOf(std::max(std::min(usual_m2, range.most_m2), range.least_m2), asked.side_ratio.value_or(usual_ratio), deeper,
            size);
    if (area_factor <= 2.5 && !asked.side_ratio && named && !other) {
      size.width_m = std::clamp(size.width_m, LeastOf(archetype.width_m()), MostOf(archetype.width_m()));
      size.depth_m = std::clamp(size.depth_m, LeastOf(archetype.depth_m()), MostOf(archetype.depth_m()));
    }
    size.assumption = fmt::format("The brief gives no size in numbers; {:g} m x {:g} m {}.", size.width_m, size.depth_m,
                                  other ? "has room for what it asks for" : "is usual for this " + archetype.name());
  }
  if (size.height_m < kLowestM) {
    size.assumption += fmt::format("{}A ceiling at {:g} m is drawn at {:g} m, the lowest that a room may have.",
                                   size.assumption.empty() ? "" : " ", size.height_m, kLowestM);
    size.height_m = kLowestM;
  }
  for (double* const side_m : {&size.width_m, &size.depth_m}) {
    if (*side_m >= kShortestM) continue;
    size.assumption += fmt::format("{}A side of {:g} m is drawn at {:g} m, the shortest that a room may have.",
                                   size.assumption.empty() ? "" : " ", *side_m, kShortestM);
    *side_m = kShortestM;
  }
  return size;
}

namespace {

constexpr double kLeastArmM = 1.5;

struct Corner {
  double x_m = 0;
  double y_m = 0;
};
using Outline = std::vector<Corner>;

// Differences of lengths are off by rounding.
double Micrometres(double length_m) { return std::round(length_m * 1e6) / 1e6; }

const char* NameOf(RoomShape shape) { return shape == RoomShape::kL ? "L" : shape == RoomShape::kT ? "T" : "U"; }

// Of a room with as many corners round its middle; 0 for others. What is round has walls that a piece can stand at.
int CornersOf(RoomShape shape, double shorter_m) {
  constexpr double kLargeM = 4.5;
  switch (shape) {
    case RoomShape::kRound:
    case RoomShape::kOval:
      return shorter_m < kLargeM ? 8 : 12;
    case RoomShape::kOctagon:
      return 8;
    case RoomShape::kHexagon:
      return 6;
    default:
      return 0;
  }
}

// With a wall along every side of its bounding rectangle where the number of corners is a multiple of four.
Outline Polygon(int sides, double w, double d) {
  Outline outline;
  const bool flat = sides % 4 == 0;
  const double step_rad = 2 * std::numbers::pi / sides, half_d = std::cos(step_rad / 2), half_w = flat ? half_d : 1;
  for (int i = 0; i < sides; ++i) {
    const double at_rad = (flat ? i + 0.5 : i) * step_rad;
    outline.push_back({w / 2 * (1 + std::cos(at_rad) / half_w), d / 2 * (1 + std::sin(at_rad) / half_d)});
  }
  return outline;
}

double ShareOf(RoomShape shape) {
  if (const int sides = CornersOf(shape, 0); sides > 0) return sides == 6 ? 3.0 / 4 : 5.0 / 6;
  return shape == RoomShape::kL ? 21.0 / 25 : shape == RoomShape::kT ? 3.0 / 4 : 5.0 / 6;
}

// As drawn before it is turned; w along x. Counter-clockwise.
Outline Upright(RoomShape shape, double w, double d) {
  if (shape == RoomShape::kL) {
    const double x = w - RoundToStep(2 * w / 5), y = d - RoundToStep(2 * d / 5);
    return {{0, 0}, {w, 0}, {w, y}, {x, y}, {x, d}, {0, d}};
  }
  if (shape == RoomShape::kT) {
    const double x = RoundToStep(w / 4), y = RoundToStep(d / 2);
    return {{x, 0}, {w - x, 0}, {w - x, y}, {w, y}, {w, d}, {0, d}, {0, y}, {x, y}};
  }
  const double x = RoundToStep(w / 3), y = d - RoundToStep(d / 2);
  return {{0, 0}, {w, 0}, {w, d}, {w - x, d}, {w - x, y}, {x, y}, {x, d}, {0, d}};
}

double NarrowestArm(RoomShape shape, double w, double d) {
  if (shape == RoomShape::kL) return std::min(w - RoundToStep(2 * w / 5), d - RoundToStep(2 * d / 5));
  if (shape == RoomShape::kT) return std::min(w - 2 * RoundToStep(w / 4), d - RoundToStep(d / 2));
  return std::min(RoundToStep(w / 3), d - RoundToStep(d / 2));
}

// Turned by quarters counter-clockwise about the bounding rectangle, whose lower-left corner stays (0, 0).
Outline Turned(Outline outline, double w, double d, std::size_t quarters) {
  for (std::size_t i = 0; i < quarters; ++i) {
    for (Corner& corner : outline) corner = {d - corner.y_m, corner.x_m};
    std::swap(w, d);
  }
  return outline;
}

void Warn(const char* code, const std::string& message, v1::Room& room) {
  v1::Diagnostic& diagnostic = *room.add_diagnostics();
  diagnostic.set_severity(v1::SEVERITY_WARNING);
  diagnostic.set_code(code);
  diagnostic.set_message(message);
}

// A rectangle with a leg at its north wall: at x of its wall from `from_m` on.
Outline WithLeg(double w, double d, double from_m, double along_m, double out_m) {
  const double to_m = from_m + along_m;
  Outline outline = {{0, 0}, {w, 0}};
  if (to_m < w) outline.insert(outline.end(), {{w, d}, {to_m, d}});
  outline.insert(outline.end(), {{std::min(w, to_m), d + out_m}, {from_m, d + out_m}});
  if (from_m > 0) outline.insert(outline.end(), {{from_m, d}, {0, d}});
  return outline;
}

// As many quarters as turn the north wall to where the word says.
std::size_t QuartersTo(const std::string& word, std::size_t otherwise) {
  constexpr const char* kWalls[] = {"northern_walls", "western_walls", "southern_walls", "eastern_walls"};
  const auto found = std::ranges::find_if(kWalls, [&](const char* wall) { return IsIn(wall, word); });
  return found == std::end(kWalls) ? otherwise : static_cast<std::size_t>(found - kWalls);
}

Outline OfLeg(const RoomLeg& leg, double w, double d, const Choice& choice) {
  const std::size_t quarters = QuartersTo(leg.wall, choice.Index("room.shape.turn", 4));
  const bool across = quarters % 2 == 1;
  const double along_m = across ? leg.depth_m : leg.width_m, out_m = across ? leg.width_m : leg.depth_m;
  if (across) std::swap(w, d);
  // Drawn in the north, its right end is turned with it.
  const double spare_m = std::max(0.0, w - along_m);
  const bool right = QuartersTo(leg.end, 2 * choice.Index("room.leg.end", 2) + quarters + 1) % 4 == (quarters + 3) % 4;
  const double from_m = !leg.of_an_l ? spare_m / 2 : right ? spare_m : 0;
  return Turned(WithLeg(w, d, from_m, along_m, out_m), w, d + out_m, quarters);
}

// Narrower by a quarter in the north, turned as told.
Outline Narrowing(const ShapeRequest& request, double w, double d, const Choice& choice) {
  const std::size_t quarters = QuartersTo(request.narrow_end, d >= w ? 0 : 1 + 2 * choice.Index("room.shape.turn", 2));
  if (quarters % 2 == 1) std::swap(w, d);
  const double in_m = RoundToStep(w / 8);
  Outline outline = Turned({{0, 0}, {w, 0}, {w - in_m, d}, {in_m, d}}, w, d, quarters);
  // The first wall is that in the south.
  std::ranges::rotate(outline, outline.begin() + static_cast<std::ptrdiff_t>((4 - quarters) % 4));
  return outline;
}

void SetOutline(const Outline& outline, v1::Room& room) {
  for (const Corner& corner : outline) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(Micrometres(corner.x_m));
    vertex.set_y_m(Micrometres(corner.y_m));
  }
  constexpr const char* kCompass[] = {"south", "east", "north", "west"};
  for (std::size_t i = 0; i < outline.size(); ++i) {
    room.add_walls()->set_name(outline.size() == 4 ? kCompass[i] : fmt::format("wall_{}", i + 1));
  }
}

// As wide as deep, unless it is oval or both are given.
void SetRound(RoomShape shape, double w, double d, const SizeRequest& asked, v1::Room& room) {
  if (shape != RoomShape::kOval && !(asked.width_m && asked.depth_m)) w = d = RoundToStep(std::sqrt(w * d));
  SetOutline(Polygon(CornersOf(shape, std::min(w, d)), w, d), room);
}

}  // namespace

void SetFloor(const ShapeRequest& request, const SizeRequest& asked, const RoomSize& size, const Choice& choice,
              v1::Room& room) {
  const Outline rectangle = {{0, 0}, {size.width_m, 0}, {size.width_m, size.depth_m}, {0, size.depth_m}};
  if (!request.unknown.empty()) {
    Warn("shape_unknown",
         fmt::format(
             "A room that is \"{}\" cannot be drawn; it is a rectangle of {:g} m x {:g} m with an upright wall on "
             "every side instead. Rectangles, L, T and U shapes, round rooms, octagons and hexagons can be drawn, and "
             "a floor plan of your own "
             "can have any straight walls.",
             request.unknown, size.width_m, size.depth_m),
         room);
  }
  if (!request.parts.empty()) {
    Warn("shape_part_left_out",
         fmt::format("\"{}\" cannot be drawn: floors are level, ceilings flat and walls full height.",
                     fmt::join(request.parts, "\", \"")),
         room);
  }
  if (asked.leg) return SetOutline(OfLeg(*asked.leg, size.width_m, size.depth_m, choice), room);
  if (request.shape == RoomShape::kRectangle) return SetOutline(rectangle, room);
  if (request.shape == RoomShape::kNarrowing)
    return SetOutline(Narrowing(request, size.width_m, size.depth_m, choice), room);
  double w = size.width_m, d = size.depth_m;
  if (asked.area_m2 && !asked.width_m && !asked.depth_m) {
    w = RoundToStep(w / std::sqrt(ShareOf(request.shape)));
    d = RoundToStep(d / std::sqrt(ShareOf(request.shape)));
  }
  if (CornersOf(request.shape, 0) > 0) return SetRound(request.shape, w, d, asked, room);
  // Turned by a quarter the sides change places, so that the room has its size after it.
  const std::size_t quarters = choice.Index("room.shape.turn", 4);
  const bool across = quarters % 2 == 1;
  const double upright_w = across ? d : w, upright_d = across ? w : d;
  if (NarrowestArm(request.shape, upright_w, upright_d) < kLeastArmM) {
    Warn("shape_too_small",
         fmt::format("{:g} m x {:g} m is too small for a room in the shape of a {}, whose arms would be narrower than "
                     "{:g} m; it is a rectangle instead.",
                     size.width_m, size.depth_m, NameOf(request.shape), kLeastArmM),
         room);
    return SetOutline(rectangle, room);
  }
  SetOutline(Turned(Upright(request.shape, upright_w, upright_d), upright_w, upright_d, quarters), room);
}

}  // namespace flair::language
