// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/event_table.h"

#include <fmt/format.h>

#include "worker_runtime/files/files.h"

namespace flair::orchestrator {

absl::Status EventTable::Append(v1::JobEvent& event) {
  const auto lock = database_.lock();
  const absl::StatusOr<int64_t> last = LastSequence(event.job_id());
  if (!last.ok()) return last.status();
  event.set_sequence(*last + 1);
  return Insert(event);
}

absl::StatusOr<int64_t> EventTable::LastSequence(const std::string& job_id) {
  const auto lock = database_.lock();
  Statement last = database_.Prepare("SELECT coalesce(max(sequence), 0) FROM events WHERE job_id = ?");
  const absl::StatusOr<bool> row = last.Bind(job_id).Step();
  if (!row.ok()) return row.status();
  return last.Int(0);
}

absl::Status EventTable::Insert(const v1::JobEvent& event) {
  const auto lock = database_.lock();
  return database_.Prepare("INSERT INTO events VALUES (?, ?, ?)")
      .Bind(event.job_id())
      .Bind(event.sequence())
      .BindBytes(runtime::CanonicalBytes(event))
      .Run();
}

absl::StatusOr<std::vector<v1::JobEvent>> EventTable::After(const std::string& job_id, int64_t sequence, int limit) {
  const auto lock = database_.lock();
  Statement select =
      database_.Prepare("SELECT event FROM events WHERE job_id = ? AND sequence > ? ORDER BY sequence LIMIT ?");
  select.Bind(job_id).Bind(sequence).Bind(limit);
  std::vector<v1::JobEvent> events;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return events;
    if (!events.emplace_back().ParseFromString(select.Bytes(0))) {
      return absl::DataLossError(fmt::format("job store: an event of job {} is damaged", job_id));
    }
  }
}

}  // namespace flair::orchestrator
