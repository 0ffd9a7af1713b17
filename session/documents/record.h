// SPDX-License-Identifier: GPL-3.0-or-later
// What the files of Documents share: no business of those who call it.
#pragma once

#include <google/protobuf/util/time_util.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "absl/time/clock.h"
#include "absl/time/time.h"
#include "flair/store/v1/document_record.pb.h"
#include "flair/v1/artifact.pb.h"
#include "flair/v1/layout_edit.pb.h"
#include "flair/v1/studio_service.pb.h"

namespace flair::session {

inline constexpr size_t kMostTitleLetters = 200;
// What a room is called that nobody has named.
inline constexpr char kOwnRoom[] = "Own room";

inline google::protobuf::Timestamp NowProto() {
  return google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(absl::ToUnixMicros(absl::Now()));
}

// As much of a text as a title holds.
inline std::string TitleOf(const std::string& text) {
  size_t most = kMostTitleLetters;
  if (text.size() <= most) return text;
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80) --most;
  return text.substr(0, most);
}

// What callers see of a record. A room that is called by its brief is called by the one that it was furnished for last.
inline v1::Document DocumentOf(const store::v1::DocumentRecord& record) {
  v1::Document document = record.document();
  if (record.states().empty()) return document;
  document.set_variants_layout_id(record.variants_layout_id());
  const int at = record.position();
  for (int i = at; i >= 0; --i) {
    if (!record.states(i).has_brief()) continue;
    const bool by_brief = document.has_brief() && document.title() == TitleOf(document.brief().text());
    *document.mutable_brief() = record.states(i).brief();
    if (by_brief) document.set_title(TitleOf(document.brief().text()));
    break;
  }
  document.set_layout_id(record.states(at).layout_id());
  const auto& pending = record.states(at).pending_edits();
  document.set_unsettled(std::ranges::any_of(pending, [](const v1::LayoutEdit& edit) {
    return edit.pin_object_id().empty() && edit.unpin_object_id().empty();
  }));
  if (at > 0) document.set_undo_label(record.states(at).label());
  if (at + 1 < record.states_size()) document.set_redo_label(record.states(at + 1).label());
  return document;
}

// What the renderer is asked to draw. It wants a piece: an empty room gets one that stands nowhere, which is left out.
v1::SolvedLayout Drawable(const v1::SolvedLayout& layout);

inline v1::Artifact ArtifactOf(v1::SolvedLayout layout, const v1::Producer& producer, const std::string& made_from) {
  v1::Artifact artifact;
  if (!made_from.empty()) artifact.add_made_from_ids(made_from);
  *artifact.mutable_producer() = producer;
  artifact.mutable_solved_layout()->Swap(&layout);
  return artifact;
}

}  // namespace flair::session
