// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/session/orchestrator_shelf.h"

#include <set>
#include <utility>
#include <vector>

#include "cli/session/session.h"

namespace flair::cli {
namespace {

constexpr int kSearchedJobs = 1000;

class OrchestratorShelf final : public ArtifactShelf {
 public:
  OrchestratorShelf(std::unique_ptr<Session> session, const std::string& address)
      : session_(std::move(session)), name_("the orchestrator at " + address) {}

  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& id) override { return session_->GetArtifact(id); }

  absl::StatusOr<std::vector<std::string>> FindIds(const std::string& prefix) override {
    const absl::StatusOr<std::vector<v1::Job>> jobs = session_->ListJobs(kSearchedJobs);
    if (!jobs.ok()) return jobs.status();
    std::set<std::string> ids;
    for (const v1::Job& job : *jobs) {
      for (const v1::ArtifactRef& ref : job.artifacts()) {
        if (ref.id().starts_with(prefix)) ids.insert(ref.id());
      }
    }
    return std::vector<std::string>(ids.begin(), ids.end());
  }

  absl::StatusOr<v1::Job> GetJob(const std::string& id) override { return session_->GetJob(id); }
  std::string name() const override { return name_; }

 private:
  const std::unique_ptr<Session> session_;
  const std::string name_;
};

}  // namespace

absl::StatusOr<std::unique_ptr<ArtifactShelf>> OpenOrchestratorShelf(const std::string& address) {
  absl::StatusOr<std::unique_ptr<Session>> session = Session::Open(address);
  if (!session.ok()) return session.status();
  return std::make_unique<OrchestratorShelf>(*std::move(session), address);
}

}  // namespace flair::cli
