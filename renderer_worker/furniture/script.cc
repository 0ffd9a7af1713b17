// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/script.h"

#include <cmath>
#include <cstdlib>
#include <string>

#include "renderer_worker/furniture/pieces_text.h"  // after script.h, whose types it takes

namespace flair::renderer {
namespace {

constexpr size_t kMostMemory = size_t{64} << 20;
constexpr int kMostInstructions = 10'000'000;

void TakesTooLong(lua_State* state, lua_Debug*) {
  luaL_where(state, 0);
  lua_pushstring(state, "the script does not end");
  lua_concat(state, 2);
  lua_error(state);
}

// Lua's own that reach beyond the script, differ from run to run (the order of pairs), or change how others read it.
constexpr const char* kForbidden[] = {"dofile",  "loadfile",     "load",         "print",  "collectgarbage", "pcall",
                                      "xpcall",  "getmetatable", "setmetatable", "rawget", "rawset",         "rawequal",
                                      "require", "warn",         "pairs",        "next",   "tostring",       "math"};

int UnknownName(lua_State* state) { return luaL_error(state, "there is no \"%s\"", luaL_tolstring(state, 2, nullptr)); }
int NewGlobal(lua_State* state) {
  return luaL_error(state, "\"%s\" is not declared local", luaL_tolstring(state, 2, nullptr));
}

// From now on scripts only read globals that exist, so that no piece depends on what was made before it.
void Freeze(lua_State* state) {
  lua_pushglobaltable(state);
  lua_newtable(state);
  lua_pushcfunction(state, UnknownName);
  lua_setfield(state, -2, "__index");
  lua_pushcfunction(state, NewGlobal);
  lua_setfield(state, -2, "__newindex");
  lua_setmetatable(state, -2);
  lua_pop(state, 1);
}

void SetGlobal(lua_State* state, const char* name, double value) {
  lua_pushglobaltable(state);
  lua_pushstring(state, name);
  lua_pushnumber(state, value);
  lua_rawset(state, -3);
  lua_pop(state, 1);
}

}  // namespace

void* Script::Allocate(void* memory, void* block, size_t old_size, size_t new_size) {
  size_t& used = static_cast<Memory*>(memory)->used;
  if (block == nullptr) old_size = 0;
  if (new_size > old_size && used + new_size - old_size > kMostMemory) return nullptr;
  void* moved = nullptr;
  if (new_size == 0) {
    std::free(block);
  } else if (moved = std::realloc(block, new_size); moved == nullptr) {
    return nullptr;
  }
  used += new_size - old_size;
  return moved;
}

std::span<const ScriptFile> PieceFiles() { return kPieceFiles; }

Script::Script(const luaL_Reg* functions, std::span<const ScriptFile> files)
    : state_(lua_newstate(Allocate, &memory_), lua_close) {
  if (state_ == nullptr) std::abort();  // no memory
  lua_State* state = state_.get();
  luaL_requiref(state, "_G", luaopen_base, 1);
  luaL_requiref(state, "math", luaopen_math, 1);
  lua_settop(state, 0);
  for (; functions->name != nullptr; ++functions) lua_register(state, functions->name, functions->func);
  Read("common.lua", kCommonLua);
  for (const char* name : kForbidden) {
    lua_pushnil(state);
    lua_setglobal(state, name);
  }
  for (const auto& [file, text] : files) Read(file, text);
  Freeze(state);
}

void Script::Read(const char* file, std::string_view text) {
  if (!read_.ok()) return;
  const std::string name = std::string("@") + file;
  if (luaL_loadbufferx(state_.get(), text.data(), text.size(), name.c_str(), "t") != LUA_OK) {
    read_ = absl::InvalidArgumentError(lua_tostring(state_.get(), -1));
    lua_settop(state_.get(), 0);
    return;
  }
  read_ = Call(0);
}

absl::Status Script::Call(int arguments) {
  lua_State* state = state_.get();
  lua_sethook(state, TakesTooLong, LUA_MASKCOUNT, kMostInstructions);
  absl::Status status;
  if (lua_pcall(state, arguments, 0, 0) != LUA_OK) {
    const char* message = lua_tostring(state, -1);
    status = absl::InvalidArgumentError(message != nullptr ? message : "the script fails without a reason");
    lua_settop(state, 0);
    lua_gc(state, LUA_GCCOLLECT);  // the next one finds all its memory
  }
  lua_settop(state, 0);
  return status;
}

bool Script::Has(const char* table, std::string_view name) {
  const std::lock_guard lock(mutex_);
  lua_State* state = state_.get();
  if (!read_.ok()) return false;
  lua_getglobal(state, table);
  lua_pushlstring(state, name.data(), name.size());
  const bool found = lua_rawget(state, -2) == LUA_TFUNCTION;
  lua_settop(state, 0);
  return found;
}

absl::Status Script::Run(const char* table, std::string_view name, const PieceSize& size, void* session) {
  const std::lock_guard lock(mutex_);
  lua_State* state = state_.get();
  if (!read_.ok()) return read_;
  *static_cast<void**>(lua_getextraspace(state)) = session;
  SetGlobal(state, "w", size.width);
  SetGlobal(state, "d", size.depth);
  SetGlobal(state, "h", size.height);
  SetGlobal(state, "rest", size.rest_height);
  const std::string called = std::string(table) + "." + std::string(name);
  lua_getglobal(state, "begin");
  if (absl::Status begun = Call(0); !begun.ok()) return begun;
  lua_getglobal(state, table);
  lua_pushlstring(state, name.data(), name.size());
  if (lua_rawget(state, -2) != LUA_TFUNCTION) {
    lua_settop(state, 0);
    return absl::NotFoundError("no script has " + called);
  }
  lua_remove(state, -2);
  absl::Status status = Call(0);
  if (!status.ok()) status = absl::InvalidArgumentError(called + ": " + std::string(status.message()));
  return status;
}

double NumberAt(lua_State* state, int argument) {
  const double value = luaL_checknumber(state, argument);
  luaL_argcheck(state, std::isfinite(value), argument, "not a finite number");
  return value;
}

double NumberAt(lua_State* state, int argument, double usual) {
  return lua_isnoneornil(state, argument) ? usual : NumberAt(state, argument);
}

int CountAt(lua_State* state, int argument, int usual, int least, int most) {
  const double value = NumberAt(state, argument, usual);
  if (!(value >= least && value <= most)) {
    luaL_argerror(state, argument, lua_pushfstring(state, "not between %d and %d", least, most));
  }
  return static_cast<int>(value);
}

double ComponentAt(lua_State* state, int argument, int index) {
  luaL_checktype(state, argument, LUA_TTABLE);
  const bool given = lua_rawgeti(state, argument, index) != LUA_TNIL;
  const bool number = lua_isnumber(state, -1) != 0;
  const double value = lua_tonumber(state, -1);
  lua_pop(state, 1);
  luaL_argcheck(state, !given || (number && std::isfinite(value)), argument,
                "has a component that is not a finite number");
  return given ? value : 0;
}

int ChoiceAt(lua_State* state, int argument, std::span<const char* const> names, int usual) {
  if (usual >= 0 && lua_isnoneornil(state, argument)) return usual;
  const std::string_view name = luaL_checkstring(state, argument);
  for (size_t i = 0; i < names.size(); ++i) {
    if (names[i] == name) return static_cast<int>(i);
  }
  return luaL_argerror(state, argument, lua_pushfstring(state, "there is no \"%s\"", name.data()));
}

}  // namespace flair::renderer
