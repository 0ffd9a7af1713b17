// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace flair::runtime {

// Where figures about the program's work go. `name` is snake_case with its unit, such as "rpc_duration_seconds";
// `label` tells apart what shares a name, such as the method, and comes from a small fixed set. Thread-safe.
class Metrics {
 public:
  virtual ~Metrics() = default;

  // Adds to a counter.
  virtual void Count(std::string_view name, std::string_view label, double amount) = 0;

  // Records one value of a distribution.
  virtual void Observe(std::string_view name, std::string_view label, double value) = 0;
};

// Forgets everything. Lives for the whole process.
Metrics& NullMetrics();

}  // namespace flair::runtime
