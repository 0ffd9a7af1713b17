// SPDX-License-Identifier: GPL-3.0-or-later
#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <stdio.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <mutex>

#include "absl/strings/ascii.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_split.h"
#include "cli/batch/collector.h"
#include "cli/exit_code.h"
#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/report_text.h"
#include "cli/output/tar_file.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

constexpr int64_t kJobsInAFolder = 1000;

class JobFolders final : public ResultWriter {
 public:
  explicit JobFolders(fs::path folder) : folder_(std::move(folder)) {}

  absl::StatusOr<Place> Write(int64_t batch_index, const std::vector<OutputFile>& files) override {
    const std::string path = fmt::format("jobs/{:03}/{}", batch_index / kJobsInAFolder, IndexName(batch_index));
    const fs::path final_folder = folder_ / path;
    const fs::path made = final_folder.parent_path() / fmt::format(".{}.partial", IndexName(batch_index));
    std::error_code error;
    if (fs::is_symlink(made.parent_path(), error)) return CannotWrite(made.parent_path(), ELOOP);
    fs::remove_all(made, error);  // of a process that was killed
    fs::create_directories(made, error);
    if (error) return CannotWrite(made, error.value());
    for (const OutputFile& file : files) RETURN_IF_ERROR(WriteFile(made / file.name, file.content));
    RETURN_IF_ERROR(PutInPlace(made, final_folder));
    return Place{.path = path, .ticket = ++last_ticket_};
  }

  absl::Status Settle(bool) override {
    const int64_t written = last_ticket_;
    if (written == settled_) return absl::OkStatus();
    RETURN_IF_ERROR(FlushFileSystem(folder_));
    settled_ = written;
    return absl::OkStatus();
  }

  bool IsSettled(int64_t ticket) override { return ticket <= settled_; }

 private:
  static absl::Status PutInPlace(const fs::path& made, const fs::path& final_folder) {
    if (::rename(made.c_str(), final_folder.c_str()) == 0) return absl::OkStatus();
    if (errno != ENOTEMPTY && errno != EEXIST) return CannotWrite(final_folder, errno);
    // The job ran again: the two change places, then the old one goes.
    if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, final_folder.c_str(), RENAME_EXCHANGE) != 0) {
      return CannotWrite(final_folder, errno);
    }
    std::error_code ignored;
    fs::remove_all(made, ignored);
    return absl::OkStatus();
  }

  const fs::path folder_;
  std::atomic<int64_t> last_ticket_ = 0;
  std::atomic<int64_t> settled_ = 0;
};

constexpr char kPartial[] = ".partial";
// The index of the Python package wids, which WebDataset reads; further members are ours.
constexpr int kIndexVersion = 1;

class TarShards final : public ResultWriter {
 public:
  TarShards(fs::path folder, int shard_size) : folder_(std::move(folder)), shard_size_(shard_size) {}

