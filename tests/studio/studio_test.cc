// SPDX-License-Identifier: GPL-3.0-or-later
// The studio as people use it: the real program, a real Chromium. `./flair test` builds the page before.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/fixtures/programs.h"

namespace flair::testing {
namespace {

namespace fs = std::filesystem;

fs::path Source() { return fs::path(FLAIR_SOURCE_DIR) / "tests/studio"; }

class StudioPage : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(fs::exists(fs::path(FLAIR_BINARY_DIR) / "studio_web/index.html"))
        << "the page is not built; ./flair test builds it";
  }

  // A script of this folder, beside what it imports.
  static void Play(const std::string& script) {
    static const NpmFolder npm(
        "studio", Source(),
        {"package.json", "package-lock.json", "studio.mjs", "edit.mjs", "own_room.mjs", "batches.mjs", "rooms.mjs"});
    const Finished played = npm.Run({"FLAIR=" + ProgramPath("flair").string(), "node", (npm.path() / script).string()});
    EXPECT_EQ(played.exit_code, 0) << played.out << played.err;
  }
};

TEST_F(StudioPage, ARoomIsDesignedEditedExplainedAndUndone) { Play("edit.mjs"); }

TEST_F(StudioPage, AnOwnRoomIsDrawnFurnishedAndChanged) { Play("own_room.mjs"); }

TEST_F(StudioPage, RoomsAreNamedCopiedDeletedPutBackAndSaved) { Play("rooms.mjs"); }

TEST_F(StudioPage, BatchesAreLookedAtAndAVariantIsTaken) { Play("batches.mjs"); }

TEST_F(StudioPage, ItsModulesHoldAndItsTypesFit) {
  for (const char* const script : {"check", "test"}) {
    Process npm("/usr/bin/env", {"npm", "--prefix", std::string(FLAIR_SOURCE_DIR) + "/studio/web", "run", script});
    const Finished finished = npm.Wait();
    EXPECT_EQ(finished.exit_code, 0) << finished.out << finished.err;
  }
}

}  // namespace
}  // namespace flair::testing
