// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/contract/ask.h"
#include "flair/v1/layout_graph.pb.h"

namespace flair::contract {

// Each makes a bad problem of BedroomGraph().
const std::vector<Fault<v1::LayoutGraph>>& GraphFaults();

// GraphFaults of the graph in another message: `graph_of` is such as &v1::SolveRequest::mutable_layout_graph.
template <typename Request>
std::vector<Fault<Request>> GraphFaultsIn(v1::LayoutGraph* (Request::*graph_of)()) {
  std::vector<Fault<Request>> faults;
  for (const Fault<v1::LayoutGraph>& fault : GraphFaults()) {
    faults.push_back({fault.what, fault.field,
                      [graph_of, spoil = fault.spoil](Request& request) { spoil(*(request.*graph_of)()); }});
  }
  return faults;
}

}  // namespace flair::contract
