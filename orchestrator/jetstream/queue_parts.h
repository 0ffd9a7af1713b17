// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/jetstream/bucket.h"
#include "orchestrator/jetstream/connection.h"
#include "orchestrator/jetstream/names.h"
#include "orchestrator/jetstream/streams.h"
#include "worker_runtime/clock/clock.h"

namespace flair::orchestrator {

// A value of a bucket as a message, and the revision that it had.
template <typename Message>
struct Revised {
  Message value;
  uint64_t revision = 0;
};
using RevisedJob = Revised<store::v1::JobRecord>;
using RevisedBatch = Revised<store::v1::BatchRecord>;

// What all parts of a queue share: the connection and the streams and buckets behind it. Thread-safe.
class QueueParts {
 public:
  // `config` is checked; `connection` is open, and the streams are there.
  QueueParts(std::unique_ptr<NatsConnection> connection, const config::v1::QueueConfig& config,
             const runtime::Clock& clock);

  // NOT_FOUND when unknown, also when it cannot be an id; a job that is being forgotten is known to GetAnyJob only.
  absl::StatusOr<RevisedJob> GetAnyJob(const std::string& job_id);
  absl::StatusOr<RevisedJob> GetJob(const std::string& job_id);
  absl::StatusOr<RevisedBatch> GetBatch(const std::string& batch_id);
  // What GetAll gave.
  absl::StatusOr<RevisedJob> ParseJob(const std::string& job_id, const absl::StatusOr<Bucket::Entry>& entry) const;

  // Replaces a record by what `change` makes of it, whatever others do to it meanwhile: `change` is called again with
  // what they made of it. Nothing is written when it returns an error or, `unchanged`, false.
  template <typename Record>
  using Change = std::function<absl::StatusOr<bool>(Record&)>;
  absl::StatusOr<RevisedJob> ChangeJob(const std::string& job_id, const Change<store::v1::JobRecord>& change);
  absl::StatusOr<RevisedBatch> ChangeBatch(const std::string& batch_id, const Change<store::v1::BatchRecord>& change);

  // Puts the job into the queue stream: once for one `message_id`, at least for some minutes.
  NatsRequest QueueMessage(const v1::Job& job, const std::string& message_id) const;
  // The subject under which the job waits.
  std::string SubjectOf(const v1::Job& job) const;

  // Notifies the other processes, which may miss it: see Notice.
  void Notify(Notice::Kind kind, const std::string& subject, const std::string& batch_id = "");
  // Something happened to the job.
  void NotifyJob(const v1::Job& job);

  const std::unique_ptr<NatsConnection> connection;
  const QueueNames names;
  const absl::Duration lease;
  const runtime::Clock& clock;
  Streams streams;
  Bucket jobs;
  Bucket batches;
  Bucket requests;
  Bucket index;
  Bucket statuses;
};

}  // namespace flair::orchestrator
