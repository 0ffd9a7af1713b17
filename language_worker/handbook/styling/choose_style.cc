// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/styling/choose_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/sentences/fill.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

template <typename List>
const auto& Pick(const List& list, const Choice& choice, const std::string& key) {
  return list[static_cast<int>(choice.Index(key, static_cast<std::size_t>(list.size())))];
}

long RgbOf(const hb::NamedColour& colour) { return std::strtol(colour.hex().c_str() + 1, nullptr, 16); }

// Squared distance of their red, green and blue.
long DistanceOf(const hb::NamedColour& one, const hb::NamedColour& other) {
  long distance = 0;
  for (const int shift : {16, 8, 0}) {
    const long difference = ((RgbOf(one) >> shift) & 255) - ((RgbOf(other) >> shift) & 255);
    distance += difference * difference;
  }
  return distance;
}

// How far the colours of the brief are from those of a style.
long FarFrom(const std::vector<const hb::NamedColour*>& asked, const hb::Style& style) {
  long far = 0;
  for (const hb::NamedColour* colour : asked) {
    long nearest = 3 * 255 * 255;
    for (const hb::Palette& palette : style.palettes())
      for (const hb::NamedColour& one : palette.colours()) nearest = std::min(nearest, DistanceOf(*colour, one));
    far += nearest;
  }
  return far;
}

// What the brief names, else what its themes say, else what suits the kind of room and the colours asked for.
const hb::Style* PickStyle(const BriefFacts& facts, const Handbook& handbook, const Choice& choice) {
  if (!facts.styles.empty()) return facts.styles.front();
  for (const hb::Theme* theme : facts.themes) {
    if (theme->styles_size() == 0) continue;
    if (const hb::Style* style = handbook.FindStyle(Pick(theme->styles(), choice, "style.theme"))) return style;
  }
  const hb::Archetype& archetype = EffectiveArchetype(facts, handbook);
  const hb::Style* nearest = nullptr;
  for (const std::string& name : archetype.styles()) {
    const hb::Style* style = facts.colours.empty() ? nullptr : handbook.FindStyle(name);
    if (style == nullptr) continue;
    if (nearest == nullptr || FarFrom(facts.colours, *style) < FarFrom(facts.colours, *nearest)) nearest = style;
  }
  if (nearest != nullptr) return nearest;
  if (archetype.styles_size() > 0) {
    if (const hb::Style* style = handbook.FindStyle(Pick(archetype.styles(), choice, "style.room"))) return style;
  }
  return &handbook.contents().styles(0);
}

hb::Finish PlainCeiling() {
  hb::Finish finish;
  finish.set_material("matt white paint");
  finish.mutable_colour()->set_name("white");
  finish.mutable_colour()->set_hex("#FAFAF7");
  return finish;
}

long BrightnessOf(const hb::NamedColour& colour) {
  const long rgb = RgbOf(colour);
  return 3 * (rgb >> 16 & 255) + 6 * (rgb >> 8 & 255) + (rgb & 255);
}

// Whether somebody who wants none of the one would not want the other: pink and blush.
bool IsAlike(const hb::NamedColour& one, const hb::NamedColour& other) {
  constexpr long kAlike = 60 * 60;
  if (one.hex().size() != 7 || other.hex().size() != 7) return false;
  return DistanceOf(one, other) < kAlike || other.name().find(one.name()) != std::string::npos;
}

// The style without colours like those; the last of a list stays.
hb::Style Without(const std::vector<const hb::NamedColour*>& refused, const hb::Style& style) {
  hb::Style left = style;
  const auto strike = [&](auto& list, const auto& colour_of) {
    for (int i = list.size() - 1; i >= 0 && list.size() > 1; --i) {
      const bool out = std::ranges::any_of(refused, [&](const auto* one) { return IsAlike(*one, colour_of(list[i])); });
      if (out) list.DeleteSubrange(i, 1);
    }
  };
  const auto itself = [](const hb::NamedColour& colour) -> const hb::NamedColour& { return colour; };
  const auto of_finish = [](const hb::Finish& finish) -> const hb::NamedColour& { return finish.colour(); };
  for (hb::Palette& palette : *left.mutable_palettes()) strike(*palette.mutable_colours(), itself);
  for (hb::MaterialChoice& material : *left.mutable_materials()) strike(*material.mutable_colours(), itself);
  for (auto* finishes : {left.mutable_walls(), left.mutable_floors()}) strike(*finishes, of_finish);
  return left;
}

}  // namespace

