// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <grpcpp/impl/service_type.h>

#include <functional>
#include <memory>
#include <string>

#include "absl/status/statusor.h"
#include "flair/config/v1/language_worker_config.pb.h"
#include "flair/v1/language_service.pb.h"
#include "language_worker/handbook/handbook.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/bootstrap/worker_context.h"

namespace flair::language {

// Answers the seven requests of the language phase. Each validates its request, and returns what the brief itself
// brings, by the method "brief" (INVALID_ARGUMENT when that does not go with what it belongs to); else the handbook
// answers, or what overrides Answer (model/model_handlers.h). Thread-safe.
class LanguageHandlers {
 public:
  // `handbook` must outlive it.
  explicit LanguageHandlers(const Handbook& handbook) : handbook_(handbook) {}
  virtual ~LanguageHandlers() = default;

// Answer: to a valid request, of which the brief brings nothing. Here: the handbook's.
#define FLAIR_ANSWER(Rpc)                                                                              \
 public:                                                                                               \
  absl::StatusOr<v1::Rpc##Response> Handle(const v1::Rpc##Request&, runtime::CallContext& call) const; \
                                                                                                       \
 protected:                                                                                            \
  virtual absl::StatusOr<v1::Rpc##Response> Answer(const v1::Rpc##Request&, runtime::CallContext& call) const;
  FLAIR_ANSWER(DescribeRoom)
  FLAIR_ANSWER(PlanZones)
  FLAIR_ANSWER(ListObjects)
  FLAIR_ANSWER(ChooseStyle)
  FLAIR_ANSWER(ListConstraints)
  FLAIR_ANSWER(CleanConstraints)
  // With a model, too: what pieces are for is the handbook's to know.
  FLAIR_ANSWER(CompleteConstraints)
#undef FLAIR_ANSWER

  const Handbook& handbook() const { return handbook_; }

 private:
  const Handbook& handbook_;
};

// The artifact that a response brings.
template <typename Response>
auto& PartOf(Response& response) {
  if constexpr (requires { response.room(); }) {
    return *response.mutable_room();
  } else if constexpr (requires { response.zone_plan(); }) {
    return *response.mutable_zone_plan();
  } else if constexpr (requires { response.object_list(); }) {
    return *response.mutable_object_list();
  } else if constexpr (requires { response.style_sheet(); }) {
    return *response.mutable_style_sheet();
  } else {
    return *response.mutable_constraint_list();
  }
}

// A response whose producer is this program, by `method` of `version`, such as a model with its prompts.
template <typename Response>
Response AnsweredBy(const std::string& method, const std::string& version = "") {
  Response response;
  response.mutable_producer()->set_program("flair-language");
  response.mutable_producer()->set_method(method);
  response.mutable_producer()->set_version(version);
  return response;
}

// Makes handlers that ask the config's language model, and adds to the worker's revision what decides their answers;
// see model/model_handlers.h.
using ModelHandlersMaker = std::function<absl::StatusOr<std::unique_ptr<LanguageHandlers>>(
    const config::v1::LanguageWorkerConfig&, const Handbook&, runtime::WorkerContext&)>;

// The LanguageService, for flair-language and for programs that host it themselves. The handbook answers; when the
// config has an llm, the handlers that `with_model` makes, and INVALID_ARGUMENT when it is null. Reads the handbook
// once; errors as LoadHandbook and `with_model`. `worker` must outlive it.
absl::StatusOr<std::unique_ptr<grpc::Service>> MakeLanguageService(const config::v1::LanguageWorkerConfig& config,
                                                                   runtime::WorkerContext& worker,
                                                                   const ModelHandlersMaker& with_model = nullptr);

}  // namespace flair::language
