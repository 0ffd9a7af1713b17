// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "language_worker/handbook/choice.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/handbook/reading/brief_facts.h"

namespace flair::language {

// Step C iv: the style of the room, of every object and of every door and window. Errors as ReadBrief.
absl::StatusOr<v1::StyleSheet> ChooseStyle(const v1::Brief& brief, const v1::Room& room, const v1::ObjectList& objects,
                                           const Handbook& handbook);

// The style of one room: everything that the seed leaves open is chosen. Pointers go into the handbook, which must
// outlive it. The same facts and seed give the same style in every step that asks.
class StyleChoice {
 public:
  StyleChoice(const BriefFacts& facts, const Handbook& handbook, const Choice& choice);

  // Such as "green boho".
  const std::string& title() const { return title_; }
  const hb::Style& style() const { return style_; }
  // At least one colour; a colour that the brief names comes first.
  const hb::Palette& palette() const { return palette_; }
  const hb::Finish& wall() const { return wall_; }
  const hb::Finish& floor() const { return floor_; }
  const hb::Finish& ceiling() const { return ceiling_; }

  // Look of the `number`-th object of a class.
  struct Look {
    std::string material;
    hb::NamedColour colour;
    std::string adjective;
  };
  Look LookOf(const hb::Furniture& furniture, int number) const;

  // A sentence about an object of that look: one of the class's descriptions, filled in.
  std::string Describe(const hb::Furniture& furniture, const Look& look) const;

 private:
  void Lead(const std::vector<const hb::NamedColour*>& colours);
  void Take(const AskedFinish& asked);
  const hb::MaterialChoice* MaterialOf(const std::string& group) const;
  void TakeAskedColour(const hb::Furniture& furniture, Look& look) const;
  void TakeAskedMaterial(const hb::Furniture& furniture, Look& look) const;

  const Handbook& handbook_;
  const Choice& choice_;
  const std::vector<std::pair<const hb::Furniture*, const hb::NamedColour*>> object_colours_;
  const std::vector<std::pair<const hb::Furniture*, std::string>> object_materials_;
  const std::vector<const hb::NamedColour*> asked_colours_;  // of the room
  hb::Style style_;                                          // without the colours that the brief refuses
  std::string title_;
  hb::Palette palette_;
  hb::Finish wall_, floor_, ceiling_;
};

// "#RRGGBB" as a message; grey when it is not of that form.
v1::Colour ToColour(const hb::NamedColour& colour);

}  // namespace flair::language
