// SPDX-License-Identifier: GPL-3.0-or-later
// Log lines with fields. Lines hold ids, codes and figures, never prompts, keys or tokens. Whatever is in a message or
// a field, it stays one line, and cannot be taken for another field.
#pragma once

#include <chrono>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "spdlog/logger.h"

namespace flair::runtime {

struct LogField {
  // snake_case, with its unit: "request_id", "duration_ms".
  std::string_view name;
  // Nothing and an empty text are left out.
  std::variant<std::monostate, std::string_view, int64_t, double> value;
};

// One line with fields. `message` says what happened, for people.
void Log(spdlog::logger& logger, spdlog::level::level_enum level, std::string_view message,
         std::initializer_list<LogField> fields);

// A logger to standard error. `level`: "debug", "info", "warning", "error"; "info" when empty. `format`: "text" when
// empty,
//   2026-05-01T12:00:00.123Z info flair-optimizer Solve OK request_id=20260521T134501123456-3fa2c1/solve
//   duration_ms=81.2
// or "json", one object a line with time (RFC 3339), level, program, message and the fields. Lines that are logged
// without fields are written in the same form.
std::shared_ptr<spdlog::logger> MakeLogger(const std::string& program, const std::string& level,
                                           const std::string& format = "");

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
