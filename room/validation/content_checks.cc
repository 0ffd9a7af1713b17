// SPDX-License-Identifier: GPL-3.0-or-later
// What is put into a room: objects, styles, constraints, and the catalogue of their types.
#include <cmath>

#include "room/validation/checks.h"

namespace flair::validation {
namespace {

// Two hundred take a solve a minute and a half on one core, and the time grows with more than the square.
constexpr int kMostObjects = 250;
constexpr Range kExtent{.least = 0, .most = 20, .open_least = true};
constexpr Range kHeight{.least = 0, .most = 12, .open_least = true};
constexpr Range kElevation{.least = 0, .most = 12};

void CheckObject(const v1::Object& object, const Known& known, const Field& at) {
  at["name"].Text(object.name(), 1, 200);
  at["role"].Enum(object.role(), v1::ObjectRole_IsValid(object.role()));
  at["kind"].Enum(object.kind(), v1::ObjectKind_IsValid(object.kind()));
  at["width_m"].InRange(object.width_m(), kExtent);
  at["depth_m"].InRange(object.depth_m(), kExtent);
  at["height_m"].InRange(object.height_m(), kHeight);
  at["elevation_m"].InRange(object.elevation_m(), kElevation);
  at["description"].Text(object.description(), 0, 4000);
  at["placement"].Text(object.placement(), 0, 4000);
  if (!object.category().empty()) at["category"].Id(object.category());
  const bool standing = object.role() == v1::OBJECT_ROLE_PRIMARY || object.role() == v1::OBJECT_ROLE_SECONDARY;
  if (standing && object.kind() != v1::OBJECT_KIND_FLOOR && object.kind() != v1::OBJECT_KIND_UNSPECIFIED) {
    at["kind"].Reject("is {} for a {}; primaries and secondaries stand on the floor",
                      v1::ObjectKind_Name(object.kind()), v1::ObjectRole_Name(object.role()));
  }
  if (object.walk_over() && object.kind() != v1::OBJECT_KIND_FLOOR) {
    at["walk_over"].Reject("is set for {}; only what lies on the floor is walked over",
                           v1::ObjectKind_Name(object.kind()));
  }
  if (object.zone_id().empty()) {
    if (standing) at["zone_id"].Reject("is empty; every primary and secondary belongs to a zone");
  } else if (known.zones != nullptr) {
    at["zone_id"].Refers(object.zone_id(), *known.zones, "a zone");
  }
}

}  // namespace

void Check(const v1::ObjectList& list, const Known& known, const Field& at) {
  const Field objects = at["objects"];
  if (!objects.Count(list.objects_size(), 1, kMostObjects, "objects")) return;
  NameSet seen;
  for (int i = 0; i < list.objects_size(); ++i) {
    objects[i]["id"].NewId(list.objects(i).id(), seen);
    CheckObject(list.objects(i), known, objects[i]);
  }
  for (int i = 0; i < list.objects_size(); ++i) {
    const v1::Object& object = list.objects(i);
    if (object.host_id().empty()) continue;
    const Field host = objects[i]["host_id"];
    if (host.Refers(object.host_id(), seen, "an object") && object.host_id() == object.id()) {
      host.Reject("\"{}\" is the object itself", object.id());
    }
  }
  for (int i = 0; i < list.omissions_size(); ++i) {
    at["omissions"][i]["name"].Text(list.omissions(i).name(), 1, 1000);
    at["omissions"][i]["reason"].Text(list.omissions(i).reason(), 1, 4000);
  }
  CheckDiagnostics(list.diagnostics(), at["diagnostics"]);
}

NameSet ObjectIds(const v1::ObjectList& list) {
  NameSet ids;
  for (const v1::Object& object : list.objects()) ids.insert(object.id());
  return ids;
}

namespace {

constexpr Range kChannel{.least = 0, .most = 255};

void CheckColour(const v1::Colour& colour, const Field& at) {
  at["name"].Text(colour.name(), 0, 100);
  at["red"].InRange(colour.red(), kChannel);
  at["green"].InRange(colour.green(), kChannel);
  at["blue"].InRange(colour.blue(), kChannel);
}

}  // namespace

void Check(const v1::StyleSheet& sheet, const Known& known, const Field& at) {
  at["name"].Text(sheet.name(), 0, 200);
  at["summary"].Text(sheet.summary(), 0, 4000);
  for (int i = 0; i < sheet.palette_size(); ++i) CheckColour(sheet.palette(i), at["palette"][i]);
  const NameSet surface_names = {"walls", "floor", "ceiling"};
  for (int i = 0; i < sheet.surfaces_size(); ++i) {
    const Field surface = at["surfaces"][i];
    surface["surface"].Refers(sheet.surfaces(i).surface(), surface_names, "a surface");
    CheckColour(sheet.surfaces(i).colour(), surface["colour"]);
  }
  NameSet seen;
  for (int i = 0; i < sheet.objects_size(); ++i) {
    const v1::ObjectStyle& style = sheet.objects(i);
    const Field field = at["objects"][i];
    CheckColour(style.colour(), field["colour"]);
    if (!field["subject_id"].NewId(style.subject_id(), seen)) continue;
    if (known.objects == nullptr || known.openings == nullptr || known.openings->contains(style.subject_id())) continue;
    field["subject_id"].Refers(style.subject_id(), *known.objects, "an object or opening");
  }
  CheckDiagnostics(sheet.diagnostics(), at["diagnostics"]);
}

namespace {

void CheckSentence(const v1::Sentence& sentence, const Known& known, const Field& at) {
  at["text"].Text(sentence.text(), 1, 4000);
  at["scope"].Enum(sentence.scope(), v1::SentenceScope_IsValid(sentence.scope()));
  at["weight"].InRange(sentence.weight(), {.least = 0, .most = 10, .open_least = true});
  at["reason"].Text(sentence.reason(), 0, 4000);
  for (int k = 0; k < sentence.subject_ids_size(); ++k) {
    if (known.objects != nullptr) at["subject_ids"][k].Refers(sentence.subject_ids(k), *known.objects, "an object");
  }
}

}  // namespace

void Check(const v1::ConstraintList& list, const Known& known, const Field& at) {
  const Field sentences = at["sentences"];
  if (!sentences.Count(list.sentences_size(), 0, 10000, "sentences")) return;
  NameSet seen;
  for (int i = 0; i < list.sentences_size(); ++i) {
    sentences[i]["id"].NewId(list.sentences(i).id(), seen);
    CheckSentence(list.sentences(i), known, sentences[i]);
  }
  for (int i = 0; i < list.cleaning_steps_size(); ++i) {
    const v1::CleaningStep& step = list.cleaning_steps(i);
    const Field field = at["cleaning_steps"][i];
    field["action"].Enum(step.action(), v1::CleaningAction_IsValid(step.action()));
    field["from_ids"].Count(step.from_ids_size(), 1, 10000, "ids");
    field["reason"].Text(step.reason(), 0, 4000);
  }
  CheckDiagnostics(list.diagnostics(), at["diagnostics"]);
}

NameSet SentenceIds(const v1::ConstraintList& list) {
  NameSet ids;
  for (const v1::Sentence& sentence : list.sentences()) ids.insert(sentence.id());
  return ids;
}

namespace {

void CheckParameter(const v1::ParameterSpec& parameter, const Field& at) {
  at["kind"].Enum(parameter.kind(), v1::ParameterKind_IsValid(parameter.kind()));
  at["doc"].Text(parameter.doc(), 0, 4000);
  const bool bounded = parameter.has_min_number() && parameter.has_max_number();
  if (bounded && !(parameter.min_number() <= parameter.max_number())) {
    at["min_number"].Reject("{} is above max_number {}", parameter.min_number(), parameter.max_number());
  }
  if (parameter.required() && parameter.has_default_value()) at["default_value"].Reject("is set, but it is required");
}

void CheckExample(const v1::CallExample& example, const NameSet& parameters, const Field& at) {
  at["sentence"].Text(example.sentence(), 1, 4000);
  for (int i = 0; i < example.arguments_size(); ++i) {
    at["arguments"][i]["name"].Refers(example.arguments(i).name(), parameters, "a parameter");
  }
}

}  // namespace

void Check(const v1::ConstraintCatalog& catalog, const Field& at) {
  at["library"].Text(catalog.library(), 1, 200);
  if (!at["types"].Count(catalog.types_size(), 1, 1000, "types")) return;
  NameSet names;  // aliases share them
  for (int i = 0; i < catalog.types_size(); ++i) at["types"][i]["name"].NewId(catalog.types(i).name(), names);
  for (int i = 0; i < catalog.types_size(); ++i) {
    const v1::ConstraintType& type = catalog.types(i);
    const Field field = at["types"][i];
    for (int k = 0; k < type.aliases_size(); ++k) {
      if (type.aliases(k) != type.name()) field["aliases"][k].NewId(type.aliases(k), names);
    }
    field["summary"].Text(type.summary(), 1, 4000);
    NameSet parameters;
    for (int k = 0; k < type.parameters_size(); ++k) {
      field["parameters"][k]["name"].NewId(type.parameters(k).name(), parameters);
      CheckParameter(type.parameters(k), field["parameters"][k]);
    }
    for (int k = 0; k < type.examples_size(); ++k) CheckExample(type.examples(k), parameters, field["examples"][k]);
  }
}

}  // namespace flair::validation
