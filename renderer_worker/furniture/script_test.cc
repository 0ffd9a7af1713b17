// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/script.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace flair::renderer {
namespace {

int Take(lua_State* state) {
  SessionOf<double>(state) = NumberAt(state, 1);
  return 0;
}

// What `take` was called with last, or the error.
std::string Result(const std::string& text, double* taken = nullptr, const char* name = "piece") {
  static constexpr luaL_Reg kFunctions[] = {{"take", Take}, {nullptr, nullptr}};
  const ScriptFile file{"test.lua", text};
  Script script(kFunctions, {&file, 1});
  double value = 0;
  const absl::Status status =
      script.Run("mesh", name, {.width = 2, .depth = 1, .height = 3, .rest_height = 0.5}, &value);
  if (taken != nullptr) *taken = value;
  return std::string(status.message());
}

TEST(Script, SeesTheSizeOfThePiece) {
  double taken = 0;
  EXPECT_EQ(Result("function mesh.piece() take(w + 10 * d + 100 * h + 1000 * rest + 10000 * smaller) end", &taken), "");
  EXPECT_DOUBLE_EQ(taken, 2 + 10 + 300 + 500 + 10000);
}

TEST(Script, CountsDecimalsAsPeopleDo) {
  double taken = 0;
  EXPECT_EQ(
      Result("function mesh.piece() take(100 * floor(0.6 / 0.2) + floor(0.59 / 0.2) + round(0.9 / 0.6)) end", &taken),
      "");
  EXPECT_DOUBLE_EQ(taken, 304);
}

TEST(Script, ErrorsNameFileAndLine) {
  EXPECT_EQ(Result("\nfunction mesh.piece(\n"), "test.lua:3: <name> or '...' expected near <eof>");
  EXPECT_EQ(Result("function mesh.piece()\n  take(width)\nend"), "mesh.piece: test.lua:2: there is no \"width\"");
  EXPECT_EQ(Result("function mesh.piece()\n  take(0 / 0)\nend"),
            "mesh.piece: test.lua:2: bad argument #1 to 'take' (not a finite number)");
  EXPECT_EQ(Result("function mesh.other() end"), "no script has mesh.piece");
}

TEST(Script, LeavesNothingBehind) {
  EXPECT_EQ(Result("function mesh.piece() last = w end"), "mesh.piece: test.lua:1: \"last\" is not declared local");
}

TEST(Script, ReachesNeitherFilesNorSystem) {
  for (const char* name :
       {"io", "os", "require", "load", "dofile", "loadfile", "debug", "package", "string", "coroutine",
        "collectgarbage", "print", "setmetatable", "rawset", "pcall", "pairs", "tostring", "math"}) {
    EXPECT_EQ(Result(std::string("function mesh.piece() return ") + name + ".x end"),
              std::string("mesh.piece: test.lua:1: there is no \"") + name + "\"");
  }
}

TEST(Script, EndsInTimeAndMemory) {
  EXPECT_EQ(Result("function mesh.piece() while true do end end"), "mesh.piece: test.lua:1: the script does not end");
  EXPECT_EQ(Result("function mesh.piece() local l = {} while true do push(l, {1, 2, 3, 4}) end end"),
            "mesh.piece: not enough memory");
  EXPECT_NE(Result("function mesh.piece() return mesh.piece() + 1 end"), "");
}

TEST(Script, TakesNoCompiledCode) {
  EXPECT_THAT(Result("\x1bLua"), ::testing::HasSubstr("attempt to load a binary chunk"));
}

}  // namespace
}  // namespace flair::renderer
