// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace flair::renderer::gltf {

// A triangle as GLB, good unless members are replaced: each JSON is merged into the part it is named after.
struct TriangleFile {
  std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  nlohmann::json node = nlohmann::json::object();
  nlohmann::json primitive = nlohmann::json::object();
  nlohmann::json accessor = nlohmann::json::object();  // of the positions
  nlohmann::json view = nlohmann::json::object();      // of the positions
  nlohmann::json top = nlohmann::json::object();
  std::string image = {};  // base colour picture, when not empty
};
std::string TriangleGlb(const TriangleFile& file);

// A GLB of any JSON text and binary chunk.
std::string GlbOf(std::string_view json, std::string_view binary);

}  // namespace flair::renderer::gltf
