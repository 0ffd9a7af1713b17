// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/styling/choose_style.h"

#include <fmt/format.h>

#include <string>

#include "language_worker/handbook/program/room_program.h"
#include "language_worker/handbook/reading/brief_facts.h"
#include "language_worker/handbook/sentences/fill.h"
#include "language_worker/handbook/styling/style_choice.h"

namespace flair::language {
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
  const absl::StatusOr<BriefFacts> facts = ReadBrief(brief, handbook);
  if (!facts.ok()) return facts.status();
  const Choice choice(brief.seed(), brief.text());
  const StyleChoice style(*facts, handbook, choice);
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
    const hb::Furniture* furniture = handbook.FindFurniture(object.name());
    const StyleChoice::Look look = style.LookOf(furniture != nullptr ? *furniture : unknown, 0);
    v1::ObjectStyle& entry = *sheet.add_objects();
    entry.set_subject_id(object.id());
    entry.set_material(look.material);
    *entry.mutable_colour() = ToColour(look.colour);
    entry.set_description(object.description());
  }
  const hb::OpeningRules& rules = EffectiveArchetype(*facts, handbook).openings();
  for (const v1::Opening& opening : room.openings()) AddOpening(opening, rules, style, choice, sheet);
  return sheet;
}

}  // namespace flair::language
