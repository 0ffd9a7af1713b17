// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/config/v1/language_worker_config.pb.h"
#include "flair/model/v1/constraint_answers.pb.h"
#include "flair/v1/brief.pb.h"
#include "flair/v1/constraint_list.pb.h"
#include "flair/v1/language_service.pb.h"
#include "flair/v1/object_list.pb.h"
#include "flair/v1/room.pb.h"
#include "flair/v1/style_sheet.pb.h"
#include "flair/v1/zone_plan.pb.h"
#include "language_worker/handbook/parts/brief_parts.h"
#include "language_worker/model/model_tools.h"
#include "language_worker/service/make_language_service.h"
#include "llm/answers/prompt_library.h"
#include "llm/client/llm_client.h"
#include "worker_runtime/bootstrap/worker_context.h"
#include "worker_runtime/config/config_reader.h"

namespace flair::language {

// Asks a language model. A step that fails because of the model, and for no other reason, is answered by the handbook
// where the request allows that, and a remark "stand_in" says so. Thread-safe; every call to a model blocks its thread
// until the model has answered.
class ModelHandlers final : public LanguageHandlers {
 public:
  // `handbook` must outlive it.
  ModelHandlers(const Handbook& handbook, std::unique_ptr<llm::LlmClient> client, llm::PromptLibrary prompts);

 private:
#define FLAIR_ANSWER(Rpc) \
  absl::StatusOr<v1::Rpc##Response> Answer(const v1::Rpc##Request&, runtime::CallContext& call) const override;
  FLAIR_ANSWER(DescribeRoom)
  FLAIR_ANSWER(PlanZones)
  FLAIR_ANSWER(ListObjects)
  FLAIR_ANSWER(ChooseStyle)
  FLAIR_ANSWER(ListConstraints)
  FLAIR_ANSWER(CleanConstraints)
#undef FLAIR_ANSWER

  template <typename Response, typename Request>
  absl::StatusOr<Response> AskModel(const Request& request, runtime::CallContext& call) const;

  const std::unique_ptr<llm::LlmClient> client_;
  const llm::PromptLibrary prompts_;
  const FurnitureIndex furniture_;
  const ModelTools tools_;
};

// For MakeLanguageService: with the model of config.llm, or with one of one's own in its place. Both read the prompts
// once; errors as llm::MakeLlmClient and PromptLibrary::Load.
absl::StatusOr<std::unique_ptr<LanguageHandlers>> MakeModelHandlers(const config::v1::LanguageWorkerConfig& config,
                                                                    const Handbook& handbook,
                                                                    runtime::WorkerContext& worker);
absl::StatusOr<std::unique_ptr<LanguageHandlers>> MakeModelHandlers(std::unique_ptr<llm::LlmClient> model,
                                                                    const config::v1::LanguageWorkerConfig& config,
                                                                    const Handbook& handbook,
                                                                    runtime::WorkerContext& worker);

// Reports what is wrong with the config, but for its runtime.
void CheckLanguageConfig(const config::v1::LanguageWorkerConfig& config, runtime::ConfigChecker& checker);

// The steps of the language phase with a model, one function each. Errors are those of Conversation::Ask, and
// INVALID_ARGUMENT for a brief that ReadBrief refuses. Each says with remarks what of the answer was left out.

// Step A: floor, openings and sockets. A size that the brief gives in numbers holds whatever the model answers.
absl::StatusOr<v1::Room> AskRoom(const v1::Brief& brief, const ModelTools& tools, llm::Conversation& conversation);

// Step B: the zones, most important first, those of the brief's own objects among them.
absl::StatusOr<v1::ZonePlan> AskZones(const v1::Brief& brief, const v1::Room& room, const ModelTools& tools,
                                      llm::Conversation& conversation);
// Steps C i to iii: floor objects first, then what completes them. Where the handbook may stand in and one of the two
// answers is of no use, it answers that one alone, with a remark.
absl::StatusOr<v1::ObjectList> AskObjects(const ObjectsRequest& request, const ModelTools& tools,
                                          llm::Conversation& conversation);
// Steps C i and ii: primaries in zone order and secondaries, counts expanded. Things that the handbook knows to hang or
// to lie are taken as tertiaries, at the end. `ids` gets their ids.
absl::StatusOr<v1::ObjectList> AskFloorObjects(const ObjectsRequest& request, const ModelTools& tools,
                                               llm::Conversation& conversation, IdMaker& ids);
// Step C iii: adds to the floor objects what hangs, stands on them or lies on the floor, each with its host and its
// placement sentence. The list stays as it was when it fails.
absl::Status AskTertiaries(const ObjectsRequest& request, const ModelTools& tools, llm::Conversation& conversation,
                           IdMaker& ids, v1::ObjectList& list);

// Step C iv. What the model says nothing of gets the handbook's look, with a remark.
absl::StatusOr<v1::StyleSheet> AskStyle(const v1::Brief& brief, const v1::Room& room, const v1::ObjectList& objects,
                                        const ModelTools& tools, llm::Conversation& conversation);

// Steps D i and ii, both asked at once, and the tertiaries' placements as sentences. Where the handbook may stand in
// and one of the two answers is of no use, its sentences take the place of that one's, with a remark.
absl::StatusOr<v1::ConstraintList> AskConstraints(const ObjectsRequest& request, const v1::ObjectList& objects,
                                                  const ModelTools& tools, llm::Conversation& conversation);
// Step D iii: the handbook's cleaning, then the model's of what is left; the model names changes, all else stays.
// Tertiaries' sentences are not sent: each says one thing. Asks nothing when there is no other.
absl::StatusOr<v1::ConstraintList> AskCleaning(const v1::Room& room, const v1::ObjectList& objects,
                                               const v1::ConstraintList& raw, const ModelTools& tools,
                                               llm::Conversation& conversation);

// Sentences by id: those that a cleaning may change. Borrows the list.
using SentenceIndex = std::map<std::string, const v1::Sentence*, std::less<>>;
SentenceIndex IndexOf(const v1::ConstraintList& list);

// Some sentences and what takes their place: one of several, several of one, or nothing.
struct Change {
  std::vector<std::string> from;
  std::vector<std::string> to;
  std::string reason;  // why they go; may be empty
};

// The changes of an answer, in its order; lines about the same sentence are one change, and one that leaves its
// sentence as it is is none. Others that make no sense are left out, with a fault of their element in `faults` when it
// is not null: ids that there are not, sentences changed twice, several made of several. Takes any answer.
std::vector<Change> ReadChanges(const model::v1::CleaningAnswer& answer, const SentenceIndex& sentences,
                                std::vector<llm::Fault>* faults);

}  // namespace flair::language
