// SPDX-License-Identifier: GPL-3.0-or-later
// Problems from bytes: rooms, objects, edges of every constraint type, pins and options, mostly good, at times just
// outside what is allowed.
#pragma once

#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/optimizer_service.pb.h"
#include "tests/fuzz/byte_source.h"

namespace flair::fuzz {

// One more object or edge, of any kind; mostly of things that are there.
void AddRandomObject(ByteSource& bytes, v1::LayoutGraph& graph);
void AddRandomEdge(ByteSource& bytes, v1::LayoutGraph& graph);

// A number that nobody should send: not finite, negative, very small or very large.
double Nasty(ByteSource& bytes);

v1::LayoutGraph RandomGraph(ByteSource& bytes);

// Few restarts and evaluations, whatever the bytes say.
v1::SolveOptions RandomOptions(ByteSource& bytes);

}  // namespace flair::fuzz
