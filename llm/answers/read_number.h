// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of a model's answer.
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "llm/answers/fault.h"
#include "llm/answers/length_unit.h"

namespace flair::llm {

// A value as a fault shows it, short.
std::string Shown(const nlohmann::json& value);

// A number, also as a text, without a unit of its own.
std::optional<double> PlainNumber(const nlohmann::json& value);

// A text that says that there is nothing: "N/A".
bool SaysNothing(const nlohmann::json& value);
bool SaysNothing(std::string_view text);

// The number of a field, with or without a unit, in the field's own; nothing, and a fault, when it is none that the
// field may have. Lengths without a unit are in `bare_unit`, or metres when that is null; then numbers beyond all
// metres are taken as centimetres or millimetres, with a fault that is doubtful.
std::optional<double> ReadNumber(const nlohmann::json& value, const google::protobuf::FieldDescriptor& field,
                                 const std::string& path, const LengthUnit* bare_unit, std::vector<Fault>& faults);

}  // namespace flair::llm
