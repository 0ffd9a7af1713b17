// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <google/protobuf/arena.h>

namespace flair::orchestrator {

// A request whose large parts are artifacts that somebody else keeps, lent for the time of the call instead of copied.
// Who answers only reads it. One thread at a time.
template <typename Request>
class LentRequest {
 public:
  LentRequest() : request_(google::protobuf::Arena::CreateMessage<Request>(&arena_)) {}
  LentRequest(const LentRequest&) = delete;
  LentRequest& operator=(const LentRequest&) = delete;

  Request& operator*() { return *request_; }
  Request* operator->() { return request_; }

  // `set`: the field's unsafe_arena_set_allocated_… function. `part` outlives this and does not change meanwhile;
  // serializing it, by several threads too, writes nothing but sizes that are always the same.
  template <typename Part>
  void Lend(void (Request::*set)(Part*), const Part& part) {
    (request_->*set)(const_cast<Part*>(&part));
  }

 private:
  // A message of an arena does not free its parts.
  google::protobuf::Arena arena_;
  Request* const request_;
};

}  // namespace flair::orchestrator
