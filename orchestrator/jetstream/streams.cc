// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/streams.h"

#include <nlohmann/json.hpp>

namespace flair::orchestrator {
namespace {

using nlohmann::json;

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

}  // namespace

absl::Status MakeQueueStreams(JetStreamApi& api, const QueueNames& names, int replica_count) {
  json queue = Stream(names.queue_stream(), names.AllOf("*"), replica_count);
  queue["retention"] = "workqueue";
  json ends = Stream(names.ends_stream(), names.End("*", "*", "*", "*"), replica_count);
  ends["max_msgs_per_subject"] = 1;
  json status = BucketStream(names.Bucket("status"), replica_count);
  status["storage"] = "memory";
  status["max_age"] = absl::ToInt64Nanoseconds(kStatusLife);
  status["duplicate_window"] = absl::ToInt64Nanoseconds(kStatusLife);
  absl::Status made = Make(api, queue);
  if (made.ok()) made = Make(api, ends);
  if (made.ok()) made = Make(api, status);
  for (const char* bucket : {"jobs", "batches", "requests", "index"}) {
    if (made.ok()) made = Make(api, BucketStream(names.Bucket(bucket), replica_count));
  }
  return made;
}

absl::Status MakeArtifactStream(JetStreamApi& api, const QueueNames& names, int replica_count) {
  return Make(api, BucketStream(names.Bucket("artifacts"), replica_count));
}

}  // namespace flair::orchestrator
