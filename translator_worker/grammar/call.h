// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "flair/v1/constraint_catalog.pb.h"

namespace flair::translator {

// A call under construction: Call("near").Text("object", id).Number("max_distance_m", 0.5).
struct Call {
  explicit Call(std::string type_name) : type(std::move(type_name)) {}

  std::string type;
  std::vector<v1::Argument> arguments;

  Call&& Text(const std::string& name, const std::string& value) {
    Add(name).set_text(value);
    return std::move(*this);
  }
  Call&& Texts(const std::string& name, const std::vector<std::string>& values) {
    v1::TextList& list = *Add(name).mutable_texts();
    for (const std::string& value : values) list.add_items(value);
    return std::move(*this);
  }
  Call&& Number(const std::string& name, double value) {
    Add(name).set_number(value);
    return std::move(*this);
  }
  Call&& Flag(const std::string& name, bool value) {
    Add(name).set_flag(value);
    return std::move(*this);
  }

  // The argument of that name; null when it has none.
  const v1::ArgumentValue* Find(std::string_view name) const {
    for (const v1::Argument& argument : arguments) {
      if (argument.name() == name) return &argument.value();
    }
    return nullptr;
  }
  const std::string& TextOf(std::string_view name) const {
    const v1::ArgumentValue* const value = Find(name);
    return value != nullptr ? value->text() : v1::ArgumentValue::default_instance().text();
  }

 private:
  v1::ArgumentValue& Add(const std::string& name) {
    v1::Argument& argument = arguments.emplace_back();
    argument.set_name(name);
    return *argument.mutable_value();
  }
};

}  // namespace flair::translator
