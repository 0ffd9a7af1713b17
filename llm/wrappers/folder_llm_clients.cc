// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "fmt/format.h"
#include "llm/wrappers/llm_wrappers.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::llm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<Role, const char*>, 3> kRoles = {
    {{Role::kSystem, "system"}, {Role::kUser, "user"}, {Role::kAssistant, "assistant"}}};
constexpr std::array<std::pair<FinishReason, const char*>, 4> kFinishReasons = {{{FinishReason::kStop, "stop"},
                                                                                 {FinishReason::kLength, "length"},
                                                                                 {FinishReason::kRefused, "refused"},
                                                                                 {FinishReason::kOther, "other"}}};

template <typename Table, typename Value>
const char* NameOf(const Table& table, Value value) {
  for (const auto& [known, name] : table) {
    if (known == value) return name;
  }
  return "";
}

Json ToJson(const ChatRequest& request) {
  Json messages = Json::array();
  for (const Message& message : request.messages) {
    messages.push_back({{"role", NameOf(kRoles, message.role)}, {"text", message.text}});
  }
  Json json = {{"messages", std::move(messages)},
               {"schema_name", request.schema_name},
               {"schema", request.schema},
               {"max_output_token_count", request.max_output_token_count}};
  // Requests without one are what they were before there were seeds, and so are the names of their files.
  if (request.seed != 0) json["seed"] = request.seed;
  return json;
}

Json ToJson(const ChatAnswer& answer) {
  return {{"text", answer.text},
          {"finish", NameOf(kFinishReasons, answer.finish)},
          {"model", answer.model},
          {"usage",
           {{"input_token_count", answer.usage.input_token_count},
            {"output_token_count", answer.usage.output_token_count},
            {"cached_input_token_count", answer.usage.cached_input_token_count},
            {"estimated", answer.usage.estimated}}},
          {"cost_usd", answer.cost_usd}};
}

std::string Dump(const Json& json, int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); }

absl::Status Bad(const std::string& path, const char* expected) { return DataLoss("{}: expected {}", path, expected); }

// Reads fields one after the other; remembers the first that is wrong.
class Reader {
 public:
  Reader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {}

  void Text(const char* field, std::string& value) {
    if (const Json* found = Find(field, &Json::is_string, "a text")) value = found->get<std::string>();
  }
  void Count(const char* field, int64_t& value) {
    const Json* found = Find(field, &Json::is_number_integer, "a count of 0 or more");
    if (found == nullptr) return;
    value = found->get<int64_t>();
    if (value < 0) Fail(field, "a count of 0 or more");
  }
  void Amount(const char* field, double& value) {
    if (const Json* found = Find(field, &Json::is_number, "a number")) value = found->get<double>();
  }
  void Flag(const char* field, bool& value) {
    if (const Json* found = Find(field, &Json::is_boolean, "true or false")) value = found->get<bool>();
  }
  const Json& Object(const char* field) {
    static const Json empty = Json::object();
    const Json* found = Find(field, &Json::is_object, "an object");
    return found != nullptr ? *found : empty;
  }
  void Fail(const std::string& field, const char* expected) {
    if (status_.ok()) status_ = Bad(path_ + field, expected);
  }
  const absl::Status& status() const { return status_; }

 private:
  const Json* Find(const char* field, bool (Json::*is)() const noexcept, const char* expected) {
    const auto it = json_.find(field);
    if (it != json_.end() && ((*it).*is)()) return &*it;
    Fail(field, expected);
    return nullptr;
  }

  const Json& json_;
  const std::string path_;
  absl::Status status_;
};

// What decides the answer: messages, schema, limit, seed when it is not 0; not the step. Equal requests give equal
// texts.
std::string RequestJson(const ChatRequest& request) { return Dump(ToJson(request), -1); }

constexpr char kIdentityFile[] = "identity";

