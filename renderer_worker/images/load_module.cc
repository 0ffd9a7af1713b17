// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/images/load_module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

namespace flair::renderer {
namespace {

constexpr char kFileName[] = "libflair_image_writer.so";

std::vector<std::filesystem::path> Places() {
  std::vector<std::filesystem::path> places;
  if (const char* folder = std::getenv("FLAIR_MODULE_DIR"); folder != nullptr) places.emplace_back(folder);
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
  if (!error) {
    places.push_back(program);
    places.push_back(program.parent_path() / "lib");
    places.push_back(program.parent_path() / "lib" / "flair");
  }
  places.emplace_back(FLAIR_MODULE_BUILD_DIR);
  return places;
}

absl::StatusOr<const EncoderModule*> LoadModule() {
  std::string tried;
  for (const std::filesystem::path& place : Places()) {
    const std::filesystem::path file = place / kFileName;
    std::error_code error;
    if (!std::filesystem::exists(file, error)) {
      tried += (tried.empty() ? "" : ", ") + place.string();
      continue;
    }
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) return absl::UnavailableError(fmt::format("cannot load the image writer: {}", dlerror()));
    const auto* encoder = static_cast<const EncoderModule*>(dlsym(module, kEncoderModuleSymbol));
    if (encoder == nullptr || encoder->version != kEncoderModuleVersion) {
      return absl::UnavailableError(fmt::format("{} belongs to another version of this program", file.string()));
    }
    return encoder;
  }
  return absl::UnavailableError(
      fmt::format("cannot find {}; looked in {}; FLAIR_MODULE_DIR may name its folder", kFileName, tried));
}

}  // namespace

absl::StatusOr<const EncoderModule*> LoadImageModule() {
  static std::once_flag once;
  static absl::StatusOr<const EncoderModule*> module = absl::UnavailableError("not loaded");
  std::call_once(once, [] { module = LoadModule(); });
  return module;
}

}  // namespace flair::renderer
