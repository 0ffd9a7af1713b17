// SPDX-License-Identifier: GPL-3.0-or-later
// What stands in the room and how it looks: objects, style.
#include <map>
#include <tuple>
#include <vector>

#include "cli/inspect/content_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace flair::cli {
namespace {

// What pieces of one row have in common.
using RowKey = std::tuple<std::string, int, int, std::string, double, double, double, double, std::string, bool>;

RowKey KeyOf(const v1::Object& object) {
  return {object.name(),    object.role(),     object.kind(),        object.zone_id(), object.width_m(),
          object.depth_m(), object.height_m(), object.elevation_m(), object.host_id(), object.requested()};
}

std::string Remarkable(const v1::Object& object) {
  std::vector<std::string> words;
  if (object.requested()) words.emplace_back("asked for");
  if (object.walk_over()) words.emplace_back("walked over");
  if (!object.host_id().empty()) words.push_back("on " + object.host_id());
  if (object.elevation_m() > 0) words.push_back(fmt::format("{:.2f} m up", object.elevation_m()));
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string ColourText(const v1::Colour& colour) {
  return fmt::format("{}#{:02x}{:02x}{:02x}", colour.name().empty() ? "" : colour.name() + " ", colour.red() & 255,
                     colour.green() & 255, colour.blue() & 255);
}

}  // namespace

std::string ObjectsText(const v1::ObjectList& list, const ContentStyle& style) {
  std::vector<std::vector<const v1::Object*>> rows;
  std::map<RowKey, size_t> row_of;
  for (const v1::Object& object : list.objects()) {
    const auto [found, is_new] = row_of.emplace(KeyOf(object), rows.size());
    if (is_new) rows.emplace_back();
    rows[found->second].push_back(&object);
  }
  Columns table(
      {"object", ">count", "name", "role", "kind", "zone", ">width m", ">depth m", ">height m", "category", "more"});
  for (const std::vector<const v1::Object*>& row : rows) {
    const v1::Object& object = *row.front();
    table.Add({row.size() == 1 ? object.id() : fmt::format("{} … {}", object.id(), row.back()->id()),
               fmt::format("{}", row.size()), object.name(),
               ShortName(v1::ObjectRole_Name(object.role()), "OBJECT_ROLE_"),
               ShortName(v1::ObjectKind_Name(object.kind()), "OBJECT_KIND_"), object.zone_id(),
               fmt::format("{:.2f}", object.width_m()), fmt::format("{:.2f}", object.depth_m()),
               fmt::format("{:.2f}", object.height_m()), object.category(), Remarkable(object)});
  }
  std::string text = Heading(fmt::format("OBJECTS, {}", list.objects_size())) + table.Text(style.most_rows);
  if (!list.omissions().empty()) {
    Columns left({"left out", "asked for", "why"});
    for (const v1::Omission& omission : list.omissions()) {
      left.Add({omission.name(), omission.requested() ? "yes" : "no", omission.reason()});
    }
    text += Heading(fmt::format("LEFT OUT, {}", list.omissions_size())) + left.Text(style.most_rows);
  }
  return text + RemarksText(list.diagnostics(), style);
}

std::string StyleText(const v1::StyleSheet& sheet, const ContentStyle& style) {
  std::string text = fmt::format("{:<11}{}\n{:<11}{}\n", "style", sheet.name(), "summary", sheet.summary());
  std::vector<std::string> colours;
  for (const v1::Colour& colour : sheet.palette()) colours.push_back(ColourText(colour));
  text += fmt::format("{:<11}{}\n", "palette", fmt::join(colours, ", "));
  Columns looks({"what", "material", "colour", "look"});
  for (const v1::SurfaceStyle& surface : sheet.surfaces()) {
    looks.Add({surface.surface(), surface.material(), ColourText(surface.colour()), surface.description()});
  }
  for (const v1::ObjectStyle& object : sheet.objects()) {
    looks.Add({object.subject_id(), object.material(), ColourText(object.colour()), object.description()});
  }
  if (!looks.empty()) text += Heading("LOOKS") + looks.Text(style.most_rows);
  return text + RemarksText(sheet.diagnostics(), style);
}

}  // namespace flair::cli
