// SPDX-License-Identifier: GPL-3.0-or-later
// Optimizer: restarts are a pure function of their numbers, which lets a solve be spread over several servers.
#include <utility>

#include "cli/contract/ask.h"
#include "cli/contract/bedroom.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::contract {
namespace {

constexpr int kRestarts = 5;

v1::SolveRestartsRequest Primaries(int first, int count) {
  v1::SolveRestartsRequest request;
  *request.mutable_layout_graph() = BedroomGraph();
  request.mutable_options()->set_seed(5);
  request.set_stage("primary");
  request.set_first_restart(first);
  request.set_restart_count(count);
  return request;
}

// The outcomes' bytes, or what is wrong with them.
absl::StatusOr<std::string> OutcomesOf(Target& target, int first, int count) {
  const auto answer = target.Ask<v1::SolveRestartsResponse>(Primaries(first, count));
  if (!answer.ok()) return answer.status();
  if (answer->outcomes_size() != count) {
    return absl::InternalError(fmt::format("{} outcomes of {} restarts", answer->outcomes_size(), count));
  }
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    if (answer->outcomes(i).restart() != first + i) {
      return absl::InternalError(fmt::format("restart {} in place {}", answer->outcomes(i).restart(), first + i));
    }
    bytes += answer->outcomes(i).SerializeAsString();
  }
  return bytes;
}

Finding CutsDoNotMatter(Target& target) {
  const std::string sent = fmt::format("SolveRestarts of restarts 0 to {}, as one range and as three", kRestarts - 1);
  const std::string right = "one outcome for each restart, in order, with the same bytes whichever range it is in";
  const absl::StatusOr<std::string> whole = OutcomesOf(target, 0, kRestarts);
  if (!whole.ok()) return Broken(sent, StatusText(whole.status()), right);
  std::string pieces;
  for (const auto& [first, count] : {std::pair(0, 1), std::pair(1, 3), std::pair(4, 1)}) {
    const absl::StatusOr<std::string> piece = OutcomesOf(target, first, count);
    if (!piece.ok()) return Broken(sent, StatusText(piece.status()), right);
    pieces += *piece;
  }
  return pieces == *whole ? Kept() : Broken(sent, "outcomes that differ", right);
}

}  // namespace

void AddRestartChecks(Checks& checks) {
  checks.push_back({"Restarts do not depend on how their range is cut", Promise::kRepetition, CutsDoNotMatter,
                    v1::CAPABILITY_SOLVE_RESTARTS});
  using Request = v1::SolveRestartsRequest;
  AddRefusals<v1::SolveRestartsResponse, Request>(
      Primaries(0, 1),
      {{"a stage that is not there", "stage", [](Request& request) { request.set_stage("quaternary"); }},
       {"too many restarts", "restart_count", [](Request& request) { request.set_restart_count(1001); }},
       {"a first restart below zero", "first_restart", [](Request& request) { request.set_first_restart(-1); }},
       {"a zone that is not there", "zone_id",
        [](Request& request) {
          request.set_stage("secondary");
          request.set_zone_id("nowhere");
        }},
       {"a placement of an object that is not there", "placements[0].object_id",
        [](Request& request) { request.add_placements()->set_object_id("ghost"); }}},
      checks, v1::CAPABILITY_SOLVE_RESTARTS);
}

}  // namespace flair::contract
