// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/open.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "orchestrator/jetstream/connect_options.h"
#include "orchestrator/jetstream/jetstream_artifacts.h"
#include "orchestrator/jetstream/jetstream_work_queue.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

// How long a status is known after it was reported.
constexpr absl::Duration kStatusLife = absl::Seconds(10);

// What all streams have in common: nothing that they hold is thrown away for something new.
json Stream(const std::string& name, const std::string& subjects, int replica_count) {
  return {{"name", name},      {"subjects", {subjects}},       {"retention", "limits"}, {"discard", "new"},
          {"storage", "file"}, {"max_consumers", -1},          {"max_msgs", -1},        {"max_bytes", -1},
          {"max_age", 0},      {"num_replicas", replica_count}};
}

json BucketStream(const std::string& bucket, int replica_count) {
  json stream = Stream("KV_" + bucket, "$KV." + bucket + ".>", replica_count);
  stream["max_msgs_per_subject"] = 1;
  stream["deny_delete"] = false;
  // Read from the leader alone; see Bucket.
  stream["allow_direct"] = false;
  return stream;
}

absl::Status Make(JetStreamApi& api, const json& stream) {
  const std::string name = stream.at("name");
  const absl::Status known = api.Call("STREAM.INFO." + name, nullptr).status();
  if (!absl::IsNotFound(known)) return known;
  const absl::Status made = api.Call("STREAM.CREATE." + name, stream).status();
  // Somebody else may have made it just now.
  return made.ok() ? made : api.Call("STREAM.INFO." + name, nullptr).ok() ? absl::OkStatus() : made;
}

// Makes the streams and buckets of a queue, or of its artifacts, that are not there. Those that are stay as they are.
absl::Status MakeQueueStreams(JetStreamApi& api, const QueueNames& names, int replica_count) {
  json queue = Stream(names.queue_stream(), names.AllOf("*"), replica_count);
  queue["retention"] = "workqueue";
  json ends = Stream(names.ends_stream(), names.End("*", "*", "*", "*"), replica_count);
  ends["max_msgs_per_subject"] = 1;
  json status = BucketStream(names.Bucket("status"), replica_count);
  status["storage"] = "memory";
  status["max_age"] = absl::ToInt64Nanoseconds(kStatusLife);
  status["duplicate_window"] = absl::ToInt64Nanoseconds(kStatusLife);
  for (const json& stream : {queue, ends, status}) RETURN_IF_ERROR(Make(api, stream));
  for (const char* bucket : {"jobs", "batches", "requests", "index"}) {
    RETURN_IF_ERROR(Make(api, BucketStream(names.Bucket(bucket), replica_count)));
  }
  return absl::OkStatus();
}

absl::Status MakeArtifactStream(JetStreamApi& api, const QueueNames& names, int replica_count) {
  return Make(api, BucketStream(names.Bucket("artifacts"), replica_count));
}

absl::StatusOr<std::unique_ptr<QueueParts>> Connect(const config::v1::QueueConfig& config,
                                                    const config::v1::TlsConfig* tls, const runtime::Clock& clock) {
  RETURN_IF_ERROR(CheckQueueConfig(config, tls));
  ASSIGN_OR_RETURN(std::unique_ptr<NatsConnection> connection, NatsConnection::Open(config, tls));
  return std::make_unique<QueueParts>(std::move(connection), config, clock);
}

int ReplicaCount(const config::v1::QueueConfig& config) { return std::max(1, config.replica_count()); }

}  // namespace

absl::StatusOr<std::unique_ptr<WorkQueue>> OpenJetStreamQueue(const config::v1::QueueConfig& config,
                                                              const config::v1::TlsConfig* tls,
                                                              const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<QueueParts> parts, Connect(config, tls, clock));
  RETURN_IF_ERROR(MakeQueueStreams((parts)->api, (parts)->names, ReplicaCount(config)));
  return JetStreamWorkQueue::Open(std::move(parts));
}

absl::StatusOr<std::unique_ptr<ArtifactStore>> OpenJetStreamArtifacts(const config::v1::QueueConfig& config,
                                                                      const config::v1::TlsConfig* tls,
                                                                      const runtime::Clock& clock) {
  ASSIGN_OR_RETURN(std::unique_ptr<QueueParts> parts, Connect(config, tls, clock));
  RETURN_IF_ERROR(MakeArtifactStream((parts)->api, (parts)->names, ReplicaCount(config)));
  return std::make_unique<JetStreamArtifacts>(std::move(parts));
}

}  // namespace flair::orchestrator
