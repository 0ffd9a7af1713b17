// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/openai/json_text.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace flair::llm {
namespace {

// What becomes of a byte: itself, an escape, or a part of a character of several bytes.
enum class Treatment : char { kPlain, kEscaped, kLong };

constexpr std::array<Treatment, 256> kTreatments = [] {
  std::array<Treatment, 256> treatments{};
  for (int byte = 0; byte < 256; ++byte) {
    const bool escaped = byte < 0x20 || byte == '"' || byte == '\\';
    treatments[byte] = byte >= 0x80 ? Treatment::kLong : escaped ? Treatment::kEscaped : Treatment::kPlain;
  }
  return treatments;
}();

Treatment TreatmentOf(char c) { return kTreatments[static_cast<unsigned char>(c)]; }

}  // namespace

void AppendJsonString(std::string_view text, std::string& json) {
  json.reserve(json.size() + text.size() + 2);
  json += '"';
  while (!text.empty()) {
    const Treatment treatment = TreatmentOf(text.front());
    const auto end = std::ranges::find_if(text, [&](char c) { return TreatmentOf(c) != treatment; });
    const std::string_view run = text.substr(0, static_cast<size_t>(end - text.begin()));
    text.remove_prefix(run.size());
    if (treatment == Treatment::kPlain) {
      json += run;
      continue;
    }
    // Characters of several bytes have no byte below 0x80, so that a run of such bytes can be judged by itself.
    const std::string written = nlohmann::json(run).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    json.append(written, 1, written.size() - 2);
  }
  json += '"';
}

}  // namespace flair::llm
