// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mcp/schema.h"

#include <algorithm>
#include <cmath>

#include "fmt/format.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli::mcp {
namespace {

using Json = nlohmann::json;

// Of a value, in a message about it.
std::string Quoted(const Json& value) {
  constexpr size_t kMost = 60;
  std::string text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

bool HasType(const Json& value, const std::string& type) {
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "number") return value.is_number();
  if (type == "integer") {
    return value.is_number_integer() || (value.is_number() && value.get<double>() == std::trunc(value.get<double>()));
  }
  return type == "null" && value.is_null();
}

absl::Status Wrong(const std::string& path, const Json& value, const std::string& right) {
  return InvalidArgument("{}: {}; must be {}", path.empty() ? "arguments" : path, Quoted(value), right);
}

size_t LettersOf(const std::string& text) {
  return static_cast<size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

absl::Status CheckNumber(const Json& schema, const Json& value, const std::string& path) {
  const double number = value.get<double>();
  if (schema.contains("minimum") && number < schema["minimum"].get<double>()) {
    return Wrong(path, value, fmt::format("at least {}", schema["minimum"].dump()));
  }
  if (schema.contains("exclusiveMinimum") && number <= schema["exclusiveMinimum"].get<double>()) {
    return Wrong(path, value, fmt::format("more than {}", schema["exclusiveMinimum"].dump()));
  }
  if (schema.contains("maximum") && number > schema["maximum"].get<double>()) {
    return Wrong(path, value, fmt::format("at most {}", schema["maximum"].dump()));
  }
  return absl::OkStatus();
}

absl::Status CheckObject(const Json& schema, const Json& value, const std::string& path) {
  const std::string before = path.empty() ? "" : path + ".";
  for (const Json& name : schema.value("required", Json::array())) {
    if (!value.contains(name)) return InvalidArgument("{}{}: is missing", before, name.get<std::string>());
  }
  const Json properties = schema.value("properties", Json::object());
  for (const auto& [name, member] : value.items()) {
    const auto known = properties.find(name);
    if (known != properties.end()) {
      RETURN_IF_ERROR(CheckAgainst(*known, member, before + name));
    } else if (schema.value("additionalProperties", Json(true)) == false) {
      std::string names;
      for (const auto& [each, unused] : properties.items()) names += (names.empty() ? "" : ", ") + each;
      return InvalidArgument("{}{}: is not known; there are: {}", before, name.substr(0, 60), names);
    }
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckAgainst(const Json& schema, const Json& value, const std::string& path) {
  const std::string type = schema.value("type", "");
  if (!type.empty() && !HasType(value, type)) {
    return Wrong(path, value, (type[0] == 'i' || type[0] == 'o' || type[0] == 'a' ? "an " : "a ") + type);
  }
  const auto words = schema.find("enum");
  if (words != schema.end() && std::ranges::find(*words, value) == words->end()) {
    std::string names;
    for (const Json& word : *words) names += (names.empty() ? "" : ", ") + word.get<std::string>();
    return Wrong(path, value, "one of " + names);
  }
  if (value.is_number()) return CheckNumber(schema, value, path);
  if (value.is_object()) return CheckObject(schema, value, path);
  if (value.is_string()) {
    const size_t letters = LettersOf(value.get_ref<const std::string&>());
    if (letters < schema.value("minLength", size_t{0})) return Wrong(path, value, "some text");
    const size_t most = schema.value("maxLength", SIZE_MAX);
    if (letters > most) return Wrong(path, value, fmt::format("at most {} characters", most));
  }
  if (value.is_array() && schema.contains("items")) {
    const size_t most = schema.value("maxItems", SIZE_MAX);
    if (value.size() > most) return InvalidArgument("{}: {} items; at most {}", path, value.size(), most);
    for (size_t i = 0; i < value.size(); ++i) {
      RETURN_IF_ERROR(CheckAgainst(schema["items"], value[i], fmt::format("{}[{}]", path, i)));
    }
  }
  return absl::OkStatus();
}

Json WithShared(const Json& json, const Json& shared) {
  if (!json.is_structured()) return json;
  Json whole = json.is_array() ? Json::array() : Json::object();
  if (json.is_array()) {
    for (const Json& item : json) whole.push_back(WithShared(item, shared));
    return whole;
  }
  const auto use = json.find("use");
  if (use != json.end() && use->is_string()) whole = WithShared(shared.at(use->get<std::string>()), shared);
  for (const auto& [name, member] : json.items()) {
    if (name != "use" || !member.is_string()) whole[name] = WithShared(member, shared);
  }
  return whole;
}

}  // namespace flair::cli::mcp
