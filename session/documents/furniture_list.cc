// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/documents/furniture_list.h"

#include <map>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"

namespace flair::session {
namespace {

std::string Cell(std::string text) {
  // Spreadsheets run what begins so.
  if (!text.empty() && std::string_view("=+-@\t\r").find(text[0]) != std::string_view::npos) text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

// "dining", "on the desk", "on the wall, seating".
std::string PlaceOf(const v1::Object& object, const std::map<std::string, std::string>& zones,
                    const std::map<std::string, std::string>& names) {
  const auto host = names.find(object.host_id());
  if (object.kind() == v1::OBJECT_KIND_SURFACE && host != names.end()) return "on the " + host->second;
  const auto zone = zones.find(object.zone_id());
  const std::string part = zone == zones.end() ? "" : zone->second;
  const std::string hangs = object.kind() == v1::OBJECT_KIND_WALL      ? "on the wall"
                            : object.kind() == v1::OBJECT_KIND_CEILING ? "from the ceiling"
                                                                       : "";
  return hangs + (hangs.empty() || part.empty() ? "" : ", ") + part;
}

}  // namespace

std::string FurnitureCsv(const v1::SolvedLayout& layout) {
  const v1::LayoutGraph& graph = layout.graph();
  std::map<std::string, std::string> zones, names;
  std::set<std::string> placed;
  for (const v1::Zone& zone : graph.zone_plan().zones()) zones[zone.id()] = zone.name();
  for (const v1::Object& object : graph.object_list().objects()) names[object.id()] = object.name();
  for (const v1::Placement& at : layout.placements()) placed.insert(at.object_id());
  // Before and behind the count.
  std::vector<std::pair<std::string, std::string>> rows;
  std::map<std::pair<std::string, std::string>, int> counts;
  for (const v1::Object& object : graph.object_list().objects()) {
    if (!placed.contains(object.id())) continue;
    const std::pair row(Cell(object.name()), fmt::format("{:.2f},{:.2f},{:.2f},{}", object.width_m(), object.depth_m(),
                                                         object.height_m(), Cell(PlaceOf(object, zones, names))));
    if (++counts[row] == 1) rows.push_back(row);
  }
  std::string csv = "name,count,width_m,depth_m,height_m,where\r\n";
  for (const auto& row : rows) csv += fmt::format("{},{},{}\r\n", row.first, counts[row], row.second);
  return csv;
}

}  // namespace flair::session
