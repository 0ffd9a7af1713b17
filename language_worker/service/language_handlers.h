// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "absl/status/statusor.h"
#include "flair/v1/language_service.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/model/furniture_index.h"
#include "language_worker/model/model_tools.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::language {

// Answers the six requests of the language phase. Each validates its request; returns what the brief itself brings, by
// the method "brief" (INVALID_ARGUMENT when that does not go with what it belongs to); else asks the model, or, without
// one, the handbook. A step that fails because of the model, and for no other reason, is answered by the handbook where
// the request allows that, and a remark "stand_in" says so. Thread-safe; every call to a model blocks its thread until
// the model has answered.
class LanguageHandlers {
 public:
  // `handbook` must outlive it.
  explicit LanguageHandlers(const Handbook& handbook) : handbook_(handbook) {}
  LanguageHandlers(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client, llm::PromptLibrary prompts);

  absl::StatusOr<v1::DescribeRoomResponse> Handle(const v1::DescribeRoomRequest& request,
                                                  runtime::CallContext& call) const;
  absl::StatusOr<v1::PlanZonesResponse> Handle(const v1::PlanZonesRequest& request, runtime::CallContext& call) const;
  absl::StatusOr<v1::ListObjectsResponse> Handle(const v1::ListObjectsRequest& request,
                                                 runtime::CallContext& call) const;
  absl::StatusOr<v1::ChooseStyleResponse> Handle(const v1::ChooseStyleRequest& request,
                                                 runtime::CallContext& call) const;
  absl::StatusOr<v1::ListConstraintsResponse> Handle(const v1::ListConstraintsRequest& request,
                                                     runtime::CallContext& call) const;
  absl::StatusOr<v1::CleanConstraintsResponse> Handle(const v1::CleanConstraintsRequest& request,
                                                      runtime::CallContext& call) const;

 private:
  // What asking a model takes.
  struct Model {
    Model(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client, llm::PromptLibrary prompts);

    const std::unique_ptr<llm::LlmClient> client;
    const llm::PromptLibrary prompts;
    const FurnitureIndex furniture;
    const ModelTools tools;
  };

  // Asks with `ask(Conversation&, ModelTools)`, else `stand_in()`, both of which return the artifact, and puts it where
  // `part` of the response points to.
  template <typename Response, typename Request, typename Ask, typename StandIn, typename Part>
  absl::StatusOr<Response> Answer(const Request& request, runtime::CallContext& call, const Ask& ask,
                                  const StandIn& stand_in, Part part) const;

  const Handbook& handbook_;
  std::unique_ptr<const Model> model_;  // null: the handbook answers
};

}  // namespace flair::language
