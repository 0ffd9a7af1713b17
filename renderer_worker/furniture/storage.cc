// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// Cabinets and shelves.
namespace flair::renderer {
namespace {

// A carcass from `bottom` to the top whose front lies `inset` behind the box's: room for doors and handles.
struct CabinetCarcass {
  float board, bottom, front;
};

CabinetCarcass SolidCarcass(Piece& p, float plinth, bool cornice) {
  const CabinetCarcass c{std::min(0.02F, 0.06F * p.smaller()), plinth, p.d / 2 - std::min(0.05F, 0.14F * p.d)};
  p.make.Box(p.is.hard, {-p.w / 2 + 0.5F * c.board, -p.d / 2, 0},
             {p.w / 2 - 0.5F * c.board, c.front - 0.8F * c.board, plinth}, 0.003F);
  p.make.Box(p.is.hard, {-p.w / 2 + 0.3F * c.board, -p.d / 2, plinth},
             {p.w / 2 - 0.3F * c.board, c.front, p.h - c.board}, 0.003F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, p.h - (cornice ? 2 : 1) * c.board}, {p.w / 2, c.front + c.board, p.h},
             0.006F);
  return c;
}

// Doors side by side between two heights; handles meet in pairs.
void Doors(Piece& p, const CabinetCarcass& c, float left, float right, float bottom, float top, bool mirrored) {
  const int count = std::clamp(static_cast<int>(std::lround((right - left) / 0.52F)), 1, 8);
  const float wide = (right - left) / static_cast<float>(count), gap = std::min(0.004F, 0.02F * wide);
  const bool framed = !p.Says("sleek") && !p.Says("minimalist") && !p.Says("modern") && !p.Says("clean");
  for (int i = 0; i < count; ++i) {
    const float from = left + wide * static_cast<float>(i) + gap, to = from + wide - 2 * gap;
    p.Panel(p.is.hard, {from, bottom + gap}, {to, top - gap}, c.front, 0.8F * c.board, framed);
    if (mirrored)
      p.make.Box(stuff::Mirror(), {from + 0.14F * wide, c.front, bottom + 0.1F * wide},
                 {to - 0.14F * wide, c.front + 0.95F * c.board, top - 0.1F * wide}, 0.002F);
    const bool hinge_left = i % 2 == 0 && count > 1;
    const float x = hinge_left ? to - 0.05F * wide : from + 0.05F * wide,
                z = bottom + (top - bottom) * (top > 1.4F ? 0.5F : 0.62F);
    p.Handle({x, c.front + 0.8F * c.board, z}, std::min(0.22F, 0.3F * (top - bottom)), true);
  }
}

void DrawerFronts(Piece& p, const CabinetCarcass& c, float bottom, float top, int columns, int rows, bool knobs) {
  const float wide = (p.w - c.board) / static_cast<float>(columns), high = (top - bottom) / static_cast<float>(rows);
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < columns; ++i) {
      const float x = -p.w / 2 + 0.5F * c.board + wide * static_cast<float>(i),
                  z = bottom + high * static_cast<float>(row);
      const float gap = std::min(0.004F, 0.03F * high);
      p.Panel(p.is.hard, {x + gap, z + gap}, {x + wide - gap, z + high - gap}, c.front, 0.9F * c.board);
      const float y = c.front + 0.9F * c.board, middle = z + 0.55F * high;
      if (!knobs) {
        p.Handle({x + wide / 2, y, middle}, std::min(0.18F, 0.4F * wide), false);
      } else if (wide > 0.5F) {
        for (const float side : {0.25F, 0.75F}) p.Knob({x + side * wide, y, middle}, std::min(0.018F, 0.14F * high));
      } else {
        p.Knob({x + wide / 2, y, middle}, std::min(0.018F, 0.14F * high));
      }
    }
  }
}

