// SPDX-License-Identifier: GPL-3.0-or-later
// Artifacts as bytes and as text; the same artifact gives the same bytes.
#pragma once

#include <google/protobuf/duration.pb.h>
#include <google/protobuf/timestamp.pb.h>

#include <string>

#include "flair/v1/artifact.pb.h"
#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::cli {

// Deterministic binary form, with the id.
std::string ArtifactBytes(const v1::Artifact& artifact);
// Proto JSON with the field names of the .proto files, indented, ending in a newline.
std::string ToJson(const google::protobuf::Message& message);
// The same on one line, without the newline.
std::string ToJsonLine(const google::protobuf::Message& message);
// Protobuf text format.
std::string ToText(const google::protobuf::Message& message);

// File name without extension: "zones", "layout"; empty for kinds that the output folder does not hold.
std::string FileStem(v1::ArtifactKind kind);
// The stage that makes artifacts of a kind, see JobEvent.stage, such as "solve"; empty for none.
std::string StageOf(v1::ArtifactKind kind);
// Kind for people, such as "zone plan".
std::string KindName(v1::ArtifactKind kind);

// Graphs and layouts that no job made, as artifact files.

// A layout or a graph as the bytes of an artifact with its id, made by `flair` of the given build and, as the
// producer's method, by the command given.
std::string LayoutArtifactBytes(const v1::SolvedLayout& layout, const std::string& command, const std::string& build);
std::string GraphArtifactBytes(const v1::LayoutGraph& graph, const std::string& command, const std::string& build);

// "bed", "[left, right]", "0.6" or "true"; "?" when unset.
std::string ValueText(const v1::ArgumentValue& value);

// A call as it is written: "against_wall(object=bed, side=back)".
std::string CallText(const std::string& type, const google::protobuf::RepeatedPtrField<v1::Argument>& arguments);

// The same, with " x 3" when it weighs 3.
std::string CallText(const v1::ConstraintEdge& edge);

double SecondsOf(const google::protobuf::Duration& duration);
// "2026-05-21 13:45:01" in local time.
std::string LocalTimeText(const google::protobuf::Timestamp& time);

// A constraint catalogue for people.

// All types by family: formula, parameters with range and default, sentences with the calls they mean.
// docs/constraints.md is this text.
std::string CatalogMarkdown(const v1::ConstraintCatalog& catalog);
// One type for the terminal.
std::string TypeText(const v1::ConstraintType& type);
// A line per type that a translator may call: name and summary.
std::string CatalogOverview(const v1::ConstraintCatalog& catalog);

}  // namespace flair::cli
