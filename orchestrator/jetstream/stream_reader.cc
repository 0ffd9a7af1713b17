// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/stream_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "absl/strings/escaping.h"
#include "absl/strings/numbers.h"
#include "absl/strings/str_split.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using nlohmann::json;

// Consumers that nobody removed, because their process died, go after this.
constexpr absl::Duration kConsumerLife = absl::Seconds(30);
// Messages that are asked for one by one before a consumer is made.
constexpr int kOneByOne = 32;
// A message on its way from the server.
constexpr absl::Duration kOneMessage = absl::Seconds(2);

json ConsumerOf(const std::string& stream, const std::string& filter, uint64_t first_sequence, bool with_content) {
  json config = {{"ack_policy", "none"},
                 {"replay_policy", "instant"},
                 {"filter_subject", filter},
                 {"inactive_threshold", absl::ToInt64Nanoseconds(kConsumerLife)},
                 {"num_replicas", 1},
                 {"mem_storage", true},
                 {"headers_only", !with_content},
                 {"deliver_policy", first_sequence <= 1 ? "all" : "by_start_sequence"}};
  if (first_sequence > 1) config["opt_start_seq"] = first_sequence;
  return {{"stream_name", stream}, {"config", config}};
}

}  // namespace

DeliveryPosition ParseDelivery(std::string_view reply_subject) {
  const std::vector<absl::string_view> tokens =
      absl::StrSplit(absl::string_view(reply_subject.data(), reply_subject.size()), '.');
  // $JS.ACK.[DOMAIN.ACCOUNT.]STREAM.CONSUMER.DELIVERIES.SEQUENCE.ORDER.TIME.PENDING[.MORE]
  DeliveryPosition delivery;
  if (tokens.size() < 9 || tokens[0] != "$JS" || tokens[1] != "ACK") return delivery;
  const size_t first = tokens.size() == 9 ? 4 : 6;
  if (!absl::SimpleAtoi(tokens[first], &delivery.delivery_count) ||
      !absl::SimpleAtoi(tokens[first + 1], &delivery.sequence)) {
    return {};
  }
  return delivery;
}

absl::StatusOr<std::vector<int64_t>> StreamReader::Count(const std::string& stream,
                                                         std::span<const std::string> filters) {
  std::vector<int64_t> counts(filters.size(), -1);
  const absl::Status status = api_.WithinLimit([&]() -> absl::Status {
    std::vector<size_t> places;
    std::vector<std::pair<std::string, json>> calls;
    for (size_t i = 0; i < filters.size(); ++i) {
      if (counts[i] >= 0) continue;
      places.push_back(i);
      calls.emplace_back("CONSUMER.CREATE." + stream, ConsumerOf(stream, filters[i], 1, false));
    }
    absl::Status failed;
    auto place = places.begin();
    for (const absl::StatusOr<json>& made : api_.CallAll(calls)) {
      const size_t i = *place++;
      failed.Update(made.status());
      if (!made.ok()) continue;
      counts[i] = made->value("num_pending", int64_t{0});
      Forget(stream, made->value("name", ""));
    }
    return failed;
  });
  if (!status.ok()) return status;
  return counts;
}

absl::StatusOr<std::map<std::string, int64_t>> StreamReader::Subjects(const std::string& stream,
                                                                      const std::string& filter) {
  ASSIGN_OR_RETURN(const json info, api_.Call("STREAM.INFO." + stream, json{{"subjects_filter", filter}}));
  std::map<std::string, int64_t> counts;
  const json subjects = info.value("state", json::object()).value("subjects", json::object());
  for (const auto& [subject, count] : subjects.items()) {
    if (count.is_number_integer()) counts[subject] = count.get<int64_t>();
  }
  return counts;
}

void StreamReader::Forget(const std::string& stream, const std::string& consumer) {
  (void)api_.connection().Publish({"$JS.API.CONSUMER.DELETE." + stream + "." + consumer, "", {}});
}

absl::StatusOr<std::vector<StreamReader::Message>> StreamReader::Read(const std::string& stream, const Range& range) {
  // Most of the time there is little that is new. Only where there is more, a consumer is worth its making.
  Range some = range;
  some.limit = std::min(range.limit, kOneByOne);
  absl::StatusOr<std::vector<Message>> read = ReadOneByOne(stream, some);
  if (!read.ok() || static_cast<int>(read->size()) < kOneByOne || range.limit == kOneByOne) return read;
  Range rest = range;
  rest.first_sequence = read->back().sequence + 1;
  rest.limit = range.limit - kOneByOne;
  absl::StatusOr<std::vector<Message>> more = api_.WithinLimit([&] { return ReadOnce(stream, rest); });
  if (!more.ok()) return more;
  std::ranges::move(*more, std::back_inserter(*read));
  return read;
}

absl::StatusOr<std::vector<StreamReader::Message>> StreamReader::ReadOneByOne(const std::string& stream,
                                                                              const Range& range) {
  std::vector<Message> read;
  uint64_t sequence = std::max<uint64_t>(1, range.first_sequence);
  while (static_cast<int>(read.size()) < range.limit) {
    const absl::StatusOr<json> answer =
        api_.Call("STREAM.MSG.GET." + stream, json{{"seq", sequence}, {"next_by_subj", range.filter}});
    if (absl::IsNotFound(answer.status())) break;
    if (!answer.ok()) return answer.status();
    const json found = answer->value("message", json::object());
    Message& message = read.emplace_back();
    message.subject = found.value("subject", "");
    message.sequence = found.value("seq", uint64_t{0});
    if (message.sequence < sequence || !absl::Base64Unescape(found.value("data", ""), &message.content)) {
      return absl::InternalError(fmt::format("stream {} gives a message that cannot be read", stream));
    }
    sequence = message.sequence + 1;
  }
  return read;
}

absl::StatusOr<std::vector<StreamReader::Message>> StreamReader::ReadOnce(const std::string& stream,
                                                                          const Range& range) {
  ASSIGN_OR_RETURN(const json made,
                   api_.Call("CONSUMER.CREATE." + stream,
                             ConsumerOf(stream, range.filter, range.first_sequence, range.with_content)));
  const std::string consumer = made.value("name", "");
  ASSIGN_OR_RETURN(std::unique_ptr<NatsInbox> inbox, api_.connection().OpenInbox());
  const json next = {{"batch", range.limit}, {"no_wait", true}};
  if (absl::Status status = api_.connection().Publish(
          {"$JS.API.CONSUMER.MSG.NEXT." + stream + "." + consumer, next.dump(), {}}, inbox->subject() + ".0");
      !status.ok()) {
    return status;
  }
  std::vector<Message> read;
  const int64_t there = made.value("num_pending", int64_t{0});
  while (static_cast<int64_t>(read.size()) < std::min<int64_t>(range.limit, there)) {
    absl::StatusOr<NatsMessage> message = inbox->Next(kOneMessage);
    if (!message.ok()) return absl::UnavailableError("the queue's servers stopped while they were read");
    if (message->status != 0) break;
    read.push_back({std::move(message->subject), std::move(message->content), ParseDelivery(message->reply).sequence});
  }
  Forget(stream, consumer);
  return read;
}

absl::StatusOr<uint64_t> StreamReader::LastSequence(const std::string& stream) {
  ASSIGN_OR_RETURN(const json info, api_.Call("STREAM.INFO." + stream, nullptr));
  return info.value("state", json::object()).value("last_seq", uint64_t{0});
}

}  // namespace flair::orchestrator
