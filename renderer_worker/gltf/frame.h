// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>

#include "renderer_worker/scene/mesh.h"

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

}  // namespace flair::renderer::gltf
