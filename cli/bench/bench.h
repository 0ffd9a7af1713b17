// SPDX-License-Identifier: GPL-3.0-or-later
// What all measurements share: problems from files, clocks, records and their summaries.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "nlohmann/json.hpp"

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

// A graph of ours, the graph of a layout of ours (.pb or .json), or a recorded FlairGPT problem (.json).
// INVALID_ARGUMENT when it is none of these.
absl::StatusOr<BenchProblem> ReadBenchProblem(const ProblemFile& file);

// CPU time that this process has used, all threads, seconds.
double ProcessCpu_s();
// CPU time that the calling thread has used, seconds.
double ThreadCpu_s();
// Monotonic time, seconds from some point.
double Wall_s();
// Memory that this process holds now, and the most it has held, MiB.
double Memory_MiB();
double PeakMemory_MiB();

// The value at `share` of [0, 1] of the way through the sorted values, the upper one between two; 0 when there are
// none.
double Quantile(std::vector<double> values, double share);
double Mean(const std::vector<double>& values);

// What was measured once: an object that --json writes and that tables are made of.
using Record = nlohmann::ordered_json;

// A number of a record, by its JSON pointer; nothing when the record does not have it.
std::optional<double> NumberAt(const Record& record, const std::string& at);
// Those of all records that have it.
std::vector<double> NumbersAt(const std::vector<Record>& records, const std::string& at, double factor = 1);

// A column of a table of records.
struct Figure {
  const char* title;
  const char* at;
  int digits = 0;
  double factor = 1;
};
// "-" for what the record does not have.
std::string CellOf(const Record& record, const Figure& figure);

// Indented, ending in a newline.
std::string RecordText(const Record& record);

}  // namespace flair::cli
