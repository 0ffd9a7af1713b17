// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/gltf/mesh_book.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include "fmt/format.h"
#include "renderer_worker/gltf/frame.h"

namespace flair::renderer::gltf {
namespace {

absl::Status Check(const MeshPart& part, const std::string& name) {
  const size_t count = part.positions.size();
  if (part.normals.size() != count || (!part.uvs.empty() && part.uvs.size() != count) || part.indices.size() % 3 != 0) {
    return absl::InternalError(fmt::format("the mesh of {} has {} positions, {} normals, {} uvs and {} indices", name,
                                           count, part.normals.size(), part.uvs.size(), part.indices.size()));
  }
  for (size_t i = 0; i < count; ++i) {
    if (!IsFinite(part.positions[i]) || !IsFinite(part.normals[i])) {
      return absl::InternalError(fmt::format("vertex {} of the mesh of {} is not finite", i, name));
    }
  }
  for (const uint32_t index : part.indices) {
    if (index >= count) {
      return absl::InternalError(fmt::format("the mesh of {} names vertex {} of {}", name, index, count));
    }
  }
  return absl::OkStatus();
}

// FNV-1a over words.
class Digest {
 public:
  template <typename T>
  void Add(const std::vector<T>& values) {
    const auto* words = reinterpret_cast<const uint32_t*>(values.data());
    for (size_t i = 0; i < values.size() * sizeof(T) / 4; ++i) Add(words[i]);
    Add(static_cast<uint32_t>(values.size()));
  }
  void Add(uint32_t word) { value_ = (value_ ^ word) * 0x100000001B3U; }
  uint64_t value() const { return value_; }

 private:
  uint64_t value_ = 0xCBF29CE484222325U;
};

uint64_t DigestOf(const Mesh& mesh, MeshFrame frame) {
  Digest digest;
  digest.Add(static_cast<uint32_t>(frame));
  for (const MeshPart& part : mesh.parts) {
    digest.Add(part.positions);
    digest.Add(part.indices);
  }
  return digest.value();
}

bool Equal(const Mesh& a, const Mesh& b) {
  return std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                    [](const MeshPart& p, const MeshPart& q) {
                      return p.material == q.material && p.positions == q.positions && p.normals == q.normals &&
                             p.uvs == q.uvs && p.indices == q.indices;
                    });
}

// The part in glTF's frame, without triangles that have lost a corner, vertices that no triangle has, and uvs that
// nothing uses.
Vertices Converted(const MeshPart& part, MeshFrame frame) {
  Vertices out;
  const Vec2 scale = MaterialBook::UvScale(part.material);
  constexpr uint32_t kUnseen = ~uint32_t{0};
  std::vector<uint32_t> moved(part.positions.size(), kUnseen);
  const auto convert = [&](Vec3 v) { return frame == MeshFrame::kRoom ? FromRoom(v) : FromObject(v); };
  const auto vertex = [&](uint32_t index) {
    if (moved[index] == kUnseen) {
      moved[index] = static_cast<uint32_t>(out.positions.size());
      out.positions.push_back(convert(part.positions[index]));
      out.normals.push_back(Normalized(convert(part.normals[index])));
      const Vec2 uv = index < part.uvs.size() ? part.uvs[index] : Vec2{};
      if (scale.x > 0) out.uvs.push_back({uv.x * scale.x, uv.y * scale.y});
    }
    return moved[index];
  };
  out.indices.reserve(part.indices.size());
  for (size_t i = 0; i < part.indices.size(); i += 3) {
    const uint32_t a = part.indices[i];
    const uint32_t b = part.indices[i + 1];
    const uint32_t c = part.indices[i + 2];
    if (a != b && b != c && c != a) out.indices.insert(out.indices.end(), {vertex(a), vertex(b), vertex(c)});
  }
  return out;
}

}  // namespace

absl::StatusOr<int> MeshBook::NumberOf(const Mesh& mesh, MeshFrame frame, const std::string& name) {
  auto& namesakes = written_[DigestOf(mesh, frame)];
  for (const Written& known : namesakes) {
    if (known.frame == frame && (known.mesh == &mesh || Equal(*known.mesh, mesh))) return known.number;
  }
  for (const MeshPart& part : mesh.parts) {
    if (absl::Status sound = Check(part, name); !sound.ok()) return sound;
  }
  namesakes.push_back({&mesh, frame, Write(mesh, frame, name)});
  return namesakes.back().number;
}

int MeshBook::Write(const Mesh& mesh, MeshFrame frame, const std::string& name) {
  tinygltf::Mesh written;
  written.name = name;
  for (const MeshPart& part : mesh.parts) {
    const Vertices vertices = Converted(part, frame);
    if (vertices.indices.empty()) continue;
    tinygltf::Primitive primitive = buffer_.Add(vertices);
    primitive.material = materials_.NumberOf(part.material);
    written.primitives.push_back(std::move(primitive));
  }
  if (written.primitives.empty()) return -1;
  model_.meshes.push_back(std::move(written));
  return static_cast<int>(model_.meshes.size()) - 1;
}

}  // namespace flair::renderer::gltf
