// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/batch_table.h"

#include <fmt/format.h>

namespace flair::orchestrator {

absl::Status BatchTable::Insert(const std::string& id, const std::string& request_id, const std::string& specs_digest) {
  const auto lock = database_.lock();
  return database_.Prepare("INSERT INTO batches VALUES (?, ?, ?)").Bind(id).Bind(request_id).Bind(specs_digest).Run();
}

absl::StatusOr<std::optional<BatchTable::Row>> BatchTable::FindByRequest(const std::string& request_id) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT id, specs_digest FROM batches WHERE request_id = ?");
  absl::StatusOr<bool> row = select.Bind(request_id).Step();
  if (!row.ok()) return row.status();
  if (!*row) return std::nullopt;
  return Row{select.Text(0), select.Text(1)};
}

absl::StatusOr<v1::Batch> BatchTable::Get(const std::string& id) {
  const auto lock = database_.lock();
  v1::Batch batch;
  batch.set_id(id);
  {
    Statement known = database_.Prepare("SELECT 1 FROM batches WHERE id = ?");
    absl::StatusOr<bool> row = known.Bind(id).Step();
    if (!row.ok()) return row.status();
    if (!*row) return absl::NotFoundError(fmt::format("batch_id: no batch \"{}\" in this store", id.substr(0, 80)));
  }
  Statement count =
      database_.Prepare("SELECT state, count(*) FROM jobs WHERE batch_id != '' AND batch_id = ? GROUP BY state");
  count.Bind(id);
  while (true) {
    absl::StatusOr<bool> row = count.Step();
    if (!row.ok()) return row.status();
    if (!*row) return batch;
    const int jobs = static_cast<int>(count.Int(1));
    batch.set_job_count(batch.job_count() + jobs);
    switch (static_cast<v1::JobState>(count.Int(0))) {
      case v1::JOB_STATE_SUCCEEDED:
        batch.set_succeeded_count(jobs);
        break;
      case v1::JOB_STATE_FAILED:
        batch.set_failed_count(jobs);
        break;
      case v1::JOB_STATE_CANCELLED:
        batch.set_cancelled_count(jobs);
        break;
      default:
        batch.set_open_count(batch.open_count() + jobs);
    }
  }
}

}  // namespace flair::orchestrator
