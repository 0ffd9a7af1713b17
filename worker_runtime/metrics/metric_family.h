// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace flair::runtime {

enum class MetricKind { kCounter, kGauge, kHistogram };

// What is measured, declared once as a constant beside the code that measures it:
//   constexpr MetricFamily kRestarts{.kind = MetricKind::kCounter, .name = "flair_optimizer_restarts_total", ...};
// Names follow Prometheus: letters, digits and "_", the unit last ("_seconds", "_bytes"), counters end in "_total".
struct MetricFamily {
  MetricKind kind = MetricKind::kCounter;
  std::string_view name;
  // One sentence for people.
  std::string_view help;
  // Names of what tells apart the values, such as "rpc"; unused ones are empty and last. The values of each come from a
  // small fixed set.
  std::array<std::string_view, 2> labels = {};
  // Of histograms: upper ends of the buckets, growing.
  std::span<const double> buckets = {};

  constexpr size_t label_count() const {
    size_t count = 0;
    while (count < labels.size() && !labels[count].empty()) ++count;
    return count;
  }
};

// From half a millisecond, which a call in one machine takes, to the ten minutes that a stage may take.
inline constexpr double kSecondsBuckets[] = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25,
                                             0.5,    1,     2.5,    5,     10,   30,    60,   180, 600};

}  // namespace flair::runtime
