// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/symbols/symbol_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "renderer_worker/drawing/symbols/families.h"
#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

using enum Outline;

constexpr double kSeat = 0.40;  // seats slide under table tops
constexpr double kTop = 0.74;   // table tops

// Sorted by category; a test holds this and that every class of furniture leads here.
constexpr Symbol kSymbols[] = {
    {"armchair", DrawArmchair, kRounded, 0xB9A99A, kSeat},
    {"barrel", DrawBarrel, kEllipse, 0xA67B4F},
    {"basin", DrawBasin, kRounded, 0xF2F4F4},
    {"basket", DrawBasket, kRounded, 0xC9A879},
    {"bath", DrawBath, kRounded, 0xF2F4F4},
    {"bed", DrawBed, kRectangle, 0x9FB0BD, kSeat},
    {"bench", DrawBench, kRectangle, 0xB88F62, kSeat},
    {"books", DrawBooks, kRectangle, 0x9C5A4A},
    {"bookshelf", DrawBookshelf, kRectangle, 0xA9814F},
    {"box", DrawPlainBox, kRectangle, 0xD0C6B8},
    {"bunk_bed", DrawBunkBed, kRectangle, 0x9FB0BD},
    {"cabinet", DrawCabinet, kRectangle, 0xBFA27C},
    {"candles", DrawCandles, kEllipse, 0xC9B27A},
    {"cauldron", DrawCauldron, kEllipse, 0x4A4A4C},
    {"ceiling_fan", DrawCeilingFan, kEllipse, 0xB0A89C},
    {"chair", DrawChair, kRectangle, 0xB98F62, kSeat},
    {"chandelier", DrawChandelier, kEllipse, 0xB89A55},
    {"coffee_table", DrawCoffeeTable, kRounded, 0xB58E62},
    {"coffin", DrawCoffin, kEllipse, 0x4A2F2A, kSeat},
    {"cot", DrawCot, kRectangle, 0xBFD3DC},
    {"counter", DrawCounter, kRectangle, 0xC9C2B6},
    {"curtain", DrawCurtain, kRectangle, 0xA39B8F},
    {"cushion", DrawCushion, kRounded, 0xC98F7C},
    {"daybed", DrawDaybed, kRectangle, 0xB7B4A6, kSeat},
    {"desk", DrawDesk, kRectangle, 0xB58E62, kTop},
    {"dishwasher", DrawDishwasher, kRectangle, 0xD9DCDD},
    {"dresser", DrawDresser, kRectangle, 0xB9946A},
    {"drums", DrawDrums, kOpen, 0x9C3B3B},
    {"easel", DrawEasel, kOpen, 0xC9A879},
    {"exercise_bike", DrawExerciseBike, kOpen, 0x8F9AA3},
    {"fireplace", DrawFireplace, kRectangle, 0xA79C92},
    {"fridge", DrawFridge, kRectangle, 0xDCE1E3},
    {"globe", DrawGlobe, kEllipse, 0xA9814F},
    {"grand_piano", DrawGrandPiano, kOpen, 0x2E2A28},
    {"guitar", DrawGuitar, kOpen, 0xB5713A},
    {"hob", DrawHob, kRectangle, 0xC6C9CA},
    {"ironing_board", DrawIroningBoard, kRounded, 0xA9BCCB},
    {"keyboard", DrawKeyboard, kRectangle, 0x3A3A3C},
    {"lamp", DrawLamp, kEllipse, 0xE6CF8E},
    {"laptop", DrawLaptop, kRectangle, 0xB8BCC0},
    {"mannequin", DrawMannequin, kEllipse, 0xD9C3A9},
    {"mat", DrawMat, kRounded, 0x9FB8A9},
    {"mirror", DrawMirror, kRectangle, 0xBFCBD0},
    {"music_stand", DrawMusicStand, kOpen, 0x5A5654},
    {"nightstand", DrawNightstand, kRectangle, 0xB9946A},
    {"office_chair", DrawOfficeChair, kEllipse, 0x6E7780, kSeat},
    {"orb", DrawOrb, kEllipse, 0x8A7FB0},
    {"pendant", DrawPendant, kEllipse, 0xB0A070},
    {"piano", DrawUprightPiano, kRectangle, 0x4A3428},
    {"picture", DrawPicture, kRectangle, 0xA98F5F},
    {"plant", DrawPlant, kEllipse, 0x7FA36B},
    {"pool_table", DrawPoolTable, kRounded, 0x5C8A5C},
    {"pouf", DrawPouf, kRounded, 0xC2A28C, kSeat},
    {"rack", DrawRack, kRectangle, 0xA9917A},
    {"rocking_chair", DrawRockingChair, kRounded, 0xB5875A, kSeat},
    {"round_rug", DrawRoundRug, kEllipse, 0xC7B299},
    {"round_table", DrawRoundTable, kEllipse, 0xB58E62, kTop},
    {"rug", DrawRug, kRectangle, 0xC7B299},
    {"screen", DrawScreen, kRectangle, 0x4A4E52},
    {"sewing_machine", DrawSewingMachine, kRectangle, 0xD7D9DB},
    {"shelf", DrawShelf, kRectangle, 0xBE9C72},
    {"shower", DrawShower, kRectangle, 0xE4ECEE},
    {"sink", DrawKitchenSink, kRectangle, 0xC9C2B6},
    {"small_appliance", DrawSmallAppliance, kRectangle, 0xBFC3C5},
    {"sofa", DrawSofa, kRounded, 0x8F9FA6, kSeat},
    {"speaker", DrawSpeaker, kRectangle, 0x4A4A4C},
    {"statue", DrawStatue, kRectangle, 0xCFCBC2},
    {"stool", DrawStool, kEllipse, 0xB98F62, kSeat},
    {"table", DrawTable, kRectangle, 0xB58E62, kTop},
    {"telescope", DrawTelescope, kOpen, 0xB08D4F},
    {"television", DrawTelevision, kRectangle, 0x3A3D40},
    {"tent", DrawTent, kEllipse, 0xE2D5BE},
    {"throne", DrawThrone, kRectangle, 0x8E2F35, kSeat},
    {"toilet", DrawToilet, kEllipse, 0xF2F4F4},
    {"toy", DrawToy, kRounded, 0xE0C08A},
    {"tray", DrawTray, kRounded, 0xC2A070},
    {"treadmill", DrawTreadmill, kRectangle, 0x7F868C},
    {"trunk", DrawTrunk, kRectangle, 0x9A6F45},
    {"vanity", DrawVanity, kRectangle, 0xD9C6B4},
    {"vase", DrawVase, kEllipse, 0x9DB2BE},
    {"wall_lamp", DrawWallLamp, kRectangle, 0xE6CF8E},
    {"wardrobe", DrawWardrobe, kRectangle, 0xB9946A},
    {"washing_machine", DrawWasher, kRectangle, 0xE3E7E9},
    {"weight_bench", DrawWeightBench, kOpen, 0x6E7780},
    {"weights", DrawWeights, kRectangle, 0x7F868C},
    {"workbench", DrawWorkbench, kRectangle, 0xB98F62, kTop},
};

