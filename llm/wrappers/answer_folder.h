// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "llm/client/chat.h"

namespace flair::llm {

// Answers of a model in a folder, one JSON file each, found by the content of the request. The same request has one
// answer: the first that was put. Files say what was asked, so that people can read them; nothing in them is secret but
// the texts themselves. Several processes may share a folder. Thread-safe.
class AnswerFolder {
 public:
  // Uses the folder at `path`; for writing it is made when missing.
  explicit AnswerFolder(std::string path) : path_(std::move(path)) {}

  // The folder's file "identity" names the model that answered (LlmClient::identity()). FAILED_PRECONDITION when it
  // names another one: answers of two models do not mix. Writes it when there is none.
  absl::Status ClaimFor(const std::string& identity) const;
  // NOT_FOUND when the folder or its file "identity" is missing.
  absl::StatusOr<std::string> Identity() const;

  // DATA_LOSS for a file that is damaged, with its name.
  absl::StatusOr<std::optional<ChatAnswer>> Find(const ChatRequest& request) const;
  // Keeps the answer unless there is one, and returns the one that is kept.
  absl::StatusOr<ChatAnswer> Put(const ChatRequest& request, const ChatAnswer& answer) const;

  // The file of a request: "<step>-<first 16 digits of the digest of messages, schema, limit and seed>.json".
  static std::string FileName(const ChatRequest& request);

  const std::string& path() const { return path_; }

 private:
  const std::string path_;
};

// A request with its answer as JSON text, as it is kept in files, indented for people. Bytes that are not UTF-8 become
// U+FFFD.
std::string RecordJson(const ChatRequest& request, const ChatAnswer& answer);

// The answer of a record. DATA_LOSS, naming the field, for anything else.
absl::StatusOr<ChatAnswer> ReadRecordJson(const std::string& text);

}  // namespace flair::llm