StyleChoice::StyleChoice(const BriefFacts& facts, const Handbook& handbook, const Choice& choice)
    : handbook_(handbook),
      choice_(choice),
      object_colours_(facts.object_colours),
      object_materials_(facts.object_materials),
      asked_colours_(facts.colours),
      style_(Without(facts.refused_colours, *PickStyle(facts, handbook, choice))) {
  palette_ = Pick(style_.palettes(), choice, "style.palette");
  wall_ = Pick(style_.walls(), choice, "style.wall");
  floor_ = Pick(style_.floors(), choice, "style.floor");
  ceiling_ = style_.ceilings_size() > 0 ? Pick(style_.ceilings(), choice, "style.ceiling") : PlainCeiling();
  title_ = style_.title().empty() ? style_.name() : style_.title();
  if (!facts.colours.empty()) Lead(facts.colours);
  for (const AskedFinish& finish : facts.finishes) Take(finish);
}

// The surface that the brief names is of what it says, in the colour that it says or that such a surface has in a
// style.
void StyleChoice::Take(const AskedFinish& asked) {
  const bool walls = asked.surface == AskedFinish::Surface::kWalls;
  hb::Finish& finish = walls ? wall_ : asked.surface == AskedFinish::Surface::kFloor ? floor_ : ceiling_;
  finish.clear_description();
  if (asked.colour != nullptr) *finish.mutable_colour() = *asked.colour;
  if (asked.material.empty()) return;
  finish.set_material(asked.material);
  if (asked.colour != nullptr) return;
  // Of "reclaimed oak boards" the colour is that of oak.
  const auto has_it = [&](const auto& one) {
    return std::ranges::any_of(TokensOf(asked.material),
                               [&](const Token& word) { return one.material().find(word.text) != std::string::npos; });
  };
  for (const hb::Style& style : handbook_.contents().styles()) {
    for (const auto* finishes : {walls ? &style.walls() : &style.floors(), walls ? &style.floors() : &style.walls()}) {
      const auto found = std::ranges::find_if(*finishes, has_it);
      if (found == finishes->end()) continue;
      *finish.mutable_colour() = found->colour();
      return;
    }
    const auto found = std::ranges::find_if(style.materials(), has_it);
    if (found == style.materials().end() || found->colours_size() == 0) continue;
    *finish.mutable_colour() = found->colours(0);
    return;
  }
}

void StyleChoice::Lead(const std::vector<const hb::NamedColour*>& colours) {
  // Colours of the brief lead the palette and take the walls.
  hb::Palette led;
  for (const hb::NamedColour* colour : colours) *led.add_colours() = *colour;
  for (const hb::NamedColour& colour : palette_.colours()) *led.add_colours() = colour;
  palette_ = led;
  *wall_.mutable_colour() = *colours.front();
  wall_.clear_description();
  if (title_.find(colours.front()->name()) == std::string::npos) title_ = colours.front()->name() + " " + title_;
}

const hb::MaterialChoice* StyleChoice::MaterialOf(const std::string& group) const {
  std::vector<const hb::MaterialChoice*> options;
  for (const std::string& wanted : {group, std::string()}) {
    for (const hb::MaterialChoice& material : style_.materials()) {
      if (material.group() == wanted) options.push_back(&material);
    }
    if (!options.empty()) return options[choice_.Index("material." + wanted, options.size())];
  }
  return nullptr;
}