// Classes of furniture that look like another in plan, sorted by class.
constexpr std::pair<std::string_view, std::string_view> kLookAlikes[] = {
    {"aquarium", "counter"},
    {"bean_bag", "pouf"},
    {"blanket", "cushion"},
    {"board", "picture"},
    {"cart", "tray"},
    {"clock", "picture"},
    {"coat_stand", "rack"},
    {"floor_lamp", "lamp"},
    {"folding_screen", "curtain"},
    {"garment_rack", "rack"},
    {"kitchen_island", "table"},
    {"ladder", "rack"},
    {"log_stack", "trunk"},
    {"loom", "workbench"},
    {"organizer", "tray"},
    {"pool", "bath"},
    {"punching_bag", "orb"},
    {"range_hood", "shelf"},
    {"rowing_machine", "exercise_bike"},
    {"side_table", "coffee_table"},
    {"spinning_wheel", "exercise_bike"},
    {"table_lamp", "lamp"},
    {"tv_stand", "dresser"},
};

}  // namespace

std::span<const Symbol> Symbols() { return kSymbols; }

const Symbol* FindSymbol(std::string_view category) {
  const Symbol* at =
      std::lower_bound(std::begin(kSymbols), std::end(kSymbols), category,
                       [](const Symbol& symbol, std::string_view name) { return symbol.category < name; });
  return at != std::end(kSymbols) && at->category == category ? at : nullptr;
}

const Symbol* SymbolOfClass(std::string_view class_name) {
  if (const Symbol* symbol = FindSymbol(class_name); symbol != nullptr) return symbol;
  for (const auto& [name, category] : kLookAlikes) {
    if (name == class_name) return FindSymbol(category);
  }
  return FindSymbol("box");
}

const Symbol* SymbolFor(const v1::Object& object) { return SymbolOfClass(ClassOf(object)); }

}  // namespace flair::renderer
