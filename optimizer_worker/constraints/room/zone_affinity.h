// SPDX-License-Identifier: GPL-3.0-or-later
// The whole-room term "zone": in_zone (space/in_zone.h) for an object and the zone it belongs to. [Paper] Eq. zone.
#pragma once

#include "optimizer_worker/constraints/space/in_zone.h"
