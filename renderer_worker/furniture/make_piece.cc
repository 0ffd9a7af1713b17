// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/furniture/make_piece.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>

#include "renderer_worker/furniture/families.h"

namespace flair::renderer {
namespace {

using enum ClassLook::Dominant;

// Sorted by class; a test holds this and that every class is here.
constexpr PieceMaker kMakers[] = {
    {"aquarium", MakeAquarium, {.hard = "oak"}},
    {"armchair", MakeArmchair, {.hard = "walnut", .metal = "brass", .dominant = kSoft, .soft_colour = 0xA98F78}},
    {"barrel", MakeBarrel, {.hard = "oak", .metal = "iron"}},
    {"basin", MakeBasin, {.hard = "ceramic"}},
    {"basket", MakeBasket, {.hard = "rattan"}},
    {"bath", MakeBath, {.hard = "ceramic"}},
    {"bean_bag", MakeBeanBag, {.hard = "oak", .dominant = kSoft, .soft_colour = 0xC08457}},
    {"bed", MakeBed, {.hard = "oak", .dominant = kSoft, .soft_colour = 0x8FA3B3}},
    {"bench", MakeBench, {.hard = "oak", .soft_colour = 0xB9A88C}},
    {"blanket", MakeBlanket, {.hard = "oak", .soft = "wool", .dominant = kSoft, .soft_colour = 0xB9785C}},
    {"board", MakeBoard, {.hard = "oak"}},
    {"books", MakeBooks, {.hard = "oak"}},
    {"bookshelf", MakeBookshelf, {.hard = "oak", .metal = "iron"}},
    {"box", MakeBox, {.hard = "oak"}},
    {"bunk_bed", MakeBunkBed, {.hard = "pine", .soft_colour = 0x7F9BB0}},
    {"cabinet", MakeCabinet, {.hard = "oak", .metal = "brass"}},
    {"candles", MakeCandles, {.hard = "brass", .metal = "brass"}},
    {"cart", MakeCart, {.hard = "oak", .metal = "brass"}},
    {"cauldron", MakeCauldron, {.hard = "iron", .metal = "iron"}},
    {"ceiling_fan", MakeCeilingFan, {.hard = "walnut", .metal = "bronze"}},
    {"chair", MakeChair, {.hard = "oak", .soft_colour = 0xC9BBA2}},
    {"chandelier", MakeChandelier, {.hard = "brass", .metal = "brass"}},
    {"clock", MakeClock, {.hard = "walnut", .metal = "brass"}},
    {"coat_stand", MakeCoatStand, {.hard = "walnut", .soft = "wool", .metal = "brass", .soft_colour = 0x5F6B73}},
    {"coffee_table", MakeCoffeeTable, {.hard = "walnut", .metal = "iron"}},
    {"coffin", MakeCoffin, {.hard = "ebony", .soft = "velvet", .metal = "gold", .soft_colour = 0x7A1F2B}},
    {"cot", MakeCot, {.hard = "birch", .soft = "cotton", .soft_colour = 0xB8D0DA}},
    {"counter", MakeCounter, {.hard = "lacquer", .hard_colour = 0xD5DAD3}},
    {"curtain", MakeCurtain, {.hard = "oak", .metal = "brass", .dominant = kSoft, .soft_colour = 0xB7A994}},
    {"cushion", MakeCushion, {.hard = "oak", .dominant = kSoft, .soft_colour = 0xC98F7C}},
    {"daybed", MakeDaybed, {.hard = "walnut", .metal = "brass", .dominant = kSoft, .soft_colour = 0xA3A894}},
    {"desk", MakeDesk, {.hard = "oak", .metal = "iron"}},
    {"dishwasher", MakeDishwasher, {.hard = "steel"}},
    {"dresser", MakeDresser, {.hard = "oak", .metal = "brass"}},
    {"drums", MakeDrums, {.hard = "lacquer", .metal = "chrome", .hard_colour = 0x9C2F2F}},
    {"easel", MakeEasel, {.hard = "pine", .soft = "canvas"}},
    {"exercise_bike", MakeExerciseBike, {.hard = "lacquer", .hard_colour = 0x4A5560}},
    {"fireplace", MakeFireplace, {.hard = "marble", .metal = "iron"}},
    {"floor_lamp", MakeFloorLamp, {.hard = "brass", .metal = "brass"}},
    {"folding_screen", MakeFoldingScreen, {.hard = "walnut"}},
    {"fridge", MakeFridge, {.hard = "steel"}},
    {"garment_rack", MakeGarmentRack, {.hard = "iron", .metal = "iron", .soft_colour = 0x7E8FA0}},
    {"globe", MakeGlobe, {.hard = "walnut", .metal = "brass"}},
    {"grand_piano", MakeGrandPiano, {.hard = "lacquer", .metal = "gold", .hard_colour = 0x1E1D1F}},
    {"guitar", MakeGuitar, {.hard = "cherry"}},
    {"hob", MakeHob, {.hard = "steel"}},
    {"ironing_board", MakeIroningBoard, {.hard = "oak", .soft = "cotton", .dominant = kSoft, .soft_colour = 0x9FB6C9}},
    {"keyboard", MakeKeyboard, {.hard = "plastic", .hard_colour = 0x2C2D30}},
    {"kitchen_island", MakeKitchenIsland, {.hard = "lacquer", .metal = "brass", .hard_colour = 0x5D7076}},
    {"ladder", MakeLadder, {.hard = "oak", .soft = "wool", .soft_colour = 0xD8CDB8}},
    {"laptop", MakeLaptop, {.hard = "steel"}},
    {"log_stack", MakeLogStack, {.hard = "bark", .metal = "iron"}},
    {"loom", MakeLoom, {.hard = "oak", .soft = "wool", .soft_colour = 0xA8553F}},
    {"mannequin", MakeMannequin, {.hard = "walnut", .metal = "brass", .dominant = kSoft, .soft_colour = 0xD9CBB2}},
    {"mat", MakeMat, {.hard = "oak", .soft = "wool", .dominant = kSoft, .soft_colour = 0x8FAE9E}},
    {"mirror", MakeMirror, {.hard = "walnut", .metal = "brass"}},
    {"music_stand", MakeMusicStand, {.hard = "walnut"}},
    {"nightstand", MakeNightstand, {.hard = "oak", .metal = "brass"}},
    {"office_chair", MakeOfficeChair, {.hard = "plastic", .dominant = kSoft, .soft_colour = 0x59646E}},
    {"orb", MakeOrb, {.hard = "stone", .soft = "velvet", .metal = "brass", .soft_colour = 0x8A7FC0}},
    {"organizer", MakeOrganizer, {.hard = "walnut"}},
    {"pendant", MakePendant, {.hard = "brass", .metal = "brass"}},
    {"piano", MakeUprightPiano, {.hard = "mahogany", .metal = "brass"}},
    {"picture",
     MakePicture,
     {.hard = "walnut", .soft = "wool", .metal = "gold", .dominant = kSoft, .soft_colour = 0x5F7F8C}},
    {"plant", MakePlant, {.hard = "terracotta", .soft = "cotton"}},
    {"pool", MakePool, {.hard = "marble"}},
    {"pool_table", MakePoolTable, {.hard = "mahogany", .soft = "wool", .metal = "brass", .soft_colour = 0x2F6B4A}},
    {"pouf", MakePouf, {.hard = "oak", .soft = "wool", .dominant = kSoft, .soft_colour = 0xC2A28C}},
    {"punching_bag",
     MakePunchingBag,
     {.hard = "iron", .soft = "leather", .metal = "iron", .dominant = kSoft, .soft_colour = 0x7A2A26}},
    {"rack", MakeRack, {.hard = "oak", .soft = "cotton", .metal = "brass", .soft_colour = 0xC8B79C}},
    {"range_hood", MakeRangeHood, {.hard = "steel"}},
    {"rocking_chair", MakeRockingChair, {.hard = "cherry", .soft_colour = 0xD0C3A6}},
    {"round_rug", MakeRoundRug, {.hard = "oak", .soft = "wool", .dominant = kSoft, .soft_colour = 0xC2A27E}},
    {"round_table", MakeRoundTable, {.hard = "walnut"}},
    {"rowing_machine", MakeRowingMachine, {.hard = "lacquer", .hard_colour = 0x3C434A}},
    {"rug", MakeRug, {.hard = "oak", .soft = "wool", .dominant = kSoft, .soft_colour = 0xA96B58}},
    {"screen", MakeScreen, {.hard = "plastic", .hard_colour = 0x2A2B2E}},
    {"sewing_machine", MakeSewingMachine, {.hard = "lacquer", .soft = "cotton", .soft_colour = 0xB2483F}},
    {"shelf", MakeShelf, {.hard = "oak", .metal = "iron", .soft_colour = 0xB8A283}},
    {"shower", MakeShower, {.hard = "ceramic", .metal = "chrome"}},
    {"side_table", MakeSideTable, {.hard = "walnut", .metal = "brass"}},
    {"sink", MakeSink, {.hard = "lacquer", .hard_colour = 0xD5DAD3}},
    {"small_appliance", MakeSmallAppliance, {.hard = "steel"}},
    {"sofa", MakeSofa, {.hard = "walnut", .metal = "brass", .dominant = kSoft, .soft_colour = 0x7F919B}},
    {"speaker", MakeSpeaker, {.hard = "lacquer", .hard_colour = 0x2E2E30}},
    {"spinning_wheel", MakeSpinningWheel, {.hard = "cherry", .soft = "wool"}},
    {"statue", MakeStatue, {.hard = "marble"}},
    {"stool", MakeStool, {.hard = "oak", .soft = "leather"}},
    {"table", MakeTable, {.hard = "oak", .metal = "iron"}},
    {"table_lamp", MakeTableLamp, {.hard = "ceramic", .metal = "brass", .hard_colour = 0x6F8C97}},
    {"telescope", MakeTelescope, {.hard = "walnut", .metal = "brass"}},
    {"television", MakeTelevision, {.hard = "plastic", .hard_colour = 0x232427}},
    {"tent", MakeTent, {.hard = "pine", .soft = "canvas", .dominant = kSoft, .soft_colour = 0xE2D5BE}},
    {"throne",
     MakeThrone,
     {.hard = "mahogany", .soft = "velvet", .metal = "gold", .dominant = kSoft, .soft_colour = 0x8E2F35}},
    {"toilet", MakeToilet, {.hard = "ceramic"}},
    {"toy", MakeToy, {.hard = "birch", .soft = "fur", .soft_colour = 0xA9764A}},
    {"tray", MakeTray, {.hard = "walnut"}},
    {"treadmill", MakeTreadmill, {.hard = "plastic", .hard_colour = 0x3E444A}},
    {"trunk", MakeTrunk, {.hard = "walnut", .metal = "brass"}},
    {"tv_stand", MakeTvStand, {.hard = "walnut", .metal = "brass"}},
    {"vanity", MakeVanity, {.hard = "birch", .metal = "brass"}},
    {"vase", MakeVase, {.hard = "ceramic", .metal = "gold", .hard_colour = 0x7FA0AE}},
    {"wall_lamp", MakeWallLamp, {.hard = "brass", .metal = "brass"}},
    {"wardrobe", MakeWardrobe, {.hard = "oak", .metal = "brass"}},
    {"washing_machine", MakeWashingMachine, {.hard = "lacquer"}},
    {"weight_bench", MakeWeightBench, {.hard = "lacquer", .soft = "leather", .hard_colour = 0x9C3B33}},
    {"weights", MakeWeights, {.hard = "metal", .metal = "chrome"}},
    {"workbench", MakeWorkbench, {.hard = "oak", .metal = "iron"}},
};

const PieceMaker& MakerOf(std::string_view class_name) {
  const auto find = [](std::string_view name) {
    return std::lower_bound(std::begin(kMakers), std::end(kMakers), name,
                            [](const PieceMaker& maker, std::string_view n) { return maker.class_name < n; });
  };
  const auto at = find(class_name);
  return at != std::end(kMakers) && at->class_name == class_name ? *at : *find("box");
}

float Extent(double metres) {
  const auto value = static_cast<float>(metres);
  return std::isfinite(value) ? std::clamp(value, kSmallestExtent_m, kLargestExtent_m) : kSmallestExtent_m;
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

std::span<const PieceMaker> PieceMakers() { return kMakers; }

MadePiece MakePiece(std::string_view class_name, const v1::Object& object, const v1::ObjectStyle* style) {
  const PieceMaker& maker = MakerOf(class_name);
  Piece piece{.w = Extent(object.width_m()),
              .d = Extent(object.depth_m()),
              .h = Extent(object.height_m()),
              .is = PaletteOf(maker.look, object, style),
              .words = WordsOf(object, style),
              .seed = SeedOf(maker.class_name, object.name()),
              .make = {},
              .lights = {}};
  maker.make(piece);
  std::vector<Vec3> places;
  for (const LampLight& light : piece.lights) places.push_back(light.position);
  MadePiece made{piece.make.Filling(piece.w, piece.d, piece.h, places), std::move(piece.lights)};
  for (size_t i = 0; i < places.size(); ++i) made.lights[i].position = places[i];
  return made;
}

}  // namespace flair::renderer
