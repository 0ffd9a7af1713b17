// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/targets.h"

#include <array>

namespace flair::fuzz {

std::span<const Target> AllTargets() {
  static constexpr std::array<Target, 12> kTargets = {{{"read_graph", ReadGraph},
                                                       {"solve_problem", SolveProblem},
                                                       {"edit_layout", EditLayout},
                                                       {"read_reference_room", ReadReferenceRoom},
                                                       {"read_scene_text", ReadSceneText},
                                                       {"read_model_answer", ReadModelAnswer},
                                                       {"read_reply", ReadReply},
                                                       {"model_step", ModelStep},
                                                       {"read_artifact", ReadArtifact},
                                                       {"select_field", SelectField},
                                                       {"read_asset", ReadAsset},
                                                       {"read_manifest", ReadManifest}}};
  return kTargets;
}

}  // namespace flair::fuzz
