// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/loading/check_handbook.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "language_worker/handbook/sentences/template.h"

namespace flair::language {
namespace {

using Names = std::set<std::string, std::less<>>;

// Words that name the room itself as a host.
bool IsRoomHost(std::string_view name) {
  return name == "wall" || name == "ceiling" || name == "floor" || name == "window";
}

class Checker {
 public:
  Checker(const hb::Handbook& handbook, const std::vector<EntrySource>& sources)
      : handbook_(handbook), sources_(sources) {}

  std::vector<std::string> Run() {
    CollectNames();
    for (const auto& item : handbook_.furniture()) CheckFurniture(item);
    for (const auto& item : handbook_.archetypes()) CheckArchetype(item);
    for (const auto& item : handbook_.themes()) CheckTheme(item);
    for (const auto& item : handbook_.needs()) CheckNeed(item);
    for (const auto& item : handbook_.styles()) CheckStyle(item);
    for (const auto& item : handbook_.colours()) {
      Enter("colour", item.name());
      CheckHex(item);
    }
    for (const auto& item : handbook_.general_rules()) {
      Enter("rule", item.name());
      for (const auto& name : item.selector().furniture()) Furniture(name, "selector");
      for (const auto& name : item.selector().except_furniture()) Furniture(name, "selector");
      CheckRelation(item.relation(), false);
    }
    if (handbook_.archetypes().empty()) problems_.push_back("no archetype: the handbook needs at least one");
    return std::move(problems_);
  }

 private:
  template <typename Items>
  Names Collect(const Items& items, const char* kind) {
    Names names;
    for (const auto& item : items) {
      Enter(kind, item.name());
      if (item.name().empty()) Problem("name: missing");
      if (!names.insert(item.name()).second) Problem("name: given twice; names are unique over all files");
    }
    return names;
  }

  void CollectNames() {
    furniture_ = Collect(handbook_.furniture(), "furniture");
    archetypes_ = Collect(handbook_.archetypes(), "archetype");
    styles_ = Collect(handbook_.styles(), "style");
    colours_ = Collect(handbook_.colours(), "colour");
    needs_ = Collect(handbook_.needs(), "need");
    Collect(handbook_.themes(), "theme");
  }

  void Enter(const char* kind, const std::string& name) {
    kind_ = kind;
    name_ = name;
  }

  void Problem(const std::string& what) {
    std::string file = "handbook";
    for (const EntrySource& source : sources_) {
      if (source.kind == kind_ && source.name == name_) file = source.file;
    }
    problems_.push_back(fmt::format("{}: {} \"{}\": {}", file, kind_, name_, what));
  }

  void Furniture(const std::string& name, const char* field) {
    if (!furniture_.contains(name)) Problem(fmt::format("{}: no furniture \"{}\"", field, name));
  }

  void Styles(const google::protobuf::RepeatedPtrField<std::string>& names) {
    for (const auto& name : names) {
      if (!styles_.contains(name)) Problem(fmt::format("styles: no style \"{}\"", name));
    }
  }

  void CheckExtent(const hb::Extent& extent, const char* field, bool required) {
    if (extent.typical() <= 0 && required) Problem(fmt::format("{}.typical: {}; must be above 0", field, extent.typical()));
    const double low = extent.min() > 0 ? extent.min() : extent.typical();
    const double high = extent.max() > 0 ? extent.max() : extent.typical();
    if (low > extent.typical() || high < extent.typical()) {
      Problem(fmt::format("{}: typical {} is not within [{}, {}]", field, extent.typical(), low, high));
    }
  }

  void CheckTemplate(const std::string& text, const char* field) {
    for (const std::string& name : UnknownPlaceholders(text)) {
      Problem(fmt::format("{}: unknown placeholder {{{}}} in \"{}\"", field, name, text));
    }
  }

  void CheckCondition(const hb::Condition& condition) {
    for (const auto& name : condition.with()) Furniture(name, "condition.with");
    for (const auto& name : condition.without()) Furniture(name, "condition.without");
    for (const auto& name : condition.rooms()) {
      if (!archetypes_.contains(name)) Problem(fmt::format("condition.rooms: no archetype \"{}\"", name));
    }
    if (condition.chance() < 0 || condition.chance() > 1) {
      Problem(fmt::format("condition.chance: {} is not within [0, 1]", condition.chance()));
    }
  }

