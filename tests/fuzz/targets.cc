// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/targets.h"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace flair::fuzz {

std::span<const Target> AllTargets() {
  static constexpr std::array<Target, 7> kTargets = {{{"read_graph", ReadGraph},
                                                      {"solve_problem", SolveProblem},
                                                      {"edit_layout", EditLayout},
                                                      {"read_reference_room", ReadReferenceRoom},
                                                      {"read_scene_text", ReadSceneText},
                                                      {"read_model_answer", ReadModelAnswer},
                                                      {"model_step", ModelStep}}};
  return kTargets;
}

void Require(bool holds, std::string_view promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

}  // namespace flair::fuzz
