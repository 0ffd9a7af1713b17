// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

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

}  // namespace flair::renderer