// The material that the brief names, in the colour that it has in a style that has such a thing: of "dark oak" the
// darkest oak, of "dark" alone the darkest of the room's colours.
void StyleChoice::TakeAskedMaterial(const hb::Furniture& furniture, Look& look) const {
  const auto asked =
      std::ranges::find_if(object_materials_, [&](const auto& one) { return one.first->name() == furniture.name(); });
  if (asked == object_materials_.end()) return;
  const std::string shade = asked->second.substr(0, asked->second.find(' '));
  const bool shaded = IsIn("shades", shade);
  const std::string material =
      shaded ? asked->second.substr(std::min(asked->second.size(), shade.size() + 1)) : asked->second;
  if (!material.empty()) look.material = asked->second;
  std::vector<hb::NamedColour> colours;
  for (const hb::Style& style : handbook_.contents().styles()) {
    for (const hb::MaterialChoice& one : style.materials()) {
      if (material.empty() || one.material().find(material) == std::string::npos) continue;
      colours.insert(colours.end(), one.colours().begin(), one.colours().end());
    }
  }
  if (material.empty()) colours.assign(palette_.colours().begin(), palette_.colours().end());
  if (colours.empty()) return;
  const auto [darkest, lightest] = std::ranges::minmax_element(colours, {}, BrightnessOf);
  look.colour = !shaded ? colours.front() : IsIn("dark_shades", shade) ? *darkest : *lightest;
}

// Of several colours of the brief seats have the first that the walls have not, and cushions and rugs the last.
void StyleChoice::TakeAskedColour(const hb::Furniture& furniture, Look& look) const {
  const bool textile = furniture.material_group() == "textile", seat = furniture.material_group() == "upholstery";
  if (asked_colours_.empty() || !(textile || (seat && asked_colours_.size() > 1))) return;
  look.colour = textile ? *asked_colours_.back() : *asked_colours_[asked_colours_.size() > 2 ? 1 : 0];
}

StyleChoice::Look StyleChoice::LookOf(const hb::Furniture& furniture, int number) const {
  Look look;
  const hb::MaterialChoice* material = MaterialOf(furniture.material_group());
  look.material = !furniture.fixed_material().empty() ? furniture.fixed_material()
                  : material != nullptr               ? material->material()
                                                      : "painted wood";
  const auto& colours = material != nullptr && material->colours_size() > 0 ? material->colours() : palette_.colours();
  look.colour =
      colours[static_cast<int>(choice_.Index("colour." + furniture.name(), static_cast<std::size_t>(colours.size())))];
  TakeAskedColour(furniture, look);
  TakeAskedMaterial(furniture, look);
  if (const hb::NamedColour* fixed = handbook_.FindColour(furniture.fixed_colour())) look.colour = *fixed;
  for (const auto& [piece, colour] : object_colours_) {
    if (piece->name() == furniture.name()) look.colour = *colour;
  }
  if (style_.adjectives_size() > 0) {
    const std::size_t turn =
        choice_.Index("adjective." + furniture.name(), static_cast<std::size_t>(style_.adjectives_size()));
    look.adjective = style_.adjectives(static_cast<int>((turn + static_cast<std::size_t>(number)) %
                                                        static_cast<std::size_t>(style_.adjectives_size())));
  }
  return look;
}

std::string StyleChoice::Describe(const hb::Furniture& furniture, const Look& look) const {
  std::string text = "A {adjective} {name} in {material}, {colour}.";
  if (furniture.descriptions_size() > 0)
    text = Pick(furniture.descriptions(), choice_, "description." + furniture.name());
  // Books, sheet music: what is its own plural takes no article.
  if (furniture.plural() == furniture.name() && text.starts_with("A ")) text.erase(0, 2);
  text = Fill(text, {{"adjective", look.adjective},
                     {"material", look.material},
                     {"colour", look.colour.name()},
                     {"style", title_},
                     {"name", furniture.name()}});
  return Polish(text);
}

v1::Colour ToColour(const hb::NamedColour& colour) {
  v1::Colour message;
  message.set_name(colour.name());
  const bool good = colour.hex().size() == 7;
  const long rgb = good ? std::strtol(colour.hex().c_str() + 1, nullptr, 16) : 0x808080;
  message.set_red(static_cast<int>(rgb >> 16) & 255);
  message.set_green(static_cast<int>(rgb >> 8) & 255);
  message.set_blue(static_cast<int>(rgb) & 255);
  return message;
}

