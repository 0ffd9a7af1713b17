// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>

namespace flair::studio {

// How many bytes all connections together may hold. Thread-safe; outlives what it has given.
class ByteBudget {
 public:
  explicit ByteBudget(int64_t bytes) : left_(bytes) {}

  // Gives back what it holds at its end.
  class Held {
   public:
    Held() = default;
    Held(Held&& other) noexcept { *this = std::move(other); }
    Held& operator=(Held&& other) noexcept {
      std::swap(budget_, other.budget_);
      std::swap(bytes_, other.bytes_);
      return *this;
    }
    ~Held() {
      if (budget_ != nullptr) budget_->left_ += bytes_;
    }

   private:
    friend class ByteBudget;
    Held(ByteBudget* budget, int64_t bytes) : budget_(budget), bytes_(bytes) {}
    ByteBudget* budget_ = nullptr;
    int64_t bytes_ = 0;
  };

  // Nothing when so many are not left.
  std::optional<Held> Take(int64_t bytes) {
    if (left_.fetch_sub(bytes) >= bytes) return Held(this, bytes);
    left_ += bytes;
    return std::nullopt;
  }

 private:
  std::atomic<int64_t> left_;
};

}  // namespace flair::studio
