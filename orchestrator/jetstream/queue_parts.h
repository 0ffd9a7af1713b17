// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "flair/config/v1/orchestrator_config.pb.h"
#include "flair/store/v1/job_record.pb.h"
#include "orchestrator/batch/work_queue.h"
#include "orchestrator/jetstream/connection.h"
#include "orchestrator/jetstream/streams.h"
#include "worker_runtime/clock/clock.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {

// Values by keys in a stream of JetStream, the latest of each; keys are tokens with dots between. cnats's kvStore is
// not used: it cannot remove a value without a trace, and it may read from a server that is behind. Errors as Streams.
// Thread-safe.
class Bucket {
 public:
  struct Entry {
    std::string value;
    // Changes with each writing.
    uint64_t revision = 0;
  };

  Bucket(Streams& streams, const std::string& name)
      : streams_(streams), stream_("KV_" + name), prefix_("$KV." + name + ".") {}

  // NOT_FOUND when there is none.
  absl::StatusOr<Entry> Get(std::string_view key) { return ToEntry(streams_.Last(stream_, SubjectOf(key))); }

  std::vector<absl::StatusOr<Entry>> GetAll(std::span<const std::string> keys) {
    std::vector<std::string> subjects;
    for (const std::string& key : keys) subjects.push_back(SubjectOf(key));
    std::vector<absl::StatusOr<Entry>> entries;
    for (auto& message : streams_.LastOfEach(stream_, subjects)) entries.push_back(ToEntry(std::move(message)));
    return entries;
  }

  // Without repetition.
  absl::StatusOr<Entry> GetOnce(std::string_view key, absl::Duration limit) {
    return ToEntry(streams_.LastOnce(stream_, SubjectOf(key), limit));
  }

  // Whatever was there.
  absl::StatusOr<uint64_t> Put(std::string_view key, std::string value) {
    return streams_.Publish({SubjectOf(key), std::move(value), {}});
  }

  // Only if the key's revision is still `expected`, 0 for none at all; ABORTED otherwise. Returns the new one. Asks
  // again while the servers do not answer and `more` (null: the calls' limit) allows; a value that is then found to be
  // there has been written.
  absl::StatusOr<uint64_t> Update(std::string_view key, std::string value, uint64_t expected,
                                  const std::function<bool()>& more = nullptr) {
    const NatsRequest request = WithExpected(SubjectOf(key), std::move(value), expected);
    int asked = 0;
    const auto ask = [&] {
      ++asked;
      return streams_.PublishOnce(request);
    };
    absl::StatusOr<uint64_t> revision = more ? Streams::WhileUnavailable(ask, more) : streams_.WithinLimit(ask);
    if (!absl::IsAborted(revision.status()) || asked == 1) return revision;
    // An earlier attempt may have been stored although its answer was lost.
    ASSIGN_OR_RETURN(const Entry now, Get(key));
    if (now.value == request.content) return now.revision;
    return revision;
  }

  struct Change {
    std::string key;
    std::string value;
    uint64_t expected = 0;
  };
  // Many updates of different keys at once; each ends as Update.
  std::vector<absl::StatusOr<uint64_t>> UpdateAll(std::span<const Change> changes) {
    std::vector<NatsRequest> requests;
    for (const Change& change : changes) {
      requests.push_back(WithExpected(SubjectOf(change.key), change.value, change.expected));
    }
    return streams_.PublishAll(requests);
  }

  struct Revision {
    std::string key;
    uint64_t revision = 0;
  };
  // Removes values without a trace: those that still have that revision. False where that is not so.
  std::vector<absl::StatusOr<bool>> RemoveAll(std::span<const Revision> revisions) {
    // A key has one message, the latest: an earlier one is gone.
    std::vector<uint64_t> sequences;
    for (const Revision& revision : revisions) sequences.push_back(revision.revision);
    return streams_.Remove(stream_, sequences);
  }

  absl::StatusOr<bool> Remove(const Revision& revision) { return RemoveAll(std::span(&revision, 1)).front(); }

  const std::string& stream() const { return stream_; }
  // The subject of a key, with wildcards where it has them, and the key of a subject.
  std::string SubjectOf(std::string_view key) const { return prefix_ + std::string(key); }
  std::string_view KeyOf(std::string_view subject) const { return subject.substr(prefix_.size()); }

 private:
  static absl::StatusOr<Bucket::Entry> ToEntry(absl::StatusOr<StoredMessage> message) {
    if (!message.ok()) return message.status();
    return Bucket::Entry{std::move(message->content), message->sequence};
  }

  Streams& streams_;
  const std::string stream_;
  const std::string prefix_;
};

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

Notice ReadNotice(std::string_view text);

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
