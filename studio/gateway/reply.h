// SPDX-License-Identifier: GPL-3.0-or-later
// Answers over HTTP.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/status.h"

namespace flair::studio {

struct Reply {
  int status = 200;
  // Beside those of every answer (HeadOf).
  std::vector<std::pair<std::string_view, std::string>> headers = {};
  std::string body = "";
  // In place of `body`: a file of the page, which outlives the answer.
  std::string_view file = {};
  // The connection ends with this answer.
  bool close = false;
  // The length is told, the bytes are not sent.
  bool head_only = false;

  std::string_view content() const { return file.empty() ? std::string_view(body) : file; }
};

// A page of plain text.
Reply TextReply(int status, std::string text);

// An error of a call, as JSON, with the HTTP status of its code.
Reply ErrorReply(const absl::Status& error);
// The same with another HTTP status.
Reply ErrorReply(int http_status, const absl::Status& error);

// Status line and headers, with the empty line at their end. Every answer tells the browser to run, show, embed and
// send nothing but what comes from here.
std::string HeadOf(const Reply& reply);
// The same of an answer in chunks.
std::string StreamHead(std::string_view content_type);

}  // namespace flair::studio
