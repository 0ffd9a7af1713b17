// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/store/status_table.h"

namespace flair::orchestrator {

absl::Status StatusTable::Set(const v1::OrchestratorStatus& status, absl::Time time, absl::Time oldest) {
  const auto lock = database_.lock();
  absl::Status stored =
      database_.Prepare("DELETE FROM orchestrators WHERE report_time_us < ?").Bind(absl::ToUnixMicros(oldest)).Run();
  if (!stored.ok()) return stored;
  return database_.Prepare("INSERT OR REPLACE INTO orchestrators VALUES (?, ?, ?)")
      .Bind(status.id())
      .BindBytes(status.SerializeAsString())
      .Bind(absl::ToUnixMicros(time))
      .Run();
}

absl::StatusOr<std::vector<v1::OrchestratorStatus>> StatusTable::Since(absl::Time oldest) {
  const auto lock = database_.lock();
  Statement select = database_.Prepare("SELECT status FROM orchestrators WHERE report_time_us >= ? ORDER BY id");
  select.Bind(absl::ToUnixMicros(oldest));
  std::vector<v1::OrchestratorStatus> statuses;
  while (true) {
    absl::StatusOr<bool> row = select.Step();
    if (!row.ok()) return row.status();
    if (!*row) return statuses;
    if (!statuses.emplace_back().ParseFromString(select.Bytes(0))) statuses.pop_back();
  }
}

}  // namespace flair::orchestrator
