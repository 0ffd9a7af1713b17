// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/call_json.h"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "fmt/format.h"
#include "llm/answers/choices.h"
#include "llm/answers/fault.h"

namespace flair::translator {
namespace {

using nlohmann::json;

constexpr size_t kMostArguments = 200;

const json* Member(const json& object, std::initializer_list<std::string_view> names) {
  for (const auto& [key, value] : object.items()) {
    for (const std::string_view name : names) {
      if (llm::Bare(key) == name) return &value;
    }
  }
  return nullptr;
}

const json* FunctionOf(const json& object) {
  const json* name = Member(object, {"function", "call", "functionname"});
  if (name == nullptr) name = Member(object, {"name", "type"});
  return name != nullptr && name->is_string() ? name : nullptr;
}

std::string ValueText(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump(-1, ' ', false, json::error_handler_t::replace);
}

void AddValue(std::string name, const json& value, WrittenCall& call) {
  if (value.is_null() || call.arguments.size() >= kMostArguments) return;
  WrittenArgument& argument = call.arguments.emplace_back();
  argument.name = std::move(name);
  argument.in_brackets = value.is_array() && value.size() > 1;
  if (!value.is_array()) {
    argument.values.push_back(ValueText(value));
    return;
  }
  for (const json& item : value) argument.values.push_back(ValueText(item));
}

void AddArguments(const json& given, WrittenCall& call);

// One argument of a list: a text in the notation, a name with its value, or a value alone.
void AddListed(const json& item, WrittenCall& call) {
  if (item.is_string()) {
    call.arguments.push_back(ReadArgumentText(item.get_ref<const std::string&>()));
    return;
  }
  if (!item.is_object()) {
    AddValue("", item, call);
    return;
  }
  const json* name = Member(item, {"name", "parameter", "argument"});
  const json* value = Member(item, {"value", "values"});
  if (name != nullptr && name->is_string() && value != nullptr) {
    AddValue(name->get<std::string>(), *value, call);
  } else {
    AddArguments(item, call);
  }
}

void AddArguments(const json& given, WrittenCall& call) {
  if (given.is_object()) {
    for (const auto& [name, value] : given.items()) AddValue(name, value, call);
    return;
  }
  if (given.is_string()) {
    // Arguments as the text of a JSON object, as in tool calls.
    const json inner = json::parse(given.get_ref<const std::string&>(), nullptr, /*allow_exceptions=*/false);
    if (inner.is_structured()) {
      AddArguments(inner, call);
      return;
    }
  }
  if (!given.is_array()) return AddListed(given, call);
  for (const json& item : given) AddListed(item, call);
}

absl::Status AddCall(const json& value, WrittenCalls& read) {
  if (value.is_string()) {
    absl::StatusOr<WrittenCalls> text = ReadCallText(value.get_ref<const std::string&>());
    if (!text.ok()) return text.status();
    for (WrittenCall& call : text->calls) read.calls.push_back(std::move(call));
    if (text->none) read.none = true;
    if (!text->why.empty()) read.why = text->why;
    return absl::OkStatus();
  }
  const bool none = value.is_null() || (value.is_object() && value.empty());
  if (none) read.none = true;
  if (none) return absl::OkStatus();
  const json* function = value.is_object() ? FunctionOf(value) : nullptr;
  const bool named_by_key = function == nullptr && value.is_object() && value.size() == 1;
  if (function == nullptr && !named_by_key) {
    return absl::InvalidArgumentError(
        fmt::format("{} names no function; near(sofa, shelf) or none(why) would be right",
                    llm::Quoted(value.dump(-1, ' ', false, json::error_handler_t::replace))));
  }
  WrittenCall call;
  call.function = named_by_key ? value.begin().key() : function->get<std::string>();
  if (named_by_key) {
    AddArguments(value.front(), call);
  } else {
    const json* arguments = Member(value, {"arguments", "args", "parameters", "params"});
    if (arguments != nullptr) AddArguments(*arguments, call);
    for (const auto& [key, member] : value.items()) {
      if (&member == function || &member == arguments) continue;
      if (llm::Bare(key) == "kwargs") {
        AddArguments(member, call);
      } else if (arguments == nullptr) {
        AddValue(key, member, call);
      }
    }
  }
  if (llm::Bare(call.function) == "none") {
    read.none = true;
    if (!call.arguments.empty() && !call.arguments[0].values.empty()) read.why = call.arguments[0].values[0];
    return absl::OkStatus();
  }
  read.calls.push_back(std::move(call));
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<WrittenCalls> ReadCallJson(std::string_view text) {
  const json value = json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (value.is_discarded()) {
    return absl::InvalidArgumentError(
        fmt::format("{} is no call; one such as near(sofa, shelf) or none(why) would be right", llm::Quoted(text)));
  }
  WrittenCalls read;
  if (!value.is_array()) {
    if (absl::Status status = AddCall(value, read); !status.ok()) return status;
    return read;
  }
  read.none = value.empty();
  for (const json& item : value) {
    if (read.calls.size() >= kMostCalls) break;
    if (item.is_array()) continue;
    if (absl::Status status = AddCall(item, read); !status.ok()) return status;
  }
  return read;
}

}  // namespace flair::translator
