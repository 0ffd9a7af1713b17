// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <utility>

#include "cli/input/artifact_shelf.h"
#include "fmt/format.h"
#include "orchestrator/store/artifact_files.h"
#include "orchestrator/store/artifact_id.h"
#include "orchestrator/store/database.h"
#include "orchestrator/store/job_table.h"

namespace flair::cli {
namespace {

namespace fs = std::filesystem;

class StoreShelf final : public ArtifactShelf {
 public:
  explicit StoreShelf(std::string folder) : folder_(std::move(folder)), files_(folder_ + "/artifacts") {}

  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) override { return files_.Get(id); }

  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) override {
    std::vector<std::string> ids;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(fs::path(files_.PathOf(prefix)).parent_path(), error)) {
      const std::string id = entry.path().stem().string();
      if (orchestrator::IsArtifactId(id) && id.starts_with(prefix)) ids.push_back(id);
    }
    std::sort(ids.begin(), ids.end());
    return ids;
  }

  absl::StatusOr<v1::Job> GetJob(const std::string& id) override {
    std::error_code error;
    const std::string path = folder_ + "/jobs.db";
    if (!fs::is_regular_file(path, error)) return absl::NotFoundError(fmt::format("{} has no jobs", name()));
    if (database_ == nullptr) {
      absl::StatusOr<std::unique_ptr<orchestrator::Database>> opened = orchestrator::Database::Open(path);
      if (!opened.ok()) return opened.status();
      database_ = *std::move(opened);
    }
    return orchestrator::JobTable(*database_).Get(id);
  }

  std::string name() const override { return "the store " + folder_; }

 private:
  const std::string folder_;
  orchestrator::ArtifactFiles files_;
  std::unique_ptr<orchestrator::Database> database_;
};

}  // namespace

std::unique_ptr<ArtifactShelf> MakeStoreShelf(const std::string& folder) {
  return std::make_unique<StoreShelf>(folder);
}

}  // namespace flair::cli
