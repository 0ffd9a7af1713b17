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

bool Any(const v1::ObjectList& list, v1::ObjectKind kind, bool tertiary_only) {
  return std::any_of(list.objects().begin(), list.objects().end(), [&](const v1::Object& object) {
    return object.kind() == kind && (!tertiary_only || object.role() == v1::OBJECT_ROLE_TERTIARY);
  });
}

// Whether a sentence of the pass has the word, in lower case or at its beginning.
bool Says(const v1::TranslateRequest& request, const Pass& pass, std::string_view word_without_first) {
  return std::any_of(request.constraint_list().sentences().begin(), request.constraint_list().sentences().end(),
                     [&](const v1::Sentence& sentence) {
                       return sentence.scope() == pass.scope &&
                              sentence.text().find(word_without_first) != std::string::npos;
                     });
}

// Whether a pass has what the types of a family are about, or speaks of it.
bool HasUseFor(std::string_view family, const Pass& pass, const v1::TranslateRequest& request) {
  const v1::ObjectList& objects = request.object_list();
  if (family == "on_wall") return Any(objects, v1::OBJECT_KIND_WALL, false) || Says(request, pass, "wall");
  if (family == "ceiling") return Any(objects, v1::OBJECT_KIND_CEILING, false) || Says(request, pass, "eiling");
  // Of the small things only those on the floor stand at walls, and only some of them are rugs.
  const bool small_on_floor = Any(objects, v1::OBJECT_KIND_FLOOR, true);
  if (family == "rug") return small_on_floor || Says(request, pass, "rug");
  if (family != "wall" || pass.scope == v1::SENTENCE_SCOPE_INTRA) return true;
  // What stands at a wall by itself is told where objects are told one by one.
  if (pass.scope == v1::SENTENCE_SCOPE_INTER) return Says(request, pass, "wall") || Says(request, pass, "corner");
  return small_on_floor;
}

// Whether there is something for every argument that a type needs.
bool CanBeCalled(const v1::ConstraintType& type, const v1::TranslateRequest& request) {
  int object_count = 0;
  for (const v1::ParameterSpec& parameter : type.parameters()) {
    if (!parameter.required()) continue;
    const v1::ParameterKind kind = parameter.kind();
    object_count += kind == v1::PARAMETER_KIND_OBJECT || kind == v1::PARAMETER_KIND_OBJECTS ? 1 : 0;
    if (kind == v1::PARAMETER_KIND_ZONE && request.zone_plan().zones().empty()) return false;
    if (kind == v1::PARAMETER_KIND_FEATURE && request.room().openings().empty() && request.room().sockets().empty()) {
      return false;
    }
  }
  return object_count <= request.object_list().objects_size();
}

}  // namespace

std::vector<const v1::ConstraintType*> TypesFor(const Pass& pass, const v1::TranslateRequest& request) {
  const Families& families = FamiliesOf(pass.scope);
  std::vector<const v1::ConstraintType*> types;
  for (const v1::ConstraintType& type : request.catalog().types()) {
    if (type.built_in() || !CanBeCalled(type, request)) continue;
    const bool wanted = std::find(families.begin(), families.end(), type.family()) != families.end() &&
                        HasUseFor(type.family(), pass, request);
    if (wanted || !IsOurs(type.family())) types.push_back(&type);
  }
  return types;
}

}  // namespace flair::translator
