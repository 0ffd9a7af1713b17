// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <utility>

#include "flair/model/v1/room_answers.pb.h"
#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/rooms/openings.h"
#include "language_worker/model/model_handlers.h"
#include "language_worker/model/prompt_text.h"
#include "llm/answers/prompt_library.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

using llm::Fault;
using llm::FaultKind;
using model::v1::OpeningAnswer;
using model::v1::RoomAnswer;

constexpr double kUsualHeight_m = 3;
constexpr double kUsualSocketHeight_m = 0.45;
constexpr double kLowestDoor_m = 1.8;

double WallLength(const RoomAnswer& answer, const std::string& wall) {
  return wall == "south" || wall == "north" ? answer.width_m() : answer.depth_m();
}

// Distance of a place from the wall's start vertex, walking counter-clockwise: answers count from the west or south
// end.
double OffsetOf(const std::string& wall, double position, double length_m) {
  const bool forward = wall == "south" || wall == "east";
  return (forward ? position : 1 - position) * length_m;
}

// The stretch of its wall that an opening covers.
std::pair<double, double> StretchOf(const OpeningAnswer& opening, const RoomAnswer& room) {
  const double length_m = WallLength(room, opening.wall());
  const double start_m = std::clamp(OffsetOf(opening.wall(), opening.position(), length_m) - opening.width_m() / 2, 0.0,
                                    std::max(0.0, length_m - opening.width_m()));
  return {start_m, start_m + opening.width_m()};
}

void CheckSize(const SizeRequest& size, const RoomAnswer& answer, std::vector<Fault>& faults) {
  const auto differs = [](const std::optional<double>& asked_m, double answered_m) {
    return asked_m && answered_m > 0 && std::abs(*asked_m - answered_m) > 0.02;
  };
  if (differs(size.width_m, answer.width_m())) {
    faults.push_back(
        {"width_m", fmt::format("is {}; the brief says {}", answer.width_m(), *size.width_m), FaultKind::kDoubtful});
  }
  if (differs(size.depth_m, answer.depth_m())) {
    faults.push_back(
        {"depth_m", fmt::format("is {}; the brief says {}", answer.depth_m(), *size.depth_m), FaultKind::kDoubtful});
  }
  const double area_m2 = answer.width_m() * answer.depth_m();
  if (size.area_m2 && area_m2 > 0 && std::abs(area_m2 / *size.area_m2 - 1) > 0.1) {
    faults.push_back({"width_m",
                      fmt::format("makes {:.1f} m2 with the depth; the brief says {:g} m2", area_m2, *size.area_m2),
                      FaultKind::kDoubtful});
  }
}

void CheckOpenings(const RoomAnswer& answer, std::vector<Fault>& faults) {
  bool door = false;
  for (int i = 0; i < answer.openings_size(); ++i) {
    const OpeningAnswer& opening = answer.openings(i);
    door = door || opening.kind() == "door";
    if (opening.wall().empty() || opening.width_m() <= 0) continue;
    const double length_m = WallLength(answer, opening.wall());
    if (opening.width_m() > length_m) {
      faults.push_back({fmt::format("openings[{}].width_m", i),
                        fmt::format("is {}; its wall has {} m", opening.width_m(), length_m)});
      continue;
    }
    const auto [start_m, end_m] = StretchOf(opening, answer);
    for (int k = 0; k < i; ++k) {
      if (answer.openings(k).wall() != opening.wall()) continue;
      const auto [other_start_m, other_end_m] = StretchOf(answer.openings(k), answer);
      if (std::min(end_m, other_end_m) - std::max(start_m, other_start_m) < 1e-6) continue;
      faults.push_back(
          {fmt::format("openings[{}].position", i),
           fmt::format("is {}; it overlaps openings[{}] on the {} wall there", opening.position(), k, opening.wall())});
      break;
    }
  }
  if (!door) faults.push_back({"openings", "has no door; a room has one", FaultKind::kDoubtful});
}

void SetFloor(double width_m, double depth_m, v1::Room& room) {
  const double corners[4][2] = {{0, 0}, {width_m, 0}, {width_m, depth_m}, {0, depth_m}};
  for (const auto& corner : corners) {
    v1::Point2& vertex = *room.mutable_floor()->add_vertices();
    vertex.set_x_m(corner[0]);
    vertex.set_y_m(corner[1]);
  }
  for (const char* name : {"south", "east", "north", "west"}) room.add_walls()->set_name(name);
}

