// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "renderer_worker/gltf/gltf.h"
#include "renderer_worker/gltf/tiny_gltf.h"
#include "renderer_worker/scene/mesh.h"
#include "renderer_worker/scene/scene.h"

namespace flair::renderer::gltf {

// How our frames become glTF's, which is right-handed, y up, metres, and wants the front of an asset to look along +z.
//
// Room frame R (x east, y north, z up):      g = (x, z, -y)      north is -z
// Object frame O (y to the front, z up):     g = (-x, z, y)      the front is +z, as glTF asks of assets
//
// Both are rotations, so triangles keep their winding. A node of heading theta turns by theta + pi about +y.

constexpr Vec3 FromRoom(Vec3 p) { return {p.x, p.z, -p.y}; }
constexpr Vec3 FromObject(Vec3 p) { return {-p.x, p.z, p.y}; }
constexpr Vec3 ToObject(Vec3 g) { return {-g.x, g.z, g.y}; }

// x, y, z, w.
using Quaternion = std::array<double, 4>;

// Of a node whose mesh is in FromObject form and whose heading in R is `theta_rad`.
inline Quaternion NodeRotation(double theta_rad) { return {0, std::cos(theta_rad / 2), 0, -std::sin(theta_rad / 2)}; }

// To six decimals, so that files hold 0.8 and not 0.800000011920929. Zero is positive.
inline double Rounded(double value) { return std::round(value * 1e6) / 1e6 + 0.0; }

// What a pattern does to a material's colour at one point: (1 - mix) colour + mix second_colour, times shade.
struct Tone {
  float mix = 0;    // [0, 1]
  float shade = 1;  // [kDarkestShade, kLightestShade]
};

inline constexpr float kDarkestShade = 0.78F;
inline constexpr float kLightestShade = 1.12F;

// What is drawn for a material: its pattern, but stone that is laid in stones apart from stone in one piece.
enum class Figure {
  kPlain,
  kWood,
  kPlanks,
  kHerringbone,
  kTiles,
  kBricks,
  kStone,
  kCarpet,
  kFabric,
  kWallpaper,
  kStones
};
inline constexpr int kFigureCount = 11;

// Stone of a size below a metre is laid, as flags or rubble.
Figure FigureOf(const Material& material);

// The rectangle after which a pattern repeats, in units of pattern_size_m: a board's or stave's width, a tile's side, a
// brick's length, a stone or cloud, a tuft, a thread, a repeat of wallpaper. (0, 0) for kPlain.
Vec2 PeriodOf(Figure figure);

// The tone at (u, v), units of pattern_size_m, within the period. Grain and boards run along u.
Tone ToneAt(Figure figure, float u, float v);

// One period of a material's pattern as a PNG that tiles, row 0 at v = 0. Its pixels are numbers of tones, which depend
// on the pattern alone and are computed once per process; the palette gives them the material's colours. Empty for
// kPlain. Thread-safe, the same bytes for the same material.
std::string PatternPng(const Material& material);

// Vertices and indices of one primitive, in glTF's frame. `uvs` may be empty.
struct Vertices {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;
  std::vector<uint32_t> indices;
};

// Collects what goes into the binary chunk and describes it in the model: vertices interleaved in one view per stride,
// indices in one view per width, images in views of their own. Every offset is a multiple of 4.
class GlbBuffer {
 public:
  // `model` must outlive this.
  explicit GlbBuffer(tinygltf::Model& model) : model_(model) {}

  // A primitive without material. Positions must not be empty and every index must be one of them.
  tinygltf::Primitive Add(const Vertices& vertices);

  // Number of the image.
  int AddImage(std::string_view mime_type, std::string_view bytes);

  // Puts all together; call once, at the end.
  void Finish();

 private:
  struct Section {
    std::vector<unsigned char> bytes;
    std::vector<int> accessors;
  };
  int AddAccessor(Section& section, size_t offset, int component_type, int type, size_t count);
  void FinishSection(Section& section, int target, size_t stride);

  tinygltf::Model& model_;
  Section plain_;     // position, normal: 24 bytes
  Section textured_;  // position, normal, uv: 32 bytes
  Section short_indices_;
  Section long_indices_;
  std::vector<std::vector<unsigned char>> images_;
};

// The materials of a file, each once. Patterns become textures that tile; emission above 1 uses
// KHR_materials_emissive_strength.
class MaterialBook {
 public:
  // Both must outlive this.
  MaterialBook(tinygltf::Model& model, GlbBuffer& buffer) : model_(model), buffer_(buffer) {}

  // Number of the material in the file.
  int NumberOf(const Material& material);

  // What texture coordinates of the scene are multiplied with in the file; (0, 0) where the material has no texture.
  static Vec2 UvScale(const Material& material);

 private:
  int Write(const Material& material);
  int TextureOf(const Material& material);
  int SamplerNumber();

  tinygltf::Model& model_;
  GlbBuffer& buffer_;
  std::map<std::string, std::vector<std::pair<Material, int>>> written_;  // by name
  std::map<const SurfaceImage*, int> images_;                             // texture of each
  std::map<std::string, int> patterns_;                                   // texture of each, by its PNG
};

// Which frame a mesh is in: R for the shell, O for furniture.
enum class MeshFrame { kRoom, kObject };

// The meshes of a file; those with equal content and frame are one.
class MeshBook {
 public:
  // All must outlive this.
  MeshBook(tinygltf::Model& model, GlbBuffer& buffer, MaterialBook& materials)
      : model_(model), buffer_(buffer), materials_(materials) {}

  // Number of the mesh in the file, -1 for one without triangles. `mesh` must outlive this; the first of equal meshes
  // gives the name. INTERNAL for a mesh that is not sound: arrays of different lengths, numbers that are not finite,
  // indices of no vertex.
  absl::StatusOr<int> NumberOf(const Mesh& mesh, MeshFrame frame, const std::string& name);

 private:
  struct Written {
    const Mesh* mesh;
    MeshFrame frame;
    int number;
  };
  int Write(const Mesh& mesh, MeshFrame frame, const std::string& name);

  tinygltf::Model& model_;
  GlbBuffer& buffer_;
  MaterialBook& materials_;
  std::vector<Written> written_;
};

// The bytes of a model with one buffer. RESOURCE_EXHAUSTED: more than GLB holds; INTERNAL: what JSON cannot hold.
absl::StatusOr<std::string> GlbText(const tinygltf::Model& model);

// What nodes say of themselves in `extras`; docs/scene.md lists the fields. Borrows the layout.
class Extras {
 public:
  explicit Extras(const v1::SolvedLayout& layout);

  tinygltf::Value OfObject(const SceneObject& object) const;
  tinygltf::Value OfShellPart(const ShellPart& part) const;
  static tinygltf::Value OfAsset(const Scene& scene, const GlbMetadata& metadata);

 private:
  tinygltf::Value ConstraintOf(int edge) const;

  const v1::SolvedLayout& layout_;
  std::map<std::string, std::vector<int>> edges_of_;    // object id -> edges that name it
  std::map<std::string, std::string> sentences_;        // id -> text
  std::map<std::string, const v1::Opening*> openings_;  // by id
};

}  // namespace flair::renderer::gltf
