// SPDX-License-Identifier: GPL-3.0-or-later
// Uses met: whether one can use the pieces as one uses them. What a use is, is said by sentences (Sentence.use, and
// those of origin IMPLIED); whether it is met, by the outcomes of their calls. A sentence whose pieces are not all
// placed is no use; one that no call was made of, or of which a call does not hold, is not met.
#pragma once

#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/layout_metrics.pb.h"
#include "flair/v1/solved_layout.pb.h"

namespace flair::evaluation {

// Counts the uses and adds a finding for each that is not met, in the order of the sentences. `outcomes` holds one per
// edge of the graph, in its order.
void AddUses(const v1::LayoutGraph& graph, const google::protobuf::RepeatedPtrField<v1::Placement>& placements,
             const google::protobuf::RepeatedPtrField<v1::EdgeOutcome>& outcomes, v1::LayoutMetrics& metrics);

}  // namespace flair::evaluation
