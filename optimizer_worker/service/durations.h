// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/time/time.h"
#include "google/protobuf/duration.pb.h"
#include "google/protobuf/repeated_ptr_field.h"

namespace flair::optimizer {

// Appends wall times to a field of an answer.
inline void WriteDurations(const std::vector<absl::Duration>& durations,
                           google::protobuf::RepeatedPtrField<google::protobuf::Duration>& field) {
  for (absl::Duration duration : durations) {
    google::protobuf::Duration& message = *field.Add();
    message.set_seconds(absl::ToInt64Seconds(duration));
    message.set_nanos(static_cast<int32_t>(absl::ToInt64Nanoseconds(duration % absl::Seconds(1))));
  }
}

}  // namespace flair::optimizer