// Books that fill a shelf from `left` to `right`, some lying, with gaps now and then.
void RowOfBooks(Piece& p, float left, float right, float back, float depth, float z, float room, int& index) {
  float x = left;
  const float scale = room / 0.3F, bevel = index < 60 ? 0.0025F * scale : 0;
  while (x < right - 0.03F * scale && index < 150) {
    const float pick = p.Chance(5 * index), thick = scale * (0.022F + 0.03F * p.Chance(5 * index + 1));
    if (pick > 0.93F && right - x > 0.2F * scale) {  // a small stack
      for (int i = 0; i < 3; ++i) {
        const float from = z + 0.032F * scale * static_cast<float>(i);
        p.make.Box(stuff::Book(index + i), {x, back + 0.1F * depth, from},
                   {x + 0.19F * scale, back + 0.85F * depth, from + 0.03F * scale}, 0.003F);
      }
      x += 0.2F * scale;
    } else if (pick > 0.86F) {
      x += 0.09F * scale;
    } else if (x + thick < right) {
      const float high = room * (0.62F + 0.26F * p.Chance(5 * index + 2)),
                  deep = depth * (0.66F + 0.24F * p.Chance(5 * index + 3));
      p.make.Box(stuff::Book(static_cast<int>(7 * p.Chance(5 * index + 4))), {x, back, z},
                 {x + thick, back + deep, z + high}, bevel);
      x += thick + 0.001F;
    } else {
      break;
    }
    ++index;
  }
}

void MakeWardrobe(Piece& p) {
  const CabinetCarcass c = SolidCarcass(p, std::min(0.08F, 0.06F * p.h), true);
  const float drawer = p.Says("drawer") ? 0.2F * p.h : 0;
  if (drawer > 0) DrawerFronts(p, c, c.bottom, c.bottom + drawer, p.w > 0.9F ? 2 : 1, 1, false);
  Doors(p, c, -p.w / 2 + 0.5F * c.board, p.w / 2 - 0.5F * c.board, c.bottom + drawer, p.h - 2 * c.board,
        p.Says("mirrored") || p.Says("mirror"));
}

void MakeDresser(Piece& p) {
  const bool legs = p.h > 0.5F && !p.Says("filing");
  const float plinth = legs ? std::min(0.13F, 0.14F * p.h) : 0.05F * p.h;
  const float board = std::min(0.02F, 0.06F * p.smaller()), front = p.d / 2 - std::min(0.05F, 0.14F * p.d);
  const CabinetCarcass c{board, plinth, front};
  if (legs)
    p.LegsAt(p.is.hard, 0.46F * p.w, 0.4F * p.d, plinth + 0.01F, std::min(0.022F, 0.05F * p.smaller()), 0.55F,
             0.01F * p.w);
  p.make.Box(p.is.hard, {-0.49F * p.w, -p.d / 2, legs ? plinth : 0}, {0.49F * p.w, front, p.h - board}, 0.003F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, p.h - 1.2F * board}, {p.w / 2, front + 1.3F * board, p.h}, 0.007F);
  const bool buffet = p.Says("sideboard") || p.Says("buffet") || p.Says("credenza");
  const int columns = p.w > 1.9F ? 3 : p.w > 0.85F ? 2 : 1;
  const int rows = std::clamp(static_cast<int>(std::lround((p.h - plinth) / 0.2F)), 1, 6);
  if (buffet && p.w > 0.9F) {
    DrawerFronts(p, c, p.h - 1.2F * board - 0.22F * p.h, p.h - 1.2F * board, columns, 1, true);
    Doors(p, c, -0.49F * p.w, 0.49F * p.w, plinth, p.h - 1.2F * board - 0.22F * p.h, false);
    return;
  }
  DrawerFronts(p, c, plinth + 0.01F * p.h, p.h - 1.2F * board, columns, rows,
               !p.Says("modern") && !p.Says("filing") && !p.Says("handle"));
}

void MakeTvStand(Piece& p) {
  const float board = std::min(0.022F, 0.08F * p.smaller()), leg = std::min(0.14F, 0.3F * p.h), front = p.d / 2 - 0.03F;
  const CabinetCarcass c{board, leg, front};
  p.LegsAt(p.is.hard, 0.42F * p.w, 0.36F * p.d, leg + 0.01F, std::min(0.02F, 0.07F * p.smaller()), 0.5F, 0.02F * p.w);
  for (const float z : {leg, p.h - board})
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, z}, {p.w / 2, front, z + board}, 0.004F);
  p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, leg}, {p.w / 2, -p.d / 2 + board, p.h - 0.5F * board}, 0.003F);
  for (const float x : {-0.5F, -0.18F, 0.18F, 0.5F}) {
    const float at = x * (p.w - board);
    p.make.Box(p.is.hard, {at - board / 2, -p.d / 2, leg}, {at + board / 2, front, p.h - 0.5F * board}, 0.003F);
  }
  Doors(p, c, -p.w / 2 + board, -0.18F * p.w, leg + board, p.h - board, false);
  Doors(p, c, 0.18F * p.w, p.w / 2 - board, leg + board, p.h - board, false);
  const float middle = (leg + p.h) / 2;
  p.make.Box(p.is.hard, {-0.18F * p.w, -p.d / 2, middle}, {0.18F * p.w, 0.9F * front, middle + 0.7F * board}, 0.003F);
  if (p.h - leg > 0.2F)
    p.make.Box(stuff::Black(), {-0.13F * p.w, -0.2F * p.d, leg + board}, {0.13F * p.w, 0.3F * p.d, leg + board + 0.06F},
               0.006F);
}

