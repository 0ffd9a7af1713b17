// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of JSON-RPC 2.0 as the Model Context Protocol restricts it: one object a line, ids of strings or whole
// numbers, parameters by name, no batches.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "nlohmann/json.hpp"

namespace flair::cli::mcp {

using Json = nlohmann::json;

inline constexpr size_t kMostLineBytes = size_t{8} << 20;
inline constexpr int kMostDepth = 64;

// Codes of JSON-RPC, and the one of ours that the protocol's revision 2026-07-28 gives.
enum ErrorCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kResourceNotFound = -32002,  // until revision 2025-11-25; kInvalidParams since
  kUnsupportedVersion = -32022,
};

struct Fault {
  ErrorCode code = kInternalError;
  std::string message;
  Json data;  // null: none
  Json id;    // of the request that it answers; null when that could not be read
};

// A request, or a notification when `id` is null.
struct Message {
  Json id;
  std::string method;
  Json params = Json::object();
};

// What a line says; nothing for an answer, since no requests are sent. Every text is either read or a fault.
std::variant<std::monostate, Message, Fault> ReadMessage(std::string_view line);

// Whole, of at most kMostDepth levels, without the same key twice in an object; `error` says what is wrong.
std::optional<Json> ParseStrictJson(std::string_view text, std::string& error);

// As lines without their end. Text that is no UTF-8 is replaced.
std::string ResultLine(const Json& id, Json result);
std::string FaultLine(const Fault& fault);
std::string NotificationLine(const std::string& method, Json params);

}  // namespace flair::cli::mcp
