// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/grammar/rules/space.h"

#include <algorithm>
#include <utility>

#include "translator_worker/grammar/sides.h"

namespace flair::translator {
namespace {

// People get at what is longer than wide from a long side, at everything else from the front.
std::string UsualSide(const Placed& placed, Composer& composer) {
  constexpr double kMuchLonger = 1.25;
  const v1::Object& object = composer.object(placed.object);
  return composer.IsBed(placed) || object.depth_m() > kMuchLonger * object.width_m() ? "side" : "front";
}

// "One side is accessible": the usual one, unless another side of the object is named beside it.
void ChooseOpenSides(std::vector<Placed>& placed, Composer& composer) {
  for (Placed& one : placed) {
    const bool alone = std::none_of(placed.begin(), placed.end(), [&](const Placed& other) {
      return &other != &one && other.object == one.object && !other.side.empty();
    });
    if (one.side == "side" && alone) one.side = UsualSide(one, composer);
    if (one.side == "two_any" && alone && UsualSide(one, composer) == "side") one.side = "sides";
  }
}

}  // namespace

void KeepSpaceAt(const Placed& placed, const std::vector<std::string>& sides, const Distance* distance,
                 Composer& composer) {
  Call call = Call("accessible").Text("object", composer.id(placed)).Texts("sides", sides);
  if (distance != nullptr) call.Number("min_clearance_m", distance->Nominal());
  composer.EmitFirst({std::move(call)});
}

void KeepSpace(std::vector<Placed> placed, const Distance* distance, Composer& composer) {
  ChooseOpenSides(placed, composer);
  std::vector<int> done;
  for (const Placed& first : placed) {
    if (std::find(done.begin(), done.end(), first.object) != done.end()) continue;
    done.push_back(first.object);
    std::vector<std::string> sides;
    for (const Placed& other : placed) {
      if (other.object != first.object) continue;
      for (const std::string& side : SidesOf(composer, other)) {
        if (std::find(sides.begin(), sides.end(), side) == sides.end()) sides.push_back(side);
      }
    }
    if (sides.empty()) sides = {"front"};
    KeepSpaceAt(first, sides, distance, composer);
  }
}

bool KeepsOwnSides(const Mention* mover, const Mention& place, Composer& composer) {
  const Reference& reference = place.references.front();
  const std::string& side = reference.side;
  const bool several = side == "sides" || side == "all" || side == "opposite_two" || side.ends_with("both");
  const bool own = reference.kind == RefKind::kPronoun && reference.name.empty();
  // "5 cm on each side and at the back": as much there.
  const bool more = own && mover == nullptr && composer.topic().size() == 1 && !composer.calls().empty() &&
                    composer.calls().back().type == "accessible" && composer.scope() == v1::SENTENCE_SCOPE_INTRA;
  if (more && composer.AddSides(SidesOf(composer, {composer.topic().front().object, side}))) return true;
  if (mover != nullptr || !own || !several || composer.scope() != v1::SENTENCE_SCOPE_INTRA) return false;
  std::vector<Placed> sided;
  for (const Placed& placed : composer.topic()) sided.push_back({placed.object, side});
  KeepSpace(std::move(sided), nullptr, composer);
  return true;
}

void KeepUsableSpace(const Distance* distance, Composer& composer) {
  for (const Placed& placed : composer.topic()) {
    const bool pulled_out = composer.IsChair(placed) && !composer.object(placed.object).name().ends_with("armchair");
    const std::string side = pulled_out ? "back" : composer.IsBed(placed) ? "side" : "front";
    KeepSpace({{placed.object, side}}, distance, composer);
  }
}

}  // namespace flair::translator
