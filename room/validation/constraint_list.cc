// SPDX-License-Identifier: GPL-3.0-or-later
#include "room/validation/checks.h"

namespace flair::validation {
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

}  // namespace flair::validation
