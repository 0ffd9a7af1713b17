// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/logging/log.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "nlohmann/json.hpp"

namespace flair::runtime {
namespace {

std::string TimeText(std::chrono::system_clock::time_point time) {
  const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(static_cast<std::time_t>(ms / 1000)), ms % 1000);
}

// Also the C1 set (U+0080 to U+009F, in UTF-8 after C2), which terminals obey, and U+2028 and U+2029 (E2 80 A8, A9),
// which some readers take for line breaks.
size_t ControlLength(std::string_view text, size_t at) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  if (byte(at) < 0x20 || byte(at) == 0x7f) return 1;
  if (byte(at) == 0xc2 && byte(at + 1) >= 0x80 && byte(at + 1) < 0xa0) return 2;
  if (byte(at) == 0xe2 && byte(at + 1) == 0x80 && (byte(at + 2) == 0xa8 || byte(at + 2) == 0xa9)) return 3;
  return 0;
}

// Control characters as \n or \xHH.
std::string Escaped(std::string_view text, std::string_view also) {
  std::string out;
  for (size_t i = 0; i < text.size();) {
    const size_t length = ControlLength(text, i);
    if (text[i] == '\n') {
      out += "\\n";
    } else if (length > 0) {
      for (size_t k = 0; k < length; ++k) out += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[i + k]));
    } else {
      if (also.find(text[i]) != std::string_view::npos) out += '\\';
      out += text[i];
    }
    i += std::max<size_t>(length, 1);
  }
  return out;
}

std::string TextValue(const LogField& field) {
  if (const auto* number = std::get_if<int64_t>(&field.value)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<double>(&field.value)) return fmt::format("{:.1f}", *number);
  const std::string_view text = std::get<std::string_view>(field.value);
  std::string escaped = Escaped(text, "\"\\");
  const bool plain = escaped == text && text.find_first_of(" =") == std::string_view::npos;
  return plain ? escaped : fmt::format("\"{}\"", escaped);
}

nlohmann::ordered_json JsonValue(const LogField& field) {
  if (const auto* number = std::get_if<int64_t>(&field.value)) return *number;
  if (const auto* number = std::get_if<double>(&field.value)) return std::round(*number * 1000) / 1000;
  return std::string(std::get<std::string_view>(field.value));
}

bool IsEmpty(const LogField& field) {
  const auto* text = std::get_if<std::string_view>(&field.value);
  return std::holds_alternative<std::monostate>(field.value) || (text != nullptr && text->empty());
}

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

std::string TextLogLine(const LogLine& line) {
  std::string out =
      fmt::format("{} {} {} {}", TimeText(line.time), line.level, line.program, Escaped(line.message, ""));
  for (const LogField& field : line.fields) {
    if (!IsEmpty(field)) out += fmt::format(" {}={}", field.name, TextValue(field));
  }
  return out;
}

std::string JsonLogLine(const LogLine& line) {
  nlohmann::ordered_json json = {{"time", TimeText(line.time)},
                                 {"level", std::string(line.level)},
                                 {"program", std::string(line.program)},
                                 {"message", std::string(line.message)}};
  for (const LogField& field : line.fields) {
    if (!IsEmpty(field)) json[std::string(field.name)] = JsonValue(field);
  }
  // ASCII only: nothing in a line can steer a terminal or end the line.
  return json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
}

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
