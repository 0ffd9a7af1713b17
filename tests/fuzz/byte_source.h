// SPDX-License-Identifier: GPL-3.0-or-later
// A fuzzer's bytes as choices: whatever the bytes are, they are a sequence of valid picks. Ends in zeros.
#pragma once

#include <cstdint>
#include <string_view>

namespace flair::fuzz {

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

}  // namespace flair::fuzz
