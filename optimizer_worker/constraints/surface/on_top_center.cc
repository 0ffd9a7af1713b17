// SPDX-License-Identifier: GPL-3.0-or-later
#include "optimizer_worker/constraints/surface/on_top_center.h"

#include "optimizer_worker/autodiff/smooth.h"
#include "optimizer_worker/constraints/facts.h"

namespace flair::optimizer {

template <typename T>
T OnTopCenter::operator()(const Frames<T, 2>& frames) const {
  return SquaredNorm(frames[0].center - frames[1].center) + Turn(frames[0].front, frames[1].front);
}

ConstraintFacts OnTopCenterFacts() {
  return {.name = "on_top_center",
          .aliases = {"on_top_central"},
          .family = "surface",
          .summary = "`object` stands on the middle of `host`, facing the same way.",
          .doc = "cost = squared distance of the centres + (1 - cos of the difference of headings) [m2].",
          .parameters = {ObjectParameter("object", "What is set down."), ObjectParameter("host", "What carries it.")},
          .sentences = {{"A lamp stands on the nightstand.", "object=lamp host=nightstand"}},
          .layouts = {Satisfied("5x4 room; desk 1.2x0.6 at 2,2,90; lamp 0.2x0.2 at 2,2,90 surface on desk",
                                "object=lamp host=desk"),
                      Violated("5x4 room; desk 1.2x0.6 at 2,2,90; lamp 0.2x0.2 at 2.1,2.3,40 surface on desk",
                               "object=lamp host=desk")},
          .bind = [](const Arguments& a, const BindContext& context) -> absl::StatusOr<std::unique_ptr<Cost>> {
            return MakeCost(OnTopCenter{}, {a.Object("object"), a.Object("host")});
          }};
}

}  // namespace flair::optimizer
