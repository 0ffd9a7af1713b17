// SPDX-License-Identifier: GPL-3.0-or-later
// For tests: answers to read, and what was said of them.
#pragma once

#include <string>
#include <vector>

#include "llm/answers/read_answer.h"

namespace flair::llm {

inline const FieldChoices kZones = {
    {"flair.model.v1.FloorObjectAnswer.zone", {{"sleeping", "floor work"}, {{"bed", "sleeping"}}}}};

inline std::vector<std::string> Sentences(const std::vector<Fault>& faults) {
  std::vector<std::string> sentences;
  for (const Fault& fault : faults) sentences.push_back(fault.Sentence());
  return sentences;
}

// One object of the floor with a member more or instead.
inline std::string Object(const std::string& members) {
  return R"({"objects":[{"name":"bed","zone":"sleeping","primary":true,"count":1,"width_m":1.6,"depth_m":2,)"
         R"("height_m":0.5,"description":null,"requested":false)" +
         (members.empty() ? "" : "," + members) + "}],\"left_out\":[]}";
}

}  // namespace flair::llm
