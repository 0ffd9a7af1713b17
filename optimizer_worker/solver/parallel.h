// SPDX-License-Identifier: GPL-3.0-or-later
// Runs numbered, independent pieces of work on several threads.
#pragma once

#include <functional>

namespace flair::optimizer {

// Calls work(0) .. work(count - 1), each once, on up to `thread_count` threads including the caller's; returns when all
// have ended. `work` writes to its own slot, so the result does not depend on the number of threads. It must not throw.
void ForEachIndex(int count, int thread_count, const std::function<void(int)>& work);

// `requested` when positive, else the number of cores.
int ThreadCount(int requested);

}  // namespace flair::optimizer
