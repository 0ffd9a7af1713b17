// SPDX-License-Identifier: GPL-3.0-or-later
// A scripted model behind the six requests, for tests.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "flair/v1/language_service.pb.h"
#include "language_worker/handbook/handbook.h"
#include "language_worker/model/model_handlers.h"
#include "llm/testing/fake_llm_client.h"

namespace flair::language {

// Good answers for "A bedroom that is 4m x 5m.", by step.
const std::map<std::string, std::string>& GoodAnswers();

// Handlers with a model that answers from a script, and the requests of a bedroom.
class ModelSession {
 public:
  // With the good answers for every step but `except`.
  explicit ModelSession(const std::string& except = "");

  // Goes on from where another one is.
  void TakePartsOf(const ModelSession& other);

  // The model, for further answers and for what it was asked.
  llm::FakeLlmClient& model() { return *model_; }
  v1::Brief& brief() { return brief_; }
  v1::ModelOptions& options() { return options_; }

  // Each asks with the parts that the earlier ones answered.
  absl::StatusOr<v1::DescribeRoomResponse> DescribeRoom();
  absl::StatusOr<v1::PlanZonesResponse> PlanZones();
  absl::StatusOr<v1::ListObjectsResponse> ListObjects();
  absl::StatusOr<v1::ChooseStyleResponse> ChooseStyle();
  absl::StatusOr<v1::ListConstraintsResponse> ListConstraints();
  absl::StatusOr<v1::CleanConstraintsResponse> CleanConstraints();

  const v1::Room& room() const { return room_; }
  const v1::ZonePlan& zones() const { return zones_; }
  const v1::ObjectList& objects() const { return objects_; }

  static const Handbook& handbook();

 private:
  template <typename Request>
  Request Ask() const;

  llm::FakeLlmClient* model_;
  ModelHandlers handlers_;
  v1::Brief brief_;
  v1::ModelOptions options_;
  v1::Room room_;
  v1::ZonePlan zones_;
  v1::ObjectList objects_;
  v1::ConstraintList constraints_;
  runtime::CallContext call_;
};

}  // namespace flair::language
