// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/scene/mesh.h"

namespace flair::renderer {

// An sRGB colour, each channel in [0, 1].
struct Rgb {
  double red = 0;
  double green = 0;
  double blue = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

inline constexpr Rgb kWhite{1, 1, 1};

// The same colour as people see it (OKLCH): lightness in [0, 1], chroma in about [0, 0.35], hue in radians.
struct Oklch {
  double lightness = 0;
  double chroma = 0;
  double hue_rad = 0;
};

// 0xRRGGBB.
Rgb Hex(unsigned value);
// Channels are clamped to [0, 255].
Rgb FromProto(const v1::Colour& colour);
// Of linear RGB, as materials have it.
Rgb FromLinear(const Vec3& linear);
// `from` at share 0, `to` at share 1.
Rgb Mix(const Rgb& from, const Rgb& to, double share);
Oklch ToOklch(const Rgb& colour);
// Chroma is reduced until the colour exists in sRGB.
Rgb FromOklch(const Oklch& colour);

// The tint of the zone at that place of the plan: neighbours in the list are far apart in hue.
Rgb ZoneTint(int index);

// A colour light enough to print lines and text on. Order by lightness and the hue survive; a black coffin becomes
// grey.
Rgb SoftenForPrint(const Rgb& colour);
// A floor or wall tint: lighter and paler still.
Rgb TintForPrint(const Rgb& colour);
// A dark line colour that belongs to `fill`.
Rgb LineColourFor(const Rgb& fill);

}  // namespace flair::renderer
