// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "orchestrator/jetstream/api.h"

namespace flair::orchestrator {

// Where a message that a consumer delivered stands, as its reply subject says.
struct DeliveryPosition {
  uint64_t sequence = 0;
  // How often it was delivered, with this time.
  int64_t delivery_count = 0;
};
// All 0 when the subject is none of those.
DeliveryPosition ParseDelivery(std::string_view reply_subject);

// Reads streams by consumers that live no longer than the call. Errors as JetStreamApi. Thread-safe.
class StreamReader {
 public:
  explicit StreamReader(JetStreamApi& api) : api_(api) {}

  // How many messages have subjects that match each filter; the stream's servers count, nothing is read. While a server
  // that just died is still believed to live, one may be asked that does not answer, and another is asked.
  absl::StatusOr<std::vector<int64_t>> Count(const std::string& stream, std::span<const std::string> filters);

  // The subjects that match, at most some thousands, with their messages. One answer of the stream's leader.
  absl::StatusOr<std::map<std::string, int64_t>> Subjects(const std::string& stream, const std::string& filter);

  struct Range {
    std::string filter;
    // From this one on, in order.
    uint64_t first_sequence = 1;
    int limit = 1000;
    bool with_content = true;
  };
  struct Message {
    std::string subject;
    std::string content;
    uint64_t sequence = 0;
  };
  absl::StatusOr<std::vector<Message>> Read(const std::string& stream, const Range& range);

  // The highest sequence that the stream gave; 0 when none.
  absl::StatusOr<uint64_t> LastSequence(const std::string& stream);

 private:
  absl::StatusOr<std::vector<Message>> ReadOneByOne(const std::string& stream, const Range& range);
  absl::StatusOr<std::vector<Message>> ReadOnce(const std::string& stream, const Range& range);
  void Forget(const std::string& stream, const std::string& consumer);

  JetStreamApi& api_;
};

}  // namespace flair::orchestrator
