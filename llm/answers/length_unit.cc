// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/length_unit.h"

#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

constexpr int kFewestKnown = 4;

bool NotInMetres(const LengthEvidence& in_metres) {
  return in_metres.known >= kFewestKnown && 3 * in_metres.plausible <= in_metres.known;
}

}  // namespace

const LengthUnit* ClearUnit(const LengthEvidence& in_metres,
                            std::span<const LengthEvidence, kLengthUnits.size()> in_units) {
  if (!NotInMetres(in_metres)) return nullptr;
  const LengthUnit* clear = nullptr;
  for (size_t i = 0; i < kLengthUnits.size(); ++i) {
    if (2 * in_units[i].plausible < in_units[i].known) continue;
    const bool fits = in_units[i].known >= kFewestKnown && 5 * in_units[i].plausible >= 4 * in_units[i].known;
    if (clear != nullptr || !fits) return nullptr;
    clear = &kLengthUnits[i];
  }
  return clear;
}

UnitReading ReadInClearUnit(std::string_view answer, const FieldChoices& choices, const google::protobuf::Message& type,
                            const LengthJudge& judge) {
  const auto read_in = [&](const LengthUnit& unit) {
    UnitReading reading{&unit, std::unique_ptr<google::protobuf::Message>(type.New()), {}};
    reading.faults = ReadAnswer(answer, choices, *reading.answer, &unit);
    return reading;
  };
  constexpr LengthUnit kMetres = {"metres", 1};
  const LengthEvidence in_metres = judge(*read_in(kMetres).answer);
  if (!NotInMetres(in_metres)) return {};
  std::array<UnitReading, kLengthUnits.size()> readings;
  std::array<LengthEvidence, kLengthUnits.size()> in_units;
  for (size_t i = 0; i < kLengthUnits.size(); ++i) {
    readings[i] = read_in(kLengthUnits[i]);
    in_units[i] = judge(*readings[i].answer);
  }
  const LengthUnit* const unit = ClearUnit(in_metres, in_units);
  if (unit == nullptr) return {};
  return std::move(readings[static_cast<size_t>(unit - kLengthUnits.data())]);
}

}  // namespace flair::llm
