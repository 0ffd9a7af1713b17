// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <curl/curl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "llm/http/http_request.h"

namespace flair::llm {

class Transfer;

// What one call to libcurl reads. An answer comes in hundreds of pieces: asking for the time of each, or passing each
// on by itself, would be much of the work.
struct ReadRound {
  // runtime::SystemClock().Elapsed().
  absl::Duration now;
  // Of bodies, decompressed.
  int64_t body_byte_count = 0;
  // Pieces that came for a transfer with on_piece and were not passed on yet; some 64 KiB at most.
  Transfer* gathering = nullptr;
  std::string gathered;
  // Those whose on_piece wanted no more: they are to be aborted.
  std::vector<int64_t> refused;

  // Passes on what was gathered.
  void Deliver();
};

// One request on its way: a libcurl easy handle, what came so far, and when to give up. Made by any thread, then used
// by the loop thread.
class Transfer {
 public:
  // `deadline` is when the caller stops waiting; times are runtime::SystemClock().Elapsed().
  Transfer(HttpRequest request, const HttpOptions& options, absl::Duration start, absl::Duration deadline);

  // OK when the handle could be made.
  const absl::Status& status() const { return failure_; }
  CURL* handle() const { return handle_.get(); }

  // Before libcurl runs it, under its id. `round` is shared by all that libcurl reads at once, and outlives this.
  void Join(ReadRound* round, int64_t id) {
    round_ = round;
    id_ = id;
  }

  // The earliest moment at which Expired() can have an error, as known at `now`.
  absl::Duration NextCheck(absl::Duration now) const;
  // The error of a transfer that has run out of time at `now`.
  std::optional<absl::Status> Expired(absl::Duration now) const;

  // What came of it, after libcurl said `code`.
  absl::StatusOr<HttpResponse> Finish(CURLcode code);

 private:
  friend struct ReadRound;

  struct CleanUp {
    void operator()(CURL* handle) const { curl_easy_cleanup(handle); }
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
  };

  void SetOptions(const HttpOptions& options);
  void AddHeaders();
  size_t TakeHeader(std::string_view line);
  size_t TakeBody(std::string_view piece);
  // Keeps the piece for ReadRound::Deliver. False when no more is wanted.
  bool Gather(std::string_view piece);
  // Of the answer, by HTTP; 0 when there is none yet.
  int HttpStatus() const;
  absl::Status ErrorOf(CURLcode code) const;

  HttpRequest request_;
  const HttpTimeouts timeouts_;
  const int64_t body_byte_limit_;
  const absl::Duration total_end_;
  const absl::Duration deadline_;
  // Since when the server is silent; infinite while connecting.
  absl::Duration silent_since_ = absl::InfiniteDuration();
  std::unique_ptr<curl_slist, CleanUp> header_list_;
  HttpResponse response_;
  int64_t body_byte_count_ = 0;
  // Since the first piece of the body.
  int status_ = 0;
  ReadRound* round_ = nullptr;
  int64_t id_ = 0;
  int64_t header_byte_count_ = 0;
  // Why the transfer was ended from our side.
  absl::Status failure_;
  // Enough of the body of an error was read.
  bool enough_ = false;
  // The last member: closing a handle may still call back.
  std::unique_ptr<CURL, CleanUp> handle_;
  char error_text_[CURL_ERROR_SIZE] = {};
};

}  // namespace flair::llm
