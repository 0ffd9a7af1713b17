// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where tinygltf's functions are compiled.
#include <fstream>  // its header forgets it

#define TINYGLTF_IMPLEMENTATION
#include "renderer_worker/gltf/tiny_gltf.h"
