// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "llm/client/llm_client.h"
#include "llm/openai/server_error.h"

namespace flair::llm {

// The data of each server-sent event of a stream, in order; names, ids and comments of events are skipped. Lines end in
// LF, CR LF or CR. An event that no empty line ended counts too. Any bytes are good input.
std::vector<std::string> EventsOf(std::string_view stream);

// What a reply is read with; all is borrowed.
struct ReplyContext {
  const std::string& address;  // begins every error
  const ChatRequest& request;
  const Confidential& confidential;
  const std::string& model;  // stands in for a name that the server does not say
};

// A reply of status 2xx.
struct ChatReply {
  ChatAnswer answer;
  bool thought = false;  // the model thought before it answered
};

// Reads the body of a reply, a whole completion or, of a server that was asked to stream, its events; one that knows no
// streams sends a whole completion then, too. Errors: DATA_LOSS when it is not of the protocol (HTML, empty, not JSON,
// no choices); UNAVAILABLE when a stream ends early; that of an error inside the reply.
absl::StatusOr<ChatReply> ReadReply(std::string_view body, bool streamed, const ReplyContext& context);

}  // namespace flair::llm
