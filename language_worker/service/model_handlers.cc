// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/service/model_handlers.h"

#include <utility>

#include "language_worker/handbook/cleaning/clean_constraints.h"
#include "language_worker/handbook/objects/list_objects.h"
#include "language_worker/handbook/rooms/describe_room.h"
#include "language_worker/handbook/sentences/list_constraints.h"
#include "language_worker/handbook/styling/choose_style.h"
#include "language_worker/model/cleaning_step.h"
#include "language_worker/model/constraints_step.h"
#include "language_worker/model/objects_step.h"
#include "language_worker/model/placements.h"
#include "language_worker/model/room_step.h"
#include "language_worker/model/style_step.h"
#include "language_worker/model/zones_step.h"
#include "language_worker/service/own_parts.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// The brief's seed; cleaning knows no brief, and nothing in it is a matter of taste.
template <typename Request>
int64_t SeedOf(const Request& request) {
  if constexpr (requires { request.brief(); }) return request.brief().seed();
  return 0;
}

// The request's own fault, or the answer that its brief brings; nothing when a model is to be asked.
template <typename Response, typename Request, typename... Data>
std::optional<absl::StatusOr<Response>> AnswerAtOnce(const Request& request, const Data&... data) {
  RETURN_IF_ERROR(Validate(request));
  ASSIGN_OR_RETURN(std::optional<Response> own, OwnAnswer(request, data...));
  if (own) return *std::move(own);
  return std::nullopt;
}

}  // namespace

ModelHandlers::ModelHandlers(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client,
                             llm::PromptLibrary prompts)
    : handbook_(handbook),
      client_(std::move(client)),
      prompts_(std::move(prompts)),
      furniture_(handbook),
      tools_{prompts_, handbook_, furniture_} {}

v1::Producer ModelHandlers::Producer(const llm::Conversation& conversation, bool stood_in) const {
  v1::Producer producer;
  producer.set_program("flair-language");
  const bool asked = !stood_in && !conversation.calls().empty();
  producer.set_method(asked ? conversation.calls().back().model() : "handbook");
  producer.set_version(asked ? prompts_.version() : handbook_.version());
  return producer;
}

template <typename Response, typename Request, typename Ask, typename StandIn, typename Part>
absl::StatusOr<Response> ModelHandlers::Answer(const Request& request, runtime::CallContext& call, const Ask& ask,
                                               const StandIn& stand_in, Part part) const {
  llm::Conversation conversation(*client_, prompts_, request.model_options(), call, SeedOf(request));
  auto answer = ask(conversation);
  const bool stood_in = !answer.ok();
  if (stood_in) {
    const absl::Status failure = answer.status();
    if (!conversation.MayStandIn(failure)) return failure;
    answer = stand_in();
    if (!answer.ok()) return answer.status();
    AddStandIn(failure, *answer);
  }
  Response response;
  *(response.*part)() = *std::move(answer);
  *response.mutable_producer() = Producer(conversation, stood_in);
  for (const v1::ModelCall& made : conversation.calls()) *response.add_model_calls() = made;
  return response;
}

absl::StatusOr<v1::DescribeRoomResponse> ModelHandlers::Handle(const v1::DescribeRoomRequest& request,
                                                               runtime::CallContext& call) const {
  if (auto answer = AnswerAtOnce<v1::DescribeRoomResponse>(request)) return *std::move(answer);
  return Answer<v1::DescribeRoomResponse>(
      request, call, [&](llm::Conversation& conversation) { return AskRoom(request.brief(), tools_, conversation); },
      [&] { return DescribeRoom(request.brief(), handbook_); }, &v1::DescribeRoomResponse::mutable_room);
}

absl::StatusOr<v1::PlanZonesResponse> ModelHandlers::Handle(const v1::PlanZonesRequest& request,
                                                            runtime::CallContext& call) const {
  if (auto answer = AnswerAtOnce<v1::PlanZonesResponse>(request)) return *std::move(answer);
  return Answer<v1::PlanZonesResponse>(
      request, call,
      [&](llm::Conversation& conversation) { return AskZones(request.brief(), request.room(), tools_, conversation); },
      [&] { return PlanWantedZones(request.brief(), request.room(), handbook_); },
      &v1::PlanZonesResponse::mutable_zone_plan);
}

absl::StatusOr<v1::ListObjectsResponse> ModelHandlers::Handle(const v1::ListObjectsRequest& request,
                                                              runtime::CallContext& call) const {
  if (auto answer = AnswerAtOnce<v1::ListObjectsResponse>(request)) return *std::move(answer);
  const ObjectsRequest wanted{request.brief(), request.room(), request.zone_plan()};
  return Answer<v1::ListObjectsResponse>(
      request, call, [&](llm::Conversation& conversation) { return AskObjects(wanted, tools_, conversation); },
      [&] { return ListObjects(request.brief(), request.room(), request.zone_plan(), handbook_); },
      &v1::ListObjectsResponse::mutable_object_list);
}

absl::StatusOr<v1::ChooseStyleResponse> ModelHandlers::Handle(const v1::ChooseStyleRequest& request,
                                                              runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  const StyleRequest wanted{request.brief(), request.room(), request.object_list()};
  return Answer<v1::ChooseStyleResponse>(
      request, call, [&](llm::Conversation& conversation) { return AskStyle(wanted, tools_, conversation); },
      [&] { return ChooseStyle(request.brief(), request.room(), request.object_list(), handbook_); },
      &v1::ChooseStyleResponse::mutable_style_sheet);
}

absl::StatusOr<v1::ListConstraintsResponse> ModelHandlers::Handle(const v1::ListConstraintsRequest& request,
                                                                  runtime::CallContext& call) const {
  if (auto answer = AnswerAtOnce<v1::ListConstraintsResponse>(request, handbook_)) return *std::move(answer);
  const ObjectsRequest wanted{request.brief(), request.room(), request.zone_plan()};
  return Answer<v1::ListConstraintsResponse>(
      request, call,
      [&](llm::Conversation& conversation) {
        return AskConstraints(wanted, request.object_list(), tools_, conversation);
      },
      [&] { return UsualConstraints(wanted, request.object_list(), handbook_); },
      &v1::ListConstraintsResponse::mutable_constraint_list);
}

absl::StatusOr<v1::CleanConstraintsResponse> ModelHandlers::Handle(const v1::CleanConstraintsRequest& request,
                                                                   runtime::CallContext& call) const {
  RETURN_IF_ERROR(Validate(request));
  return Answer<v1::CleanConstraintsResponse>(
      request, call,
      [&](llm::Conversation& conversation) {
        return AskCleaning(request.room(), request.object_list(), request.constraint_list(), tools_, conversation);
      },
      [&]() -> absl::StatusOr<v1::ConstraintList> { return CleanConstraints(request.constraint_list()); },
      &v1::CleanConstraintsResponse::mutable_constraint_list);
}

}  // namespace flair::language
