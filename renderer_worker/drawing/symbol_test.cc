// SPDX-License-Identifier: GPL-3.0-or-later
#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "renderer_worker/drawing/plan.h"
#include "renderer_worker/furniture/classes.h"

namespace flair::renderer {
namespace {

TEST(Symbols, AreMarkedAtTheirFrontsWhereTheyArePlain) {
  for (const FurnitureClass& each : Furniture().furniture()) {
    EXPECT_EQ(each.front_mark(), each.symbol() == "plain_box") << each.name();
  }
}

// The ink of a symbol of this size, in millimetres at 1:10; `status` takes what drawing it says.
Box InkOf(const std::string& symbol, Size size, absl::Status* status = nullptr) {
  cairo_surface_t* surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, nullptr);
  cairo_t* cairo = cairo_create(surface);
  Canvas canvas(cairo);
  canvas.EnterFrame({0, 0}, 100, 0, true);
  const absl::Status drawn = DrawSymbol(canvas, {Hex(0xC0B0A0), Hex(0x403020)}, size.width, size.height, symbol);
  if (status != nullptr) {
    *status = drawn;
  } else {
    EXPECT_TRUE(drawn.ok()) << drawn.message();
  }
  EXPECT_EQ(cairo_status(cairo), CAIRO_STATUS_SUCCESS) << symbol;
  double x, y, width, height;
  cairo_recording_surface_ink_extents(surface, &x, &y, &width, &height);
  cairo_destroy(cairo);
  cairo_surface_destroy(surface);
  return {x, y, x + width, y + height};
}

std::set<std::string> AllSymbols() {
  std::set<std::string> all;
  for (const FurnitureClass& each : Furniture().furniture()) all.insert(each.symbol());
  return all;
}

TEST(Symbols, ANameThatIsNoneIsAPlainBlock) {
  absl::Status status;
  EXPECT_FALSE(InkOf("whatchamacallit", {1, 1}, &status).empty());
  EXPECT_EQ(status.code(), absl::StatusCode::kNotFound);
}

TEST(Symbols, EverySymbolStaysInItsRectangle) {
  for (const std::string& symbol : AllSymbols()) {
    for (const Size size : {Size{1.2, 0.7}, Size{0.9, 2.1}, Size{3, 3}}) {
      const Box allowed =
          BoxAround({0, 0}, {100 * size.width, 100 * size.height}).Grown(6);  // outlines and their corners
      EXPECT_TRUE(allowed.Contains(InkOf(symbol, size))) << symbol << " " << size.width << " x " << size.height;
    }
  }
}

TEST(Symbols, EverySymbolDrawsSomethingAtAnySize) {
  for (const std::string& symbol : AllSymbols()) {
    for (const Size size : {Size{0.01, 0.01}, Size{20, 0.02}, Size{0.02, 20}, Size{20, 20}}) {
      EXPECT_FALSE(InkOf(symbol, size).empty()) << symbol << " " << size.width << " x " << size.height;
    }
  }
}

}  // namespace
}  // namespace flair::renderer
