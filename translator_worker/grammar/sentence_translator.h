// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "flair/v1/translator_service.pb.h"
#include "translator_worker/catalog/catalog_index.h"
#include "translator_worker/grammar/call.h"
#include "translator_worker/grammar/scene_names.h"

namespace flair::translator {

// What became of a sentence: calls, or remarks that say why there are none, or both.
struct Translation {
  std::vector<Call> calls;
  std::vector<v1::Diagnostic> diagnostics;
  // Factor of the sentence's weight: a half for wishes ("ideally").
  double weight_factor = 1;
};

// Translates one sentence. Reads it from left to right: at each term the rule that covers most is taken; what no rule
// covers is left over. Linear in the length of the sentence. Never without calls and without diagnostics.
Translation TranslateSentence(const v1::TranslateRequest& request, const SceneNames& names, const CatalogIndex& catalog,
                              const v1::Sentence& sentence);

}  // namespace flair::translator
