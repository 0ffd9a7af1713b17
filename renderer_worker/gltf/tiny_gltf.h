// SPDX-License-Identifier: GPL-3.0-or-later
// tinygltf as we use it: no files, no images decoded, no stb. Within gltf/ only; include it by this header alone, since
// its switches change its classes.
#pragma once

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>
