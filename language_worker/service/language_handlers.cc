// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/language_handlers.h"

#include <utility>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/cleaning_step.h"
#include "language_worker/model/constraints_step.h"
#include "language_worker/model/objects_step.h"
#include "language_worker/model/room_step.h"
#include "language_worker/model/style_step.h"
#include "language_worker/model/zones_step.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

v1::Producer Producer(const std::string& method, const std::string& version = "") {
  v1::Producer producer;
  producer.set_program("flair-language");
  producer.set_method(method);
  producer.set_version(version);
  return producer;
}

// The brief's seed; cleaning knows no brief, and nothing in it is a matter of taste.
template <typename Request>
int64_t SeedOf(const Request& request) {
  if constexpr (requires { request.brief(); }) return request.brief().seed();
  return 0;
}

// What the brief brings, as it is.
template <typename Response, typename Part, typename Artifact>
Response FromBrief(Part part, const Artifact& artifact) {
  Response response;
  *(response.*part)() = artifact;
  *response.mutable_producer() = Producer("brief");
  return response;
}

}  // namespace

LanguageHandlers::Model::Model(const Handbook& handbook, std::unique_ptr<llm::LlmClient> asked,
                               llm::PromptLibrary library)
    : client(std::move(asked)), prompts(std::move(library)), furniture(handbook), tools{prompts, handbook, furniture} {}

LanguageHandlers::LanguageHandlers(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client,
                                   llm::PromptLibrary prompts)
    : handbook_(handbook), model_(std::make_unique<const Model>(handbook, std::move(client), std::move(prompts))) {}

template <typename Response, typename Request, typename Ask, typename StandIn, typename Part>
absl::StatusOr<Response> LanguageHandlers::Answer(const Request& request, runtime::CallContext& call, const Ask& ask,
                                                  const StandIn& stand_in, Part part) const {
  Response response;
  *response.mutable_producer() = Producer("handbook", handbook_.version());
  if (model_ == nullptr) {
    ASSIGN_OR_RETURN(*(response.*part)(), stand_in());
    return response;
  }
  llm::Conversation conversation(*model_->client, model_->prompts, request.model_options(), call, SeedOf(request));
  auto answer = ask(conversation, model_->tools);
  if (!answer.ok()) {
    const absl::Status failure = answer.status();
    if (!conversation.MayStandIn(failure)) return failure;
    answer = stand_in();
    RETURN_IF_ERROR(answer.status());
    AddStandIn(failure, *answer);
  } else if (!conversation.calls().empty()) {
    *response.mutable_producer() = Producer(conversation.calls().back().model(), model_->prompts.version());
  }
  *(response.*part)() = *std::move(answer);
  for (const v1::ModelCall& made : conversation.calls()) *response.add_model_calls() = made;
  return response;
}

absl::StatusOr<v1::DescribeRoomResponse> LanguageHandlers::Handle(const v1::DescribeRoomRequest& request,
                                                                  runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  const auto part = &v1::DescribeRoomResponse::mutable_room;
  if (brief.has_room()) return FromBrief<v1::DescribeRoomResponse>(part, brief.room());
  return Answer<v1::DescribeRoomResponse>(
      request, call,
      [&](llm::Conversation& conversation, const ModelTools& tools) { return AskRoom(brief, tools, conversation); },
      [&] { return DescribeRoom(brief, handbook_); }, part);
}

absl::StatusOr<v1::PlanZonesResponse> LanguageHandlers::Handle(const v1::PlanZonesRequest& request,
                                                               runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  const auto part = &v1::PlanZonesResponse::mutable_zone_plan;
  if (brief.has_zone_plan()) return FromBrief<v1::PlanZonesResponse>(part, brief.zone_plan());
  return Answer<v1::PlanZonesResponse>(
      request, call,
      [&](llm::Conversation& conversation, const ModelTools& tools) {
        return AskZones(brief, request.room(), tools, conversation);
      },
      [&] { return PlanWantedZones(brief, request.room(), handbook_); }, part);
}

absl::StatusOr<v1::ListObjectsResponse> LanguageHandlers::Handle(const v1::ListObjectsRequest& request,
                                                                 runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  const auto part = &v1::ListObjectsResponse::mutable_object_list;
  if (brief.has_object_list()) {
    RETURN_IF_ERROR(Validate(brief.object_list(), request.zone_plan(), "brief.object_list"));
    return FromBrief<v1::ListObjectsResponse>(part, brief.object_list());
  }
  const ObjectsRequest wanted{brief, request.room(), request.zone_plan()};
  return Answer<v1::ListObjectsResponse>(
      request, call,
      [&](llm::Conversation& conversation, const ModelTools& tools) { return AskObjects(wanted, tools, conversation); },
      [&] { return ListObjects(brief, request.room(), request.zone_plan(), handbook_); }, part);
}

absl::StatusOr<v1::ChooseStyleResponse> LanguageHandlers::Handle(const v1::ChooseStyleRequest& request,
                                                                 runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const StyleRequest wanted{request.brief(), request.room(), request.object_list()};
  return Answer<v1::ChooseStyleResponse>(
      request, call,
      [&](llm::Conversation& conversation, const ModelTools& tools) { return AskStyle(wanted, tools, conversation); },
      [&] { return ChooseStyle(request.brief(), request.room(), request.object_list(), handbook_); },
      &v1::ChooseStyleResponse::mutable_style_sheet);
}

absl::StatusOr<v1::ListConstraintsResponse> LanguageHandlers::Handle(const v1::ListConstraintsRequest& request,
                                                                     runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const v1::Brief& brief = request.brief();
  const ObjectsRequest wanted{brief, request.room(), request.zone_plan()};
  const auto part = &v1::ListConstraintsResponse::mutable_constraint_list;
  if (brief.has_constraint_list()) {
    RETURN_IF_ERROR(Validate(brief.constraint_list(), request.object_list(), "brief.constraint_list"));
    ASSIGN_OR_RETURN(const v1::ConstraintList own, OwnConstraints(wanted, request.object_list(), handbook_));
    return FromBrief<v1::ListConstraintsResponse>(part, own);
  }
  return Answer<v1::ListConstraintsResponse>(
      request, call,
      [&](llm::Conversation& conversation, const ModelTools& tools) {
        return AskConstraints(wanted, request.object_list(), tools, conversation);
      },
      [&] { return UsualConstraints(wanted, request.object_list(), handbook_); }, part);
}

absl::StatusOr<v1::CleanConstraintsResponse> LanguageHandlers::Handle(const v1::CleanConstraintsRequest& request,
                                                                      runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  return Answer<v1::CleanConstraintsResponse>(
      request, call,
      [&](llm::Conversation& conversation, const ModelTools& tools) {
        return AskCleaning(request.room(), request.object_list(), request.constraint_list(), tools, conversation);
      },
      [&]() -> absl::StatusOr<v1::ConstraintList> { return CleanConstraints(request.constraint_list()); },
      &v1::CleanConstraintsResponse::mutable_constraint_list);
}

}  // namespace flair::language
