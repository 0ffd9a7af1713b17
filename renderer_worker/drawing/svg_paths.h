// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "renderer_worker/drawing/canvas.h"
#include "room/geometry/polygon.h"

namespace flair::renderer {

// Writes what a canvas draws as SVG elements that need nothing else: no ids, no definitions, so that any number of them
// go into one document. Device units of the canvas are millimetres of the room; coordinates are written in metres, to
// a tenth of a millimetre. What is clipped is cut, by straight lines.
class SvgPaths {
 public:
  // `m_per_mm`: metres of the room that are a millimetre of paper.
  explicit SvgPaths(double m_per_mm) : m_per_mm_(m_per_mm) {}

  // The current path of `cairo`, which keeps it.
  void Fill(cairo_t* cairo, const Rgb& colour, double alpha);
  void Draw(cairo_t* cairo, const Stroke& stroke);
  // Until Unclip, only what lies in the polygon that is the path is written. Unless it is convex, polygons that are
  // filled must be.
  void Clip(cairo_t* cairo);
  void Unclip() { clip_.vertices.clear(); }

  // One <g> of all since the last call.
  std::string Take();

 private:
  // The data of a path, within the clip.
  std::string Data(cairo_t* cairo, bool filled) const;

  double m_per_mm_;
  std::string elements_;
  std::string filled_;  // data of the last element, when it is a fill that a stroke may be added to
  Polygon clip_;
};

}  // namespace flair::renderer