std::optional<std::string> ReadFile(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return std::string((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
}

absl::Status MakeFolder(const std::string& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (!error) return absl::OkStatus();
  return FailedPrecondition("{}: the folder for answers cannot be made: {}", path, error.message());
}

// Steps are words, dots and slashes; whatever else is in one does not get into a file's name.
std::string FileStem(const std::string& step) {
  std::string stem;
  for (const char c : step.substr(0, 60)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    stem.push_back(plain ? c : '.');
  }
  return stem.empty() || stem.front() == '.' ? "call" + stem : stem;
}

class FolderLlmClient final : public LlmClient {
 public:
  enum class Use { kCache, kRecording, kReplay };

  // `inner` is null for a replay.
  FolderLlmClient(Use use, std::string path, std::string identity, std::unique_ptr<LlmClient> inner)
      : use_(use), folder_(std::move(path)), identity_(std::move(identity)), inner_(std::move(inner)) {}

  absl::StatusOr<ChatAnswer> Ask(const ChatRequest& request, runtime::CallContext& call) override {
    RETURN_IF_ERROR(call.CheckAlive());
    absl::StatusOr<std::optional<ChatAnswer>> known = Find(request);
    if (!known.ok() && use_ != Use::kCache) return known.status();
    if (known.ok() && known->has_value()) return **std::move(known);
    if (use_ == Use::kReplay) {
      return NotFound("{}: no recorded answer for step \"{}\"{}: expected the file {}", folder_.path(), request.step,
                      request.seed == 0 ? "" : fmt::format(" with seed {}", request.seed),
                      AnswerFolder::FileName(request));
    }
    ASSIGN_OR_RETURN(ChatAnswer answer, inner_->Ask(request, call));
    // When two callers asked the same at once, both get what is kept.
    absl::StatusOr<ChatAnswer> kept = folder_.Put(request, answer);
    if (!kept.ok() && use_ == Use::kCache) return answer;
    return kept;
  }
  std::string identity() const override { return identity_; }
  int concurrency() const override { return inner_ == nullptr ? 1 : inner_->concurrency(); }

 private:
  absl::StatusOr<std::optional<ChatAnswer>> Find(const ChatRequest& request) const {
    absl::StatusOr<std::optional<ChatAnswer>> known = folder_.Find(request);
    if (use_ != Use::kReplay || request.seed == 0 || !known.ok() || known->has_value()) return known;
    ChatRequest of_any_seed = request;
    of_any_seed.seed = 0;
    return folder_.Find(of_any_seed);
  }

  const Use use_;
  const AnswerFolder folder_;
  const std::string identity_;
  const std::unique_ptr<LlmClient> inner_;
};

}  // namespace

std::string RecordJson(const ChatRequest& request, const ChatAnswer& answer) {
  const Json record = {{"step", request.step}, {"request", ToJson(request)}, {"answer", ToJson(answer)}};
  return Dump(record, 1) + "\n";
}

absl::StatusOr<ChatAnswer> ReadRecordJson(const std::string& text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return absl::DataLossError("expected a JSON object with \"request\" and \"answer\"");
  Reader record(json, "");
  Reader reader(record.Object("answer"), "answer.");
  RETURN_IF_ERROR(record.status());
  ChatAnswer answer;
  std::string finish;
  reader.Text("text", answer.text);
  reader.Text("finish", finish);
  reader.Text("model", answer.model);
  reader.Amount("cost_usd", answer.cost_usd);
  Reader usage(reader.Object("usage"), "answer.usage.");
  usage.Count("input_token_count", answer.usage.input_token_count);
  usage.Count("output_token_count", answer.usage.output_token_count);
  usage.Count("cached_input_token_count", answer.usage.cached_input_token_count);
  usage.Flag("estimated", answer.usage.estimated);
  bool known = false;
  for (const auto& [reason, name] : kFinishReasons) {
    if (finish != name) continue;
    answer.finish = reason;
    known = true;
  }
  if (!known) reader.Fail("finish", "\"stop\", \"length\", \"refused\" or \"other\"");
  RETURN_IF_ERROR(reader.status());
  RETURN_IF_ERROR(usage.status());
  return answer;
}

std::string AnswerFolder::FileName(const ChatRequest& request) {
  return fmt::format("{}-{}.json", FileStem(request.step), runtime::Sha256Hex(RequestJson(request)).substr(0, 16));
}

absl::Status AnswerFolder::ClaimFor(const std::string& identity) const {
  RETURN_IF_ERROR(MakeFolder(path_));
  const absl::StatusOr<std::string> found = Identity();
  if (found.ok() && *found == identity) return absl::OkStatus();
  if (found.ok()) {
    return FailedPrecondition("{}: holds answers of \"{}\", not of \"{}\"; choose another folder", path_, *found,
                              identity);
  }
  return runtime::WriteFileAtomically(path_ + "/" + kIdentityFile, identity + "\n");
}

absl::StatusOr<std::string> AnswerFolder::Identity() const {
  std::optional<std::string> text = ReadFile(path_ + "/" + kIdentityFile);
  if (!text.has_value()) return NotFound("{}: no recorded answers: its file \"{}\" is missing", path_, kIdentityFile);
  while (!text->empty() && text->back() == '\n') text->pop_back();
  return *text;
}

absl::StatusOr<std::optional<ChatAnswer>> AnswerFolder::Find(const ChatRequest& request) const {
  const std::string path = path_ + "/" + FileName(request);
  const std::optional<std::string> text = ReadFile(path);
  if (!text.has_value()) return std::optional<ChatAnswer>();
  absl::StatusOr<ChatAnswer> answer = ReadRecordJson(*text);
  if (answer.ok()) return std::optional<ChatAnswer>(*std::move(answer));
  return DataLoss("{}: not a recorded answer: {}", path, answer.status().message());
}

absl::StatusOr<ChatAnswer> AnswerFolder::Put(const ChatRequest& request, const ChatAnswer& answer) const {
  RETURN_IF_ERROR(MakeFolder(path_));
  const absl::StatusOr<std::optional<ChatAnswer>> before = Find(request);
  if (before.ok() && before->has_value()) return **before;
  RETURN_IF_ERROR(runtime::WriteFileAtomically(path_ + "/" + FileName(request), RecordJson(request, answer)));
  return answer;
}

std::unique_ptr<LlmClient> MakeCachingClient(std::unique_ptr<LlmClient> inner, const std::string& path) {
  const std::string identity = inner->identity();
  return std::make_unique<FolderLlmClient>(FolderLlmClient::Use::kCache,
                                           path + "/" + runtime::Sha256Hex(identity).substr(0, 16), identity,
                                           std::move(inner));
}

absl::StatusOr<std::unique_ptr<LlmClient>> MakeRecordingClient(std::unique_ptr<LlmClient> inner,
                                                               const std::string& path) {
  const std::string identity = inner->identity();
  RETURN_IF_ERROR(AnswerFolder(path).ClaimFor(identity));
  return std::make_unique<FolderLlmClient>(FolderLlmClient::Use::kRecording, path, identity, std::move(inner));
}

absl::StatusOr<std::unique_ptr<LlmClient>> MakeReplayingClient(const std::string& path) {
  ASSIGN_OR_RETURN(std::string identity, AnswerFolder(path).Identity());
  return std::make_unique<FolderLlmClient>(FolderLlmClient::Use::kReplay, path, std::move(identity), nullptr);
}

}  // namespace flair::llm
