// SPDX-License-Identifier: GPL-3.0-or-later
#include "language_worker/recorded/import_answers.h"

#include <memory>
#include <utility>

#include "language_worker/recorded/recorded_room_client.h"
#include "language_worker/service/language_handlers.h"
#include "llm/wrappers/folder_llm_clients.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::language {
namespace {

// One request after the other, as an orchestrator makes them.
class Phase {
 public:
  Phase(const RecordedRoom& room, const LanguageHandlers& handlers, ImportedAnswers& result)
      : room_(room), handlers_(handlers), result_(result) {}

  absl::Status Run() {
    absl::Status status = Take<v1::DescribeRoomRequest>(result_.room, &v1::DescribeRoomResponse::room);
    if (status.ok()) status = Take<v1::PlanZonesRequest>(result_.zones, &v1::PlanZonesResponse::zone_plan);
    if (status.ok()) status = Take<v1::ListObjectsRequest>(result_.objects, &v1::ListObjectsResponse::object_list);
    v1::StyleSheet style;
    if (status.ok()) status = Take<v1::ChooseStyleRequest>(style, &v1::ChooseStyleResponse::style_sheet);
    if (status.ok()) {
      status = Take<v1::ListConstraintsRequest>(result_.constraints, &v1::ListConstraintsResponse::constraint_list);
    }
    if (status.ok()) {
      status = Take<v1::CleanConstraintsRequest>(result_.constraints, &v1::CleanConstraintsResponse::constraint_list);
    }
    return status;
  }

 private:
  template <typename Request, typename Part, typename Response>
  absl::Status Take(Part& part, const Part& (Response::*get)() const) {
    Request request;
    request.set_request_id("import");
    if constexpr (requires { request.mutable_brief(); }) *request.mutable_brief() = room_.brief;
    if constexpr (requires { request.mutable_room(); }) *request.mutable_room() = result_.room;
    if constexpr (requires { request.mutable_zone_plan(); }) *request.mutable_zone_plan() = result_.zones;
    if constexpr (requires { request.mutable_object_list(); }) *request.mutable_object_list() = result_.objects;
    if constexpr (requires { request.mutable_constraint_list(); }) {
      *request.mutable_constraint_list() = result_.constraints;
    }
    ASSIGN_OR_RETURN(const Response response, handlers_.Handle(request, call_));
    part = ((response).*get)();
    result_.calls.insert(result_.calls.end(), response.model_calls().begin(), response.model_calls().end());
    return absl::OkStatus();
  }

  const RecordedRoom& room_;
  const LanguageHandlers& handlers_;
  ImportedAnswers& result_;
  runtime::CallContext call_;
};

}  // namespace

absl::StatusOr<ImportedAnswers> ImportAnswers(const RecordedRoom& room, const Handbook& handbook,
                                              const llm::PromptLibrary& prompts, const std::string& folder) {
  auto recorded = std::make_unique<RecordedRoomClient>(room, handbook);
  const RecordedRoomClient& client = *recorded;
  absl::StatusOr<std::unique_ptr<llm::LlmClient>> recording =
      llm::RecordingLlmClient::Make(std::move(recorded), folder);
  if (!recording.ok()) return recording.status();
  const LanguageHandlers handlers(handbook, *std::move(recording), prompts);
  ImportedAnswers result;
  RETURN_IF_ERROR(Phase(room, handlers, result).Run());
  result.conversions = client.conversions();
  return result;
}

}  // namespace flair::language
