-- SPDX-License-Identifier: GPL-3.0-or-later
-- What every piece may use, loaded before all others.
--
-- `mesh.NAME` makes a piece of furniture in the box [-w/2, w/2] x [-d/2, d/2] x [0, h], front at +y, metres; it is
-- stretched to fill it exactly in the end. Its shapes (box, cushion, pillow, taper, slab, lathe, ring, tube, sheet) are
-- described in modeller.h, those made of them (cylinder, ellipsoid, bar, hoop) below; each takes its material first:
-- "hard", "soft", "metal", "pale" or "accent" of the piece's own, the name of one in materials.textproto, or what
-- `material` gives.
-- `plan.NAME` draws the plan symbol in [left, right] x [back, front]: area, oval, circle, shape, segment and curve of
-- drawing/symbol.h, with a tone and a line by name.
--
-- Meshes may ask says("word", ...) whether the piece's name, material or description has one of these words, and
-- chance(i) for a number in [0, 1) that is the same whenever the piece is made. `rest` is how high things lie on it.
-- shine(at, candela, radius) is a lamp's light; inside(frame, function) builds in a frame that is turned or moved.

local rawset, setmetatable = rawset, setmetatable  -- which other scripts do not see

mesh, plan = {}, {}

pi = math.pi
abs, min, max, sqrt, exp = math.abs, math.min, math.max, math.sqrt, math.exp
sin, cos, atan, fmod = math.sin, math.cos, math.atan, math.fmod

function clamp(value, low, high) return max(low, min(high, value)) end
-- Counts come from decimals: what is a whole number but for the last digit counts as one.
local whole_floor = math.floor
function floor(value) return whole_floor(value + 1e-6) end
function round(value) return floor(value + 0.5) end

-- Lists.

function each(list)
  local i = 0
  return function()
    i = i + 1
    return list[i]
  end
end

function push(list, value) list[#list + 1] = value end

function reverse(list)
  for i = 1, #list // 2 do list[i], list[#list + 1 - i] = list[#list + 1 - i], list[i] end
end

-- Points and directions: {x, y, z}, which vec gives arithmetic.

local vector = {}
function vec(x, y, z) return setmetatable({x, y, z or 0}, vector) end
function vector.__add(a, b) return vec(a[1] + b[1], a[2] + b[2], (a[3] or 0) + (b[3] or 0)) end
function vector.__sub(a, b) return vec(a[1] - b[1], a[2] - b[2], (a[3] or 0) - (b[3] or 0)) end
function vector.__unm(a) return vec(-a[1], -a[2], -a[3]) end
function vector.__mul(a, b)
  if type(a) == "number" then a, b = b, a end
  return vec(a[1] * b, a[2] * b, a[3] * b)
end

function dot(a, b) return a[1] * b[1] + a[2] * b[2] + a[3] * b[3] end
function cross(a, b) return vec(a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1]) end
function length(a) return sqrt(dot(a, a)) end
function normalized(a) return vec(a[1], a[2], a[3]) * (1 / max(length(a), 1e-12)) end

-- Frames for inside(frame, function): an origin and the directions of x, y and z.

function turned_x(origin, angle)
  return {origin, {1, 0, 0}, {0, cos(angle), sin(angle)}, {0, -sin(angle), cos(angle)}}
end
function turned_y(origin, angle)
  return {origin, {cos(angle), 0, -sin(angle)}, {0, 1, 0}, {sin(angle), 0, cos(angle)}}
end
function turned_z(origin, angle)
  return {origin, {cos(angle), sin(angle), 0}, {-sin(angle), cos(angle), 0}, {0, 0, 1}}
end
-- z to the front, x to the left of someone who looks at it, y up: for what is drawn on a wall or a door.
function facing_front(origin) return {origin, {-1, 0, 0}, {0, 0, 1}, {0, 1, 0}} end
-- z to the right: for wheels.
function facing_right(origin) return {origin, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}} end
-- A quarter turn, x to the front.
function quarter_turn() return {{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}} end

-- Builds what is longer than wide, whichever way its box lies.
function lengthwise(build)
  if d >= w then return build() end
  inside(quarter_turn(), function()
    w, d = d, w
    build()
    w, d = d, w
  end)
end

-- Outlines and profiles: lists of points, counter-clockwise.

function arc(centre, radius_x, radius_y, from, to, steps)
  local points = {}
  for i = 0, steps do
    local angle = from + (to - from) * i / steps
    push(points, {(centre[1] or 0) + radius_x * cos(angle), (centre[2] or 0) + radius_y * sin(angle)})
  end
  return points
end

