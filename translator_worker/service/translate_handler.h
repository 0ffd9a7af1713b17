// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "absl/status/statusor.h"
#include "flair/v1/translator_service.pb.h"
#include "translator_worker/catalog/catalog_source.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::translator {

// Answers TranslatorService.Translate with the grammar.
class TranslateHandler {
 public:
  // `source` gives the catalogue to requests without one and must outlive the handler.
  explicit TranslateHandler(CatalogSource& source) : source_(source) {}

  absl::StatusOr<v1::TranslateResponse> Handle(const v1::TranslateRequest& request, runtime::CallContext& call) const;

 private:
  CatalogSource& source_;
};

}  // namespace flair::translator
