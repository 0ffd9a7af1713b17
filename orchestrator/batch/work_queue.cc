// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/batch/work_queue.h"

#include <fmt/format.h>

#include <algorithm>

namespace flair::orchestrator {
namespace {
constexpr char kArtifactIsGone[] = "flair/artifact-is-gone";
}  // namespace

absl::Status ArtifactIsGone(const std::string& artifact_id) {
  absl::Status gone =
      absl::NotFoundError(fmt::format("artifact {}: deleted with the last job that had it", artifact_id));
  gone.SetPayload(kArtifactIsGone, absl::Cord());
  return gone;
}

bool IsArtifactGone(const absl::Status& status) { return status.GetPayload(kArtifactIsGone).has_value(); }

std::string JobIdSource::Next() {
  std::lock_guard lock(mutex_);
  last_ = std::max(clock_.Now(), last_ + absl::Microseconds(1));
  const std::string seconds = absl::FormatTime("%Y%m%dT%H%M%S", last_, absl::UTCTimeZone());
  const int64_t microseconds = absl::ToUnixMicros(last_) % 1000000;
  return fmt::format("{}{:06}-{:06x}", seconds, microseconds, random_() & 0xffffffu);
}

std::string BatchJobId(const std::string& batch_id, int64_t index) { return fmt::format("{}-{:08}", batch_id, index); }

}  // namespace flair::orchestrator
