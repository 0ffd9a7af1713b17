// SPDX-License-Identifier: GPL-3.0-or-later
// What all measurements share: problems from files, clocks, records and their summaries.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json.hpp"

namespace flair::renderer {
class ImageWriter;
}

namespace flair::cli {

struct ProblemFile {
  // The file's name without its ending; that of its folder for the graph in a folder of a design.
  std::string name;
  std::filesystem::path path;
};

struct BenchProblem {
  std::string name;
  v1::LayoutGraph graph;
  // What the file says that somebody else made of it; placements only.
  std::optional<v1::SolvedLayout> recorded;
};

// The files of a folder that may hold problems, by name: .json and .pb, and the graph.pb of folders in it (what
// `flair design --out` writes). `path` itself when it is a file. NOT_FOUND when there are none.
absl::StatusOr<std::vector<ProblemFile>> ListProblemFiles(const std::filesystem::path& path);

// A graph, or the graph of a layout, .pb or .json; INVALID_ARGUMENT when it is neither. ./flair-dev import flairgpt
// makes them of recorded problems.
absl::StatusOr<BenchProblem> ReadBenchProblem(const ProblemFile& file);

// CPU time that this process has used, all threads, seconds.
double ProcessCpu_s();
// CPU time that the calling thread has used, seconds.
double ThreadCpu_s();
// Monotonic time, seconds from some point.
double Wall_s();
// The most memory that this process has held, MiB.
double PeakMemory_MiB();

// The value at `share` of [0, 1] of the way through the sorted values, the upper one between two; 0 when there are
// none.
double Quantile(std::vector<double> values, double share);

// What was measured once; evaluation/bench makes tables of it.
using Record = nlohmann::ordered_json;

// Solves.

struct SolveMeasure {
  v1::SolvedLayout layout;
  // name, objects, cpu_s and wall_s of this process (all threads, medians over the repeats), restarts and evaluations
  // of all branches, total_cost; "stages" with the same of each; "ours" and, of the layout that the problem came with,
  // "recorded": verdicts, measures and findings; "missed": the constraints that do not hold, and why; "memory_mib": the
  // most that the process had held before and after.
  Record record;
};

// Solves `repeats` (>= 1) times in this process. INTERNAL when the repeats do not give the same bytes.
absl::StatusOr<SolveMeasure> MeasureSolve(const BenchProblem& problem, const v1::SolveOptions& options, int repeats);

// Edits of solved layouts: what one costs, how much it moves, and how good the result is.

// One edit of each kind per object, at most `per_kind` objects of a room: moved by half a metre, turned, grown by a
// fifth, unpinned after a pin, removed, doubled; and weights raised and edges dropped. Each record has room, edit (such
// as "move desk 1.2 0.5 90"), cpu_s of this process, moved, deepest_overlap_m, and constraints that hold: held_before
// the edit and held_after it.
absl::StatusOr<std::vector<Record>> MeasureResolves(const BenchProblem& problem, const v1::SolveOptions& options,
                                                    int per_kind);

// How soon restarts of the primary stage find the best layout that many of them find: runs restarts 0 to `count` of the
// stage, one after the other. The record has name and, for each restart in order, its scores and the cpu_s of its
// thread. NOT_FOUND when the room has no primaries.
absl::StatusOr<Record> MeasureRestarts(const BenchProblem& problem, v1::SolveOptions options, int count);

// Pictures and scenes.

struct RenderBench {
  int repeat_count = 3;
  int view_size_px = 1024;
  int sample_count = 16;
  int thread_count = 2;
  bool views = true;
};

// Draws the layout as a renderer does, without its transport. The record has room, object_count and for each kind of
// picture that is drawn, such as "plan PNG", the cpu_s of all threads, the least of the repeats, and bytes. The first
// call of the process also loads what it needs; call it once beforehand.
absl::StatusOr<Record> MeasureRenders(const std::string& room, const v1::SolvedLayout& layout, const RenderBench& bench,
                                      renderer::ImageWriter& writer);

// Completes a graph that comes without its language stage, such as a recorded one: adds the sentences that follow from
// the use of its objects, with their calls, and takes out the calls that they overrule. A call without a sentence
// counts as one of the words of its type. Errors of the handbook's files.
absl::Status CompleteGraph(v1::LayoutGraph& graph);

}  // namespace flair::cli
