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

#include "flair/v1/view_annotations.pb.h"
#include "renderer_worker/scene/scene.h"
#include "renderer_worker/tracing/world.h"

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
  void Clear() { std::ranges::fill(values_, 0.0F); }

 private:
  size_t stride_;
  Plane<float> values_;
};

// A pinhole camera with its picture: x right, y down, z forward, as v1::CameraParameters.
struct PinholeCamera {
  int width_px = 0, height_px = 0;
  float focal_px = 1;
  Vec3 eye, right, down, forward;

  // INVALID_ARGUMENT for a camera that looks straight up or down, or whose numbers are none.
  static absl::StatusOr<PinholeCamera> Make(const SceneCamera& camera, int width_px, int height_px);
  // Unit direction through a point of the picture; pixel (0, 0) covers [0, 1) x [0, 1).
  Vec3 Through(float column, float row) const {
    const float x = (column - 0.5F * static_cast<float>(width_px)) / focal_px;
    const float y = (row - 0.5F * static_cast<float>(height_px)) / focal_px;
    return Normalized(forward + right * x + down * y);
  }
  v1::CameraParameters Parameters() const;
};

// What is seen in a direction: the first surface, and, where that is glass or a mirror, the one whose light comes
// through or back.
struct Seen {
  int instance = -1;   // of the first surface; index in World::instances, -1 for nothing
  float distance = 0;  // to it
  Vec3 first_normal;
  Vec3 first_albedo;
  // What is lit: the surface behind glass or in mirrors.
  int lit_instance = -1;
  Vec3 position, normal;
  Vec3 albedo;    // diffuse, filtered
  Vec3 specular;  // reflectance straight on
  float roughness = 1;
  Vec3 filter{1, 1, 1};  // what glass and mirrors on the way leave of its light
  Vec3 added;            // light that comes from the way itself: emission, the sky behind
  Vec3 direction;        // in which the lit surface was looked at
};

// What a point's neighbours are judged by: position, normal (0 where nothing is lit), how far off the plane a neighbour
// may be (inverse, 1/m), the lit instance (a whole number; -1 for none, -2 for the ground).
enum Guide { kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kReach, kInstance, kGuideCount };

// Irradiance over pi, so that times the albedo it is radiance; the variance of its luminance as a mean of samples.
enum Light { kRed, kGreen, kBlue, kVariance, kLuminance, kLightCount };

// Points of the picture, row by row, with what falls on the surfaces that they show.
struct LightGrid {
  LightGrid(int width, int height)
      : width(width), height(height), guides(kGuideCount, size()), light(kLightCount, size()) {}
  size_t size() const { return static_cast<size_t>(width) * height; }

  int width, height;
  Planes guides;
  Planes light;
};

// A picture at work. What comes straight from the lights is known for every pixel, what other surfaces and the open
// sky send, which varies less, for every second pixel of every second row.
struct Frame {
  Frame(int width_px, int height_px)
      : direct(width_px, height_px),
        indirect((width_px + 1) / 2, (height_px + 1) / 2),
        gloss(3, indirect.size()),
        reflectance(indirect.size()),
        paint(direct.size()),
        added(direct.size()) {}

  LightGrid direct;
  LightGrid indirect;
  Planes gloss;              // by points of `indirect`: radiance that the surface mirrors, roughly
  Plane<float> reflectance;  // by points of `indirect`: the surface's share of light, diffuse and straight on
  Plane<Vec3> paint;         // by pixel: what of the light on the lit surface gets to the eye
  Plane<Vec3> added;         // by pixel: light that comes from the way itself
};

}  // namespace flair::renderer