namespace {

void AddSurface(const char* surface, const hb::Finish& finish, v1::StyleSheet& sheet) {
  v1::SurfaceStyle& style = *sheet.add_surfaces();
  style.set_surface(surface);
  style.set_material(finish.material());
  *style.mutable_colour() = ToColour(finish.colour());
  style.set_description(finish.description().empty()
                            ? Polish(fmt::format("{} in {} {}.", surface, finish.colour().name(), finish.material()))
                            : finish.description());
}

void AddOpening(const v1::Opening& opening, const hb::OpeningRules& rules, const StyleChoice& style,
                const Choice& choice, v1::StyleSheet& sheet) {
  const bool door = opening.kind() == v1::OPENING_KIND_DOOR;
  const auto& descriptions = door ? rules.door_descriptions() : rules.window_descriptions();
  hb::Furniture frame;
  frame.set_name(door ? "door" : "window");
  frame.set_material_group("wood");
  const StyleChoice::Look look = style.LookOf(frame, 0);
  v1::ObjectStyle& object = *sheet.add_objects();
  object.set_subject_id(opening.id());
  object.set_material(look.material);
  *object.mutable_colour() = ToColour(look.colour);
  std::string text =
      door ? "A panelled door in {material}, {colour}." : "A window with a frame in {material}, {colour}.";
  if (!descriptions.empty()) {
    text = descriptions[static_cast<int>(
        choice.Index("opening." + frame.name(), static_cast<std::size_t>(descriptions.size())))];
  }
  object.set_description(Polish(Fill(text, {{"material", look.material}, {"colour", look.colour.name()}})));
}

// "sage green limewash"; the material alone when it names its colour: "white paint".
std::string WallWords(const hb::Finish& finish) {
  const std::string& colour = finish.colour().name();
  return finish.material().find(colour) != std::string::npos ? finish.material() : colour + " " + finish.material();
}

// Two or three sentences about the whole.
std::string Summary(const StyleChoice& style, const v1::Room& room, const Choice& choice) {
  const hb::Style& chosen = style.style();
  std::string text = "A {style} {room}: walls in {wall}, a floor of {floor}, led by {colour1}.";
  if (chosen.summaries_size() > 0) {
    text =
        chosen.summaries(static_cast<int>(choice.Index("summary", static_cast<std::size_t>(chosen.summaries_size()))));
  }
  const auto colour = [&](int i) { return style.palette().colours(i % style.palette().colours_size()).name(); };
  const auto material = [&](const char* group) {
    hb::Furniture probe;
    probe.set_material_group(group);
    return style.LookOf(probe, 0).material;
  };
  return Polish(Fill(text, {{"style", style.title()},
                            {"room", room.room_type()},
                            {"wall", WallWords(style.wall())},
                            {"floor", style.floor().material()},
                            {"colour1", colour(0)},
                            {"colour2", colour(1)},
                            {"colour3", colour(2)},
                            {"wood", material("wood")},
                            {"textile", material("textile")},
                            {"metal", material("metal")}}));
}

}  // namespace

absl::StatusOr<v1::StyleSheet> ChooseStyle(const v1::Brief& brief, const v1::Room& room, const v1::ObjectList& objects,
                                           const Handbook& handbook) {
  ASSIGN_OR_RETURN(const BriefFacts facts, ReadBrief(brief, handbook));
  const Choice choice(brief.seed(), brief.text());
  const Handbook& all = facts.HandbookOr(handbook);
  const StyleChoice style(facts, all, choice);
  v1::StyleSheet sheet;
  sheet.set_name(style.title());
  sheet.set_summary(Summary(style, room, choice));
  for (const hb::NamedColour& colour : style.palette().colours()) *sheet.add_palette() = ToColour(colour);
  AddSurface("walls", style.wall(), sheet);
  AddSurface("floor", style.floor(), sheet);
  AddSurface("ceiling", style.ceiling(), sheet);
  for (const v1::Object& object : objects.objects()) {
    hb::Furniture unknown;
    unknown.set_name(object.name());
    const hb::Furniture* furniture = all.FindFurniture(object.name());
    const StyleChoice::Look look = style.LookOf(furniture != nullptr ? *furniture : unknown, 0);
    v1::ObjectStyle& entry = *sheet.add_objects();
    entry.set_subject_id(object.id());
    entry.set_material(look.material);
    *entry.mutable_colour() = ToColour(look.colour);
    entry.set_description(object.description());
  }
  const hb::OpeningRules& rules = EffectiveArchetype(facts, all).openings();
  for (const v1::Opening& opening : room.openings()) AddOpening(opening, rules, style, choice, sheet);
  return sheet;
}

}  // namespace flair::language