// Whether it is as wide as its wall at most and overlaps none of those that are there.
bool Fits(const OpeningAnswer& answer, const RoomAnswer& sized, const v1::Room& room) {
  if (answer.width_m() > WallLength(sized, answer.wall())) return false;
  const auto [start_m, end_m] = StretchOf(answer, sized);
  return std::ranges::none_of(room.openings(), [&, start = start_m, end = end_m](const auto& other) {
    return other.wall() == answer.wall() &&
           std::min(end, other.offset_m() + other.width_m()) > std::max(start, other.offset_m());
  });
}

v1::DoorSwing SwingOf(const std::string& word) {
  if (word == "outward") return v1::DOOR_SWING_OUTWARD;
  if (word == "sliding") return v1::DOOR_SWING_SLIDING;
  return word == "open" ? v1::DOOR_SWING_NONE : v1::DOOR_SWING_INWARD;
}

void AddOpening(const OpeningAnswer& answer, const RoomAnswer& sized, v1::Room& room) {
  const bool door = answer.kind() == "door";
  const int number = 1 + static_cast<int>(std::ranges::count_if(room.openings(), [&](const v1::Opening& other) {
                       return (other.kind() == v1::OPENING_KIND_DOOR) == door;
                     }));
  const auto [start_m, end_m] = StretchOf(answer, sized);
  v1::Opening& opening = *room.add_openings();
  opening.set_id(fmt::format("{}_{}", door ? "door" : "window", number));
  opening.set_kind(door ? v1::OPENING_KIND_DOOR : v1::OPENING_KIND_WINDOW);
  opening.set_wall(answer.wall());
  opening.set_offset_m(start_m);
  opening.set_width_m(answer.width_m());
  double head_m = answer.has_head_m() ? answer.head_m() : (door ? 2.05 : 2.1);
  if (door) head_m = std::max(head_m, kLowestDoor_m);
  opening.set_head_height_m(std::min(head_m, room.height_m()));
  if (!door) {
    const double sill_m = answer.has_sill_m() ? answer.sill_m() : 0.9;
    opening.set_sill_height_m(std::clamp(sill_m, 0.0, opening.head_height_m() - 0.3));
    return;
  }
  const double length_m = WallLength(sized, answer.wall());
  // The leaf rests on the side wall that is nearer.
  opening.mutable_leaf()->set_hinge(start_m <= length_m - end_m ? v1::HINGE_SIDE_START : v1::HINGE_SIDE_END);
  opening.mutable_leaf()->set_swing(SwingOf(answer.swing()));
  opening.mutable_leaf()->set_swing_angle_rad(std::numbers::pi / 2);
}

void AddSockets(const RoomAnswer& sized, v1::Room& room) {
  for (const model::v1::SocketAnswer& answer : sized.sockets()) {
    const double offset_m = OffsetOf(answer.wall(), answer.position(), WallLength(sized, answer.wall()));
    const bool in_door = std::ranges::any_of(room.openings(), [&](const v1::Opening& opening) {
      return opening.kind() == v1::OPENING_KIND_DOOR && opening.wall() == answer.wall() &&
             offset_m > opening.offset_m() && offset_m < opening.offset_m() + opening.width_m();
    });
    if (in_door) continue;
    v1::Socket& socket = *room.add_sockets();
    socket.set_id(fmt::format("socket_{}", room.sockets_size()));
    socket.set_wall(answer.wall());
    socket.set_offset_m(offset_m);
    socket.set_height_m(kUsualSocketHeight_m);
  }
}

// A room without a way in gets openings where a builder would put them.
void MakeSureOfADoor(const v1::Brief& brief, v1::Room& room) {
  const bool door = std::ranges::any_of(
      room.openings(), [](const v1::Opening& opening) { return opening.kind() == v1::OPENING_KIND_DOOR; });
  if (door) return;
  room.clear_openings();
  room.clear_sockets();
  AddOpenings(OpeningPlan(), Choice(brief.seed(), brief.text()), room);
  AddDiagnostic(v1::SEVERITY_WARNING, "openings_assumed",
                "The model named no door; door, windows and sockets are where they usually are.", room);
}

v1::Room ToRoom(const v1::Brief& brief, const SizeRequest& size, const RoomAnswer& answer) {
  RoomAnswer sized = answer;
  sized.set_width_m(size.width_m.value_or(answer.width_m()));
  sized.set_depth_m(size.depth_m.value_or(answer.depth_m()));
  v1::Room room;
  room.set_room_type(PlainName(answer.room_type()).empty() ? answer.room_type() : PlainName(answer.room_type()));
  room.set_title(TitleOf(brief.text()));
  room.set_height_m(size.height_m.value_or(answer.has_height_m() ? answer.height_m() : kUsualHeight_m));
  SetFloor(sized.width_m(), sized.depth_m(), room);
  for (const OpeningAnswer& opening : sized.openings()) {
    // A wall may have become shorter when the brief's size replaced the model's.
    if (Fits(opening, sized, room)) AddOpening(opening, sized, room);
  }
  MakeSureOfADoor(brief, room);
  if (room.sockets().empty()) AddSockets(sized, room);
  return room;
}

