// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/checks.h"

namespace flair::validation {

void Check(const v1::ZonePlan& plan, const Field& at) {
  if (!at["zones"].Count(plan.zones_size(), 1, 50, "zones")) return;
  NameSet seen;
  for (int i = 0; i < plan.zones_size(); ++i) {
    const v1::Zone& zone = plan.zones(i);
    const Field field = at["zones"][i];
    field["id"].NewId(zone.id(), seen);
    field["name"].Text(zone.name(), 1, 100);
    field["purpose"].Text(zone.purpose(), 0, 2000);
  }
  CheckDiagnostics(plan.diagnostics(), at["diagnostics"]);
}

NameSet ZoneIds(const v1::ZonePlan& plan) {
  NameSet ids;
  for (const v1::Zone& zone : plan.zones()) ids.insert(zone.id());
  return ids;
}

}  // namespace flair::validation
