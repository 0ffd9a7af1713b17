// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <utility>

#include "cli/input/artifact_shelf.h"
#include "fmt/format.h"
#include "orchestrator/store/database.h"
#include "orchestrator/store/job_table.h"
#include "orchestrator/store/local_artifacts.h"

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
  // Makes no store where there is none.
  absl::StatusOr<orchestrator::LocalArtifacts*> Artifacts() {
    std::error_code error;
    const std::string path = folder_ + "/artifacts";
    if (!fs::is_directory(path, error)) return absl::NotFoundError(fmt::format("{} has no artifacts", name()));
    if (artifacts_ == nullptr) {
      auto opened = orchestrator::LocalArtifacts::Open(path);
      if (!opened.ok()) return opened.status();
      artifacts_ = *std::move(opened);
    }
    return artifacts_.get();
  }

  const std::string folder_;
  std::unique_ptr<orchestrator::LocalArtifacts> artifacts_;
  std::unique_ptr<orchestrator::Database> database_;
};

}  // namespace

std::unique_ptr<ArtifactShelf> MakeStoreShelf(const std::string& folder) {
  return std::make_unique<StoreShelf>(folder);
}

}  // namespace flair::cli
