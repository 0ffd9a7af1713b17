// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/top/cluster_client.h"

#include "absl/time/clock.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/grpc/client_call.h"

namespace flair::cli {
namespace {

using Stub = v1::OrchestratorService::StubInterface;

constexpr absl::Duration kAnswerWithin = absl::Seconds(4);
// Newest batches that are looked at.
constexpr int kBatchLimit = 50;
// Looks after which ended batches are asked for again.
constexpr int kForgetAfter = 8;

}  // namespace

absl::StatusOr<ClusterLook> ClusterClient::Look() {
  runtime::CallContext call("", absl::Now() + kAnswerWithin, runtime::SystemClock());
  absl::StatusOr<v1::GetClusterResponse> cluster =
      runtime::UnaryRequest(*stub_, &Stub::GetCluster, v1::GetClusterRequest(), call);
  if (!cluster.ok()) return cluster.status();
  ClusterLook look{absl::Now(), *std::move(cluster), {}};
  if (absl::Status status = AddBatches(look); !status.ok()) return status;
  return look;
}

absl::Status ClusterClient::AddBatches(ClusterLook& look) {
  runtime::CallContext call("", absl::Now() + kAnswerWithin, runtime::SystemClock());
  v1::ListBatchesRequest list;
  list.set_page_size(kBatchLimit);
  const absl::StatusOr<v1::ListBatchesResponse> listed = runtime::UnaryRequest(*stub_, &Stub::ListBatches, list, call);
  if (!listed.ok()) return listed.status();
  if (++look_count_ % kForgetAfter == 0) ended_.clear();
  for (const v1::Batch& known : listed->batches()) {
    if (ended_.contains(known.id())) continue;
    v1::GetBatchRequest get;
    get.set_batch_id(known.id());
    absl::StatusOr<v1::GetBatchResponse> got = runtime::UnaryRequest(*stub_, &Stub::GetBatch, get, call);
    if (!got.ok()) return got.status();
    if (got->batch().open() || got->batch().open_count() > 0) {
      look.batches.push_back(std::move(*got->mutable_batch()));
    } else {
      ended_.insert(known.id());
    }
  }
  return absl::OkStatus();
}

}  // namespace flair::cli
