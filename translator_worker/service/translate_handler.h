// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/translator_service.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "translator_worker/model/model_translator.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::translator {

// What decides the grammar's answers beyond the build: raised whenever equal sentences would give other calls.
inline constexpr char kGrammarVersion[] = "3";

// Answers TranslatorService.Translate with a model, or with the grammar when there is none.
class TranslateHandler {
 public:
  // `source` gives the catalogue to requests without one; `model` may be null. Both must outlive the handler.
  TranslateHandler(CatalogSource& source, const ModelTranslator* model) : source_(source), model_(model) {}

  absl::StatusOr<v1::TranslateResponse> Handle(const v1::TranslateRequest& request, runtime::CallContext& call) const;

 private:
  absl::StatusOr<v1::TranslateResponse> Answer(const v1::TranslateRequest& complete, runtime::CallContext& call) const;

  CatalogSource& source_;
  const ModelTranslator* const model_;
};

}  // namespace flair::translator
