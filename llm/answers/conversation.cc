// SPDX-License-Identifier: GPL-3.0-or-later
#include "llm/answers/conversation.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::llm {
namespace {

constexpr size_t kMostFaults = 30;          // told to the model or a person at once
constexpr size_t kMostQuotedBytes = 20000;  // of a first answer, in its repair

bool WorthAsking(const Fault& fault) { return fault.kind != FaultKind::kMended; }

std::vector<std::string> SentencesOf(const std::vector<Fault>& faults, bool worth_asking_only) {
  std::vector<std::string> sentences;
  size_t left_out = 0;
  for (const Fault& fault : faults) {
    if (worth_asking_only && !WorthAsking(fault)) continue;
    if (sentences.size() < kMostFaults) {
      sentences.push_back(fault.Sentence());
    } else {
      ++left_out;
    }
  }
  if (left_out > 0) sentences.push_back(fmt::format("and {} more", left_out));
  return sentences;
}

std::string RoleName(Role role) {
  return role == Role::kSystem ? "system" : (role == Role::kUser ? "user" : "assistant");
}

absl::Status ForStep(const std::string& step, const absl::Status& status) {
  // UNAVAILABLE would tell the caller to ask the worker again, which has asked the model as often as is right;
  // INVALID_ARGUMENT that its own request is wrong, when it is the model's server that does not take the question.
  const bool of_model = absl::IsUnavailable(status) || absl::IsInvalidArgument(status);
  const absl::StatusCode code = of_model ? absl::StatusCode::kAborted : status.code();
  absl::Status named(code, fmt::format("step \"{}\": {}", step, std::string(status.message())));
  status.ForEachPayload([&](auto url, const auto& payload) { named.SetPayload(url, payload); });
  return named;
}

void LeaveOutQuotations(std::vector<Fault>& faults) {
  for (Fault& fault : faults) fault.text = WithoutQuotations(fault.text);
}

// Whether an answer with these faults is worse than one with the others: of no use at all, or with more of them.
bool IsWorse(const std::vector<Fault>& faults, const std::vector<Fault>& others) {
  const auto weight = [](const std::vector<Fault>& all) {
    constexpr std::ptrdiff_t kUseless = 1'000'000;
    std::ptrdiff_t sum = 0;
    for (const Fault& fault : all) {
      const bool useless = fault.kind == FaultKind::kWrong && fault.path.find('[') == std::string::npos;
      sum += useless ? kUseless : WorthAsking(fault) ? 1 : 0;
    }
    return sum;
  };
  return weight(faults) > weight(others);
}

// Faults of the caller's check are dropped where the reader found one already: a number that could not be read is also
// 0.
void AddChecked(std::vector<Fault> checked, std::vector<Fault>& faults) {
  std::set<std::string> known;
  for (const Fault& fault : faults) known.insert(fault.path);
  for (Fault& fault : checked) {
    if (!known.contains(fault.path)) faults.push_back(std::move(fault));
  }
}

}  // namespace

PromptSpec RepairPrompt() { return {.name = "repair", .placeholders = {"faults"}, .required = {"faults"}}; }

absl::StatusOr<Reply> Conversation::Ask(const Question& question) { return std::move(AskAll({&question, 1}).front()); }

std::vector<absl::StatusOr<Reply>> Conversation::AskAll(std::span<const Question> questions) {
  std::vector<Turn> turns(questions.size());
  std::vector<Turn*> round;
  for (size_t i = 0; i < questions.size(); ++i) {
    const Question& question = questions[i];
    turns[i].question = &question;
    turns[i].request = {.step = question.step,
                        .messages = {{Role::kSystem, question.system}, {Role::kUser, question.text}},
                        .schema = AnswerSchema(*question.answer->GetDescriptor(), question.choices),
                        .schema_name = AnswerSchemaName(*question.answer->GetDescriptor()),
                        .seed = seed_};
    round.push_back(&turns[i]);
  }
  Round(round);
  round.clear();
  for (Turn& turn : turns) {
    const std::vector<Fault>& faults = turn.reply.faults;
    if (!turn.error.ok() || std::ranges::none_of(faults, WorthAsking)) continue;
    PrepareRepair(turn);
    round.push_back(&turn);
  }
  if (!round.empty()) Round(round);
  std::vector<absl::StatusOr<Reply>> replies;
  for (Turn& turn : turns) {
    if (options_.texts_omitted()) {
      for (Reply* reply : {&turn.first_reply, &turn.reply}) LeaveOutQuotations(reply->faults);
    }
    if (turn.error.ok()) turn.error = Finish(turn);
    if (turn.error.ok()) {
      replies.push_back(std::move(turn.reply));
    } else {
      replies.push_back(ForStep(turn.question->step, turn.error));
    }
  }
  return replies;
}

absl::Status Conversation::Finish(Turn& turn) {
  // A repair that broke more than it mended is not taken.
  if (turn.repairing && IsWorse(turn.reply.faults, turn.first_reply.faults)) std::swap(turn.reply, turn.first_reply);
  const std::vector<Fault> useless = DropFaulty(turn.reply.faults, *turn.reply.answer);
  if (useless.empty()) return absl::OkStatus();
  return DataLoss("the model's answer is of no use, also after a repair: {}",
                  fmt::join(SentencesOf(useless, /*worth_asking_only=*/true), "; "));
}