  // Counts what is there and removes what is not whole.
  absl::Status Open() {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) return CannotWrite(folder_, error.value());
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(kPartial)) fs::remove(entry.path(), error);
      int64_t number = 0;
      const bool is_whole = name.ends_with(".tar") && std::sscanf(name.c_str(), "shard-%ld", &number) == 1;
      if (is_whole) number_ = std::max(number_, number + 1);
    }
    if (error) return CannotWrite(folder_, error.value());
    return ReadIndex();
  }

  absl::StatusOr<Place> Write(int64_t batch_index, const std::vector<OutputFile>& files) override {
    const std::lock_guard lock(mutex_);
    if (tar_ == nullptr) {
      ASSIGN_OR_RETURN(tar_, TarFile::Make(PartialPath()));
    }
    for (const OutputFile& file : files) {
      const std::string name = fmt::format("{}.{}", IndexName(batch_index), file.name);
      RETURN_IF_ERROR(tar_->Add(name, file.content));
    }
    const Place place{.path = fmt::format("shards/{}", Name()), .ticket = number_};
    if (++job_count_ == shard_size_) RETURN_IF_ERROR(Finish());
    return place;
  }

  absl::Status Settle(bool all) override {
    const std::lock_guard lock(mutex_);
    return all && tar_ != nullptr ? Finish() : absl::OkStatus();
  }

  bool IsSettled(int64_t ticket) override {
    const std::lock_guard lock(mutex_);
    return ticket < number_;
  }

 private:
  std::string Name() const { return fmt::format("shard-{:06}.tar", number_); }
  fs::path PartialPath() const { return folder_ / (Name() + kPartial); }

  absl::Status ReadIndex() {
    std::error_code error;
    shards_ = nlohmann::json::array();
    // Made anew of the shards that are there: it may be older than the last of them.
    std::vector<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with("shard-") && name.ends_with(".tar")) names.push_back(name);
    }
    std::ranges::sort(names);
    for (const std::string& name : names) shards_.push_back(Entry(name, CountJobs(folder_ / name)));
    return names.empty() ? absl::OkStatus() : WriteIndex();
  }

  nlohmann::json Entry(const std::string& name, int64_t job_count) const {
    std::error_code error;
    return {{"url", name}, {"nsamples", job_count}, {"size_bytes", fs::file_size(folder_ / name, error)}};
  }

  static int64_t CountJobs(const fs::path& path) {
    const std::unique_ptr<archive, decltype(&archive_read_free)> tar(archive_read_new(), archive_read_free);
    archive_read_support_format_tar(tar.get());
    if (archive_read_open_filename(tar.get(), path.c_str(), 1 << 20) != ARCHIVE_OK) return 0;
    int64_t count = 0;
    std::string last;
    archive_entry* entry = nullptr;
    while (archive_read_next_header(tar.get(), &entry) == ARCHIVE_OK) {
      const std::string name = archive_entry_pathname(entry);
      const std::string job = name.substr(0, name.find('.'));
      if (job != last) ++count;
      last = job;
    }
    return count;
  }

  absl::Status WriteIndex() const {
    const nlohmann::json index = {
        {"__kind__", "flair-shards"}, {"wids_version", kIndexVersion}, {"shardlist", shards_}};
    return WriteFile(folder_ / "index.json", index.dump(1) + "\n");
  }

  absl::Status Finish() {
    absl::Status status = tar_->Close();
    tar_ = nullptr;
    if (status.ok()) status = FlushFile(PartialPath());
    if (!status.ok()) return status;
    if (::rename(PartialPath().c_str(), (folder_ / Name()).c_str()) != 0) return CannotWrite(folder_ / Name(), errno);
    shards_.push_back(Entry(Name(), job_count_));
    ++number_;
    job_count_ = 0;
    return WriteIndex();
  }

  const fs::path folder_;
  const int shard_size_;
  std::mutex mutex_;
  // Of the shard that is being written.
  int64_t number_ = 0;
  int job_count_ = 0;
  std::unique_ptr<TarFile> tar_;
  nlohmann::json shards_;
};

constexpr char kPictures[] = "pictures";
constexpr char kReport[] = "report";
constexpr char kReportText[] = "report.md";

std::string StemOf(v1::ArtifactKind kind) { return kind == v1::ARTIFACT_KIND_REPORT ? kReport : FileStem(kind); }

// Words for one artifact each: "layout" for layout.pb, "layout.json" for layout.json.
std::vector<std::string> AllWords() {
  std::vector<std::string> words;
  for (int kind = 1; kind < v1::ArtifactKind_ARRAYSIZE; ++kind) {
    const std::string stem = FileStem(static_cast<v1::ArtifactKind>(kind));
    if (stem.empty()) continue;
    words.push_back(stem);
    words.push_back(stem + ".json");
  }
  words.insert(words.end(), {kPictures, kReport, kReportText});
  return words;
}

