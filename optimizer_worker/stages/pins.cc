// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/stages/pins.h"

namespace flair::optimizer {

PartialLayout StartOf(const SolveInput& input) {
  PartialLayout start(input.scene);
  for (const Pin& pin : input.pins) start.Place(pin.object, pin.pose);
  return start;
}

StageSpec FreeStage(const SolveInput& input, StageKind kind, int zone) {
  StageSpec stage = MakeStage(input.scene, kind, zone);
  std::erase_if(stage.objects, [&input](int object) { return input.pinned[object] != 0; });
  return stage;
}

}  // namespace flair::optimizer
