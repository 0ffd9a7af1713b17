// SPDX-License-Identifier: GPL-3.0-or-later
// A reply of the chat protocol from whoever passes for a server. However the bytes come in, the answer is the same.
#include <algorithm>
#include <string>
#include <vector>

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

  const llm::ServerError error = llm::ReadServerError(bytes);
  CheckFailure(llm::StatusOf(400 + sizes, error, "http://model: HTTP", Secrets()));
  llm::IsRefusal(error);
}

}  // namespace flair::fuzz
