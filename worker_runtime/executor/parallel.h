// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "absl/status/status.h"

namespace flair::runtime {

// How work is spread: never what comes of it.
struct Workers {
  int thread_count = 1;
  std::function<absl::Status()> check_alive;  // asked from the calling thread; may be empty
};

// Calls work(i) once for every i in [0, count), on up to thread_count threads of which the caller is one; on fewer when
// the machine gives no more. Work must only write what belongs to its i, so that the number of threads decides nothing,
// and must not throw. Ends early with what check_alive says.
absl::Status ForEach(const Workers& workers, int count, const std::function<void(int)>& work);

}  // namespace flair::runtime
