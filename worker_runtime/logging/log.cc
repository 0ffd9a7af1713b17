// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/logging/log.h"

#include <spdlog/sinks/stdout_sinks.h>

#include <utility>

#include "worker_runtime/logging/log_line.h"

namespace flair::runtime {
namespace {

// The fields of the line that this thread is writing: the sinks format on the thread that logs.
thread_local LogFields current_fields;

LogLine ToLine(const spdlog::details::log_msg& message) {
  const auto to_view = [](spdlog::string_view_t text) { return std::string_view(text.data(), text.size()); };
  return {.time = message.time,
          .level = to_view(spdlog::level::to_string_view(message.level)),
          .program = to_view(message.logger_name),
          .message = to_view(message.payload),
          .fields = current_fields};
}

class Formatter final : public spdlog::formatter {
 public:
  explicit Formatter(bool json) : json_(json) {}
  void format(const spdlog::details::log_msg& message, spdlog::memory_buf_t& out) override {
    const LogLine line = ToLine(message);
    const std::string text = (json_ ? JsonLogLine(line) : TextLogLine(line)) + "\n";
    out.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<spdlog::formatter> clone() const override { return std::make_unique<Formatter>(json_); }

 private:
  const bool json_;
};

spdlog::level::level_enum Level(const std::string& level) {
  if (level == "debug") return spdlog::level::debug;
  if (level == "warning") return spdlog::level::warn;
  if (level == "error") return spdlog::level::err;
  return spdlog::level::info;
}

}  // namespace

void Log(spdlog::logger& logger, spdlog::level::level_enum level, std::string_view message,
         std::initializer_list<LogField> fields) {
  if (!logger.should_log(level)) return;
  current_fields = {fields.begin(), fields.end()};
  logger.log(level, spdlog::string_view_t(message.data(), message.size()));
  current_fields = {};
}

std::shared_ptr<spdlog::logger> MakeLogger(const std::string& program, const std::string& level,
                                           const std::string& format) {
  auto sink = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  sink->set_formatter(std::make_unique<Formatter>(format == "json"));
  auto logger = std::make_shared<spdlog::logger>(program, std::move(sink));
  logger->set_level(Level(level));
  logger->flush_on(spdlog::level::info);
  return logger;
}

}  // namespace flair::runtime
