// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/testing/read_layout.h"

#include <google/protobuf/text_format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>

namespace flair::renderer {

const std::vector<std::string>& SampleLayouts() {
  static const auto& names = *new std::vector<std::string>{
      "attic_gym",     "bare_hall", "cloakroom",    "cross_chapel",   "crowded_kitchen", "l_shaped_studio",
      "long_corridor", "nursery",   "seminar_room", "small_bathroom", "vampire_bedroom", "writer_office"};
  return names;
}

v1::SolvedLayout ReadSample(const std::string& name) {
  std::ifstream file(std::string(FLAIR_SOURCE_DIR) + "/renderer_worker/drawing/testdata/" + name + ".textproto");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  v1::SolvedLayout layout;
  if (text.empty() || !google::protobuf::TextFormat::ParseFromString(text, &layout)) {
    std::cerr << "cannot read the sample layout " << name << "\n";
    std::abort();
  }
  return layout;
}

}  // namespace flair::renderer
