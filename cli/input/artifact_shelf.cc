// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/input/artifact_shelf.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "fmt/format.h"
#include "orchestrator/store/database.h"
#include "orchestrator/store/job_table.h"
#include "orchestrator/store/local_artifacts.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

class StoreShelf final : public ArtifactShelf {
 public:
  explicit StoreShelf(std::string folder) : folder_(std::move(folder)) {}

  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) override {
    const auto artifacts = Artifacts();
    return artifacts.ok() ? (*artifacts)->Get(id) : artifacts.status();
  }

  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) override {
    const auto artifacts = Artifacts();
    // Nobody has designed anything yet.
    if (absl::IsNotFound(artifacts.status())) return std::vector<std::string>();
    return artifacts.ok() ? (*artifacts)->FindIds(prefix) : artifacts.status();
  }

  absl::StatusOr<v1::Job> GetJob(const std::string& id) override {
    std::error_code error;
    const std::string path = folder_ + "/jobs.db";
    if (!fs::is_regular_file(path, error)) return NotFound("{} has no jobs", name());
    if (database_ == nullptr) {
      ASSIGN_OR_RETURN(database_, orchestrator::Database::Open(path));
    }
    return orchestrator::JobTable(*database_).Get(id);
  }

  std::string name() const override { return "the store " + folder_; }

 private:
  // Makes no store where there is none.
  absl::StatusOr<orchestrator::LocalArtifacts*> Artifacts() {
    std::error_code error;
    const std::string path = folder_ + "/artifacts";
    if (!fs::is_directory(path, error)) return NotFound("{} has no artifacts", name());
    if (artifacts_ == nullptr) {
      ASSIGN_OR_RETURN(artifacts_, orchestrator::LocalArtifacts::Open(path));
    }
    return artifacts_.get();
  }

  const std::string folder_;
  std::unique_ptr<orchestrator::LocalArtifacts> artifacts_;
  std::unique_ptr<orchestrator::Database> database_;
};

constexpr size_t kMostFiles = 1000;
constexpr size_t kMostTexts = 50;
// Looking for a parent should take no longer than reading the artifact itself.
constexpr uintmax_t kMostTextBytes = 2u << 20;

// The regular files of a folder with one of the endings, sorted.
std::vector<fs::path> FilesIn(const fs::path& folder, const std::vector<std::string>& endings, size_t most) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    std::error_code unreadable;
    const std::string ending = entry.path().extension().string();
    if (std::ranges::find(endings, ending) == endings.end()) continue;
    if (entry.is_regular_file(unreadable)) files.push_back(entry.path());
    if (files.size() == most) break;
  }
  std::ranges::sort(files);
  return files;
}

std::string StatedId(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string begin(kLeadingIdBytes, '\0');
  file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  begin.resize(static_cast<size_t>(file.gcount()));
  return std::string(LeadingId(begin));
}

fs::path FolderOf(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

}  // namespace

std::unique_ptr<ArtifactShelf> MakeStoreShelf(const std::string& folder) {
  return std::make_unique<StoreShelf>(folder);
}

void ArtifactFinder::ListFolder() {
  if (std::exchange(listed_, true) || path_.empty()) return;
  for (const fs::path& file : FilesIn(FolderOf(path_), {".pb"}, kMostFiles)) {
    if (const std::string id = StatedId(file); !id.empty()) binary_files_.emplace(id, file.string());
  }
}

std::string ArtifactFinder::FileBeside(const std::string& id) {
  ListFolder();
  const auto found = binary_files_.find(id);
  return found == binary_files_.end() ? "" : fs::path(found->second).filename().string();
}

std::optional<ArtifactFinder::Found> ArtifactFinder::FindInTexts(const std::string& id) {
  if (path_.empty()) return std::nullopt;
  if (!edited_) {
    edited_.emplace();
    uintmax_t read = 0;
    for (const fs::path& path : FilesIn(FolderOf(path_), {".json", ".textproto", ".txtpb", ".pbtxt"}, kMostTexts)) {
      std::error_code error;
      const uintmax_t size = fs::file_size(path, error);
      if (error || size > kMostTextBytes - read) continue;
      read += size;
      absl::StatusOr<ArtifactFile> file = ReadArtifactFile(path);
      if (!file.ok() || !file->whole.ok()) continue;
      const std::string text_id = file->artifact.id();
      edited_->emplace(text_id, Found{std::move(file->artifact), path.filename().string()});
    }
  }
  const auto found = edited_->find(id);
  if (found == edited_->end()) return std::nullopt;
  return found->second;
}

std::optional<ArtifactFinder::Found> ArtifactFinder::Find(const std::string& id) {
  ListFolder();
  if (const auto beside = binary_files_.find(id); beside != binary_files_.end()) {
    absl::StatusOr<ArtifactFile> file = ReadArtifactFile(beside->second);
    if (file.ok() && file->whole.ok() && file->artifact.id() == id) {
      return Found{std::move(file->artifact), fs::path(beside->second).filename().string()};
    }
  }
  absl::StatusOr<v1::Artifact> kept = shelf_.GetArtifact(id);
  if (kept.ok() && CheckArtifactId(*kept, id).ok() && kept->id() == id) return Found{*std::move(kept), shelf_.name()};
  return FindInTexts(id);
}

std::string ArtifactFinder::SearchedPlaces() const {
  if (path_.empty()) return "not in " + shelf_.name();
  return fmt::format("neither beside {} nor in {}", path_, shelf_.name());
}

}  // namespace flair::cli
