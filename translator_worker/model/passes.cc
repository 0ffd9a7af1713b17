// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/model/passes.h"

#include <algorithm>
#include <string>

namespace flair::translator {
namespace {

using Families = std::vector<std::string_view>;

const Families& FamiliesOf(v1::SentenceScope scope) {
  static const Families intra = {"wall", "feature", "space", "room"};
  static const Families inter = {"pair", "group", "space", "wall"};
  static const Families tertiary = {"rug", "surface", "on_wall", "ceiling", "wall", "pair"};
  return scope == v1::SENTENCE_SCOPE_INTRA ? intra : (scope == v1::SENTENCE_SCOPE_INTER ? inter : tertiary);
}

bool IsOurs(std::string_view family) {
  static const Families ours = {"wall",  "feature", "space",   "room",    "pair",
                                "group", "rug",     "surface", "on_wall", "ceiling"};
  return std::find(ours.begin(), ours.end(), family) != ours.end();
}

}  // namespace

std::vector<const v1::ConstraintType*> TypesFor(const Pass& pass, const v1::ConstraintCatalog& catalog) {
  const Families& families = FamiliesOf(pass.scope);
  std::vector<const v1::ConstraintType*> types;
  for (const v1::ConstraintType& type : catalog.types()) {
    if (type.built_in()) continue;
    const bool wanted = std::find(families.begin(), families.end(), type.family()) != families.end();
    if (wanted || !IsOurs(type.family())) types.push_back(&type);
  }
  return types;
}

}  // namespace flair::translator
