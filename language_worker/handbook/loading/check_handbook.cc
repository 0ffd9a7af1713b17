// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/loading/check_handbook.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string_view>

namespace flair::language {
namespace {

template <typename List>
void Record(const std::string& kind, const List& list, const std::string& file, std::vector<EntrySource>& sources) {
  for (const auto& item : list) sources.push_back({kind, item.name(), file});
}

class Checker {
 public:
  Checker(const hb::Handbook& handbook, const std::vector<EntrySource>& sources) : handbook_(handbook) {
    for (const EntrySource& source : sources) {
      const std::string label = Label(source.kind, source.name);
      if (source.name.empty()) problems_.push_back(fmt::format("{}: a {} has no name", source.file, source.kind));
      if (!files_.emplace(label, source.file).second) {
        problems_.push_back(fmt::format("{}: {} is already defined in {}", source.file, label, files_[label]));
      }
    }
  }

  std::vector<std::string> Run() {
    for (const auto& item : handbook_.furniture()) CheckFurniture(item);
    for (const auto& item : handbook_.archetypes()) CheckArchetype(item);
    for (const auto& item : handbook_.themes()) CheckTheme(item);
    for (const auto& item : handbook_.needs()) CheckNeed(item);
    for (const auto& item : handbook_.styles()) CheckStyle(item);
    for (const auto& item : handbook_.colours()) CheckColour(item);
    for (const auto& rule : handbook_.general_rules()) {
      Enter("general rule", rule.name());
      CheckSentence(rule.relation().text());
      Known("furniture", rule.selector().furniture(), "selector");
      Known("furniture", rule.selector().except_furniture(), "selector");
    }
    for (const hb::AskedPlace& place : handbook_.asked_places()) {
      label_ = "asked place";
      CheckSentence(place.relation().text());
      if (!place.text_of_desks().empty()) CheckSentence(place.text_of_desks());
      if (place.words().empty()) Problem("has no words: " + place.relation().text());
    }
    for (const hb::Noun& noun : handbook_.nouns()) {
      label_ = "noun " + (noun.words().empty() ? "without words" : "\"" + noun.words(0) + "\"");
      for (const hb::NounOption& option : noun.options()) {
        Known("furniture", option.furniture(), "options");
        Known("archetype", option.rooms(), "options");
      }
    }
    if (handbook_.archetypes().empty()) problems_.push_back("the handbook has no archetype");
    return std::move(problems_);
  }

 private:
  static std::string Label(std::string_view kind, std::string_view name) {
    return fmt::format("{} \"{}\"", kind, name);
  }

  void Enter(std::string_view kind, std::string_view name) {
    label_ = Label(kind, name);
    const auto file = files_.find(label_);
    if (file != files_.end()) label_ = file->second + ": " + label_;
  }

  void Problem(const std::string& text) { problems_.push_back(label_ + ": " + text); }

  void Known(const std::string& kind, const std::string& name, std::string_view where) {
    if (files_.count(Label(kind, name)) == 0) Problem(fmt::format("{}: there is no {} \"{}\"", where, kind, name));
  }
  template <typename List>
  void Known(const std::string& kind, const List& names, std::string_view where) {
    for (const std::string& name : names) Known(kind, name, where);
  }

  void CheckExtent(const hb::Extent& extent, std::string_view name) {
    const double low = extent.min() > 0 ? extent.min() : extent.typical();
    const double high = extent.max() > 0 ? extent.max() : extent.typical();
    if (!(extent.typical() > 0 && low <= extent.typical() && extent.typical() <= high && high <= 20)) {
      Problem(fmt::format("{}: {} (min {}, max {}) must be above 0, in order, and at most 20 m", name, extent.typical(),
                          extent.min(), extent.max()));
    }
  }

  void CheckSentence(const std::string& text) {
    static const std::set<std::string, std::less<>> kPlaceholders = {
        "object",     "objects", "target", "targets", "front_m", "sides_m", "back_m", "side",
        "other_side", "corner",  "zone",   "count",   "first",   "second",  "wall",   "seat"};
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
      const std::size_t close = text.find('}', open);
      const std::string name = text.substr(open + 1, close == std::string::npos ? close : close - open - 1);
      if (close == std::string::npos || kPlaceholders.count(name) == 0) {
        Problem(fmt::format("sentence \"{}\": unknown placeholder {{{}}}", text, name));
      }
    }
    if (text.empty()) Problem("a sentence is empty");
  }

  void CheckRelations(const google::protobuf::RepeatedPtrField<hb::Relation>& relations, bool names_object) {
    for (const hb::Relation& relation : relations) {
      CheckSentence(relation.text());
      Known("furniture", relation.targets(), "targets");
      Known("furniture", relation.condition().with(), "with");
      Known("furniture", relation.condition().without(), "without");
      if (names_object) Known("furniture", relation.object(), "object");
    }
  }

