// SPDX-License-Identifier: GPL-3.0-or-later
// What decides a gap between two shapes: edge `edge` of one against vertex `vertex` of the other, or two vertices.
#pragma once

namespace flair::optimizer {

struct Witness {
  enum Kind { kEdgeOfFirst, kEdgeOfSecond, kVertices } kind = kEdgeOfFirst;
  // Index of an edge or a vertex of the first and of the second shape.
  int first = 0;
  int second = 0;
  double gap_m = 0;
};

}  // namespace flair::optimizer