  void CheckRelation(const hb::Relation& relation, bool names_object) {
    if (relation.text().empty()) Problem("relations.text: missing");
    CheckTemplate(relation.text(), "relations.text");
    CheckTemplate(relation.reason(), "relations.reason");
    for (const auto& name : relation.targets()) {
      if (!IsRoomHost(name)) Furniture(name, "relations.targets");
    }
    if (names_object) Furniture(relation.object(), "relations.object");
    if (relation.weight() < 0 || relation.weight() > 10) {
      Problem(fmt::format("relations.weight: {} is not within (0, 10]", relation.weight()));
    }
    CheckCondition(relation.condition());
  }

  void CheckEntry(const hb::ObjectEntry& entry, const char* field, const Names* zones) {
    Furniture(entry.furniture(), field);
    for (const auto& name : entry.or_furniture()) Furniture(name, field);
    for (const auto& name : entry.hosts()) {
      if (!IsRoomHost(name)) Furniture(name, "hosts");
    }
    if (zones != nullptr && !entry.zone().empty() && !zones->contains(entry.zone())) {
      Problem(fmt::format("{}: \"{}\" names zone \"{}\", which is not among its zones", field, entry.furniture(), entry.zone()));
    }
    if (entry.count() < 0 || entry.count() > 50) Problem(fmt::format("{}: count {} is not within [0, 50]", field, entry.count()));
    CheckTemplate(entry.sentence(), "sentence");
    CheckCondition(entry.condition());
  }

  void CheckZone(const hb::ZoneSpec& zone) {
    if (zone.name().empty()) Problem("zones.name: missing");
    for (const auto& name : zone.primaries()) Furniture(name, "zones.primaries");
  }

  void CheckFurniture(const hb::Furniture& item) {
    Enter("furniture", item.name());
    CheckExtent(item.width_m(), "width_m", true);
    CheckExtent(item.depth_m(), "depth_m", true);
    CheckExtent(item.height_m(), "height_m", true);
    for (const auto& relation : item.relations()) CheckRelation(relation, false);
    for (const auto& name : item.hosts()) Furniture(name, "hosts");
    for (const auto& entry : item.companions()) CheckEntry(entry, "companions", nullptr);
    if (!item.smaller().empty()) Furniture(item.smaller(), "smaller");
    if (!item.fixed_colour().empty() && !colours_.contains(item.fixed_colour())) {
      Problem(fmt::format("fixed_colour: no colour \"{}\"", item.fixed_colour()));
    }
    if (item.top_places() < 0 || item.top_places() > 5) Problem(fmt::format("top_places: {} is not within [0, 5]", item.top_places()));
    if (item.has_makes_zone()) CheckZone(item.makes_zone());
    for (const auto& text : item.descriptions()) CheckTemplate(text, "descriptions");
  }

  void CheckArchetype(const hb::Archetype& item) {
    Enter("archetype", item.name());
    CheckExtent(item.width_m(), "width_m", true);
    CheckExtent(item.depth_m(), "depth_m", true);
    Names zones;
    for (const auto& zone : item.zones()) {
      CheckZone(zone);
      zones.insert(zone.name());
    }
    if (item.bands().empty()) Problem("bands: missing; at least one");
    double last = 0;
    for (const auto& band : item.bands()) {
      if (band.max_area_m2() > 0 && band.max_area_m2() <= last) Problem("bands: not in the order of their areas");
      last = band.max_area_m2();
      if (band.zones().empty()) Problem("bands.zones: missing; at least one");
      for (const auto& name : band.zones()) {
        if (!zones.contains(name)) Problem(fmt::format("bands.zones: no zone \"{}\"", name));
      }
      for (const auto& entry : band.objects()) CheckEntry(entry, "bands.objects", &zones);
    }
    for (const auto& entry : item.tertiaries()) CheckEntry(entry, "tertiaries", nullptr);
    for (const auto& relation : item.relations()) CheckRelation(relation, true);
    if (!item.per_person().empty()) Furniture(item.per_person(), "per_person");
    Styles(item.styles());
  }

