// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <cmath>
#include <deque>
#include <string>
#include <utility>

#include "renderer_worker/furniture/classes.h"
#include "renderer_worker/furniture/modeller.h"
#include "renderer_worker/furniture/procedural_furniture.h"
#include "renderer_worker/furniture/script.h"
#include "worker_runtime/status/status_macros.h"

// What scripts make meshes with.
namespace flair::renderer {
namespace {

constexpr size_t kMostVertices = 500'000;

// One piece in the making.
struct Piece {
  Palette is;
  std::string words;  // lower case: name, description, material
  uint32_t seed;      // of its class and name: for what varies without meaning
  Modeller make;
  std::vector<LampLight> lights;
  std::deque<Material> own_materials;  // that its script made
};

Piece& PieceOf(lua_State* state) { return SessionOf<Piece>(state); }

float FloatAt(lua_State* state, int argument) { return static_cast<float>(NumberAt(state, argument)); }
float FloatAt(lua_State* state, int argument, float usual) {
  return static_cast<float>(NumberAt(state, argument, usual));
}
Vec2 Vec2At(lua_State* state, int argument) {
  return {static_cast<float>(ComponentAt(state, argument, 1)), static_cast<float>(ComponentAt(state, argument, 2))};
}
Vec3 Vec3At(lua_State* state, int argument) {
  const Vec2 xy = Vec2At(state, argument);
  return {xy.x, xy.y, static_cast<float>(ComponentAt(state, argument, 3))};
}
std::vector<Vec2> PointsAt(lua_State* state, int argument) {
  std::vector<Vec2> points;
  ForEachAt(state, argument, [&](int at) { points.push_back(Vec2At(state, at)); });
  return points;
}
int SidesAt(lua_State* state, int argument, int usual) { return CountAt(state, argument, usual, 3, 256); }
Vec2 StretchAt(lua_State* state, int argument) {
  return lua_isnoneornil(state, argument) ? Vec2{1, 1} : Vec2At(state, argument);
}

const Material& MaterialAt(lua_State* state, int argument) {
  const Piece& piece = PieceOf(state);
  if (const void* made = lua_touserdata(state, argument); made != nullptr) {
    for (const Material& own : piece.own_materials) {
      if (&own == made) return own;
    }
  }
  const std::string_view name = luaL_checkstring(state, argument);
  if (name == "hard") return piece.is.hard;
  if (name == "soft") return piece.is.soft;
  if (name == "metal") return piece.is.metal;
  if (name == "pale") return piece.is.pale;
  if (name == "accent") return piece.is.accent;
  const Material* found = FixedMaterial(name);
  if (found == nullptr) luaL_argerror(state, argument, lua_pushfstring(state, "no material \"%s\"", name.data()));
  return *found;
}

// The frame at `argument`: an origin and three axes, those left out as they are.
Frame FrameAt(lua_State* state, int argument) {
  Frame frame;
  int part = 0;
  ForEachAt(state, argument, [&](int at) {
    Vec3* const parts[] = {&frame.origin, &frame.x, &frame.y, &frame.z};
    luaL_argcheck(state, part < 4, argument, "a frame has an origin and three axes");
    *parts[part++] = Vec3At(state, at);
  });
  return frame;
}

void PushVec(lua_State* state, Vec3 v) {
  lua_getglobal(state, "vec");
  for (const float component : {v.x, v.y, v.z}) lua_pushnumber(state, component);
  lua_call(state, 3, 1);
}

// Ends every function that adds a shape.
int Added(lua_State* state) {
  if (PieceOf(state).make.vertex_count() > kMostVertices) return luaL_error(state, "a piece of too many vertices");
  return 0;
}

// A function for scripts that adds one shape.
template <auto kAdd>
int Shape(lua_State* s) {
  kAdd(PieceOf(s).make, s);
  return Added(s);
}

// tube(material, path, radius or list of radii, sides)
int Tube(lua_State* s) {
  std::vector<Vec3> path;
  std::vector<float> radii;
  ForEachAt(s, 2, [&](int at) { path.push_back(Vec3At(s, at)); });
  if (lua_type(s, 3) == LUA_TTABLE) {
    ForEachAt(s, 3, [&](int at) { radii.push_back(FloatAt(s, at)); });
  } else {
    radii.push_back(FloatAt(s, 3));
  }
  PieceOf(s).make.Tube(MaterialAt(s, 1), path, radii, SidesAt(s, 4, 8));
  return Added(s);
}

// sheet(material, columns, rows, function(u, v) ... return point end, thickness)
int Sheet(lua_State* s) {
  luaL_checktype(s, 4, LUA_TFUNCTION);
  const auto at = [s](float u, float v) {
    lua_pushvalue(s, 4);
    lua_pushnumber(s, u);
    lua_pushnumber(s, v);
    lua_call(s, 2, 1);
    const Vec3 point = Vec3At(s, lua_gettop(s));
    lua_pop(s, 1);
    return point;
  };
  PieceOf(s).make.Sheet(MaterialAt(s, 1), CountAt(s, 2, 1, 1, 500), CountAt(s, 3, 1, 1, 500), at,
                        FloatAt(s, 5, 0.003F));
  return Added(s);
}

// inside(frame, function() ... end)
int Inside(lua_State* s) {
  luaL_checktype(s, 2, LUA_TFUNCTION);
  PieceOf(s).make.In(FrameAt(s, 1), [s] {
    lua_pushvalue(s, 2);
    lua_call(s, 0, 0);
  });
  return 0;
}

// shine(at, candela, radius, colour): a light that moves along when the piece is fitted into its box.
int Shine(lua_State* s) {
  Piece& piece = PieceOf(s);
  luaL_argcheck(s, piece.lights.size() < 100, 1, "more than a hundred lights");
  piece.lights.push_back({.position = piece.make.Placed(Vec3At(s, 1)),
                          .colour = lua_isnoneornil(s, 4) ? Vec3{1, 0.78F, 0.52F} : Vec3At(s, 4),
                          .intensity_cd = FloatAt(s, 2),
                          .radius_m = FloatAt(s, 3)});
  return 0;
}

// Whether one of the words stands in what is said of the piece, as a word of its own; plurals count.
int Says(lua_State* s) {
  const std::string& words = PieceOf(s).words;
  const auto letter = [&words](size_t at) {
    return at < words.size() && std::isalpha(static_cast<unsigned char>(words[at]));
  };
  bool said = false;
  for (int i = 1; i <= lua_gettop(s) && !said; ++i) {
    const std::string_view word = luaL_checkstring(s, i);
    for (size_t at = words.find(word); at != std::string::npos && !said; at = words.find(word, at + 1)) {
      size_t end = at + word.size();
      if (end < words.size() && words[end] == 's') ++end;
      said = (at == 0 || !letter(at - 1)) && !letter(end);
    }
  }
  lua_pushboolean(s, said);
  return 1;
}

uint32_t Mixed(uint32_t x) {
  x ^= x >> 16;
  x *= 0x7FEB352DU;
  x ^= x >> 15;
  x *= 0x846CA68BU;
  return x ^ (x >> 16);
}

int Chance(lua_State* s) {
  const auto index = static_cast<uint32_t>(CountAt(s, 1, 0, -1'000'000, 1'000'000));
  const uint32_t mixed = Mixed(PieceOf(s).seed + 0x9E3779B9U * (index + 1));
  lua_pushnumber(s, static_cast<float>(mixed >> 8) / 16777216.0F);
  return 1;
}

// look(material).name, .colour, .emission, .pattern
int Look(lua_State* s) {
  const Material& material = MaterialAt(s, 1);
  lua_newtable(s);
  lua_pushstring(s, material.name.c_str());
  lua_setfield(s, -2, "name");
  PushVec(s, material.colour);
  lua_setfield(s, -2, "colour");
  PushVec(s, material.emission);
  lua_setfield(s, -2, "emission");
  lua_pushstring(s, SurfacePattern_Name(static_cast<SurfacePattern>(material.pattern)).c_str());
  lua_setfield(s, -2, "pattern");
  return 1;
}

// Whether a material's name has these letters: made_of("hard", "marble").
int MadeOf(lua_State* s) {
  lua_pushboolean(s, MaterialAt(s, 1).name.find(luaL_checkstring(s, 2)) != std::string::npos);
  return 1;
}

// material{like = "lamp shade", name = "blue shade", colour = {..}, emission = {..}, roughness = 0.5}
int MakeMaterial(lua_State* s) {
  Piece& piece = PieceOf(s);
  luaL_checktype(s, 1, LUA_TTABLE);
  luaL_argcheck(s, piece.own_materials.size() < 100, 1, "more than a hundred materials");
  const auto given = [s](const char* field) { return lua_getfield(s, 1, field) != LUA_TNIL; };
  Material made;
  if (given("like")) made = MaterialAt(s, lua_gettop(s));
  if (given("name")) made.name = luaL_checkstring(s, -1);
  if (given("roughness")) made.roughness = std::clamp(FloatAt(s, lua_gettop(s)), 0.01F, 1.0F);
  if (given("emission")) made.emission = Vec3At(s, lua_gettop(s));
  if (given("colour")) {
    made.colour = Vec3At(s, lua_gettop(s));
    if (made.pattern == Pattern::kPlain && made.emission == Vec3()) made.second_colour = made.colour;
  }
  lua_pushlightuserdata(s, &piece.own_materials.emplace_back(std::move(made)));
  return 1;
}

// The colour that the style names, or the class has; and whether there is a style.
int StyleColour(lua_State* s) {
  PushVec(s, PieceOf(s).is.colour);
  return 1;
}

int IsStyled(lua_State* s) {
  lua_pushboolean(s, PieceOf(s).is.styled);
  return 1;
}

int FromHex(lua_State* s) {
  PushVec(s, LinearHex(static_cast<unsigned>(luaL_checkinteger(s, 1))));
  return 1;
}

constexpr luaL_Reg kFunctions[] = {
    {"box", Shape<[](Modeller& make, lua_State* s) {
       make.Box(MaterialAt(s, 1), Vec3At(s, 2), Vec3At(s, 3), FloatAt(s, 4, 0.004F));
     }>},
    {"cushion", Shape<[](Modeller& make, lua_State* s) {
       make.Cushion(MaterialAt(s, 1), Vec3At(s, 2), Vec3At(s, 3), FloatAt(s, 4), FloatAt(s, 5, 0));
     }>},
    {"pillow", Shape<[](Modeller& make, lua_State* s) { make.Pillow(MaterialAt(s, 1), Vec3At(s, 2), Vec3At(s, 3)); }>},
    {"taper", Shape<[](Modeller& make, lua_State* s) {
       make.Taper(MaterialAt(s, 1), Vec3At(s, 2), Vec2At(s, 3), Vec3At(s, 4), Vec2At(s, 5));
     }>},
    {"slab", Shape<[](Modeller& make, lua_State* s) {
       make.Slab(MaterialAt(s, 1), PointsAt(s, 2), FloatAt(s, 3), FloatAt(s, 4), FloatAt(s, 5, 0.003F));
     }>},
    {"lathe", Shape<[](Modeller& make, lua_State* s) {
       make.Lathe(MaterialAt(s, 1), Vec3At(s, 2), PointsAt(s, 3), SidesAt(s, 4, 20), StretchAt(s, 5));
     }>},
    {"ring", Shape<[](Modeller& make, lua_State* s) {
       make.Ring(MaterialAt(s, 1), Vec3At(s, 2), PointsAt(s, 3), SidesAt(s, 4, 24), StretchAt(s, 5));
     }>},
    {"tube", Tube},
    {"sheet", Sheet},
    {"inside", Inside},
    {"shine", Shine},
    {"says", Says},
    {"chance", Chance},
    {"look", Look},
    {"made_of", MadeOf},
    {"material", MakeMaterial},
    {"style_colour", StyleColour},
    {"is_styled", IsStyled},
    {"rgb", FromHex},
    {nullptr, nullptr}};

Script& Meshes() {
  static Script& meshes = *new Script(kFunctions);
  return meshes;
}

double Extent(double metres) {
  return std::isfinite(metres) ? std::clamp<double>(metres, kSmallestExtent_m, kLargestExtent_m) : kSmallestExtent_m;
}

std::string WordsOf(const v1::Object& object, const v1::ObjectStyle* style) {
  std::string words = object.name() + " | " + object.description();
  if (style != nullptr) words += " | " + style->material() + " | " + style->description();
  for (char& c : words) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return words;
}

// FNV-1a: the same on every machine.
uint32_t SeedOf(std::string_view class_name, std::string_view name) {
  uint32_t hash = 2166136261U;
  for (const std::string_view text : {class_name, name}) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return hash;
}

}  // namespace

bool HasMesh(std::string_view name) { return Meshes().Has("mesh", name); }

absl::StatusOr<MadePiece> MakePiece(std::string_view class_name, const v1::Object& object,
                                    const v1::ObjectStyle* style) {
  const FurnitureClass& record = ClassNamed(class_name);
  PieceSize size{Extent(object.width_m()), Extent(object.depth_m()), Extent(object.height_m()), 0};
  const auto height = static_cast<float>(size.height);
  const float rest = RestHeightOf(record.name(), height);
  size.rest_height = rest == height ? size.height : rest;
  Piece piece{.is = PaletteOf(record.materials(), object, style),
              .words = WordsOf(object, style),
              .seed = SeedOf(record.name(), record.each_differs() ? object.id() : object.name()),
              .make = {},
              .lights = {},
              .own_materials = {}};
  RETURN_IF_ERROR(Meshes().Run("mesh", record.mesh(), size, &piece));
  std::vector<Vec3> places;
  for (const LampLight& light : piece.lights) places.push_back(light.position);
  MadePiece made{piece.make.Filling(static_cast<float>(size.width), static_cast<float>(size.depth),
                                    static_cast<float>(size.height), places),
                 std::move(piece.lights)};
  for (size_t i = 0; i < places.size(); ++i) made.lights[i].position = places[i];
  if (made.mesh.parts.empty()) {
    return absl::InvalidArgumentError("mesh." + record.mesh() + " adds nothing that has a volume");
  }
  return made;
}

}  // namespace flair::renderer
