// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "absl/status/statusor.h"
#include "absl/time/time.h"
#include "worker_runtime/bootstrap/call_context.h"
#include "worker_runtime/clock/clock.h"

namespace flair::runtime {

// A handler for ServeUnary that tells `observe(request, response, duration)` of every good answer of another handler,
// for counting. The arguments outlive it; `observe` is called from several threads at once.
template <typename Handler, typename Observe>
class ObservedHandler {
 public:
  ObservedHandler(Handler& inner, const Clock& clock, Observe observe)
      : inner_(inner), clock_(clock), observe_(std::forward<Observe>(observe)) {}

  template <typename Request>
  auto Handle(const Request& request, CallContext& call) {
    const absl::Duration start = clock_.Elapsed();
    auto response = inner_.Handle(request, call);
    if (response.ok()) observe_(request, *response, clock_.Elapsed() - start);
    return response;
  }

 private:
  Handler& inner_;
  const Clock& clock_;
  Observe observe_;
};

}  // namespace flair::runtime