  void CheckChanges(const hb::Changes& changes) {
    for (const auto& swap : changes.substitutions()) {
      Furniture(swap.from(), "substitutions.from");
      Furniture(swap.to(), "substitutions.to");
      CheckCondition(swap.condition());
    }
    for (const auto& name : changes.removals()) Furniture(name, "removals");
    for (const auto& entry : changes.counts()) CheckEntry(entry, "counts", nullptr);
    for (const auto& entry : changes.additions()) CheckEntry(entry, "additions", nullptr);
    for (const auto& zone : changes.zones()) CheckZone(zone);
    for (const auto& relation : changes.relations()) CheckRelation(relation, true);
    CheckCondition(changes.zone_condition());
    if (!changes.becomes_room().empty() && !archetypes_.contains(changes.becomes_room())) {
      Problem(fmt::format("becomes_room: no archetype \"{}\"", changes.becomes_room()));
    }
  }

  void CheckTheme(const hb::Theme& item) {
    Enter("theme", item.name());
    if (item.keywords().empty() && !item.fallback()) Problem("keywords: missing");
    CheckChanges(item.changes());
    Styles(item.styles());
  }

  void CheckNeed(const hb::Need& item) {
    Enter("need", item.name());
    if (item.keywords().empty()) Problem("keywords: missing");
    CheckCondition(item.condition());
    CheckChanges(item.changes());
    for (const auto& name : item.overrides()) {
      if (!needs_.contains(name)) Problem(fmt::format("overrides: no need \"{}\"", name));
    }
  }

  void CheckHex(const hb::NamedColour& colour) {
    const std::string& hex = colour.hex();
    const bool good = hex.size() == 7 && hex[0] == '#' &&
                      std::all_of(hex.begin() + 1, hex.end(), [](unsigned char c) { return std::isxdigit(c) != 0; });
    if (!good) Problem(fmt::format("colour \"{}\": hex \"{}\" is not #RRGGBB", colour.name(), hex));
  }

  void CheckStyle(const hb::Style& item) {
    Enter("style", item.name());
    if (item.palettes().empty()) Problem("palettes: missing; at least one");
    for (const auto& palette : item.palettes()) {
      if (palette.colours().empty()) Problem("palettes.colours: missing; three to six");
      for (const auto& colour : palette.colours()) CheckHex(colour);
    }
    for (const auto& finish : item.walls()) CheckHex(finish.colour());
    for (const auto& finish : item.floors()) CheckHex(finish.colour());
    for (const auto& finish : item.ceilings()) CheckHex(finish.colour());
    for (const auto& choice : item.materials()) {
      for (const auto& colour : choice.colours()) CheckHex(colour);
    }
    for (const auto& text : item.summaries()) CheckTemplate(text, "summaries");
  }

  const hb::Handbook& handbook_;
  const std::vector<EntrySource>& sources_;
  Names furniture_, archetypes_, styles_, colours_, needs_;
  std::string kind_, name_;
  std::vector<std::string> problems_;
};

}  // namespace

void RecordSources(const std::string& file, const hb::Handbook& part, std::vector<EntrySource>& sources) {
  for (const auto& item : part.furniture()) sources.push_back({"furniture", item.name(), file});
  for (const auto& item : part.archetypes()) sources.push_back({"archetype", item.name(), file});
  for (const auto& item : part.themes()) sources.push_back({"theme", item.name(), file});
  for (const auto& item : part.needs()) sources.push_back({"need", item.name(), file});
  for (const auto& item : part.styles()) sources.push_back({"style", item.name(), file});
  for (const auto& item : part.colours()) sources.push_back({"colour", item.name(), file});
  for (const auto& item : part.general_rules()) sources.push_back({"rule", item.name(), file});
}

std::vector<std::string> CheckHandbook(const hb::Handbook& handbook, const std::vector<EntrySource>& sources) {
  return Checker(handbook, sources).Run();
}

}  // namespace flair::language
