// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a model's answer, precisely enough to be told to the model and to a person.
#pragma once

#include <google/protobuf/message.h>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flair::llm {

// What becomes of a fault.
enum class FaultKind {
  // The meaning was certain; taken so, and not worth another call.
  kMended,
  // Asked about once; what was read is used when the model stays with it.
  kDoubtful,
  // Asked about once; when it stays, the list element that it is in is left out, or the answer when it is in none.
  kWrong,
};

struct Fault {
  // Where, as in the answer: "objects[3].width_m"; empty for the whole answer.
  std::string path;
  // The value, what is wrong with it and what would be right: "is \"very wide\"; metres, 0.05 to 20".
  std::string text;
  FaultKind kind = FaultKind::kWrong;

  // "objects[3].width_m: is ..."
  std::string Sentence() const;
};

// The value in quotes for a fault's text, at most 60 bytes of it, on one line.
std::string Quoted(std::string_view value);

// The text without what stands between double quotes: for those who do not want words of answers kept.
std::string WithoutQuotations(std::string_view text);

// Removes the list elements that kWrong faults are in (the innermost list of their path) and returns the faults that
// are in no list element, for which the answer as a whole is of no use. Paths are those of `message` before the call.
std::vector<Fault> DropFaulty(std::span<const Fault> faults, google::protobuf::Message& message);

}  // namespace flair::llm
