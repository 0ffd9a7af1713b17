// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "renderer_worker/furniture/piece.h"

// What hangs, and screens.
namespace flair::renderer {
namespace {

// x to the left of someone who looks at it, y up, z to the front: shapes drawn on a wall.
Frame OnWall(Vec3 origin) { return {origin, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}; }

// Four rails about an area; the area's half sizes and how broad they are.
void FrameRails(Piece& p, const Material& material, float rail) {
  const float x = p.w / 2, y = p.d / 2;
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Box(material, {side * x, -y, 0}, {side * (x - rail), y, p.h}, 0.005F);
    p.make.Box(material, {-x + rail, -y, side < 0 ? 0 : p.h - rail}, {x - rail, y, side < 0 ? rail : p.h}, 0.005F);
  }
}

Material Paint(const char* name, Vec3 colour) {
  Material paint = PlainMaterial(name, 0x808080, 0.75F);
  paint.colour = paint.second_colour = colour;
  return paint;
}

// Hills below a sky with a sun, or overlapping shapes; flush slabs, one over the other.
void Motif(Piece& p, float x, float z, float y, bool abstract) {
  const Vec3 base = p.is.colour, pale = Blend(base, {0.8F, 0.78F, 0.72F}, 0.7F), deep = base * 0.45F;
  const float wide = x, high = z;
  p.make.In(OnWall({0, y, p.h / 2}), [&] {
    if (abstract) {
      const std::array<Vec3, 4> hues{deep, LinearHex(0xC98B4B), pale * 0.8F, LinearHex(0x3E5A6B)};
      for (int i = 0; i < 4; ++i) {
        const float cx = wide * (1.0F * p.Chance(i) - 0.5F), cz = high * (1.0F * p.Chance(10 + i) - 0.5F),
                    r = std::min(wide, high) * (0.28F + 0.2F * p.Chance(20 + i));
        p.make.Slab(Paint(i == 0   ? "figure 1"
                          : i == 1 ? "figure 2"
                          : i == 2 ? "figure 3"
                                   : "figure 4",
                          hues[static_cast<size_t>(i)]),
                    i % 2 == 0 ? EllipseOutline({cx, cz}, r, r, 24)
                               : RoundedOutline({cx - r, cz - 0.6F * r}, {cx + r, cz + 0.6F * r}, 0.01F, 1),
                    0, 0.0008F * static_cast<float>(i + 1), 0);
      }
      return;
    }
    p.make.Slab(
        Paint("sun", LinearHex(0xE3B061)),
        EllipseOutline({-0.4F * wide, 0.42F * high}, 0.18F * std::min(wide, high), 0.18F * std::min(wide, high), 20), 0,
        0.0008F, 0);
    for (int layer = 0; layer < 3; ++layer) {
      std::vector<Vec2> hills{{-wide, -high}, {wide, -high}};
      for (int i = 0; i <= 10; ++i) {
        const float t = 1 - 0.2F * static_cast<float>(i);
        hills.push_back(
            {wide * t, high * (0.16F - 0.34F * static_cast<float>(layer) +
                               0.16F * std::sin(2.2F * t * (1 + static_cast<float>(layer)) + 6 * p.Chance(layer)))});
      }
      p.make.Slab(Paint(layer == 0   ? "hills far"
                        : layer == 1 ? "hills"
                                     : "hills near",
                        Blend(pale, deep, 0.33F * static_cast<float>(layer + 1))),
                  hills, 0, 0.0012F * static_cast<float>(layer + 1), 0);
    }
  });
}

void MakePicture(Piece& p) {
  const float rail = std::min(0.045F, 0.08F * std::min(p.w, p.h));
  if (p.Says("tapestry")) {
    p.make.Bar(p.is.hard, {-p.w / 2, 0, 0.97F * p.h}, {p.w / 2, 0, 0.97F * p.h}, std::min(0.02F, 0.4F * p.d), 10);
    p.make.Box(p.is.soft, {-0.46F * p.w, -0.2F * p.d, 0.06F * p.h}, {0.46F * p.w, 0.1F * p.d, 0.98F * p.h}, 0.002F);
    for (const float z : {0.16F, 0.44F, 0.72F})
      p.make.Box(z == 0.44F ? p.is.pale : p.is.accent, {-0.44F * p.w, 0.05F * p.d, z * p.h},
                 {0.44F * p.w, 0.2F * p.d, (z + 0.12F) * p.h}, 0);
    for (int i = 0; i < 16; ++i) {
      const float x = p.w * (-0.45F + 0.06F * static_cast<float>(i));
      p.make.Box(p.is.pale, {x - 0.01F * p.w, -0.1F * p.d, 0}, {x + 0.01F * p.w, 0.05F * p.d, 0.07F * p.h}, 0);
    }
    return;
  }
  const bool standing = p.Says("photo") || p.d > 0.4F * p.h;
  FrameRails(p, p.Says("gold") || p.Says("ornate") ? p.is.metal : p.is.hard, rail);
  p.make.Box(p.Says("canvas") ? p.is.pale : stuff::Paper(), {-p.w / 2 + 0.8F * rail, -p.d / 2, 0.8F * rail},
             {p.w / 2 - 0.8F * rail, 0.1F * p.d, p.h - 0.8F * rail}, 0);
  const float mount = p.Says("canvas") ? 1.0F : 1.9F, x = p.w / 2 - mount * rail, z = p.h / 2 - mount * rail;
  if (std::min(x, z) < 0.004F) return;
  p.make.Box(Paint("sky", Blend(p.is.colour, {0.72F, 0.76F, 0.78F}, 0.75F)), {-x, 0, p.h / 2 - z},
             {x, 0.12F * p.d, p.h / 2 + z}, 0);
  Motif(p, x, z, 0.12F * p.d, p.Says("abstract") || p.Says("modern") || (!standing && p.Chance(1) < 0.4F));
}

void MakeMirror(Piece& p) {
  const bool round = p.Says("round") || p.Says("oval") || p.Says("circular");
  if (p.d > 0.25F && p.h > 0.8F) {  // stands by itself, tilted in a frame
    const float leg = std::min(0.02F, 0.05F * p.w);
    for (const float side : {-1.0F, 1.0F}) {
      p.make.Box(p.is.hard, {side * p.w / 2, -p.d / 2, 0}, {side * (p.w / 2 - 2 * leg), p.d / 2, 2 * leg}, 0.006F);
      p.make.Box(p.is.hard, {side * p.w / 2, -leg, leg}, {side * (p.w / 2 - 2 * leg), leg, 0.62F * p.h}, 0.004F);
    }
    p.make.In(Frame::TurnedX({0, 0, 0.55F * p.h}, 0.08F), [&] {
      p.make.In(OnWall({}), [&] {
        p.make.Slab(p.is.hard, EllipseOutline({}, p.w / 2 - 2.6F * leg, 0.45F * p.h, 36), -leg, leg, 0.005F);
        p.make.Slab(stuff::Mirror(), EllipseOutline({}, p.w / 2 - 4.6F * leg, 0.45F * p.h - 2 * leg, 36), 0,
                    leg + 0.002F, 0);
      });
    });
    return;
  }
  const float rail = std::min(0.04F, 0.08F * std::min(p.w, p.h));
  if (round) {
    p.make.In(OnWall({0, 0, p.h / 2}), [&] {
      p.make.Slab(p.is.hard, EllipseOutline({}, p.w / 2, p.h / 2, 44), -p.d / 2, p.d / 2, 0.006F);
      p.make.Slab(stuff::Mirror(), EllipseOutline({}, p.w / 2 - rail, p.h / 2 - rail, 44), 0, p.d / 2 + 0.001F, 0);
    });
    return;
  }
  FrameRails(p, p.is.hard, rail);
  p.make.Box(stuff::Mirror(), {-p.w / 2 + 0.8F * rail, -p.d / 2, 0.8F * rail},
             {p.w / 2 - 0.8F * rail, 0.3F * p.d, p.h - 0.8F * rail}, 0);
}

void MakeClock(Piece& p) {
  const auto face = [&](Vec3 centre, float r, float thick) {
    p.make.In(OnWall(centre), [&] {
      p.make.Lathe(p.is.hard, {0, 0, -thick},
                   std::array<Vec2, 4>{{{r, 0}, {r, 0.8F * thick}, {0.94F * r, thick}, {0.88F * r, 0.75F * thick}}},
                   36);
      p.make.Cylinder(stuff::Paper(), {0, 0, -thick}, 0.9F * r, 0.8F * thick, 0, 32);
      for (int i = 0; i < 12; ++i) {
        const float turn = kPiFloat / 6 * static_cast<float>(i), half = (i % 3 == 0 ? 0.035F : 0.018F) * r;
        p.make.In(Frame::TurnedZ({}, turn), [&] {
          p.make.Box(stuff::Black(), {-half, 0.7F * r, -0.25F * thick}, {half, 0.84F * r, -0.15F * thick}, 0);
        });
      }
      for (const Vec3 hand : {Vec3{0.9F, 0.48F, 0.04F}, Vec3{-1.05F, 0.68F, 0.025F}}) {  // ten past ten
        p.make.In(Frame::TurnedZ({}, hand.x), [&] {
          p.make.Box(stuff::Black(), {-hand.z * r, -0.1F * r, -0.2F * thick}, {hand.z * r, hand.y * r, -0.1F * thick},
                     0);
        });
      }
      p.make.Cylinder(p.is.metal, {0, 0, -0.2F * thick}, 0.06F * r, 0.14F * thick, 0, 12);
    });
  };
  if (p.h > 1) {  // a long-case clock
    const float x = p.w / 2, hood = 0.74F * p.h;
    p.make.Box(p.is.hard, {-x, -p.d / 2, 0}, {x, p.d / 2, 0.22F * p.h}, 0.008F);
    p.make.Box(p.is.hard, {-0.74F * x, -p.d / 2, 0.21F * p.h}, {0.74F * x, 0.4F * p.d, hood}, 0.006F);
    p.make.Box(p.is.hard, {-x, -p.d / 2, hood}, {x, 0.44F * p.d, 0.94F * p.h}, 0.008F);
    p.make.In(OnWall({0, -p.d / 2, 0.93F * p.h}),
              [&] { p.make.Slab(p.is.hard, ArcPoints({}, x, 0.07F * p.h, 0, kPiFloat, 12), 0, 0.94F * p.d, 0.006F); });
    p.make.Box(stuff::Screen(), {-0.5F * x, 0.39F * p.d, 0.27F * p.h}, {0.5F * x, 0.41F * p.d, hood - 0.04F * p.h}, 0);
    p.make.Bar(p.is.metal, {0, 0.42F * p.d, 0.38F * p.h}, {0, 0.42F * p.d, hood - 0.05F * p.h}, 0.006F, 6);
    p.make.In(OnWall({0, 0.41F * p.d, 0.37F * p.h}),
              [&] { p.make.Cylinder(p.is.metal, {}, 0.34F * x, 0.03F * p.d, 0.003F, 24); });
    face({0, 0.5F * p.d, 0.84F * p.h}, std::min(0.8F * x, 0.09F * p.h), 0.06F * p.d);
    return;
  }
  const float r = 0.5F * std::min(p.w, p.h);
  if (p.d > 0.5F * p.h && p.h < 0.4F) {  // stands on furniture
    p.make.Cushion(p.is.hard, {-p.w / 2, -p.d / 2, 0}, {p.w / 2, 0.42F * p.d, p.h}, 0.2F * std::min({p.w, p.d, p.h}));
    face({0, p.d / 2, 0.52F * p.h}, 0.8F * r, 0.1F * p.d);
    return;
  }
  face({0, p.d / 2, p.h / 2}, r, p.d);
}

void MakeBoard(Piece& p) {
  const float rail = std::min(0.03F, 0.06F * std::min(p.w, p.h));
  static const Material kSlate = PlainMaterial("slate board", 0x2E3A36, 0.8F);
  const bool white = p.Says("white") || p.Says("whiteboard") || p.Says("calendar"),
             dark = p.Says("blackboard") || p.Says("chalkboard");
  FrameRails(p, p.is.hard, rail);
  p.make.Box(white  ? stuff::White()
             : dark ? kSlate
                    : stuff::Cork(),
             {-p.w / 2 + 0.8F * rail, -p.d / 2, 0.8F * rail}, {p.w / 2 - 0.8F * rail, 0.1F * p.d, p.h - 0.8F * rail},
             0);
  for (int i = 0; i < 6; ++i) {  // notes
    const float x = p.w * (0.72F * p.Chance(i) - 0.36F), z = p.h * (0.2F + 0.55F * p.Chance(10 + i)),
                s = 0.09F * std::min(p.w, p.h) * (1 + p.Chance(20 + i));
    p.make.In(OnWall({x, 0.1F * p.d, z}), [&] {
      p.make.In(Frame::TurnedZ({}, 0.3F * (p.Chance(30 + i) - 0.5F)), [&] {
        p.make.Box(i % 3 == 0 ? stuff::Book(i) : stuff::Paper(), {-s, -s, 0},
                   {s, 1.2F * s, 0.0012F * static_cast<float>(i + 1)}, 0);
      });
    });
  }
}

void MakeTelevision(Piece& p) {
  const bool stands = p.d > 0.12F && p.h > 0.25F;
  const float foot = stands ? 0.1F * p.h : 0, thick = std::min(0.05F, 0.5F * p.d), y = stands ? thick / 2 : p.d / 2;
  p.make.Box(p.is.hard, {-p.w / 2, y - thick, foot}, {p.w / 2, y, p.h}, 0.006F);
  const float bezel = std::min(0.012F, 0.02F * std::min(p.w, p.h));
  p.make.Box(stuff::Screen(), {-p.w / 2 + bezel, y - 0.002F, foot + 1.6F * bezel},
             {p.w / 2 - bezel, y + 0.002F, p.h - bezel}, 0);
  if (!stands)
    return p.make.Box(p.is.hard, {-0.2F * p.w, -p.d / 2, 0.3F * p.h}, {0.2F * p.w, y - 0.9F * thick, 0.7F * p.h},
                      0.004F);
  for (const float side : {-1.0F, 1.0F}) {
    p.make.Bar(p.is.hard, {side * 0.3F * p.w, 0, foot + 0.01F * p.h}, {side * 0.36F * p.w, p.d / 2 - 0.01F, 0.008F},
               0.008F, 8);
    p.make.Bar(p.is.hard, {side * 0.3F * p.w, 0, foot + 0.01F * p.h}, {side * 0.36F * p.w, -p.d / 2 + 0.01F, 0.008F},
               0.008F, 8);
  }
}

void MakeScreen(Piece& p) {
  const float foot = std::min(0.02F, 0.06F * p.h), low = 0.26F * p.h, thick = std::min(0.03F, 0.3F * p.d);
  p.make.Slab(p.is.hard, RoundedOutline({-0.26F * p.w, -p.d / 2}, {0.26F * p.w, p.d / 2}, 0.03F), 0, foot, 0.004F);
  p.make.Box(p.is.hard, {-0.05F * p.w, -0.3F * p.d, 0.5F * foot}, {0.05F * p.w, -0.1F * p.d, 0.5F * p.h}, 0.006F);
  p.make.Box(p.is.hard, {-p.w / 2, -0.12F * p.d, low}, {p.w / 2, -0.12F * p.d + thick, p.h}, 0.006F);
  const float bezel = std::min(0.012F, 0.03F * p.h), y = -0.12F * p.d + thick;
  p.make.Box(stuff::Lit(), {-p.w / 2 + bezel, y - 0.001F, low + 1.8F * bezel},
             {p.w / 2 - bezel, y + 0.002F, p.h - bezel}, 0);
  p.make.Box(stuff::White(), {-0.42F * p.w, y + 0.001F, low + 0.2F * p.h}, {0.05F * p.w, y + 0.003F, p.h - 0.12F * p.h},
             0);
}

void MakeLaptop(Piece& p) {
  const float thick = std::min(0.018F, 0.1F * p.h), hinge = -0.3F * p.d,
              lean = std::atan2(p.d / 2 + hinge, p.h - thick);
  p.make.Slab(p.is.hard, RoundedOutline({-p.w / 2, hinge}, {p.w / 2, p.d / 2}, 0.015F), 0, thick, 0.003F);
  p.make.Box(stuff::Black(), {-0.43F * p.w, hinge + 0.08F * p.d, thick - 0.001F},
             {0.43F * p.w, 0.16F * p.d, thick + 0.002F}, 0);
  p.make.Box(stuff::Steel(), {-0.13F * p.w, 0.22F * p.d, thick - 0.001F}, {0.13F * p.w, 0.43F * p.d, thick + 0.001F},
             0);
  const float length = std::sqrt((p.h - thick) * (p.h - thick) + (p.d / 2 + hinge) * (p.d / 2 + hinge));
  p.make.In(Frame::TurnedX({0, hinge, thick}, lean), [&] {
    p.make.Box(p.is.hard, {-p.w / 2, -0.4F * thick, 0}, {p.w / 2, 0.2F * thick, length}, 0.003F);
    p.make.Box(stuff::Lit(), {-0.46F * p.w, 0.1F * thick, 0.06F * length}, {0.46F * p.w, 0.3F * thick, 0.95F * length},
               0);
  });
}

void MakeCeilingFan(Piece& p) {
  const float r = 0.5F * p.smaller(), hub = 0.16F * r, z = 0.4F * p.h;
  p.make.Bar(p.is.metal, {0, 0, z}, {0, 0, p.h}, std::min(0.02F, 0.1F * r), 10);
  p.make.Lathe(p.is.metal, {0, 0, 0.9F * p.h}, std::array<Vec2, 2>{{{0.08F * r, 0}, {0.14F * r, 0.1F * p.h}}}, 20);
  p.make.Lathe(
      p.is.metal, {0, 0, 0.22F * p.h},
      std::array<Vec2, 4>{{{0.8F * hub, 0}, {hub, 0.06F * p.h}, {hub, 0.22F * p.h}, {0.5F * hub, 0.32F * p.h}}}, 24);
  p.make.Ellipsoid(stuff::Shade(), {0, 0, 0.2F * p.h}, {0.9F * hub, 0.9F * hub, 0.2F * p.h}, 18, 10);
  p.Shine({0, 0, 0.15F * p.h}, 70, 0.6F * hub);
  for (int i = 0; i < 5; ++i) {
    p.make.In(Frame::TurnedZ({0, 0, z}, 2 * kPiFloat / 5 * static_cast<float>(i)), [&] {
      p.make.In({{}, {1, 0, 0}, {0, std::cos(0.2F), std::sin(0.2F)}, {0, -std::sin(0.2F), std::cos(0.2F)}}, [&] {
        p.make.Slab(p.is.hard, RoundedOutline({0.8F * hub, -0.09F * r}, {r, 0.09F * r}, 0.06F * r), -0.01F * p.h,
                    0.03F * p.h, 0.002F);
      });
    });
  }
}

}  // namespace

std::span<const PieceMaker> MountedMakers() {
  static constexpr PieceMaker kMakers[] = {
      {"picture", MakePicture},       {"mirror", MakeMirror}, {"clock", MakeClock},   {"board", MakeBoard},
      {"television", MakeTelevision}, {"screen", MakeScreen}, {"laptop", MakeLaptop}, {"ceiling_fan", MakeCeilingFan}};
  return kMakers;
}

}  // namespace flair::renderer
