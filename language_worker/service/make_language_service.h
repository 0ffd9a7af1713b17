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
  // The same with a model: what pieces are for is the handbook's to know.
  absl::StatusOr<v1::CompleteConstraintsResponse> Handle(const v1::CompleteConstraintsRequest& request,
                                                         runtime::CallContext& call) const;

 protected:
  // The answers to valid requests, of which the brief brings nothing. Here: the handbook's.
  virtual absl::StatusOr<v1::DescribeRoomResponse> Answer(const v1::DescribeRoomRequest& request,
                                                          runtime::CallContext& call) const;
  virtual absl::StatusOr<v1::PlanZonesResponse> Answer(const v1::PlanZonesRequest& request,
                                                       runtime::CallContext& call) const;
  virtual absl::StatusOr<v1::ListObjectsResponse> Answer(const v1::ListObjectsRequest& request,
                                                         runtime::CallContext& call) const;
  virtual absl::StatusOr<v1::ChooseStyleResponse> Answer(const v1::ChooseStyleRequest& request,
                                                         runtime::CallContext& call) const;
  virtual absl::StatusOr<v1::ListConstraintsResponse> Answer(const v1::ListConstraintsRequest& request,
                                                             runtime::CallContext& call) const;
  virtual absl::StatusOr<v1::CleanConstraintsResponse> Answer(const v1::CleanConstraintsRequest& request,
                                                              runtime::CallContext& call) const;

  const Handbook& handbook() const { return handbook_; }

 private:
  const Handbook& handbook_;
};

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