// A picture's name that no file has yet: "birdseye.png", "birdseye_2.png".
std::string FreeName(const std::string& name, const std::vector<OutputFile>& files) {
  const auto taken = [&files](const std::string& candidate) {
    return std::ranges::any_of(files, [&](const OutputFile& file) { return file.name == candidate; });
  };
  const size_t dot = name.rfind('.');
  std::string free = name;
  for (int i = 2; taken(free); ++i) free = fmt::format("{}_{}{}", name.substr(0, dot), i, name.substr(dot));
  return free;
}

}  // namespace

std::string IndexName(int64_t batch_index) { return fmt::format("{:06}", batch_index); }

std::unique_ptr<ResultWriter> MakeJobFolders(const fs::path& folder) { return std::make_unique<JobFolders>(folder); }

absl::StatusOr<std::unique_ptr<ResultWriter>> MakeTarShards(const fs::path& folder, int shard_size) {
  auto shards = std::make_unique<TarShards>(folder / "shards", shard_size);
  RETURN_IF_ERROR(shards->Open());
  return shards;
}

absl::StatusOr<KeptFiles> KeptFiles::Parse(const std::string& text) {
  const std::vector<std::string> known = AllWords();
  KeptFiles kept;
  for (const absl::string_view part : absl::StrSplit(text, ',')) {
    std::string word(absl::StripAsciiWhitespace(part));
    if (word.empty() || word == "none") continue;
    if (word == "plan" || word == "picture" || word == "plan.png") word = kPictures;
    if (word == "report.json") word = kReport;
    if (word.ends_with(".pb")) word.resize(word.size() - 3);
    if (word == "all") {
      kept.words_.insert(known.begin(), known.end());
      continue;
    }
    if (std::ranges::find(known, word) == known.end()) {
      return InvalidArgument("--keep: {}: no such file{}; one of {}, all, none", word, DidYouMean(word, known),
                             absl::StrJoin(known, ", "));
    }
    kept.words_.insert(word);
  }
  return kept;
}

std::string KeptFiles::Words() const { return words_.empty() ? "none" : absl::StrJoin(words_, ","); }

bool KeptFiles::Needs(v1::ArtifactKind kind) const {
  if (Has(kReportText)) return true;  // tells of all stages
  if (kind == v1::ARTIFACT_KIND_PREVIEW) return Has(kPictures);
  const std::string stem = StemOf(kind);
  return Has(stem) || Has(stem + ".json");
}

void KeptFiles::AddPicture(const v1::Preview& preview, std::vector<OutputFile>& files) const {
  if (!Has(kPictures)) return;
  const std::string name = FreeName(PictureName(preview), files);
  files.push_back({name, preview.image()});
  if (preview.has_annotations()) files.push_back({name + ".json", ToJson(preview.annotations())});
}

std::vector<OutputFile> KeptFiles::FilesOf(const v1::Job& job, const std::vector<v1::Artifact>& artifacts) const {
  std::vector<OutputFile> files;
  if (empty()) return files;
  files.push_back({"job.json", ToJson(job)});
  ArtifactsByKind by_kind;
  for (const v1::Artifact& artifact : artifacts) {
    if (artifact.has_preview()) AddPicture(artifact.preview(), files);
    const v1::ArtifactKind kind = orchestrator::KindOf(artifact);
    if (Has(kReportText)) by_kind.emplace(kind, artifact);
    const std::string stem = StemOf(kind);
    if (stem.empty()) continue;
    if (kind == v1::ARTIFACT_KIND_REPORT) {
      if (Has(kReport)) files.push_back({"report.json", ToJson(artifact)});
      continue;
    }
    if (Has(stem)) files.push_back({stem + ".pb", ArtifactBytes(artifact)});
    if (Has(stem + ".json")) files.push_back({stem + ".json", ToJson(artifact)});
  }
  if (Has(kReportText) && job.state() == v1::JOB_STATE_SUCCEEDED) {
    files.push_back({kReportText, WriteReport(job, by_kind)});
  }
  return files;
}

}  // namespace flair::cli
