// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/validator.h"

#include <string>
#include <system_error>

namespace flair::testing {
namespace {

namespace fs = std::filesystem;

const fs::path& SourceFolder() {
  static const fs::path folder = fs::path(FLAIR_SOURCE_DIR) / "tests/scene";
  return folder;
}

constexpr const char* kFiles[] = {"package.json", "package-lock.json", "validate.mjs"};

// Named after what is in it, so that it is made anew when one of the files changes.
fs::path InstalledFolder() {
  std::string all;
  for (const char* file : kFiles) all += ReadAll(SourceFolder() / file);
  return fs::path(FLAIR_BINARY_DIR) / ("gltf_validator_" + std::to_string(std::hash<std::string>()(all)));
}

Finished Install(const fs::path& folder) {
  // Beside its place and moved there whole, since several tests may install at once.
  std::string name = (fs::path(FLAIR_BINARY_DIR) / "gltf_validator.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) return {1, "", "cannot make a folder like " + name};
  const fs::path fresh = name;
  for (const char* file : kFiles) fs::copy_file(SourceFolder() / file, fresh / file);
  Process npm("/usr/bin/env", {"npm", "ci", "--no-audit", "--no-fund", "--prefix", fresh.string()});
  Finished finished = npm.Wait();
  std::error_code taken;
  if (finished.exit_code == 0) fs::rename(fresh, folder, taken);
  if (finished.exit_code != 0 || taken) fs::remove_all(fresh);
  if (finished.exit_code != 0) finished.err = "npm could not install gltf-validator: " + finished.out + finished.err;
  return finished;
}

}  // namespace

Finished ValidateGlb(const std::vector<fs::path>& files) {
  const fs::path folder = InstalledFolder();
  if (!fs::exists(folder)) {
    if (Finished installed = Install(folder); installed.exit_code != 0) return installed;
  }
  std::vector<std::string> arguments = {"node", (folder / "validate.mjs").string()};
  for (const fs::path& file : files) arguments.push_back(file.string());
  Process node("/usr/bin/env", arguments);
  return node.Wait();
}

}  // namespace flair::testing
