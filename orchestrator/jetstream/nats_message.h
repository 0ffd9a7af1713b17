// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace flair::orchestrator {

// What goes to a server.
struct NatsRequest {
  std::string subject;
  std::string content;
  std::vector<std::pair<std::string, std::string>> headers;
};

// What comes from one.
struct NatsMessage {
  std::string subject;
  std::string content;
  // Where an answer to it, such as an acknowledgement, goes.
  std::string reply;
  // The server's own, without content: 404 no message, 408 too late, 409 consumer gone, 503 nobody there; 0 for others.
  int status = 0;
};

}  // namespace flair::orchestrator
