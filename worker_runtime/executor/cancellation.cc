// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/executor/cancellation.h"

#include <utility>

namespace flair::runtime {

void Cancellation::Cancel() {
  std::lock_guard lock(mutex_);
  cancelled_.store(true, std::memory_order_release);
  for (auto& [key, callback] : callbacks_) callback();
  callbacks_.clear();
}

OnCancel::OnCancel(Cancellation& cancellation, std::function<void()> callback) : cancellation_(cancellation) {
  std::lock_guard lock(cancellation.mutex_);
  key_ = cancellation.next_key_++;
  if (cancellation.cancelled()) {
    callback();
  } else {
    cancellation.callbacks_.emplace(key_, std::move(callback));
  }
}

OnCancel::~OnCancel() {
  std::lock_guard lock(cancellation_.mutex_);
  cancellation_.callbacks_.erase(key_);
}

}  // namespace flair::runtime
