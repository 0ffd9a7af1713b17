// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "cli/output/artifact_text.h"
#include "optimizer_worker/constraints/registry.h"

namespace flair::cli {
namespace {

TEST(Catalog, TheReferencePageIsNotStale) {
  std::ifstream file(FLAIR_SOURCE_DIR "/docs/constraints.md");
  std::stringstream page;
  page << file.rdbuf();
  EXPECT_TRUE(page.str() == CatalogMarkdown(optimizer::MakeCatalog()))
      << "write it anew: flair catalog --markdown > docs/constraints.md";
}

TEST(Catalog, EveryTypeIsOnThePage) {
  const std::string page = CatalogMarkdown(optimizer::MakeCatalog());
  for (const v1::ConstraintType& type : optimizer::MakeCatalog().types()) {
    EXPECT_NE(page.find("### " + type.name() + "\n"), std::string::npos) << type.name() << ", family " << type.family();
  }
}

}  // namespace
}  // namespace flair::cli
