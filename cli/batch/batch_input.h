// SPDX-License-Identifier: GPL-3.0-or-later
// The file of briefs: read once to know which it is, then line by line.
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/batch/results_file.h"
#include "flair/v1/job.pb.h"
#include "nlohmann/json_fwd.hpp"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::cli {

// A file of briefs, read once to know which it is; it is read a second time to submit it.
struct BatchInput {
  // Where the lines are: the file itself, or a copy of what came by a pipe.
  std::filesystem::path path;
  // Of all its bytes, lower-case hex.
  std::string sha256;
  int64_t size_bytes = 0;
  // What people know it by: the file's name.
  std::string name;
};

// `given` is a file, or "-" for standard input; that and other pipes are first copied to `copy`.
// NOT_FOUND, FAILED_PRECONDITION for what cannot be read; INVALID_ARGUMENT for an empty file and for one that is of
// another kind than text; CANCELLED when `stop` is asked for meanwhile.
absl::StatusOr<BatchInput> OpenBatchInput(const std::string& given, const std::filesystem::path& copy,
                                          runtime::Cancellation& stop);

// One line of a file that may be larger than memory.
struct Line {
  // From 1 on.
  int64_t number = 0;
  // Without its break (\n or \r\n), valid until the next one is read; of a line that is too long, its beginning.
  std::string_view text;
  bool too_long = false;
  // Where the next line begins, bytes from the file's beginning.
  int64_t end_offset = 0;
};

// Reads a file line by line. A byte order mark before the first line is left out.
class LineReader {
 public:
  // The longest line that is read whole.
  static constexpr size_t kLongestLine = 4u << 20;

  // Begins at the byte `offset`, where a line begins, the first of which has `number`. Errors as ReadFile; a pipe is
  // none.
  static absl::StatusOr<std::unique_ptr<LineReader>> Open(const std::filesystem::path& path, int64_t offset = 0,
                                                          int64_t number = 1);

  // False after the last line.
  absl::StatusOr<bool> Next(Line& line);

 private:
  LineReader(std::filesystem::path path, int64_t offset, int64_t number);

  const std::filesystem::path path_;
  std::ifstream file_;
  // Of the next line.
  int64_t offset_;
  int64_t number_;
  std::string buffer_;
};

// One line of a file of briefs, as docs/batches.md describes them.
struct BriefLine {
  v1::JobSpec spec;
  // What the user calls it ("id"); empty when nothing.
  std::string key;
};

// Reads a line without its break: a sentence, a JSON string, or a JSON object with the fields of a Brief (or a Brief in
// "brief") and id, variants, views, solve, render, models. What it leaves out is taken from `defaults`, whose brief has
// no text. INVALID_ARGUMENT says in one line what is wrong: field, value and what would be right.
absl::StatusOr<BriefLine> ReadBriefLine(std::string_view line, const v1::JobSpec& defaults);

// The pictures that a job draws: the first goes to render_options, the others to further_views. `views` are changes of
// what render_options has been set to so far.
void SetViews(const std::vector<v1::RenderOptions>& views, v1::JobSpec& spec);

// Messages as people write them in JSON: only what they want to change, enums by their short words.

// Sets the fields of `message` that the JSON object names and leaves the others as they are; parts that are messages
// are changed likewise, lists are replaced. Enums may be short words: "birdseye" for PREVIEW_VIEW_BIRDSEYE.
// INVALID_ARGUMENT begins with `path` and the field: "solve.max_restart_count: is "x"; expected ...".
absl::Status SetFromJson(const nlohmann::json& object, std::string_view path, google::protobuf::Message& message);

// Where a batch is, as its folder remembers it.
struct BatchPlace {
  std::string batch_id;
  // What people know it by.
  std::string label;
  std::string orchestrator;
  // The local store; empty when it is elsewhere.
  std::string store;
  // Of a queue in JetStream, without credentials; see EngineFlags.
  std::string engine;
  std::string queue;
  std::string artifacts;
  // What the jobs are kept as, and in how large shards (0: in folders).
  std::string kept;
  int shard_size = 0;
};

// The folder that --out names: results.db, rejected.jsonl, jobs/ or shards/. One process at a time may hold it.
class BatchFolder {
 public:
  // Makes the folder when it is missing. FAILED_PRECONDITION when it cannot be written, when another process holds it,
  // or when a file is in its place.
  static absl::StatusOr<std::unique_ptr<BatchFolder>> Hold(const std::filesystem::path& path);
  ~BatchFolder();

  // Whether there is one at the path, without holding it.
  static bool IsAt(const std::filesystem::path& path);
  // What one remembers. NOT_FOUND when it has no batch.
  static absl::StatusOr<BatchPlace> ReadPlace(const std::filesystem::path& path);

  // What it remembers; without an id when it has no batch yet.
  absl::StatusOr<BatchPlace> Place();
  absl::Status SetPlace(const BatchPlace& place);

  const std::filesystem::path& path() const { return path_; }
  ResultsFile& results() { return *results_; }

 private:
  BatchFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  const std::filesystem::path path_;
  const int lock_;
  std::unique_ptr<ResultsFile> results_;
};

// The file of results in a batch's folder.
std::filesystem::path ResultsPath(const std::filesystem::path& folder);

}  // namespace flair::cli
