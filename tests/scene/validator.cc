// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scene/validator.h"

#include <string>

#include "tests/fixtures/npm_folder.h"

namespace flair::testing {

Finished ValidateGlb(const std::vector<std::filesystem::path>& files) {
  static const NpmFolder validator("gltf_validator", std::filesystem::path(FLAIR_SOURCE_DIR) / "tests/scene",
                                   {"package.json", "package-lock.json", "validate.mjs"});
  std::vector<std::string> command = {"node", (validator.path() / "validate.mjs").string()};
  for (const std::filesystem::path& file : files) command.push_back(file.string());
  return validator.Run(command);
}

}  // namespace flair::testing
