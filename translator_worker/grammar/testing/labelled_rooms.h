// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "flair/v1/translator_service.pb.h"
#include "nlohmann/json.hpp"

namespace flair::translator {

// One labelled sentence. Each part of it (a fact, or something to refuse) has accepted alternatives, each a list of
// calls [type, {parameter: value}]; a part to refuse has none.
struct LabelledSentence {
  v1::Sentence sentence;
  std::vector<nlohmann::json> parts;
};

// A room with the sentences that a model wrote about it, labelled by hand.
struct LabelledRoom {
  std::string name;
  bool held_out = false;
  v1::TranslateRequest request;  // without sentences
  std::vector<LabelledSentence> sentences;
};

// Reads labelled_rooms.jsonl: a line with "room" begins a room, the lines after it are its sentences.
std::vector<LabelledRoom> ReadLabelledRooms(const std::string& path);

// Reads a catalogue in text form.
v1::ConstraintCatalog ReadCatalog(const std::string& path);

}  // namespace flair::translator
