// SPDX-License-Identifier: GPL-3.0-or-later
// Answers that give their lengths in another unit than the metres that were asked for, throughout and without saying
// so.
#pragma once

#include <google/protobuf/message.h>

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "llm/answers/choices.h"
#include "llm/answers/fault.h"

namespace flair::llm {

struct LengthUnit {
  std::string_view name;
  double metres = 1;
};

inline constexpr std::array<LengthUnit, 4> kLengthUnits = {
    {{"centimetres", 0.01}, {"millimetres", 0.001}, {"inches", 0.0254}, {"feet", 0.3048}}};

// How the lengths of an answer, read in some unit, go with what they are lengths of.
struct LengthEvidence {
  // Of things whose usual lengths are known.
  int known = 0;
  // Those of them that are usual.
  int plausible = 0;

  void Add(const LengthEvidence& other) {
    known += other.known;
    plausible += other.plausible;
  }
};

using LengthJudge = std::function<LengthEvidence(const google::protobuf::Message&)>;

// The one unit in which the lengths make sense; null when it is metres or not clear. It takes four known lengths, of
// which at most a third is plausible in metres, four fifths are in that unit, and less than half in any other.
// `in_units` as kLengthUnits.
const LengthUnit* ClearUnit(const LengthEvidence& in_metres,
                            std::span<const LengthEvidence, kLengthUnits.size()> in_units);

// An answer read in its unit.
struct UnitReading {
  const LengthUnit* unit = nullptr;
  std::unique_ptr<google::protobuf::Message> answer;
  std::vector<Fault> faults;
};

// Reads an answer in its ClearUnit, by what `judge` says of it in each; nothing (no unit) when there is none.
// The content of `type` is not looked at.
UnitReading ReadInClearUnit(std::string_view answer, const FieldChoices& choices, const google::protobuf::Message& type,
                            const LengthJudge& judge);

}  // namespace flair::llm
