// SPDX-License-Identifier: GPL-3.0-or-later
// What pictures and scenes of a layout cost.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/solved_layout.pb.h"
#include "renderer_worker/images/image_files.h"

namespace flair::cli {

// What is measured, in the order of the columns.
inline constexpr const char* kRenderKinds[] = {"plan PNG", "plan SVG", "plan PDF", "bird's-eye", "GLB"};
inline constexpr int kRenderKindCount = 5;

// Of one room.
struct RenderMeasure {
  std::string room;
  int object_count = 0;
  // By kind; CPU of all threads, the least of the repeats. Negative: not measured.
  double cpu_s[kRenderKindCount] = {};
  size_t bytes[kRenderKindCount] = {};
};

struct RenderBench {
  int repeat_count = 3;
  int view_size_px = 1024;
  int sample_count = 16;
  int thread_count = 2;
  bool views = true;
};

// Draws the layout as a renderer does, without its transport. The first call of the process also loads what it needs;
// call it once beforehand.
absl::StatusOr<RenderMeasure> MeasureRenders(const std::string& room, const v1::SolvedLayout& layout,
                                             const RenderBench& bench, renderer::ImageWriter& writer);

// Median, 95th percentile and the slowest room of every kind, as a table for people.
std::string RenderTable(std::span<const RenderMeasure> measures);
// All figures of all rooms.
std::string RenderJson(std::span<const RenderMeasure> measures, const RenderBench& bench);

}  // namespace flair::cli
