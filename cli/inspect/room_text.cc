// SPDX-License-Identifier: GPL-3.0-or-later
// The request and the empty room: brief, room, zones.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "absl/strings/ascii.h"
#include "cli/inspect/content_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"

namespace flair::cli {
namespace {

// Twice the area is the sum over the edges.
double AreaOf_m2(const v1::Polygon& polygon) {
  double doubled = 0;
  for (int i = 0; i < polygon.vertices_size(); ++i) {
    const v1::Point2& a = polygon.vertices(i);
    const v1::Point2& b = polygon.vertices((i + 1) % polygon.vertices_size());
    doubled += a.x_m() * b.y_m() - b.x_m() * a.y_m();
  }
  return doubled / 2;
}

std::string PointText(const v1::Point2& point) { return fmt::format("({:.4g}, {:.4g})", point.x_m(), point.y_m()); }

// What is in or on a wall, by id.
std::string ThingsIn(const v1::Room& room, const std::string& wall) {
  std::string text;
  for (const v1::Opening& opening : room.openings()) {
    if (opening.wall() == wall) text += (text.empty() ? "" : ", ") + opening.id();
  }
  for (const v1::Socket& socket : room.sockets()) {
    if (socket.wall() == wall) text += (text.empty() ? "" : ", ") + socket.id();
  }
  return text;
}

std::string WallsText(const v1::Room& room, const ContentStyle& style) {
  Columns table({"wall", "from", "to", ">length m", "with"});
  for (int i = 0; i < room.walls_size() && i < room.floor().vertices_size(); ++i) {
    const v1::Point2& a = room.floor().vertices(i);
    const v1::Point2& b = room.floor().vertices((i + 1) % room.floor().vertices_size());
    table.Add({room.walls(i).name(), PointText(a), PointText(b),
               fmt::format("{:.2f}", std::hypot(b.x_m() - a.x_m(), b.y_m() - a.y_m())),
               ThingsIn(room, room.walls(i).name())});
  }
  return Heading(fmt::format("WALLS, {}", room.walls_size())) + table.Text(style.most_rows);
}

std::string LeafText(const v1::Opening& opening) {
  if (!opening.has_leaf()) return "";
  std::string text = ShortName(v1::DoorSwing_Name(opening.leaf().swing()), "DOOR_SWING_");
  if (opening.leaf().hinge() == v1::HINGE_SIDE_UNSPECIFIED) return text;
  return fmt::format("{}, hinge at its {}, {:.0f}°", text,
                     ShortName(v1::HingeSide_Name(opening.leaf().hinge()), "HINGE_SIDE_"),
                     opening.leaf().swing_angle_rad() * 180 / std::numbers::pi);
}

std::string OpeningsText(const v1::Room& room, const ContentStyle& style) {
  if (room.openings().empty()) return "";
  Columns table({"opening", "kind", "wall", ">from m", ">width m", ">sill m", ">head m", "leaf", "look"});
  for (const v1::Opening& opening : room.openings()) {
    table.Add({opening.id(), ShortName(v1::OpeningKind_Name(opening.kind()), "OPENING_KIND_"), opening.wall(),
               fmt::format("{:.2f}", opening.offset_m()), fmt::format("{:.2f}", opening.width_m()),
               fmt::format("{:.2f}", opening.sill_height_m()), fmt::format("{:.2f}", opening.head_height_m()),
               LeafText(opening), Shortened(opening.description(), 60)});
  }
  return Heading(fmt::format("OPENINGS, {}", room.openings_size())) + table.Text(style.most_rows);
}

std::string SocketsText(const v1::Room& room, const ContentStyle& style) {
  if (room.sockets().empty()) return "";
  Columns table({"socket", "wall", ">from m", ">height m"});
  for (const v1::Socket& socket : room.sockets()) {
    table.Add({socket.id(), socket.wall(), fmt::format("{:.2f}", socket.offset_m()),
               fmt::format("{:.2f}", socket.height_m())});
  }
  return Heading(fmt::format("SOCKETS, {}", room.sockets_size())) + table.Text(style.most_rows);
}

}  // namespace

std::string Heading(const std::string& title) { return fmt::format("\n{}\n", title); }

std::string ShortName(const std::string& name, const std::string& prefix) {
  std::string text = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
  for (char& c : text) c = c == '_' ? ' ' : absl::ascii_tolower(static_cast<unsigned char>(c));
  return text.empty() ? "?" : text;
}

std::string RemarksText(const google::protobuf::RepeatedPtrField<v1::Diagnostic>& remarks, const ContentStyle& style) {
  if (remarks.empty()) return "";
  Columns table({"remark", "code", "about", "what"});
  for (const v1::Diagnostic& remark : remarks) {
    table.Add({ShortName(v1::Severity_Name(remark.severity()), "SEVERITY_"), remark.code(), remark.subject_id(),
               remark.message()});
  }
  return Heading(fmt::format("REMARKS, {}", remarks.size())) + table.Text(style.most_rows);
}

std::string BriefText(const v1::Brief& brief, const ContentStyle& style) {
  std::string text = fmt::format("{:<11}{}\n{:<11}{}\n", "asked for", brief.text(), "seed", brief.seed());
  if (brief.has_room()) text += Heading("THE USER'S OWN ROOM") + RoomText(brief.room(), style);
  if (brief.has_zone_plan()) text += ZonesText(brief.zone_plan(), style);
  if (brief.has_object_list()) text += ObjectsText(brief.object_list(), style);
  if (brief.has_constraint_list()) text += SentencesText(brief.constraint_list(), style);
  return text;
}

std::string RoomText(const v1::Room& room, const ContentStyle& style) {
  double width = 0, depth = 0;
  std::string corners;
  for (const v1::Point2& point : room.floor().vertices()) {
    width = std::max(width, point.x_m());
    depth = std::max(depth, point.y_m());
    corners += (corners.empty() ? "" : " ") + PointText(point);
  }
  std::string text = fmt::format("{:<11}{}{}\n", "room", room.room_type().empty() ? "room" : room.room_type(),
                                 room.title().empty() ? "" : ", \"" + room.title() + "\"");
  text += fmt::format("{:<11}{:.4g} m x {:.4g} m, {:.4g} m high, {:.4g} m2\n", "size", width, depth, room.height_m(),
                      AreaOf_m2(room.floor()));
  text += fmt::format("{:<11}{}\n", "floor", Shortened(corners, 400));
  return text + WallsText(room, style) + OpeningsText(room, style) + SocketsText(room, style) +
         RemarksText(room.diagnostics(), style);
}

std::string ZonesText(const v1::ZonePlan& plan, const ContentStyle& style) {
  Columns table({"zone", "name", "purpose"});
  for (const v1::Zone& zone : plan.zones()) table.Add({zone.id(), zone.name(), zone.purpose()});
  return Heading(fmt::format("ZONES, {}, most important first", plan.zones_size())) + table.Text(style.most_rows) +
         RemarksText(plan.diagnostics(), style);
}

}  // namespace flair::cli
