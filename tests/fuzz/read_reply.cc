// SPDX-License-Identifier: GPL-3.0-or-later
// A reply of the chat protocol from whoever passes for a server, streamed or at once.
#include <string>

#include "llm/openai/reply_reader.h"
#include "tests/fuzz/targets.h"

namespace flair::fuzz {
namespace {

constexpr char kSecret[] = "sk-secret-key";

void CheckFailure(const absl::Status& status) {
  Require(!status.message().empty(), "a refusal says why");
  Require(status.ToString().find(kSecret) == std::string::npos, "no error holds a key");
}

}  // namespace

void ReadReply(std::string_view bytes) {
  if (bytes.empty()) return;
  const unsigned char first = static_cast<unsigned char>(bytes.front());
  bytes.remove_prefix(1);
  const std::string address = "http://model", model = "m";
  const llm::ChatRequest request;
  const llm::Confidential confidential{.secrets = {kSecret}, .messages = {}};
  for (const bool streamed : {false, true}) {
    const auto reply = llm::ReadReply(bytes, streamed, {address, request, confidential, model});
    if (!reply.ok()) CheckFailure(reply.status());
  }
  for (const std::string& event : llm::EventsOf(bytes)) {
    Require(event.size() <= bytes.size(), "an event is no longer than its stream");
  }
  const llm::ServerError error = llm::ReadServerError(bytes);
  CheckFailure(llm::StatusOf(400 + first, error, "http://model: HTTP", confidential));
  llm::IsRefusal(error);
}

}  // namespace flair::fuzz
