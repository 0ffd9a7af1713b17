// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/jetstream/answers.h"

#include <fmt/format.h>

#include <utility>

#include "absl/strings/numbers.h"
#include "orchestrator/jetstream/connection.h"

namespace flair::orchestrator {

Answers::Answers(std::unique_ptr<NatsInbox> inbox) : inbox_(std::move(inbox)), thread_([this] { Run(); }) {}

Answers::~Answers() {
  inbox_->Close();
  thread_.join();
}

void Answers::Run() {
  while (true) {
    absl::StatusOr<NatsMessage> message = inbox_->Next(absl::Minutes(1));
    if (absl::IsDeadlineExceeded(message.status())) continue;
    if (!message.ok()) return;
    int64_t number = 0;
    if (!absl::SimpleAtoi(message->subject.substr(message->subject.rfind('.') + 1), &number)) continue;
    std::lock_guard lock(mutex_);
    const auto found = expected_.find(number);
    if (found == expected_.end()) continue;
    found->second->message_ = *std::move(message);
    found->second->arrived_.notify_all();
  }
}

Answers::Expected::Expected(Answers& answers)
    : answers_(answers), number_([&answers] {
        std::lock_guard lock(answers.mutex_);
        return answers.next_number_++;
      }()) {
  std::lock_guard lock(answers_.mutex_);
  answers_.expected_[number_] = this;
}

Answers::Expected::~Expected() {
  std::lock_guard lock(answers_.mutex_);
  answers_.expected_.erase(number_);
}

std::string Answers::Expected::reply() const { return fmt::format("{}.{}", answers_.inbox_->subject(), number_); }

std::optional<NatsMessage> Answers::Expected::Wait(absl::Duration limit) {
  std::unique_lock lock(answers_.mutex_);
  arrived_.wait_for(lock, absl::ToChronoMicroseconds(limit), [this] { return message_.has_value(); });
  return std::move(message_);
}

}  // namespace flair::orchestrator
