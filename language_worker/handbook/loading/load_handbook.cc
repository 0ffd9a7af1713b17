// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/handbook/loading/load_handbook.h"

#include <fmt/format.h>
#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "language_worker/handbook/loading/check_handbook.h"
#include "worker_runtime/files/files.h"

namespace flair::language {
namespace {

namespace fs = std::filesystem;

struct DataFile {
  std::string name;  // relative to the folder, with forward slashes
  std::string text;
};

// Collects what the parser of text protos finds, as "file:line:column: message".
class Errors : public google::protobuf::io::ErrorCollector {
 public:
  Errors(std::string file, std::vector<std::string>& lines) : file_(std::move(file)), lines_(lines) {}
  void AddError(int line, int column, const std::string& message) override {
    lines_.push_back(fmt::format("{}:{}:{}: {}", file_, line + 1, column + 1, message));
  }

 private:
  std::string file_;
  std::vector<std::string>& lines_;
};

absl::StatusOr<std::vector<DataFile>> ReadFiles(const fs::path& folder) {
  std::error_code error;
  std::vector<DataFile> files;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() != ".textproto" || !it->is_regular_file()) continue;
    std::ifstream stream(it->path(), std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) return absl::UnavailableError(fmt::format("cannot read handbook file {}", it->path().string()));
    files.push_back({fs::relative(it->path(), folder).generic_string(), text.str()});
  }
  if (error) {
    return absl::NotFoundError(fmt::format("handbook folder {}: {}", folder.string(), error.message()));
  }
  if (files.empty()) {
    return absl::NotFoundError(fmt::format("handbook folder {} has no *.textproto files", folder.string()));
  }
  std::sort(files.begin(), files.end(), [](const DataFile& a, const DataFile& b) { return a.name < b.name; });
  return files;
}

absl::Status Report(const std::vector<std::string>& problems) {
  constexpr std::size_t kMostShown = 20;
  std::string message = "the handbook does not check:";
  for (std::size_t i = 0; i < std::min(problems.size(), kMostShown); ++i) message += "\n  " + problems[i];
  if (problems.size() > kMostShown) message += fmt::format("\n  and {} more", problems.size() - kMostShown);
  return absl::InvalidArgumentError(message);
}

}  // namespace

absl::StatusOr<std::unique_ptr<const Handbook>> LoadHandbook(const fs::path& folder) {
  auto files = ReadFiles(folder);
  if (!files.ok()) return files.status();
  hb::Handbook merged;
  std::vector<std::string> problems;
  std::vector<EntrySource> sources;
  std::string digest_input;
  for (const DataFile& file : *files) {
    digest_input += fmt::format("{}\n{}\n{}", file.name, file.text.size(), file.text);
    Errors errors(file.name, problems);
    google::protobuf::TextFormat::Parser parser;
    parser.RecordErrorsTo(&errors);
    hb::Handbook part;
    if (!parser.ParseFromString(file.text, &part)) continue;
    RecordSources(file.name, part, sources);
    merged.MergeFrom(part);
  }
  if (problems.empty()) problems = CheckHandbook(merged, sources);
  if (!problems.empty()) return Report(problems);
  return std::make_unique<const Handbook>(std::move(merged), runtime::Sha256Hex(digest_input).substr(0, 16));
}

fs::path DefaultHandbookFolder() { return runtime::InstalledFolder("handbook", FLAIR_HANDBOOK_FOLDER); }

}  // namespace flair::language
