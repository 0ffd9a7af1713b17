// SPDX-License-Identifier: GPL-3.0-or-later
// What checks send: a small bedroom that every server must cope with.
#pragma once

#include <string>
#include <string_view>

#include "flair/v1/brief.pb.h"
#include "flair/v1/job.pb.h"
#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "flair/v1/solved_layout.pb.h"
#include "flair/v1/translator_service.pb.h"

namespace flair::contract {

// "A bedroom that is 4m x 5m.", seed 3.
v1::Brief BedroomBrief();

// A job of it that is quickly done.
v1::JobSpec BedroomJob();

// 4 m x 5 m with a door in the south; a bed (primary) and a nightstand in the zone "sleeping"; one sentence about each,
// "s1" and "s2"; no edges.
v1::LayoutGraph BedroomGraph();

// Solve of the bedroom with seed 5, and how reports call it.
v1::SolveRequest BedroomSolve();
inline constexpr char kBedroomSolve[] = "Solve of a small bedroom";

// Restarts of its primary stage, with seed 5.
v1::SolveRestartsRequest BedroomRestarts(int first, int count);

// The bed at (2, 0.5), half a metre of it outside the room.
v1::EvaluateRequest BedroomEvaluate();

// Its two sentences with the catalogue of Flair's optimizer.
v1::TranslateRequest BedroomTranslate();

// The bedroom with the bed in the middle, for renderers.
v1::SolvedLayout BedroomLayout();

// A graph from a text as in room/text_format/scene_text.h; every object needs a zone and a height there.
v1::LayoutGraph GraphFromText(std::string_view scene);

// An edge "e1" of weight 1 whose first argument is the object.
v1::ConstraintEdge EdgeOn(const std::string& type, const std::string& parameter, const std::string& object_id);

}  // namespace flair::contract
