// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/checks.h"

namespace flair::validation {
namespace {

constexpr Range kChannel{.least = 0, .most = 255};

void CheckColour(const v1::Colour& colour, const Field& at) {
  at["name"].Text(colour.name(), 0, 100);
  at["red"].InRange(colour.red(), kChannel);
  at["green"].InRange(colour.green(), kChannel);
  at["blue"].InRange(colour.blue(), kChannel);
}

}  // namespace

void Check(const v1::StyleSheet& sheet, const Known& known, const Field& at) {
  at["name"].Text(sheet.name(), 0, 200);
  at["summary"].Text(sheet.summary(), 0, 4000);
  for (int i = 0; i < sheet.palette_size(); ++i) CheckColour(sheet.palette(i), at["palette"][i]);
  const NameSet surface_names = {"walls", "floor", "ceiling"};
  for (int i = 0; i < sheet.surfaces_size(); ++i) {
    const Field surface = at["surfaces"][i];
    surface["surface"].Refers(sheet.surfaces(i).surface(), surface_names, "a surface");
    CheckColour(sheet.surfaces(i).colour(), surface["colour"]);
  }
  NameSet seen;
  for (int i = 0; i < sheet.objects_size(); ++i) {
    const v1::ObjectStyle& style = sheet.objects(i);
    const Field field = at["objects"][i];
    CheckColour(style.colour(), field["colour"]);
    if (!field["subject_id"].NewId(style.subject_id(), seen)) continue;
    if (known.objects == nullptr || known.openings == nullptr || known.openings->contains(style.subject_id())) continue;
    field["subject_id"].Refers(style.subject_id(), *known.objects, "an object or opening");
  }
  CheckDiagnostics(sheet.diagnostics(), at["diagnostics"]);
}

}  // namespace flair::validation
