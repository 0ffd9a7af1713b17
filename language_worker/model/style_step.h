// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/style_answers.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "language_worker/model/model_tools.h"

namespace flair::language {

// What the style step is given.
struct StyleRequest {
  const v1::Brief& brief;
  const v1::Room& room;
  const v1::ObjectList& objects;
};

// Step C iv with a model. What the model says nothing of gets the handbook's look, with a remark. Errors as
// Conversation::Ask.
absl::StatusOr<v1::StyleSheet> AskStyle(const StyleRequest& request, const ModelTools& tools,
                                        llm::Conversation& conversation);

// What is wrong with an answer that reads well: colours that are none, hardly anything described.
std::vector<llm::Fault> CheckStyle(const StyleRequest& request, const ModelTools& tools,
                                   const model::v1::StyleAnswer& answer);

}  // namespace flair::language