function ellipse(centre, radius_x, radius_y, sides)
  local points = arc(centre, radius_x, radius_y, 0, 2 * pi, sides)
  points[#points] = nil
  return points
end

function scaled(points, by_x, by_y)
  local new = {}
  for point in each(points) do push(new, {by_x * point[1], by_y * point[2]}) end
  return new
end

function rounded(low, high, radius, steps)
  radius = min(radius, 0.499 * min(high[1] - low[1], high[2] - low[2]))
  local centres = {{high[1] - radius, low[2] + radius}, {high[1] - radius, high[2] - radius},
      {low[1] + radius, high[2] - radius}, {low[1] + radius, low[2] + radius}}
  local points = {}
  for i, centre in ipairs(centres) do
    for point in each(arc(centre, radius, radius, pi / 2 * (i - 2), pi / 2 * (i - 1), steps or 3)) do
      push(points, point)
    end
  end
  return points
end

-- Shapes made of others.

-- Upright, its rims bevelled.
function cylinder(material, base, radius, height, bevel, sides)
  if radius < 1e-5 or height < 1e-5 then return end
  bevel = min(bevel or 0.003, 0.3 * radius, 0.3 * height)
  lathe(material, base, {{radius - bevel, 0}, {radius, bevel}, {radius, height - bevel}, {radius - bevel, height}},
      sides or 20)
end

function ellipsoid(material, centre, radii, sides, rings)
  if min(radii[1], radii[2], radii[3]) < 1e-5 then return end
  local profile = arc({}, 1, radii[3], -pi / 2, pi / 2, rings or 8)
  profile[1][1], profile[#profile][1] = 0, 0
  lathe(material, centre, profile, sides or 16, radii)
end

-- bar(material, from, to, radius, sides), or with a radius at either end.
function bar(material, from, to, from_radius, to_radius, sides)
  if not sides then to_radius, sides = from_radius, to_radius end
  local along = vec(to[1] or 0, to[2] or 0, to[3]) - vec(from[1] or 0, from[2] or 0, from[3])
  if length(along) >= 1e-5 then tube(material, {from, to}, {from_radius, to_radius}, sides or 8) end
end

-- A closed ring of wire about the z axis of the frame.
function hoop(material, centre, radius, thickness, sides)
  ring(material, centre, ellipse({radius}, thickness / 2, thickness / 2, 6), sides or 24)
end

-- Materials and colours (linear RGB).

local covers = {"book, red", "book, blue", "book, green", "book, ochre", "book, cream", "book, brown", "book, slate"}
function cover(i) return covers[i % 7 + 1] end

local leaves = {"leaf", "light leaf", "dark leaf"}
function leaf(i) return leaves[i % 3 + 1] end

function paint(name, colour, roughness) return material{name = name, colour = colour, roughness = roughness or 0.75} end

function blend(from, to, share)
  return vec(from[1], from[2], from[3]) * (1 - share) + vec(to[1], to[2], to[3]) * share
end

-- Parts of many pieces.

-- Square legs at the corners of a table or chest, thinner at the foot by `thinning`.
function legs_at(material, x, y, top, half, thinning, splay)
  thinning, splay = thinning or 0.6, splay or 0
  for sx in each{-1, 1} do
    for sy in each{-1, 1} do
      taper(material, {sx * (x + splay), sy * (y + splay), 0}, {half * thinning, half * thinning},
          {sx * x, sy * y, top}, {half, half})
    end
  end
end

function round_legs_at(material, x, y, top, radius, splay)
  splay = splay or 0
  for sx in each{-1, 1} do
    for sy in each{-1, 1} do
      bar(material, {sx * (x + splay), sy * (y + splay), 0}, {sx * x, sy * y, top}, 0.6 * radius, radius, 10)
    end
  end
end

-- Sticks out to the front.
function knob(at, radius)
  if radius < 1e-4 then return end
  inside(turned_x(at, -pi / 2), function()
    local profile = {}
    for point in each{{0.45, 0}, {0.4, 0.5}, {0.95, 0.9}, {1, 1.2}, {0.75, 1.6}, {0, 1.7}} do
      push(profile, {radius * point[1], radius * point[2]})
    end
    lathe("metal", {}, profile, 10)
  end)
end

-- Likewise.
function handle(at, length, upright)
  if length < 1e-3 then return end
  at = vec(at[1], at[2], at[3])
  local thick, front = min(0.006, 0.1 * length), vec(0, 0.028 * min(1, length / 0.1), 0)
  local along = upright and vec(0, 0, length / 2) or vec(length / 2, 0, 0)
  bar("metal", at - along + front, at + along + front, thick, 8)
  for side in each{-0.8, 0.8} do
    bar("metal", at + along * side, at + along * side + front, 0.8 * thick, 6)
  end
end

-- A door or a drawer's front that faces +y at `y`, between two points {x, z}; rails about it when framed.
function panel(material, low, high, y, thickness, framed)
  thickness = thickness or 0.018
  box(material, {low[1], y, low[2]}, {high[1], y + thickness, high[2]}, 0.003)
  local width, height = high[1] - low[1], high[2] - low[2]
  local rail = min(0.06, 0.2 * width, 0.2 * height)
  if not framed or rail < 0.008 then return end
  local front = y + thickness
  local proud = front + 0.55 * thickness
  box(material, {low[1], front, low[2]}, {low[1] + rail, proud, high[2]}, 0.003)
  box(material, {high[1] - rail, front, low[2]}, {high[1], proud, high[2]}, 0.003)
  box(material, {low[1] + rail, front, low[2]}, {high[1] - rail, proud, low[2] + rail}, 0.003)
  box(material, {low[1] + rail, front, high[2] - rail}, {high[1] - rail, proud, high[2]}, 0.003)
end

-- Four rails about what hangs, before its front half only: from aside it is no box.
function frame_rails(material, rail)
  local x, y = w / 2, d / 2
  for side in each{-1, 1} do
    box(material, {side * x, 0, 0}, {side * (x - rail), y, h}, 0.005)
    box(material, {-x + rail, 0, side < 0 and 0 or h - rail}, {x - rail, y, side < 0 and rail or h}, 0.005)
  end
end

-- A flame above `at` and its light.
function flame(at, height, intensity_cd)
  local r = 0.22 * height
  lathe("flame", at, {{0, 0}, {0.8 * r, 0.12 * height}, {r, 0.32 * height}, {0.45 * r, 0.68 * height}, {0, height}}, 8)
  shine({at[1], at[2], at[3] + 0.4 * height}, intensity_cd, max(0.01, r), {1, 0.66, 0.32})
end

function shade(base, bottom_radius, top_radius, height, material)
  local wall = min(0.004, 0.1 * bottom_radius, 0.1 * top_radius, 0.1 * height)
  ring(material, base, {{bottom_radius - wall, 0}, {bottom_radius, 0}, {top_radius, height},
      {top_radius - wall, height}}, 24)
end

-- Lying, its back to +y.
function book(low, high, index)
  local lining = min(0.004, 0.15 * (high[1] - low[1]))
  box(cover(floor(chance(index) * 7)), low, high, 0.15 * (high[1] - low[1]))
  -- Pages, seen from above, stand out a little: cheaper than three covers and as telling.
  box("paper", {low[1] + lining, low[2] + lining, high[3] - 0.02 * (high[3] - low[3])},
      {high[1] - lining, high[2] - 3 * lining, high[3] + 0.0015}, 0)
end

function pot(base, radius, height, material)
  local wall = 0.1 * radius
  lathe(material, base, {{0.68 * radius, 0}, {0.72 * radius, 0.02 * height}, {0.95 * radius, 0.82 * height},
      {radius, 0.84 * height}, {radius, height}, {radius - wall, height}, {radius - 1.2 * wall, 0.86 * height},
      {0, 0.86 * height}}, 20)
  cylinder("soil", {base[1] or 0, base[2] or 0, (base[3] or 0) + 0.84 * height}, radius - 1.3 * wall, 0.05 * height,
      0.002, 16)
end

-- Leaves spread over the upper part of an ellipsoid; each hangs outwards.
function foliage(centre, radii, count, size, material)
  centre = vec(centre[1], centre[2], centre[3])
  for i = 0, count - 1 do
    local z = 1 - 1.55 * (i + 0.5) / count
    local turn, flat = 2.39996323 * i + chance(i), sqrt(max(0, 1 - z * z))
    local out = vec(flat * cos(turn) * radii[1], flat * sin(turn) * radii[2], z * radii[3])
    local reach = 0.62 + 0.3 * chance(i + 100)
    local root, tip = centre + out * (reach - 0.35), centre + out * reach + vec(0, 0, -0.25 * size)
    local along = normalized(tip - root)
    local side = normalized(cross(along, abs(along[3]) < 0.95 and vec(0, 0, 1) or vec(1, 0, 0)))
    local up = cross(side, along)
    local length = size * (0.8 + 0.4 * chance(i + 200))
    local tint = i % 4 == 0 and leaf(1) or i % 5 == 0 and leaf(2) or material
    sheet(tint, 2, 3, function(u, v)
      local wide, across = 0.34 * length * sin(pi * (0.12 + 0.86 * v)), 2 * u - 1
      return root + along * (length * v) + side * (wide * across)
          + up * (0.12 * length * across * across + length * 0.3 * v * (1 - v))
    end, 0.004 * min(1, size / 0.1))
  end
end

-- Plan symbols.

function rect(x0, y0, x1, y1)
  return {x0, y0, x1, y1, x0 = x0, y0 = y0, x1 = x1, y1 = y1, width = x1 - x0, height = y1 - y0,
      centre = {(x0 + x1) / 2, (y0 + y1) / 2}}
end
function grown(box, by) return rect(box[1] - by, box[2] - by, box[3] + by, box[4] + by) end

function circle(centre, radius, tone, line) oval(centre, radius, radius, tone, line) end

-- A small wedge on the front edge, pointing out: for pieces whose front cannot be told otherwise.
function front_mark()
  local half = min(0.05, 0.14 * smaller)
  shape({{-half, front - 1.9 * half}, {half, front - 1.9 * half}, {0, front - 0.5 * half}}, "deep", "none")
end

-- Called before each piece, with w, d and h.
function begin()
  rawset(_G, "smaller", min(w, d))
  rawset(_G, "left", -w / 2)
  rawset(_G, "right", w / 2)
  rawset(_G, "back", -d / 2)
  rawset(_G, "front", d / 2)
  rawset(_G, "whole", rect(left, back, right, front))
end