  void CheckEntry(const hb::ObjectEntry& entry) {
    Known("furniture", entry.furniture(), "entry");
    Known("furniture", entry.or_furniture(), "or_furniture");
    for (const std::string& host : entry.hosts()) {
      if (host != "wall" && host != "ceiling" && host != "floor" && host != "window") Known("furniture", host, "hosts");
    }
    if (!entry.sentence().empty()) CheckSentence(entry.sentence());
  }

  void CheckFurniture(const hb::Furniture& item) {
    Enter("furniture", item.name());
    CheckExtent(item.width_m(), "width_m");
    CheckExtent(item.depth_m(), "depth_m");
    CheckExtent(item.height_m(), "height_m");
    CheckRelations(item.relations(), false);
    Known("furniture", item.hosts(), "hosts");
    for (const auto& companion : item.companions()) CheckEntry(companion);
    if (!item.smaller().empty()) Known("furniture", item.smaller(), "smaller");
    Known("furniture", item.makes_zone().primaries(), "makes_zone");
  }

  void CheckArchetype(const hb::Archetype& item) {
    Enter("archetype", item.name());
    CheckExtent(item.width_m(), "width_m");
    CheckExtent(item.depth_m(), "depth_m");
    std::set<std::string> zones;
    for (const auto& zone : item.zones()) {
      zones.insert(zone.name());
      Known("furniture", zone.primaries(), "zone " + zone.name());
    }
    if (item.bands().empty()) Problem("has no band");
    for (const auto& band : item.bands()) {
      if (band.zones().empty()) Problem("a band has no zone");
      for (const auto& zone : band.zones()) {
        if (zones.count(zone) == 0) Problem(fmt::format("a band names zone \"{}\", which is not in zones", zone));
      }
      for (const auto& entry : band.objects()) CheckEntry(entry);
    }
    for (const auto& entry : item.tertiaries()) CheckEntry(entry);
    CheckRelations(item.relations(), true);
    Known("style", item.styles(), "styles");
    for (const auto& rows : item.rows()) Known("furniture", rows.furniture(), "rows");
  }

  void CheckChanges(const hb::Changes& changes) {
    for (const auto& substitution : changes.substitutions()) {
      Known("furniture", substitution.from(), "substitutions");
      Known("furniture", substitution.to(), "substitutions");
    }
    Known("furniture", changes.removals(), "removals");
    for (const auto& entry : changes.counts()) CheckEntry(entry);
    for (const auto& entry : changes.additions()) CheckEntry(entry);
    CheckRelations(changes.relations(), true);
    if (!changes.becomes_room().empty()) Known("archetype", changes.becomes_room(), "becomes_room");
  }

  void CheckTheme(const hb::Theme& item) {
    Enter("theme", item.name());
    CheckChanges(item.changes());
    Known("style", item.styles(), "styles");
  }

  void CheckNeed(const hb::Need& item) {
    Enter("need", item.name());
    if (item.keywords().empty()) Problem("has no keywords");
    CheckChanges(item.changes());
  }

  void CheckStyle(const hb::Style& item) {
    Enter("style", item.name());
    if (item.palettes().empty()) Problem("has no palette");
    if (item.walls().empty() || item.floors().empty()) Problem("needs walls and floors");
    for (const auto& palette : item.palettes()) {
      for (const auto& colour : palette.colours()) CheckHex(colour);
    }
  }

  void CheckColour(const hb::NamedColour& item) {
    Enter("colour", item.name());
    CheckHex(item);
  }

  void CheckHex(const hb::NamedColour& colour) {
    const std::string& hex = colour.hex();
    const bool good =
        hex.size() == 7 && hex[0] == '#' && hex.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (!good) Problem(fmt::format("colour \"{}\": \"{}\" is not #RRGGBB", colour.name(), hex));
  }

  const hb::Handbook& handbook_;
  std::map<std::string, std::string, std::less<>> files_;
  std::string label_;
  std::vector<std::string> problems_;
};

}  // namespace

void RecordSources(const std::string& file, const hb::Handbook& part, std::vector<EntrySource>& sources) {
  Record("furniture", part.furniture(), file, sources);
  Record("archetype", part.archetypes(), file, sources);
  Record("theme", part.themes(), file, sources);
  Record("need", part.needs(), file, sources);
  Record("style", part.styles(), file, sources);
  Record("colour", part.colours(), file, sources);
}

std::vector<std::string> CheckHandbook(const hb::Handbook& handbook, const std::vector<EntrySource>& sources) {
  return Checker(handbook, sources).Run();
}

}  // namespace flair::language