using model::v1::ZonesAnswer;

// [Handbook facts] the recorded rooms have three zones on 20 m2; hardly any has more than five.
int UsualMost(double area_m2) {
  if (area_m2 < 6) return 2;
  if (area_m2 < 25) return 3;
  return area_m2 < 45 ? 4 : 6;
}

std::string CountText(double area_m2) {
  const int most = UsualMost(area_m2);
  return most == 2 ? "one or two" : fmt::format("{} to {}", most - 1, most);
}

std::string WantedText(const v1::Brief& brief) {
  const std::vector<std::string> wanted = WantedZones(brief);
  return wanted.empty() ? ""
                        : fmt::format("These are among them, by exactly these names: {}.", fmt::join(wanted, ", "));
}

// What is wrong with an answer that reads well: names given twice, more zones than such a floor has uses for.
std::vector<Fault> CheckZones(const v1::Room& room, const ZonesAnswer& answer) {
  std::vector<Fault> faults;
  std::set<std::string> seen;
  for (int i = 0; i < answer.zones_size(); ++i) {
    const std::string& name = answer.zones(i).name();
    if (!name.empty() && !seen.insert(llm::Bare(name)).second) {
      faults.push_back({fmt::format("zones[{}].name", i), fmt::format("{} is there already", llm::Quoted(name))});
    }
  }
  const double area_m2 = FloorArea(room);
  const int most = UsualMost(area_m2) + 2;
  if (answer.zones_size() > most) {
    faults.push_back({"zones",
                      fmt::format("has {} elements; a floor of {:.0f} m2 has uses for {} at most", answer.zones_size(),
                                  area_m2, most),
                      FaultKind::kDoubtful});
  }
  return faults;
}

v1::ZonePlan ToZonePlan(const ZonesAnswer& answer) {
  v1::ZonePlan plan;
  IdMaker ids;
  for (const model::v1::ZoneAnswer& zone : answer.zones()) {
    v1::Zone& made = *plan.add_zones();
    made.set_id(ids.Make(zone.name(), "zone"));
    made.set_name(PlainName(zone.name()).empty() ? zone.name() : PlainName(zone.name()));
    made.set_purpose(zone.purpose());
  }
  return plan;
}

}  // namespace

absl::StatusOr<v1::Room> AskRoom(const v1::Brief& brief, const ModelTools& tools, llm::Conversation& conversation) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, tools.handbook));
  llm::Question question =
      MakeQuestion(tools, "room", "room", {{"brief", llm::QuoteData(brief.text())}}, RoomAnswer::default_instance());
  question.check = llm::CheckOf<RoomAnswer>([&](RoomAnswer& answer) {
    std::vector<Fault> faults;
    CheckSize(facts.size, answer, faults);
    CheckOpenings(answer, faults);
    return faults;
  });
  const auto make = [&](const RoomAnswer& answer) -> absl::StatusOr<v1::Room> {
    return ToRoom(brief, facts.size, answer);
  };
  return AskFor<RoomAnswer, v1::Room>(question, conversation, make,
                                      [](const v1::Room& room) { return Validate(room); });
}

absl::StatusOr<v1::ZonePlan> AskZones(const v1::Brief& brief, const v1::Room& room, const ModelTools& tools,
                                      llm::Conversation& conversation) {
  llm::Question question = MakeQuestion(tools, "zones", "zones",
                                        {{"brief", llm::QuoteData(brief.text())},
                                         {"room", ShortRoomText(room)},
                                         {"zone_count", CountText(FloorArea(room))},
                                         {"wanted_zones", WantedText(brief)}},
                                        ZonesAnswer::default_instance());
  question.check = llm::CheckOf<ZonesAnswer>([&](ZonesAnswer& answer) { return CheckZones(room, answer); });
  const auto make = [&](const ZonesAnswer& answer) -> absl::StatusOr<v1::ZonePlan> {
    if (answer.zones().empty()) {
      return absl::DataLossError("step \"zones\": the model's answer has no usable zone, also after a repair");
    }
    v1::ZonePlan plan = ToZonePlan(answer);
    AddWantedZones(brief, plan);
    return plan;
  };
  return AskFor<ZonesAnswer, v1::ZonePlan>(question, conversation, make,
                                           [](const v1::ZonePlan& plan) { return Validate(plan); });
}

}  // namespace flair::language
