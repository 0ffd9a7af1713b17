// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/message.h"

#include <exception>
#include <set>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "worker_runtime/text/nests_within.h"

namespace flair::cli::mcp {
namespace {

std::string Line(const Json& message) { return message.dump(-1, ' ', false, Json::error_handler_t::replace); }

bool IsId(const Json& id) { return id.is_string() || id.is_number_integer(); }

}  // namespace

std::optional<Json> ParseStrictJson(std::string_view text, std::string& error) {
  if (!NestsWithin(text, kMostDepth)) {
    error = fmt::format("more than {} levels deep", kMostDepth);
    return std::nullopt;
  }
  // Two readers of one text must not see different values.
  std::vector<std::set<std::string>> keys;
  std::string twice;
  const auto see = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && !keys.back().insert(value.get<std::string>()).second) {
      twice = value.get<std::string>().substr(0, 80);
    }
    return true;
  };
  try {
    Json json = Json::parse(text.begin(), text.end(), see);
    if (twice.empty()) return json;
    error = fmt::format("the key \"{}\" twice in an object", twice);
  } catch (const std::exception& failure) {
    error = failure.what();
  }
  return std::nullopt;
}

std::variant<std::monostate, Message, Fault> ReadMessage(std::string_view line) {
  std::string error;
  std::optional<Json> json = ParseStrictJson(line, error);
  if (!json.has_value()) return Fault{kParseError, "no JSON: " + error, {}, {}};
  if (json->is_array())
    return Fault{kInvalidRequest, "batches are no part of the protocol: send one message a line", {}, {}};
  if (!json->is_object()) return Fault{kInvalidRequest, "a message is an object", {}, {}};
  Message message;
  const auto id = json->find("id");
  if (id != json->end()) {
    if (!IsId(*id)) return Fault{kInvalidRequest, "id: must be a string or a whole number", {}, {}};
    message.id = *id;
  }
  const auto refuse = [&](ErrorCode code, const std::string& why) { return Fault{code, why, {}, message.id}; };
  if (json->value("jsonrpc", Json()) != "2.0") return refuse(kInvalidRequest, "jsonrpc: must be \"2.0\"");
  const auto method = json->find("method");
  if (method == json->end()) {
    if (json->contains("result") || json->contains("error")) return std::monostate();
    return refuse(kInvalidRequest, "method: is missing");
  }
  if (!method->is_string()) return refuse(kInvalidRequest, "method: must be a string");
  message.method = method->get<std::string>();
  const auto params = json->find("params");
  if (params != json->end()) {
    if (!params->is_object()) return refuse(kInvalidParams, "params: must be an object");
    message.params = std::move(*params);
  }
  return message;
}

std::string ResultLine(const Json& id, Json result) {
  return Line({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

std::string FaultLine(const Fault& fault) {
  Json error = {{"code", static_cast<int>(fault.code)}, {"message", fault.message}};
  if (!fault.data.is_null()) error["data"] = fault.data;
  Json message = {{"jsonrpc", "2.0"}, {"error", std::move(error)}};
  // The protocol's schemas know no null here.
  if (!fault.id.is_null()) message["id"] = fault.id;
  return Line(message);
}

std::string NotificationLine(const std::string& method, Json params) {
  return Line({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

}  // namespace flair::cli::mcp
