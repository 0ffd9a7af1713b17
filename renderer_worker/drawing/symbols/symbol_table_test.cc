// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/symbols/symbol_table.h"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

v1::Object Named(const std::string& name, v1::ObjectKind kind = v1::OBJECT_KIND_FLOOR) {
  v1::Object object;
  object.set_name(name);
  object.set_kind(kind);
  return object;
}

TEST(SymbolTable, IsSortedWithoutRepeats) {
  for (size_t i = 1; i < Symbols().size(); ++i) EXPECT_LT(Symbols()[i - 1].category, Symbols()[i].category);
}

TEST(SymbolTable, EveryClassOfFurnitureHasASymbol) {
  for (const std::string_view name : FurnitureClasses()) {
    EXPECT_EQ(SymbolOfClass(name) == FindSymbol("box"), name == "box") << name;
  }
}

TEST(SymbolTable, FreeNamesFindTheirSymbol) {
  const std::pair<const char*, const char*> cases[] = {{"king-size bed", "bed"},
                                                       {"Chest of Drawers", "dresser"},
                                                       {"desk lamp", "lamp"},
                                                       {"oak bookshelves", "bookshelf"},
                                                       {"adjustable dumbbell set", "weights"},
                                                       {"stack of books", "books"},
                                                       {"bedside table", "nightstand"},
                                                       {"dining chairs", "chair"},
                                                       {"velvet-lined coffin", "coffin"},
                                                       {"potted plant with basket", "plant"},
                                                       {"suit of armor", "statue"},
                                                       {"wizard's cauldron", "cauldron"},
                                                       {"mattress", "bed"},
                                                       {"wine barrel", "barrel"},
                                                       {"dressing table", "vanity"}};
  for (const auto& [name, category] : cases) EXPECT_EQ(SymbolFor(Named(name))->category, category) << name;
}

TEST(SymbolTable, UnknownNamesBecomeABox) {
  EXPECT_EQ(SymbolFor(Named("whatchamacallit"))->category, "box");
  EXPECT_EQ(SymbolFor(Named(""))->category, "box");
  EXPECT_EQ(SymbolFor(Named(std::string(10000, 'x')))->category, "box");
}

TEST(SymbolTable, TheNameWinsOverTheCategoryWhichHelpsWhenTheNameSaysNothing) {
  v1::Object object = Named("office chair");
  object.set_category("chair");
  EXPECT_EQ(SymbolFor(object)->category, "office_chair");
  object.set_name("Old Faithful");
  EXPECT_EQ(SymbolFor(object)->category, "chair");
}

TEST(SymbolTable, LampsOnTheCeilingArePendants) {
  EXPECT_EQ(SymbolFor(Named("lamp", v1::OBJECT_KIND_CEILING))->category, "pendant");
  EXPECT_EQ(SymbolFor(Named("lamp", v1::OBJECT_KIND_WALL))->category, "wall_lamp");
  EXPECT_EQ(SymbolFor(Named("torch stand"))->category, "lamp");
}

// The ink of a symbol of this size, in millimetres at 1:10.
Box InkOf(const Symbol& symbol, Size size) {
  cairo_surface_t* surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr);
  cairo_t* cairo = cairo_create(surface);
  Canvas canvas(cairo);
  canvas.EnterFrame({0, 0}, 100, 0, true);
  SymbolPen pen(canvas, {Hex(0xC0B0A0), Hex(0x403020)}, size.width, size.height);
  symbol.draw(pen);
  EXPECT_EQ(cairo_status(cairo), CAIRO_STATUS_SUCCESS) << symbol.category;
  double x, y, width, height;
  cairo_recording_surface_ink_extents(surface, &x, &y, &width, &height);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return {x, y, x + width, y + height};
}

TEST(SymbolTable, EverySymbolStaysInItsRectangle) {
  for (const Symbol& symbol : Symbols()) {
    for (const Size size : {Size{1.2, 0.7}, Size{0.9, 2.1}, Size{3, 3}}) {
      const Box allowed =
          BoxAround({0, 0}, {100 * size.width, 100 * size.height}).Grown(6);  // outlines and their corners
      EXPECT_TRUE(allowed.Contains(InkOf(symbol, size)))
          << symbol.category << " " << size.width << " x " << size.height;
    }
  }
}

TEST(SymbolTable, EverySymbolDrawsSomethingAtAnySize) {
  for (const Symbol& symbol : Symbols()) {
    for (const Size size : {Size{0.01, 0.01}, Size{20, 0.02}, Size{0.02, 20}, Size{20, 20}}) {
      EXPECT_FALSE(InkOf(symbol, size).empty()) << symbol.category << " " << size.width << " x " << size.height;
    }
  }
}

}  // namespace
}  // namespace flair::renderer
