// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of a cluster, from look to look.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "cli/progress/progress.h"
#include "cli/session/session.h"
#include "flair/v1/orchestrator_service.pb.h"
#include "nlohmann/json.hpp"

namespace flair::cli {

// One look. A store that no orchestrator serves has none; processes that work on it say nothing of themselves.
struct ClusterLook {
  absl::Time time;
  v1::GetClusterResponse cluster;
  // Those that have not ended, newest first.
  std::vector<v1::Batch> batches;
};

// The last look with rates, as `flair top --json` writes it: "time"; "totals" of all
// orchestrators, without any of the batches that have not ended; "batches"; "orchestrators", the one that was asked
// first; "workers" as all orchestrators together see them, by stage, those in trouble first. What is not known before
// two looks is null.
class ClusterState {
 public:
  void See(const ClusterLook& look);

  absl::Time time() const { return time_; }
  const nlohmann::ordered_json& json() const { return json_; }

 private:
  using Json = nlohmann::ordered_json;

  // The rate of a count of that name, null before two looks.
  Json Rate(const std::string& name, absl::Time time, int64_t count);
  Json Orchestrators(const v1::GetClusterResponse& cluster);
  Json Workers(const v1::GetClusterResponse& cluster);
  Json Batches(const std::vector<v1::Batch>& batches);

  absl::Time time_;
  Json json_;
  RateMeter rates_{absl::Seconds(15)};
};

// Asks an orchestrator how its cluster does.
class ClusterClient {
 public:
  // The session outlives it.
  explicit ClusterClient(Session& session) : session_(session) {}

  absl::StatusOr<ClusterLook> Look();

 private:
  Session& session_;
  // Batches that had ended; asked for again now and then, for those that are retried.
  std::set<std::string> ended_;
  int look_count_ = 0;
};

// A cluster as text.

struct TopLayout {
  int width = 80;
  // Lines; what does not fit is counted. Any number when 0.
  int height = 0;
  // With ANSI colours.
  bool color = false;
};

// Lines of at most `width` characters: totals, batches, orchestrators, workers. `address` is who was asked; `trouble`,
// when not empty, says why what is shown is old. Nothing in it steers a terminal but our own colours.
std::vector<std::string> TopText(const ClusterState& state, const std::string& address, const std::string& trouble,
                                 const TopLayout& layout);

// "12 s", "5m12s", "2h05m", "3d04h".
std::string ShortDuration(absl::Duration duration);

// "12,345".
std::string Grouped(int64_t number);

// The state as one JSON object on one line, without line break.
std::string TopJson(const ClusterState& state);

}  // namespace flair::cli