void MakeCabinet(Piece& p) {
  const CabinetCarcass c = SolidCarcass(p, std::min(0.08F, 0.08F * p.h), p.h > 1.2F);
  const float top = p.h - 2 * c.board;
  if (p.h > 1.5F) {
    const float middle = 0.45F * p.h;
    Doors(p, c, -p.w / 2 + 0.5F * c.board, p.w / 2 - 0.5F * c.board, c.bottom, middle, false);
    Doors(p, c, -p.w / 2 + 0.5F * c.board, p.w / 2 - 0.5F * c.board, middle, top, false);
  } else {
    Doors(p, c, -p.w / 2 + 0.5F * c.board, p.w / 2 - 0.5F * c.board, c.bottom, p.h - c.board, false);
  }
}

void MakeBookshelf(Piece& p) {
  const float board = std::min(0.022F, 0.05F * p.smaller()), back = -p.d / 2 + 0.4F * board;
  const bool open = p.Says("metal") || p.Says("industrial") || p.Says("ladder");
  const Material& frame = open ? p.is.metal : p.is.hard;
  const int rows = std::clamp(static_cast<int>(std::lround(p.h / 0.36F)), 1, 8),
            columns = std::clamp(static_cast<int>(std::lround(p.w / 0.95F)), 1, 5);
  if (!open) p.make.Box(p.is.hard, {-p.w / 2 + board, -p.d / 2, 0.02F * p.h}, {p.w / 2 - board, back, p.h - board}, 0);
  const float pitch = (p.w - board) / static_cast<float>(columns);
  for (int i = 0; i <= columns; ++i) {
    const float x = -p.w / 2 + board / 2 + pitch * static_cast<float>(i), half = open ? 0.35F * board : board / 2;
    if (!open) {
      p.make.Box(frame, {x - half, -p.d / 2, 0}, {x + half, p.d / 2, p.h}, 0.003F);
    } else {
      for (const float y : {-p.d / 2 + 0.7F * board, p.d / 2 - 0.7F * board})
        p.make.Box(frame, {x - 0.6F * board, y - 0.6F * board, 0}, {x + 0.6F * board, y + 0.6F * board, p.h}, 0.002F);
    }
  }
  const float plinth = std::min(0.07F, 0.05F * p.h), step = (p.h - plinth - board) / static_cast<float>(rows);
  int index = 0;
  for (int row = 0; row <= rows; ++row) {
    const float z = plinth + step * static_cast<float>(row);
    p.make.Box(p.is.hard, {-p.w / 2 + 0.6F * board, -p.d / 2, z},
               {p.w / 2 - 0.6F * board, p.d / 2 - 0.2F * board, z + board}, 0.003F);
    if (row == rows) break;
    for (int i = 0; i < columns; ++i) {
      const float left = -p.w / 2 + board + pitch * static_cast<float>(i), wide = pitch - board;
      const float fill = 0.55F + 0.45F * p.Chance(1000 + 10 * row + i);
      RowOfBooks(p, left + 0.01F * wide, left + fill * wide, back, 0.86F * p.d, z + board, step - board, index);
      if (fill < 0.8F && step > 0.15F) {
        p.make.Lathe(stuff::Book(4 + row), {left + 0.9F * wide, 0, z + board},
                     std::array<Vec2, 5>{{{0.04F * wide, 0},
                                          {0.07F * wide, 0.2F * step},
                                          {0.06F * wide, 0.35F * step},
                                          {0.03F * wide, 0.45F * step},
                                          {0.04F * wide, 0.5F * step}}},
                     9);
      }
    }
  }
}

