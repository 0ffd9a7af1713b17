// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/drawing/box.h"

namespace flair::renderer {

// The layouts of this folder, for tests.
const std::vector<std::string>& SampleLayouts();

// Reads `name`.textproto of this folder; stops the test program when it cannot.
v1::SolvedLayout ReadSample(const std::string& name);

// The painted paths of a document as its file says them, for tests: ends of lines and curves (control points are left
// out), millimetres from the upper left corner of the page. What only clips is left out.
using PaintedPath = std::vector<Point>;

struct Document {
  Size page_mm;
  std::vector<PaintedPath> paths;  // in the order of painting; at least two points each
};

// Of what cairo writes; stops the test program at anything it does not understand.
Document ReadSvg(const std::string& file);
Document ReadPdf(const std::string& file);

}  // namespace flair::renderer
