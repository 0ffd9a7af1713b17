// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>
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

}  // namespace flair::language
