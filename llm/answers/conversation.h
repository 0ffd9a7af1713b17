// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "flair/v1/model_call.pb.h"
#include "llm/answers/prompt_library.h"
#include "llm/answers/read_answer.h"
#include "llm/client/llm_client.h"

namespace flair::llm {

// The prompt that asks for a better answer; a library that a Conversation uses has it. Placeholder {{faults}}.
PromptSpec RepairPrompt();

// What is asked, and how its answer is judged.
struct Question {
  // What it is for, such as "objects.floor"; its repair is "objects.floor/repair".
  std::string step;
  // Who the model is and the rules that always hold; the same words for all questions of a worker, so that servers can
  // keep them.
  std::string system;
  // The task.
  std::string text;
  FieldChoices choices = {};
  // The answer's type; its content is not looked at. Must outlive the call.
  const google::protobuf::Message* answer = nullptr;
  // What is wrong with an answer that reads well; may mend it (`kMended`) and append to its lists, but leaves the order
  // of list elements. Called for the first answer and for the repair.
  std::function<std::vector<Fault>(google::protobuf::Message&)> check = {};
};

// Makes a Question's `check` of a function of the answer's own type.
template <typename Answer, typename Function>
std::function<std::vector<Fault>(google::protobuf::Message&)> CheckOf(Function function) {
  return [function](google::protobuf::Message& message) { return function(static_cast<Answer&>(message)); };
}

// An answer that can be used.
struct Reply {
  std::unique_ptr<google::protobuf::Message> answer;
  // What was wrong with it to the end: list elements with kWrong faults have been left out of it.
  std::vector<Fault> faults;

  template <typename Answer>
  const Answer& As() const {
    return static_cast<const Answer&>(*answer);
  }
};

// Asks a model for typed answers on behalf of one request: within its budget, with at most one repair a question, and
// keeping account of every call. Not thread-safe; blocks the thread that asks.
class Conversation {
 public:
  // All but the options must outlive it. `seed`: see ChatRequest.
  Conversation(LlmClient& client, const PromptLibrary& prompts, const v1::ModelOptions& options,
               runtime::CallContext& call, int64_t seed = 0)
      : client_(client), prompts_(prompts), options_(options), call_(call), seed_(seed) {}

  // Errors, each beginning with the step: those of LlmClient, but ABORTED when the model cannot be reached or its
  // server does not take the question; FAILED_PRECONDITION naming the limit of the budget that the next call would
  // exceed; DATA_LOSS with the faults when the answer is of no use even after a repair.
  absl::StatusOr<Reply> Ask(const Question& question);

  // The same for questions that do not depend on each other, all at once. Answers in the order of the questions.
  std::vector<absl::StatusOr<Reply>> AskAll(std::span<const Question> questions);

  // Every call that was answered, in the order of asking, whatever became of it.
  const std::vector<v1::ModelCall>& calls() const { return calls_; }

  // Whether a step that failed so is to be answered without a model: the options allow that, and the model was not
  // reached (ABORTED), or its answers were of no use (DATA_LOSS). Not when the caller went away, a budget ended, or the
  // model is configured wrongly.
  bool MayStandIn(const absl::Status& failure) const;

 private:
  // A question on its way.
  struct Turn {
    const Question* question = nullptr;
    bool repairing = false;
    ChatRequest request;
    absl::Status error;
    std::string first_answer;
    Reply first_reply;
    Reply reply;
  };

  // Asks all turns at once and judges their answers.
  void Round(std::span<Turn* const> turns);
  absl::Status CheckBudget(std::span<Turn* const> turns) const;
  void Record(const Turn& turn, const ChatAnswer& answer, const std::vector<Fault>& faults);
  void Judge(const ChatAnswer& answer, Turn& turn);
  void PrepareRepair(Turn& turn) const;
  // Takes the better of answer and repair and leaves out what is wrong; an error when nothing useful is left.
  static absl::Status Finish(Turn& turn);

  LlmClient& client_;
  const PromptLibrary& prompts_;
  const v1::ModelOptions options_;
  runtime::CallContext& call_;
  const int64_t seed_;
  std::vector<v1::ModelCall> calls_;
};

}  // namespace flair::llm
