// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cairo.h>

#include <memory>
#include <span>

#include "flair/v1/style_sheet.pb.h"
#include "renderer_worker/drawing/box.h"
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

class Lettering;
class SvgPaths;

enum class Dash { kSolid, kDashed };

// How a path is drawn along: widths and dashes are in millimetres of paper whatever the frame.
struct Stroke {
  Rgb colour;
  double width_mm = 0.18;
  double alpha = 1;
  Dash dash = Dash::kSolid;
  bool round = false;  // ends and corners
};

// Draws on any cairo surface whose user unit is one millimetre of paper (sheet frame S). Paths may be built in another
// frame (an object's, in metres); strokes keep their width on paper. Knows nothing of files or pixels.
class Canvas {
 public:
  // Both must outlive the canvas. With `svg` paths go there instead of the surface.
  explicit Canvas(cairo_t* cairo, SvgPaths* svg = nullptr);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  // Paths are from now on built in a frame with this origin (in S), `mm_per_unit` and, when `y_up`, its y axis pointing
  // up the sheet before turning counter-clockwise by `theta_rad`.
  void EnterFrame(Point origin_mm, double mm_per_unit, double theta_rad, bool y_up);
  // Back to S.
  void LeaveFrame();

  void MoveTo(Point point);
  void LineTo(Point point);
  void CurveTo(Point control_1, Point control_2, Point end);
  // Part of a circle from angle `from_rad` to `to_rad` in the current frame, in growing angles.
  void Arc(Point centre, double radius, double from_rad, double to_rad);
  void Close();
  void Line(Point from, Point to);
  void Polygon(std::span<const Point> points);
  void Rectangle(const Box& box, double radius = 0);
  void Ellipse(Point centre, double radius_x, double radius_y);

  // Each consumes the path, except when followed by the other through `keep`.
  void Fill(const Rgb& colour, double alpha = 1, bool keep = false);
  void FillEvenOdd(const Rgb& colour, double alpha = 1);
  void Draw(const Stroke& stroke, bool keep = false);
  void Discard();
  // Restricts drawing to the path until the matching Unclip.
  void Clip();
  void Unclip();

  cairo_t* cairo() const { return cairo_; }
  const Lettering& lettering() const { return *lettering_; }

 private:
  cairo_t* cairo_;
  SvgPaths* svg_;
  std::unique_ptr<Lettering> lettering_;
  cairo_matrix_t sheet_;
  cairo_matrix_t frame_;
};

}  // namespace flair::renderer
