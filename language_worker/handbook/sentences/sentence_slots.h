// SPDX-License-Identifier: GPL-3.0-or-later
// What the placeholders of a sentence stand for: words, and what those mean.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "flair/v1/constraint_list.pb.h"

namespace flair::language {

// A placeholder filled in.
struct Slot {
  std::string words;
  // Empty for what is read as it is written: "left", "0.9 m".
  std::vector<v1::Participant> means;
};

// By the placeholder's name, "object".
using Slots = std::map<std::string, Slot, std::less<>>;

// One object or zone as a participant.
v1::Participant ObjectWithId(const std::string& id);
v1::Participant ZoneWithId(const std::string& id);

// The template with the slots' words.
std::string FillSlots(std::string_view sentence_template, const Slots& slots);

// What a sentence of the template means, the slots being what they are; without facts where the frames of english/ do
// not tell all of it. The template is read with a name in the place of every slot that means something, so that no
// object is taken for another whatever it is called. `text` is the sentence as it is written.
v1::Meaning MeaningOf(std::string_view sentence_template, const Slots& slots, std::string_view text);

}  // namespace flair::language
