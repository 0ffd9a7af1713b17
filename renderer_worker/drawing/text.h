// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "absl/status/status.h"
#include "renderer_worker/drawing/box.h"
#include "renderer_worker/drawing/canvas.h"

namespace flair::renderer {

enum class Align { kLeft, kCentre, kRight };

// Only DejaVu is relied on. `condense` scales horizontally: 0.9 is what DejaVu Condensed is.
struct TextStyle {
  double size_mm = 3.4;  // em, not cap height
  Rgb colour = Hex(0x2B2926);
  bool bold = false;
  bool serif = false;
  double tracking = 0;  // extra space between letters, em
  double condense = 0.9;
  double line_spacing = 1.0;
};

// A paragraph that never leaves its width: wraps at words up to `max_lines`, then ends in an ellipsis.
struct TextBlock {
  std::string text;
  TextStyle style;
  double max_width_mm = 0;  // 0: one line of any width
  int max_lines = 1;
  Align align = Align::kLeft;
};

// FAILED_PRECONDITION when there is no font at all to write with; any other will do for a missing DejaVu.
absl::Status CheckFonts();

// The text with what is not UTF-8 replaced.
std::string ValidUtf8(const std::string& text);

// The size on paper; independent of the surface up to rounding of the font backend.
Size Measure(const Canvas& canvas, const TextBlock& block);

// Draws with the upper left corner at `top_left_mm` (with max_width_mm set, alignment is within that width).
void DrawText(Canvas& canvas, const TextBlock& block, Point top_left_mm);

// Draws in the middle of `centre_mm`, turned counter-clockwise by `angle_rad`, over a halo of `halo` when not null.
void DrawTextAt(Canvas& canvas, const TextBlock& block, Point centre_mm, double angle_rad = 0,
                const Rgb* halo = nullptr);

}  // namespace flair::renderer