void Conversation::Round(std::span<Turn* const> turns) {
  absl::Status status = call_.CheckAlive();
  if (status.ok()) status = CheckBudget(turns);
  if (!status.ok()) {
    for (Turn* turn : turns) turn->error = status;
    return;
  }
  std::vector<ChatRequest> requests;
  for (const Turn* turn : turns) requests.push_back(turn->request);
  const std::vector<absl::StatusOr<ChatAnswer>> answers = llm::AskAll(client_, requests, call_);
  for (size_t i = 0; i < turns.size(); ++i) {
    if (answers[i].ok()) {
      Judge(*answers[i], *turns[i]);
    } else {
      turns[i]->error = answers[i].status();
    }
  }
}

absl::Status Conversation::CheckBudget(std::span<Turn* const> turns) const {
  const v1::ModelBudget& budget = options_.budget();
  int64_t tokens = 0;
  double cost_usd = 0;
  for (const v1::ModelCall& call : calls_) {
    tokens += call.usage().input_token_count() + call.usage().output_token_count();
    cost_usd += call.usage().cost_usd();
  }
  int64_t estimate = 0;
  for (const Turn* turn : turns) estimate += EstimateTokens(turn->request);
  // The request's budget is what its job has left.
  const int64_t needed = static_cast<int64_t>(turns.size());
  const int64_t calls_left = budget.call_count() - static_cast<int64_t>(calls_.size());
  if (budget.has_call_count() && needed > calls_left) {
    return FailedPrecondition("the budget of calls is spent: {} more {} needed, {} {} left", needed,
                              Form(needed, "is", "are"), calls_left, Form(calls_left, "is", "are"));
  }
  const int64_t tokens_left = std::max<int64_t>(0, budget.token_count() - tokens);
  if (budget.has_token_count() && estimate > tokens_left) {
    return FailedPrecondition("the budget of tokens is spent: about {} more are needed, {} {} left", estimate,
                              tokens_left, Form(tokens_left, "is", "are"));
  }
  if (budget.has_cost_usd() && cost_usd >= budget.cost_usd()) {
    return absl::FailedPreconditionError("the budget of US dollars is spent: nothing is left");
  }
  return absl::OkStatus();
}

void Conversation::Record(const Turn& turn, const ChatAnswer& answer, const std::vector<Fault>& faults) {
  v1::ModelCall& call = calls_.emplace_back();
  call.set_step(turn.request.step);
  call.set_model(answer.model);
  call.set_prompt_version(prompts_.version());
  if (!options_.texts_omitted()) {
    for (const Message& message : turn.request.messages) {
      v1::ModelMessage& said = *call.add_messages();
      said.set_role(RoleName(message.role));
      said.set_text(message.text);
    }
    call.set_answer(ToUtf8(answer.text));
  }
  v1::ModelUsage& usage = *call.mutable_usage();
  usage.set_call_count(1);
  usage.set_input_token_count(answer.usage.input_token_count);
  usage.set_output_token_count(answer.usage.output_token_count);
  usage.set_cached_input_token_count(answer.usage.cached_input_token_count);
  usage.set_estimated(answer.usage.estimated);
  usage.set_cost_usd(answer.cost_usd);
  for (const std::string& sentence : SentencesOf(faults, /*worth_asking_only=*/false)) call.add_faults(sentence);
}

void Conversation::Judge(const ChatAnswer& answer, Turn& turn) {
  const Question& question = *turn.question;
  turn.reply.answer.reset(question.answer->New());
  std::vector<Fault> faults = ReadAnswer(answer.text, question.choices, *turn.reply.answer);
  if (answer.finish == FinishReason::kLength && !faults.empty()) {
    faults.push_back(
        {"", "was cut off at the limit of its length; a shorter one would be right", FaultKind::kDoubtful});
  }
  const bool unread = !faults.empty() && faults.front().path.empty() && faults.front().kind == FaultKind::kWrong;
  if (answer.finish == FinishReason::kLength && answer.text.empty()) {
    faults.front().text =
        fmt::format("is empty after {}, the most that it may have, thoughts included (max_output_token_count)",
                    Counted(answer.usage.output_token_count, "token"));
  }
  if (answer.finish == FinishReason::kRefused && unread) {
    faults.front().text = fmt::format("is a refusal: {}", Quoted(answer.text));
  }
  // What could not be read at all need not be judged.
  if (!unread && question.check) AddChecked(question.check(*turn.reply.answer), faults);
  turn.reply.faults = faults;
  if (options_.texts_omitted()) LeaveOutQuotations(faults);
  Record(turn, answer, faults);
  turn.first_answer = answer.text;
}

void Conversation::PrepareRepair(Turn& turn) const {
  turn.repairing = true;
  turn.first_reply = std::move(turn.reply);
  turn.request.step += "/repair";
  std::string faults;
  for (const std::string& sentence : SentencesOf(turn.first_reply.faults, /*worth_asking_only=*/true)) {
    faults += fmt::format("- {}\n", CutBytes(sentence, 500));
  }
  // No characters that a server, or what it keeps its messages in, might trip over.
  const std::string first_answer = WithoutControls(ToUtf8(turn.first_answer), "\n\t");
  turn.request.messages.push_back({Role::kAssistant, CutBytes(first_answer, kMostQuotedBytes)});
  turn.request.messages.push_back({Role::kUser, prompts_.Fill("repair", {{"faults", faults}})});
}

bool Conversation::MayStandIn(const absl::Status& failure) const {
  return options_.stand_in_allowed() && (absl::IsAborted(failure) || absl::IsDataLoss(failure));
}

}  // namespace flair::llm
