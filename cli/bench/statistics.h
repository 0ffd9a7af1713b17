// SPDX-License-Identifier: GPL-3.0-or-later
// Clocks and figures of this process, and summaries of samples.
#pragma once

#include <vector>

namespace flair::cli {

// CPU time that this process has used, all threads, seconds.
double ProcessCpu_s();
// CPU time that the calling thread has used, seconds.
double ThreadCpu_s();
// Monotonic time, seconds from some point.
double Wall_s();

// Memory that this process holds now, and the most it has held, MiB.
double Memory_MiB();
double PeakMemory_MiB();

// The value at `share` of [0, 1] of the way through the sorted values, the upper one between two; 0 when there are
// none.
double Quantile(std::vector<double> values, double share);
double Mean(const std::vector<double>& values);

}  // namespace flair::cli
