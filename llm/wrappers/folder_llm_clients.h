// SPDX-License-Identifier: GPL-3.0-or-later
// Clients that keep answers in folders: a cache, a recording, and a replay of a recording.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "llm/client/llm_client.h"

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

// Clients that keep the answers of `inner` in a folder, or give those of one. What a folder has is not asked again.

// A cache: a folder of its own in `path` for each identity. One that cannot be read or written is as if it were empty.
std::unique_ptr<LlmClient> MakeCachingClient(std::unique_ptr<LlmClient> inner, const std::string& path);

// A recording, which MakeReplayingClient gives again. An answer that cannot be written is an error: a recording with a
// hole is none. Errors as AnswerFolder::ClaimFor.
absl::StatusOr<std::unique_ptr<LlmClient>> MakeRecordingClient(std::unique_ptr<LlmClient> inner,
                                                               const std::string& path);

// The answers of a recording, without a network; passes for the model that was recorded. What was recorded without a
// seed, or with seed 0, answers every seed. A request that the recording does not have is NOT_FOUND, naming the step
// and the file that is missing. Errors as AnswerFolder::Identity.
absl::StatusOr<std::unique_ptr<LlmClient>> MakeReplayingClient(const std::string& path);

}  // namespace flair::llm
