// SPDX-License-Identifier: GPL-3.0-or-later
// Reading JSON from a stranger: nothing is what it should be.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace flair::llm {

// Parses; discarded (is_discarded()) when it is no JSON or nests deeper than anything of the protocol does, so that
// what walks over it needs no deep stack.
inline nlohmann::json ParseJson(std::string_view text) {
  constexpr int kDepthLimit = 64;
  bool too_deep = false;
  const auto keep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    too_deep = too_deep || depth > kDepthLimit;
    return !too_deep;
  };
  nlohmann::json value = nlohmann::json::parse(text, keep, false);
  return too_deep ? nlohmann::json(nlohmann::json::value_t::discarded) : value;
}

// The member of an object; null when `value` is no object, or has none of that name, or it is JSON's null.
inline const nlohmann::json* Field(const nlohmann::json& value, const char* name) {
  if (!value.is_object()) return nullptr;
  const auto found = value.find(name);
  return found == value.end() || found->is_null() ? nullptr : &*found;
}

// A text member; empty when it is none.
inline std::string TextField(const nlohmann::json& value, const char* name) {
  const nlohmann::json* const field = Field(value, name);
  return field != nullptr && field->is_string() ? field->get<std::string>() : std::string();
}

// A count, [0, 10^9]; none when it is anything else.
inline std::optional<int64_t> CountField(const nlohmann::json& value, const char* name) {
  const nlohmann::json* const field = Field(value, name);
  if (field == nullptr || !field->is_number_integer()) return std::nullopt;
  // A count beyond int64 is stored unsigned.
  if (field->is_number_unsigned() && field->get<uint64_t>() > 1000000000u) return std::nullopt;
  const int64_t count = field->get<int64_t>();
  return count >= 0 ? std::optional(count) : std::nullopt;
}

}  // namespace flair::llm
