// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "absl/status/statusor.h"
#include "flair/model/v1/room_answers.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/room.pb.h"
#include "language_worker/handbook/reading/size_phrase.h"
#include "language_worker/model/model_tools.h"

namespace flair::language {

// Step A with a model: floor, openings and sockets for the brief. A size that the brief gives in numbers holds whatever
// the model answers. INVALID_ARGUMENT for a size that no room can have; else as Conversation::Ask.
absl::StatusOr<v1::Room> AskRoom(const v1::Brief& brief, const ModelTools& tools, llm::Conversation& conversation);

// What is wrong with an answer that reads well, given the size that the brief asks for.
std::vector<llm::Fault> CheckRoom(const SizeRequest& size, model::v1::RoomAnswer& answer);

// The room of an answer from which what CheckRoom found wrong has been left out.
v1::Room ToRoom(const v1::Brief& brief, const SizeRequest& size, const model::v1::RoomAnswer& answer);

}  // namespace flair::language
