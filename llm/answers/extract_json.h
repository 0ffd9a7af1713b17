// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "llm/answers/fault.h"

namespace flair::llm {

// The JSON of an answer.
struct ExtractedJson {
  // Discarded (`is_discarded()`) when the answer holds none; the faults then say what it holds instead.
  nlohmann::json value = nlohmann::json(nlohmann::json::value_t::discarded);
  // A truncated answer whose first list elements are whole gives those, and a doubtful fault.
  std::vector<Fault> faults;
};

// Takes the JSON out of what a model wrote: alone, between fences, with prose around it, after "thoughts", with
// comments, trailing commas or line ends within its texts. Of several values that with most of the `keys` at its root
// wins, then the later one. Faults for an empty answer, HTML, prose without JSON, JSON that does not parse, and more
// than a megabyte. Pure; any bytes are good input.
ExtractedJson ExtractJson(std::string_view answer, std::span<const std::string> keys);

}  // namespace flair::llm
