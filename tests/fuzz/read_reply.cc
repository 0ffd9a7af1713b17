// SPDX-License-Identifier: GPL-3.0-or-later
// A reply of the chat protocol from whoever passes for a server. However the bytes come in, the answer is the same.
#include <algorithm>
#include <string>
#include <vector>

#include "llm/openai/json_fields.h"
#include "llm/openai/plain_delta.h"
#include "llm/openai/reply_reader.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

const std::string& Address() {
  static const std::string address = "http://model";
  return address;
}

constexpr char kSecret[] = "sk-secret-key";

const llm::Confidential& Secrets() {
  static const llm::Confidential confidential{.secrets = {kSecret}, .messages = {}};
  return confidential;
}

using Answer = absl::StatusOr<llm::ChatAnswer>;

void CheckFailure(const absl::Status& status) {
  Require(!status.message().empty(), "a refusal says why");
  Require(status.ToString().find(kSecret) == std::string::npos, "no error holds a key");
}

// Sizes of pieces, one after the other and over again.
struct Pieces {
  size_t first;
  size_t second;
};

template <typename Take>
void Cut(std::string_view bytes, Pieces pieces, const Take& take) {
  for (bool odd = false; !bytes.empty(); odd = !odd) {
    const size_t size = std::min(bytes.size(), odd ? pieces.second : pieces.first);
    if (!take(bytes.substr(0, size))) return;
    bytes.remove_prefix(size);
  }
}

Answer Streamed(std::string_view bytes, Pieces pieces) {
  const llm::ChatRequest request;
  llm::ReplyReader reader(Address(), request, Secrets());
  absl::Status status;
  Cut(bytes, pieces, [&](std::string_view piece) {
    status = reader.Take(piece);
    return status.ok();
  });
  return status.ok() ? reader.FinishStream("m") : Answer(status);
}

void RequireSame(const Answer& one, const Answer& other) {
  Require(one.status() == other.status(), "a stream's pieces do not change its end");
  if (!one.ok()) return;
  Require(one->text == other->text, "a stream's pieces do not change the text");
  Require(one->finish == other->finish && one->model == other->model, "nor why it ended, nor who wrote it");
  Require(one->usage.output_token_count == other->usage.output_token_count, "nor what it costs");
}

std::vector<std::string> Events(std::string_view bytes, Pieces pieces) {
  std::vector<std::string> events;
  const auto keep = [&](std::string_view data) {
    events.emplace_back(data);
    return absl::OkStatus();
  };
  llm::SseReader reader;
  Cut(bytes, pieces, [&](std::string_view piece) { return reader.Take(piece, keep).ok(); });
  Require(reader.Finish(keep).ok(), "reading ends with an error of the taker only");
  return events;
}

bool Once(std::string_view text, std::string_view word) {
  const size_t at = text.find(word);
  return at != std::string_view::npos && text.find(word, at + 1) == std::string_view::npos;
}

bool Repeats(std::string_view text, const std::string& word) {
  const size_t at = text.find(word);
  return at != std::string_view::npos && text.find(word, at + 1) != std::string_view::npos;
}

// The quickest way brings what the quick one does.
void CheckQuickestWay(const std::vector<std::string>& chunks) {
  llm::RepeatedDelta repeated;
  for (const std::string& chunk : chunks) {
    const auto piece = llm::PlainDelta(chunk);
    if (const auto text = repeated.Text(chunk)) {
      Require(piece.has_value() && llm::PlainText(piece->string) == text, "a chunk like another is read like it");
      Require(text->empty() || piece->thought == repeated.thought(), "a thought is none of the answer");
    }
    if (piece.has_value()) repeated.Learn(chunk, *piece);
  }
}

// The quick way to read a chunk brings what the thorough one does, unless the chunk says something twice.
void CheckQuickWay(std::string_view chunk) {
  const auto piece = llm::PlainDelta(chunk);
  if (!piece.has_value() || chunk.find("\\u") != std::string_view::npos) return;
  if (!Once(chunk, "\"choices\"") || !Once(chunk, "\"delta\"")) return;
  const nlohmann::json parsed = llm::ParseJson(chunk);
  if (parsed.is_discarded()) return;
  const nlohmann::json text = llm::ParseJson(piece->string);
  const nlohmann::json& delta = parsed["choices"][0]["delta"];
  for (const char* name : {"content", "reasoning_content", "reasoning"}) {
    if (Repeats(chunk, "\"" + std::string(name) + "\"")) return;
    const bool of_thought = std::string_view(name) != "content";
    const std::string expected = llm::TextField(delta, name);
    if (of_thought != piece->thought) Require(expected.empty(), "the quick way leaves nothing out");
    if (!expected.empty()) Require(text == expected, "the quick way brings the text of the chunk");
  }
  const auto plain = llm::PlainText(piece->string);
  if (plain.has_value()) Require(text == std::string(*plain), "a plain text is the text");
}

}  // namespace

void ReadReply(std::string_view bytes) {
  if (bytes.empty()) return;
  const unsigned char sizes = static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  const Pieces whole{bytes.size(), bytes.size()}, odd{1u + sizes % 16, 1u + sizes / 16};

  const llm::ChatRequest request;
  const Answer at_once = llm::ReplyReader(Address(), request, Secrets()).Read(bytes, "m");
  if (!at_once.ok()) CheckFailure(at_once.status());

  const Answer streamed = Streamed(bytes, whole);
  if (!streamed.ok()) CheckFailure(streamed.status());
  RequireSame(streamed, Streamed(bytes, odd));

  const std::vector<std::string> events = Events(bytes, whole);
  Require(events == Events(bytes, odd), "pieces do not change the events");
  for (const std::string& event : events) CheckQuickWay(event);
  CheckQuickestWay(events);

  const llm::ServerError error = llm::ReadServerError(bytes);
  CheckFailure(llm::StatusOf(400 + sizes, error, "http://model: HTTP", Secrets()));
  llm::IsRefusal(error);
}

}  // namespace flair::fuzz
