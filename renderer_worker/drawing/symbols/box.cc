// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "renderer_worker/drawing/symbols/families.h"

namespace flair::renderer {

void DrawPlainBox(SymbolPen& pen) {
  pen.Area(pen.whole(), Tone::kBody, Line::kOutline);
  pen.Area(pen.whole().Grown(-std::min(0.04, 0.08 * pen.smaller())), Tone::kLight, Line::kFaint);
  pen.FrontMark();
}

}  // namespace flair::renderer
