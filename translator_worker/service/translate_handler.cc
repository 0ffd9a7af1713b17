// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/service/translate_handler.h"

#include <utility>

#include "room/validation/validate.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
namespace {

// Raise whenever equal sentences would give other calls.
constexpr char kGrammarVersion[] = "1";

}  // namespace

absl::StatusOr<v1::TranslateResponse> TranslateHandler::Handle(const v1::TranslateRequest& request,
                                                               runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  v1::TranslateResponse response;
  if (request.has_catalog()) {
    *response.mutable_layout_graph() = Translate(request);
  } else {
    absl::StatusOr<v1::ConstraintCatalog> catalog = source_.Get(call);
    if (!catalog.ok()) return catalog.status();
    v1::TranslateRequest complete = request;
    *complete.mutable_catalog() = *std::move(catalog);
    *response.mutable_layout_graph() = Translate(complete);
  }
  if (absl::Status status = call.CheckAlive(); !status.ok()) return status;
  response.mutable_producer()->set_program("flair-translator");
  response.mutable_producer()->set_method("grammar");
  response.mutable_producer()->set_version(kGrammarVersion);
  return response;
}

}  // namespace flair::translator
