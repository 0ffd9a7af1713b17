// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "absl/time/time.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "orchestrator/batch/work_queue.h"

namespace flair::orchestrator {

// Where a queue keeps what, and the subjects that say so. NAME is QueueConfig.name.
//   stream NAME-queue      jobs that wait or run, by their ids; gone when they have ended
//     NAME.queue.OWNER.single         jobs without a batch
//     NAME.queue.OWNER.batch.BATCH    those of a batch
//     NAME.queue.OWNER.named.JOB      one that somebody asked for by its id
//   stream NAME-ends       jobs of batches that have ended, the latest end of each
//     NAME.ends.BATCH.STATE.KIND.JOB  STATE and KIND: the numbers of JobState and FailureKind
//   bucket NAME-jobs       JobRecord by job
//   bucket NAME-batches    BatchRecord by batch
//   bucket NAME-requests   ids by OWNER.single.REQUEST and OWNER.batch.REQUEST, in the order in which they were made;
//                          OWNER.deleting.ID, see delete.cc
//   bucket NAME-index      result.KEY: ArtifactRef; users.ARTIFACT: ArtifactUsers; doomed.BATCH.PLACE: tombstones of
//                          artifacts, see delete.cc
//   bucket NAME-status     OrchestratorStatus, forgotten soon
//   bucket NAME-artifacts  see open.cc
//   subject NAME.news      notifications, which may be lost
// A bucket is a stream KV_BUCKET with subjects $KV.BUCKET.KEY, as NATS's own tools know them.
class QueueNames {
 public:
  explicit QueueNames(const config::v1::QueueConfig& config) : name_(config.name().empty() ? "flair" : config.name()) {}

  const std::string& name() const { return name_; }
  std::string queue_stream() const { return name_ + "-queue"; }
  std::string ends_stream() const { return name_ + "-ends"; }
  std::string Bucket(std::string_view what) const { return name_ + "-" + std::string(what); }
  std::string news_subject() const { return name_ + ".news"; }

  // Jobs of an owner that wait or run: the subject of the stream, with wildcards where the arguments have them.
  std::string Single(std::string_view owner_token) const { return Join({"queue", owner_token, "single"}); }
  std::string Batch(std::string_view owner_token, std::string_view batch_id) const {
    return Join({"queue", owner_token, "batch", batch_id});
  }
  std::string Named(std::string_view owner_token, std::string_view job_id) const {
    return Join({"queue", owner_token, "named", job_id});
  }
  std::string AllOf(std::string_view owner_token) const { return Join({"queue", owner_token, ">"}); }
  std::string End(std::string_view batch_id, std::string_view state, std::string_view kind,
                  std::string_view job_id) const {
    return Join({"ends", batch_id, state, kind, job_id});
  }

 private:
  std::string Join(std::initializer_list<std::string_view> tokens) const;

  std::string name_;
};

// An owner's name as one token of a subject: the name if possible, else a digest.
std::string OwnerToken(std::string_view owner);

// Whether it can be one token of a subject: 1 to 128 letters, digits, "-", "_".
bool IsToken(std::string_view text);

// The token at a place of a subject, from 0; empty when there is none.
std::string_view TokenAt(std::string_view subject, int place);

// The kind of a note in the bucket of requests; see delete.cc.
inline constexpr char kDeleting[] = "deleting";

// The key of a request in its bucket; the id where there is no request.
std::string RequestKey(const std::string& owner, RequestKind kind, const std::string& request_id,
                       const std::string& id);

absl::Duration LeaseOf(const config::v1::QueueConfig& config);

// Notices between the processes of a queue: hints on what to check, never data. They may be lost, so every process also
// polls. On the wire: the letter of the kind, subject and batch, separated by spaces.
struct Notice {
  enum class Kind : char {
    // `subject`, of the queue stream, may have a job to take.
    kWork = 'w',
    // Something happened to the job `subject`; it ended when `batch_id` is set.
    kJob = 'j',
    // The same, and the process that runs it should check whether it still holds it.
    kHold = 'h',
    // The batch `subject` was paused, resumed, cancelled or got jobs.
    kBatch = 'b',
  };
  // Other letters are ignored.
  Kind kind = Kind::kWork;
  std::string subject;
  std::string batch_id;
};

std::string WriteNotice(const Notice& notice);
Notice ReadNotice(std::string_view text);

}  // namespace flair::orchestrator
