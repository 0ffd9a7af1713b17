// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::language {

// A room that was recorded when the paper's authors designed it with a model: what the model was asked for, room and
// objects as numbers, and the texts that it wrote.
struct RecordedRoom {
  v1::Brief brief;
  // Room, zones and objects; its edges are the calls that the model translated its own sentences to. Objects have the
  // ids of evaluation::ReadFlairGptRoom and heights that stand for none.
  v1::LayoutGraph graph;
  // Of the file, 8 hex digits.
  std::string digest;
  // By name: "primary_intra", "secondary_inter_clean", "style" and so on.
  std::map<std::string, std::string, std::less<>> texts;

  // Empty when there is none of that name.
  std::string_view Text(std::string_view name) const;
  // Furniture on the floor: what is no tertiary.
  std::vector<const v1::Object*> FloorObjects() const;
  std::vector<const v1::Object*> Tertiaries() const;
};

// Reads the JSON of one. INVALID_ARGUMENT, naming the field, when it is none, when it is larger than 10 MB, or when its
// prompt is no brief.
absl::StatusOr<RecordedRoom> ReadRecordedRoom(const std::string& json);

// A line that has no place in a typed answer.
struct ConversionRemark {
  // Name of the text, such as "secondary_inter".
  std::string source;
  // Counted from 1; 0 when it is about no line.
  int line = 0;
  std::string text;
  std::string reason;
};

// What becomes of the lines of recorded texts. Nothing is lost without a word: a line is converted, frames the others,
// or is kept here with the reason.
struct Conversion {
  // Lines that say something, that is all but headings and what frames a list ("Certainly! Here is ...").
  int lines = 0;
  // Of them, those that are in an answer.
  int converted = 0;
  std::vector<ConversionRemark> remarks;

  void Convert() {
    ++lines;
    ++converted;
  }
  void Keep(std::string_view source, int line, std::string text, std::string reason) {
    ++lines;
    remarks.push_back({std::string(source), line, std::move(text), std::move(reason)});
  }
  // A sentence of a converted line has no place after all.
  void Unconvert(std::string_view source, std::string text, std::string reason) {
    if (converted > 0) --converted;
    remarks.push_back({std::string(source), 0, std::move(text), std::move(reason)});
  }
  void Add(const Conversion& other) {
    lines += other.lines;
    converted += other.converted;
    remarks.insert(remarks.end(), other.remarks.begin(), other.remarks.end());
  }
};

}  // namespace flair::language
