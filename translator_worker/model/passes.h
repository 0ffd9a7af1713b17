// SPDX-License-Identifier: GPL-3.0-or-later
// The three passes of the translation (the paper's section on translation): intra, inter, tertiary.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "flair/v1/constraint_catalog.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/translator_service.pb.h"

namespace flair::translator {

struct Pass {
  v1::SentenceScope scope;
  // Name of the step, such as "translation.intra".
  std::string_view step;
  // Told to the model.
  std::string_view task;
};

inline constexpr std::array<Pass, 3> kPasses = {
    {{v1::SENTENCE_SCOPE_INTRA, "translation.intra", "These sentences are about one object and the room."},
     {v1::SENTENCE_SCOPE_INTER, "translation.inter", "These sentences are about objects among each other."},
     {v1::SENTENCE_SCOPE_TERTIARY, "translation.tertiary",
      "These sentences say where small things, rugs, lamps and wall pieces go."}}};

// The types that a pass is told of: those of the families that its sentences speak of, and of every family that is not
// one of ours, in the order of the catalogue, as far as the room has something to call them with: no lamps without a
// ceiling lamp. None is built in.
std::vector<const v1::ConstraintType*> TypesFor(const Pass& pass, const v1::TranslateRequest& request);

}  // namespace flair::translator
