// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <lua.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <string_view>

#include "absl/status/status.h"

namespace flair::renderer {

// The size of a piece of furniture and of what rests on it, metres, as scripts see it.
struct PieceSize {
  double width, depth, height;
  double rest_height;
};

// A file of scripts; "beds.lua" is what errors call it.
struct ScriptFile {
  const char* name;
  std::string_view text;
};

// Those of pieces/ without common.lua.
std::span<const ScriptFile> PieceFiles();

// Runs the scripts of pieces/, which say what the pieces of furniture look like: as meshes and as plan symbols.
// They see Lua's mathematics, common.lua and the functions they are given; neither files nor the system. One that runs
// too long, takes too much memory or is wrong in any other way ends with an error that names its file and line.
// Thread-safe: one script runs at a time.
class Script {
 public:
  // Reads common.lua and `files` with these functions at hand, which end with a null entry. Never fails: every call
  // reports what is wrong with the files.
  explicit Script(const luaL_Reg* functions, std::span<const ScriptFile> files = PieceFiles());

  // Whether there is a function `table.name`, such as "mesh.bed".
  bool Has(const char* table, std::string_view name);

  // Calls `table.name`. The functions find `session` through SessionOf. NOT_FOUND for no such name, INVALID_ARGUMENT
  // with file and line when the script fails.
  absl::Status Run(const char* table, std::string_view name, const PieceSize& size, void* session);

 private:
  struct Memory {
    size_t used = 0;
  };
  static void* Allocate(void* memory, void* block, size_t old_size, size_t new_size);
  absl::Status Call(int arguments);
  void Read(const char* file, std::string_view text);

  Memory memory_;
  std::mutex mutex_;
  std::unique_ptr<lua_State, void (*)(lua_State*)> state_;
  absl::Status read_;
};

// For the functions: arguments of the running script. Each raises a script error that names the argument when it is not
// what it should be.
template <typename Session>
Session& SessionOf(lua_State* state) {
  return **static_cast<Session**>(lua_getextraspace(state));
}
// A finite number; `usual` where the script gives none.
double NumberAt(lua_State* state, int argument);
double NumberAt(lua_State* state, int argument, double usual);
// A whole number in [least, most].
int CountAt(lua_State* state, int argument, int usual, int least, int most);
// Component `index` (from 1) of the list at `argument`; 0 where the list is shorter.
double ComponentAt(lua_State* state, int argument, int index);
// One of `names`; `usual` (may be negative: none) where the script gives none.
int ChoiceAt(lua_State* state, int argument, std::span<const char* const> names, int usual);
// Calls `element` with the stack index of each entry of the list at `argument`, at most 10,000.
template <typename Function>
void ForEachAt(lua_State* state, int argument, Function element) {
  luaL_checktype(state, argument, LUA_TTABLE);
  const auto count = static_cast<int>(lua_rawlen(state, argument));
  luaL_argcheck(state, count <= 10000, argument, "a list of more than 10,000 entries");
  for (int i = 1; i <= count; ++i) {
    lua_rawgeti(state, argument, i);
    element(lua_gettop(state));
    lua_pop(state, 1);
  }
}

}  // namespace flair::renderer
