// SPDX-License-Identifier: GPL-3.0-or-later
// Problems from bytes: rooms, objects, edges of every constraint type, pins and options, mostly good, at times just
// outside what is allowed.
#pragma once

#include <cstdint>
#include <string_view>

#include "flair/v1/layout_graph.pb.h"
#include "flair/v1/optimizer_service.pb.h"

namespace flair::fuzz {

// Bytes as choices: whatever they are, they are a sequence of valid picks. Ends in zeros.
class ByteSource {
 public:
  // Borrows the bytes.
  explicit ByteSource(std::string_view bytes) : bytes_(bytes) {}

  uint8_t Byte() {
    if (next_ >= bytes_.size()) return 0;
    return static_cast<uint8_t>(bytes_[next_++]);
  }

  bool empty() const { return next_ >= bytes_.size(); }

  // 0 to count - 1; count is 1 to 256.
  int Below(int count) { return Byte() % count; }

  // Once in `one_in` bytes.
  bool Rarely(int one_in) { return Byte() % one_in == one_in - 1; }

  // In [least, most], in steps that two bytes can tell apart.
  double Between(double least, double most) {
    const int high = Byte();
    return least + (most - least) * (256 * high + Byte()) / 65535;
  }

 private:
  std::string_view bytes_;
  size_t next_ = 0;
};

// One more object or edge, of any kind; mostly of things that are there.
void AddRandomObject(ByteSource& bytes, v1::LayoutGraph& graph);
void AddRandomEdge(ByteSource& bytes, v1::LayoutGraph& graph);

// A number that nobody should send: not finite, negative, very small or very large.
double Nasty(ByteSource& bytes);

v1::LayoutGraph RandomGraph(ByteSource& bytes);

// Few restarts and evaluations, whatever the bytes say.
v1::SolveOptions RandomOptions(ByteSource& bytes);

}  // namespace flair::fuzz
