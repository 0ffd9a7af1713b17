// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/mman.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

// Wider vectors where the processor has them; every operation rounds alike, so the result is the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define FLAIR_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FLAIR_WIDE_VECTORS
#endif

namespace flair::renderer {

// Leaves what a vector grows by as the memory has it.
template <typename T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  template <typename U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <typename U>
  void construct(U*) noexcept {}
  template <typename U, typename... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

// A value for each pixel. resize(n) leaves the new ones unset, so that the threads which fill rows are the first to
// touch their memory.
template <typename T>
using PixelVector = std::vector<T, UnsetAllocator<T>>;

// Values for the pixels of a picture; none before they are written, so that the threads which fill rows are the first
// to touch their memory. In large pages where the system has them.
template <typename T>
class Plane {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  // Throws std::bad_alloc.
  explicit Plane(size_t size) : size_(size) {
    constexpr size_t kLine = 64, kLargePage = size_t{1} << 21;
    const size_t alignment = size * sizeof(T) < 2 * kLargePage ? kLine : kLargePage;
    const size_t bytes = (size * sizeof(T) / alignment + 1) * alignment;
    values_.reset(static_cast<T*>(std::aligned_alloc(alignment, bytes)));
    if (values_ == nullptr) throw std::bad_alloc();
    // A wish: small pages are as good, but slower.
    if (alignment == kLargePage) madvise(values_.get(), bytes, MADV_HUGEPAGE);
  }
  size_t size() const { return size_; }
  T* data() { return values_.get(); }
  const T* data() const { return values_.get(); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](size_t at) { return values_.get()[at]; }
  const T& operator[](size_t at) const { return values_.get()[at]; }

 private:
  struct Free {
    void operator()(T* values) const { std::free(values); }
  };
  size_t size_;
  std::unique_ptr<T, Free> values_;
};

// Planes of floats in one piece. Each begins at another place of a page: planes in step would drive each other out of
// the processor's cache.
class Planes {
 public:
  // Throws std::bad_alloc.
  Planes(int plane_count, size_t size) : stride_((size + 1023) / 1024 * 1024 + 80), values_(plane_count * stride_) {}
  float* operator[](int plane) { return &values_[plane * stride_]; }
  const float* operator[](int plane) const { return &values_[plane * stride_]; }
  void Clear() { std::fill(values_.begin(), values_.end(), 0.0F); }

 private:
  size_t stride_;
  Plane<float> values_;
};

}  // namespace flair::renderer
