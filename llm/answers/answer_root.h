// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/descriptor.h>

#include <nlohmann/json_fwd.hpp>

namespace flair::llm {

// The object that a value means for an answer of that type: a list alone is that of the type's only list; an object
// without any of the type's fields is a wrapper of its only member with some. Else the value itself.
nlohmann::json AnswerRoot(const nlohmann::json& value, const google::protobuf::Descriptor& type);

}  // namespace flair::llm