void MakeShelf(Piece& p) {
  const float board = std::min(0.025F, 0.3F * p.h), post = std::min(0.018F, 0.06F * p.smaller());
  if (p.h < 0.35F) {  // a board on brackets, with a few things on it when there is room
    const float top = p.h > 0.12F ? 0.35F * p.h : p.h;
    p.make.Box(p.is.hard, {-p.w / 2, -p.d / 2, top - board}, {p.w / 2, p.d / 2, top}, 0.005F);
    for (const float x : {-0.36F, 0.36F}) {
      p.make.Box(p.is.metal, {x * p.w - 0.01F, -p.d / 2, 0}, {x * p.w + 0.01F, -p.d / 2 + 0.01F, top - board}, 0.002F);
      p.make.Bar(p.is.metal, {x * p.w, -p.d / 2 + 0.005F, 0.1F * top}, {x * p.w, 0.35F * p.d, top - board}, 0.006F, 6);
    }
    int index = 0;
    if (top < p.h) RowOfBooks(p, -0.42F * p.w, 0.05F * p.w, -p.d / 2 + 0.02F, 0.8F * p.d, top, p.h - top, index);
    if (top < p.h)
      p.make.Lathe(p.is.soft, {0.3F * p.w, 0, top},
                   std::array<Vec2, 4>{{{0.3F, 0}, {0.5F, 0.4F}, {0.3F, 0.8F}, {0.36F, 1}}}, 14,
                   {0.5F * p.d, (p.h - top)});
    return;
  }
  const int rows = std::clamp(static_cast<int>(std::lround(p.h / 0.38F)), 2, 7);
  const bool shoes = p.Says("shoe"), wine = p.Says("wine");
  for (const float x : {-1.0F, 1.0F}) {
    for (const float y : {-1.0F, 1.0F})
      p.make.Box(p.is.hard, {x * (p.w / 2 - post) - post, y * (p.d / 2 - post) - post, 0},
                 {x * (p.w / 2 - post) + post, y * (p.d / 2 - post) + post, p.h}, 0.003F);
  }
  for (int row = 0; row < rows; ++row) {
    const float step = (p.h - board) / (static_cast<float>(rows) - 0.75F), z = step * (static_cast<float>(row) + 0.25F);
    p.make.Box(p.is.hard, {-p.w / 2 + post, -p.d / 2 + 0.5F * post, z},
               {p.w / 2 - post, p.d / 2 - 0.5F * post, z + board}, 0.003F);
    if (row == rows - 1) break;
    const int things = std::clamp(static_cast<int>(p.w / (shoes ? 0.16F : 0.34F)), 1, 6);
    const float pitch = (p.w - 3 * post) / static_cast<float>(things);
    for (int i = 0; i < things; ++i) {
      const float x = -p.w / 2 + 1.5F * post + pitch * (static_cast<float>(i) + 0.5F), room = step - board;
      const int tint = static_cast<int>(7 * p.Chance(20 * row + i));
      if (shoes) {
        if (p.Chance(300 + 20 * row + i) < 0.25F) continue;
        const float low = z + board;
        const Vec3 toe{0.26F * pitch, std::min(0.15F, 0.4F * p.d), std::min(0.04F, 0.3F * room)},
            heel{0.22F * pitch, std::min(0.08F, 0.2F * p.d), std::min(0.055F, 0.4F * room)};
        p.make.Ellipsoid(stuff::Book(tint), {x, 0, low + toe.z}, toe, 9, 5);
        p.make.Ellipsoid(stuff::Book(tint), {x, -std::min(0.07F, 0.18F * p.d), low + heel.z}, heel, 9, 5);
      } else if (wine) {
        p.make.Bar(stuff::Book(2), {x, -0.4F * p.d, z + board + 0.04F}, {x, 0.45F * p.d, z + board + 0.04F},
                   std::min(0.038F, 0.3F * room), 10);
      } else {
        p.make.Box(i % 2 == 0 ? p.is.soft : stuff::Book(tint), {x - 0.38F * pitch, -0.4F * p.d, z + board},
                   {x + 0.38F * pitch, 0.36F * p.d, z + board + room * (0.4F + 0.4F * p.Chance(400 + 20 * row + i))},
                   0.008F);
      }
    }
  }
}

}  // namespace

std::span<const PieceMaker> StorageMakers() {
  static constexpr PieceMaker kMakers[] = {{"wardrobe", MakeWardrobe},   {"dresser", MakeDresser},
                                           {"tv_stand", MakeTvStand},    {"cabinet", MakeCabinet},
                                           {"bookshelf", MakeBookshelf}, {"shelf", MakeShelf}};
  return kMakers;
}

}  // namespace flair::renderer
