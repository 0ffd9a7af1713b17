// SPDX-License-Identifier: GPL-3.0-or-later
// How log lines are written.
#pragma once

#include <chrono>
#include <span>
#include <string>
#include <string_view>

#include "worker_runtime/logging/log.h"

namespace flair::runtime {

using LogFields = std::span<const LogField>;

struct LogLine {
  std::chrono::system_clock::time_point time;
  std::string_view level;
  std::string_view program;
  std::string_view message;
  LogFields fields;
};

// For people and grep, without line break: values that hold spaces, quotes, "=" or signs that cannot be seen are
// quoted, and the latter written as \n, \x1b and so on.
std::string TextLogLine(const LogLine& line);

// A JSON object, without line break. What is not UTF-8 is replaced.
std::string JsonLogLine(const LogLine& line);

}  // namespace flair::runtime
