// SPDX-License-Identifier: GPL-3.0-or-later
#include "renderer_worker/drawing/symbols/symbol.h"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

TEST(Symbols, EveryClassOfFurnitureHasOneAndEveryOneHasAClass) {
  std::set<std::string> used;
  for (const FurnitureClass& each : Furniture().furniture()) {
    used.insert(each.symbol());
    EXPECT_EQ(SymbolNamed(each.symbol()).name, each.symbol()) << each.name();
    EXPECT_EQ(each.front_mark(), each.symbol() == "plain_box") << each.name();
  }
  for (const Symbol& symbol : Symbols()) EXPECT_TRUE(used.contains(std::string(symbol.name))) << symbol.name;
}

TEST(Symbols, ANameThatIsNoneIsAPlainBlock) { EXPECT_EQ(SymbolNamed("whatchamacallit").name, "plain_box"); }

// The ink of a symbol of this size, in millimetres at 1:10.
Box InkOf(const Symbol& symbol, Size size) {
  cairo_surface_t* surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr);
  cairo_t* cairo = cairo_create(surface);
  Canvas canvas(cairo);
  canvas.EnterFrame({0, 0}, 100, 0, true);
  SymbolPen pen(canvas, {Hex(0xC0B0A0), Hex(0x403020)}, size.width, size.height);
  symbol.draw(pen);
  EXPECT_EQ(cairo_status(cairo), CAIRO_STATUS_SUCCESS) << symbol.name;
  double x, y, width, height;
  cairo_recording_surface_ink_extents(surface, &x, &y, &width, &height);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return {x, y, x + width, y + height};
}

TEST(Symbols, EverySymbolStaysInItsRectangle) {
  for (const Symbol& symbol : Symbols()) {
    for (const Size size : {Size{1.2, 0.7}, Size{0.9, 2.1}, Size{3, 3}}) {
      const Box allowed =
          BoxAround({0, 0}, {100 * size.width, 100 * size.height}).Grown(6);  // outlines and their corners
      EXPECT_TRUE(allowed.Contains(InkOf(symbol, size))) << symbol.name << " " << size.width << " x " << size.height;
    }
  }
}

TEST(Symbols, EverySymbolDrawsSomethingAtAnySize) {
  for (const Symbol& symbol : Symbols()) {
    for (const Size size : {Size{0.01, 0.01}, Size{20, 0.02}, Size{0.02, 20}, Size{20, 20}}) {
      EXPECT_FALSE(InkOf(symbol, size).empty()) << symbol.name << " " << size.width << " x " << size.height;
    }
  }
}

}  // namespace
}  // namespace flair::renderer
