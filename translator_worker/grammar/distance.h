// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace flair::translator {

// A length as a sentence states it, metres. "At least 0.6 m" has only a least value, "0.3 to 1 m" both, a plain "0.4 m"
// both and `exact`.
struct Distance {
  std::optional<double> min_m;
  std::optional<double> max_m;
  bool exact = false;

  // The one figure that stands for it: the least value when there is one.
  double Nominal() const { return min_m ? *min_m : max_m.value_or(0); }
};

}  // namespace flair::translator
