// SPDX-License-Identifier: GPL-3.0-or-later
#include "translator_worker/service/translate_handler.h"

#include <utility>

#include "room/validation/validate.h"
#include "translator_worker/grammar/translate.h"

namespace flair::translator {
absl::StatusOr<v1::TranslateResponse> TranslateHandler::Handle(const v1::TranslateRequest& request,
                                                               runtime::CallContext& call) const {
  if (absl::Status status = Validate(request); !status.ok()) return status;
  if (request.has_catalog()) return Answer(request, call);
  absl::StatusOr<v1::ConstraintCatalog> catalog = source_.Get(call);
  if (!catalog.ok()) return catalog.status();
  v1::TranslateRequest complete = request;
  *complete.mutable_catalog() = *std::move(catalog);
  return Answer(complete, call);
}

absl::StatusOr<v1::TranslateResponse> TranslateHandler::Answer(const v1::TranslateRequest& complete,
                                                               runtime::CallContext& call) const {
  absl::StatusOr<v1::TranslateResponse> response = v1::TranslateResponse();
  if (model_ != nullptr) {
    response = model_->Translate(complete, call);
    if (!response.ok()) return response.status();
    // As the server names it; a request that needed no call names what was configured.
    response->mutable_producer()->set_method(response->model_calls().empty() ? model_->model()
                                                                             : response->model_calls(0).model());
    response->mutable_producer()->set_version(model_->version());
  } else {
    *response->mutable_layout_graph() = Translate(complete);
    response->mutable_producer()->set_method("grammar");
    response->mutable_producer()->set_version(kGrammarVersion);
  }
  if (absl::Status status = call.CheckAlive(); !status.ok()) return status;
  response->mutable_producer()->set_program("flair-translator");
  return response;
}

}  // namespace flair::translator
