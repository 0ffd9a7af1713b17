// SPDX-License-Identifier: GPL-3.0-or-later
// Every kind of content as a readable summary: headings, lines and tables.
#pragma once

#include <string>

#include "flair/v1/artifact.pb.h"

namespace flair::cli {

struct ContentStyle {
  // Rows of a table before it says how many more there are.
  size_t most_rows = 100;
};

std::string BriefText(const v1::Brief& brief, const ContentStyle& style);
std::string RoomText(const v1::Room& room, const ContentStyle& style);
std::string ZonesText(const v1::ZonePlan& plan, const ContentStyle& style);
// Equal pieces share a row that counts them.
std::string ObjectsText(const v1::ObjectList& list, const ContentStyle& style);
std::string StyleText(const v1::StyleSheet& sheet, const ContentStyle& style);
// The sentences of a list by their scope.
std::string SentencesText(const v1::ConstraintList& list, const ContentStyle& style);
// The same of a cleaned list, after what cleaning did to `raw`: with the words before and after where `raw` is known.
std::string CleanedText(const v1::ConstraintList& list, const v1::ConstraintList* raw, const ContentStyle& style);
// Sentences with their calls.
std::string GraphText(const v1::LayoutGraph& graph, const ContentStyle& style);
// Objects with their poses and verdicts, what costs most, what was dropped and why, and measures.
std::string LayoutText(const v1::SolvedLayout& layout, const ContentStyle& style);
std::string PreviewText(const v1::Preview& preview, const ContentStyle& style);
std::string ReportText(const v1::Report& report, const ContentStyle& style);

// Remarks, each with its severity, code and subject; empty when there are none.
std::string RemarksText(const google::protobuf::RepeatedPtrField<v1::Diagnostic>& remarks, const ContentStyle& style);

// "\nOBJECTS, 18\n".
std::string Heading(const std::string& title);

// An enum's name without what all names of the enum begin with, in lower case: "primary" of OBJECT_ROLE_PRIMARY.
std::string ShortName(const std::string& name, const std::string& prefix);

}  // namespace flair::cli
