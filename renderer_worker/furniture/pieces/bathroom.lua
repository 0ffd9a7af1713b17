-- SPDX-License-Identifier: GPL-3.0-or-later
-- Bathrooms and pools.

local function tub_outline(oval, share, inset)
  local x, y = w / 2 * share - inset, d / 2 * share - inset
  return oval and ellipse({}, x, y, 40) or rounded({-x, -y}, {x, y}, 0.35 * min(x, y), 5)
end

-- The skin between two outlines of the same number of points at two heights; outside when `outward`.
local function skin(material, low, z_low, high, z_high, outward)
  local count = #low
  sheet(material, count, 2, function(u, v)
    local i = round(u * count) % count
    local k = outward and i or (count - i) % count
    local s = v * v * (3 - 2 * v)
    return vec(low[k + 1][1] + (high[k + 1][1] - low[k + 1][1]) * s,
        low[k + 1][2] + (high[k + 1][2] - low[k + 1][2]) * s, z_low + (z_high - z_low) * v)
  end, 0.004 * min(1, smaller))
end

-- A tub as nested outlines: outer wall, rim, inner wall, floor. `t` has the width of the rim, the height of the floor
-- inside (deep), shares of the size at the foot and, inside, at the floor (flare), and whether it is oval.
local function make_tub(t, top, material)
  local foot, outer = tub_outline(t.oval, t.foot, 0), tub_outline(t.oval, 0.985, 0)
  local inner, floor = tub_outline(t.oval, 1, t.rim), tub_outline(t.oval, t.flare, t.rim)
  slab(material, foot, 0, 0.04 * top, 0.004)
  skin(material, foot, 0.01 * top, outer, 0.97 * top, true)
  skin(material, floor, t.deep, inner, 0.985 * top, false)
  slab(material, floor, t.deep - 0.02 * top, t.deep, 0)
  -- The rim: a flat ring with a rounded edge.
  local count = #outer
  local edge = tub_outline(t.oval, 1, 0)
  sheet(material, count, 2, function(u, v)
    local k = round(u * count) % count
    return vec(edge[k + 1][1] + (inner[k + 1][1] - edge[k + 1][1]) * v,
        edge[k + 1][2] + (inner[k + 1][2] - edge[k + 1][2]) * v, 0.975 * top)
  end, 0.05 * top)
end

local function mixer(at, size, towards)
  local r = 0.09 * size
  cylinder("brushed steel", at, 1.6 * r, 0.2 * size, 0.002, 12)
  tube("brushed steel", {at, at + vec(0, 0, 0.7 * size), at + towards * (0.4 * size) + vec(0, 0, 0.95 * size),
      at + towards * size + vec(0, 0, 0.75 * size)}, r, 8)
  bar("brushed steel", at + vec(0, 0, 0.65 * size), at + towards * (-0.3 * size) + vec(0, 0, 1.05 * size), 0.6 * r, 8)
end

function mesh.bath()
  local spout = min(0.12, 0.2 * h)
  local top = h - spout
  local oval = says("freestanding", "standing", "oval", "claw", "clawfoot", "roll", "slipper", "soaking", "round")
  local rim = min(0.055, 0.09 * smaller)
  make_tub({ rim = rim, deep = 0.24 * top, foot = oval and 0.8 or 0.97, flare = 0.78, oval = oval }, top, "hard")
  local along_x = w >= d
  local x, y = along_x and w / 2 - 2.2 * rim or 0, along_x and 0 or -d / 2 + 2.2 * rim
  slab("water", tub_outline(oval, 0.93, rim), 0.5 * top, 0.56 * top, 0)
  mixer(vec(along_x and w / 2 - 0.6 * rim or 0, along_x and 0 or -d / 2 + 0.6 * rim, top - 0.03 * top), spout,
      along_x and vec(-1, 0, 0) or vec(0, 1, 0))
  cylinder("brushed steel", {x * 0.8, y * 0.8, 0.235 * top}, 0.03 * min(1, smaller), 0.01, 0.002, 14)
end

function plan.bath()
  area(whole, "pale", "outline", 0.04)
  local rim = min(0.09, 0.12 * smaller)
  local tub = grown(whole, -rim)
  area(tub, "water", "detail", 0.42 * min(tub.width, tub.height))
  area(grown(tub, -0.35 * rim), "none", "faint", 0.4 * min(tub.width, tub.height))
  -- Drain and tap at the left or back end of the longer side.
  local along = w >= d
  local drain = along and vec(tub.x0 + 0.14 * tub.width, 0) or vec(0, tub.y0 + 0.14 * tub.height)
  local spout = along and vec(left + 0.5 * rim, 0) or vec(0, back + 0.5 * rim)
  circle(drain, 0.03, "metal")
  circle(spout, 0.03, "metal")
  segment(spout, along and vec(spout[1] + 1.1 * rim, 0) or vec(0, spout[2] + 1.1 * rim), "outline")
end

function mesh.pool()
  local rim = min(0.25, 0.1 * smaller)
  local oval = says("round", "hot tub", "oval")
  local outer, inner = tub_outline(oval, 1, 0), tub_outline(oval, 1, rim)
  make_tub({ rim = rim, deep = 0.3 * h, foot = 0.99, flare = 0.97, oval = oval }, h, "hard")
  if says("sandpit", "palaestra") then
    slab("sand", tub_outline(oval, 0.985, rim), 0.6 * h, 0.72 * h, 0)
  else
    slab("water", tub_outline(oval, 0.985, rim), 0.72 * h, 0.8 * h, 0)
  end
end

function mesh.shower()
  local tray, glass, post = min(0.06, 0.05 * h), min(0.008, 0.02 * smaller), min(0.014, 0.03 * smaller)
  slab("white glaze", rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.03), 0, tray, 0.008)
  cylinder("brushed steel", {0, 0, tray - 0.002}, 0.06 * smaller, 0.006, 0.002, 16)
  local x, y = w / 2 - post, d / 2 - post
  for at in each{vec(-x, y), vec(x, y), vec(x, -y), vec(-x, -y)} do
    box("metal", {at[1] - post, at[2] - post, tray}, {at[1] + post, at[2] + post, h}, 0.002)
  end
  box("clear glass", {-x, y - glass / 2, tray}, {x, y + glass / 2, h - post}, 0)
  box("clear glass", {x - glass / 2, -y, tray}, {x + glass / 2, y, h - post}, 0)
  for side in each{-1, 1} do
    box("metal", {side * x - post, -y, h - 2 * post}, {side * x + post, y, h}, 0.002)
  end
  box("metal", {-x, y - post, h - 2 * post}, {x, y + post, h}, 0.002)
  bar("metal", {0.02 * w, y + 1.4 * post, 0.45 * h}, {0.02 * w, y + 1.4 * post, 0.55 * h}, 0.7 * post, 8)
  local pipe = vec(0, -d / 2 + 2 * post, 0)
  tube("brushed steel", {pipe + vec(0, 0, 0.45 * h), pipe + vec(0, 0, 0.92 * h), pipe + vec(0, 0.1 * d, 0.96 * h),
      pipe + vec(0, 0.3 * d, 0.95 * h)}, 0.8 * post, 8)
  cylinder("brushed steel", pipe + vec(0, 0.3 * d, 0.925 * h), 0.12 * smaller, 0.012, 0.003, 24)
  box("brushed steel", pipe + vec(-0.1 * w, -post, 0.48 * h), pipe + vec(0.1 * w, post, 0.51 * h), 0.006)
end

function plan.shower()
  area(whole, "pale", "outline", 0.02)
  local tray = grown(whole, -min(0.05, 0.06 * smaller))
  area(tray, "water", "detail", 0.02)
  segment({tray.x0, tray.y0}, {tray.x1, tray.y1}, "faint")
  segment({tray.x1, tray.y0}, {tray.x0, tray.y1}, "faint")
  circle({0, 0}, 0.045, "metal")
  local head = vec(0, tray.y0 + 0.16 * tray.height)
  segment({0, back}, head, "outline")
  circle(head, 0.09, "pale")
  for drop in each{vec(0, 0), vec(0.045, 0), vec(-0.045, 0), vec(0, 0.045), vec(0, -0.045)} do
    circle(head + drop, 0.009, "deep", "none")
  end
end

function mesh.toilet()
  local seat, tank, middle = says("bidet") and 0.8 * h or min(0.42, 0.52 * h), min(0.2, 0.3 * d), 0.12 * d
  local rx, ry = min(0.5 * w, 0.2 + 0.15 * w), d / 2 - middle
  local bowl = {{0.5, 0}, {0.52, 0.1 * seat}, {0.55, 0.35 * seat}, {0.82, 0.75 * seat}, {0.96, 0.9 * seat},
      {0.97, 0.96 * seat}}
  lathe("hard", {0, middle, 0}, bowl, 28, {rx, ry})
  box("hard", {-0.5 * rx, -d / 2 + 0.3 * tank, 0}, {0.5 * rx, middle, 0.9 * seat}, 0.03)
  box("hard", {-0.85 * rx, -d / 2 + 0.6 * tank, 0.8 * seat}, {0.85 * rx, middle, 0.95 * seat}, 0.02)
  local lid = ellipse({0, middle}, rx, ry, 32)
  slab("white glaze", lid, 0.955 * seat, seat, 0.006)
  local lining = ellipse({0, middle}, 0.96 * rx, 0.97 * ry, 32)
  slab("white glaze", lining, seat + 0.002, 1.05 * seat, 0.01)
  if says("bidet") then
    cylinder("brushed steel", {0, -0.3 * d, seat}, 0.02, h - seat, 0.004, 12)
    return
  end
  cushion("hard", {-w / 2, -d / 2, 0.95 * seat}, {w / 2, -d / 2 + tank, h - 0.03 * h}, 0.03)
  box("hard", {-w / 2, -d / 2, h - 0.06 * h}, {w / 2, -d / 2 + 1.06 * tank, h - 0.012 * h}, 0.008)
  cylinder("brushed steel", {0, -d / 2 + tank / 2, h - 0.014 * h}, 0.06 * w, 0.014 * h, 0.002, 16)
end

function plan.toilet()
  local tank = min(0.19, 0.3 * d)
  area({left, back, right, back + tank}, "pale", "outline", 0.03)
  circle({0, back + tank / 2}, 0.028, "body")
  local y0 = back + tank
  local ry, rx = (front - y0) / 2, 0.44 * w
  area({-0.7 * rx, y0 - 0.01, 0.7 * rx, y0 + 0.6 * ry}, "pale", "detail")
  oval({0, y0 + ry}, rx, ry, "pale", "outline")
  oval({0, y0 + 1.04 * ry}, 0.7 * rx, 0.72 * ry, "water", "detail")
end

function mesh.basin()
  local cabinet = says("vanity", "cabinet", "unit") or w > 0.75
  local top = rest
  local spout, thick = h - top, min(0.14, 0.2 * top)
  if cabinet then
    box("hard", {-0.49 * w, -d / 2, 0.12 * top}, {0.49 * w, 0.42 * d, top - 0.6 * thick}, 0.004)
    for side in each{-1, 1} do
      panel("hard", {side < 0 and -0.48 * w or 0.004, 0.14 * top},
          {side < 0 and -0.004 or 0.48 * w, top - 0.66 * thick}, 0.42 * d, 0.018, true)
      handle({side * 0.05 * w, 0.42 * d + 0.018, 0.6 * top}, min(0.14, 0.2 * top), true)
    end
  else
    lathe("white glaze", {0, -0.1 * d, 0}, {{0.3, 0}, {0.26, 0.05 * top}, {0.18, 0.3 * top}, {0.2, 0.7 * top},
        {0.34, top - 0.9 * thick}}, 20, {smaller, smaller})
  end
  -- The slab around a bowl: four sides, then the hollow as a lathe turned inside.
  local x, low, high = 0.36 * w > 0.3 and 0.3 or 0.36 * w, -0.22 * d, 0.4 * d
  local underside = top - 0.45 * thick
  local white = "white glaze"
  box(white, {-w / 2, -d / 2, underside}, {-x, d / 2, top}, 0.008)
  box(white, {x, -d / 2, underside}, {w / 2, d / 2, top}, 0.008)
  box(white, {-x, -d / 2, underside}, {x, low, top}, 0.008)
  box(white, {-x, high, underside}, {x, d / 2, top}, 0.008)
  local cy, ry = (low + high) / 2, (high - low) / 2
  -- seen from above: the inside of the bowl, square at the rim and round below
  sheet(white, 28, 6, function(u, v)
    local turn = 2 * pi * u
    local c, s = cos(turn), sin(turn)
    local square = max(abs(c), abs(s))
    local r = v < 0.99 and v or 1 / (0.55 + 0.45 * square)
    local sx, sy = clamp(r * c * 1.02, -1, 1), clamp(r * s * 1.02, -1, 1)
    return vec(-x * sx, cy + ry * sy, top - 0.004 - 0.85 * thick * (1 - v * v * v))
  end, 0.004)
  mixer(vec(0, -0.36 * d, top - 0.002), spout, vec(0, 1, 0))
end

function plan.basin()
  area(whole, "pale", "outline", 0.06)
  local bowls = w >= 1.15 and 2 or 1
  for i = 0, bowls - 1 do
    local x, y = left + w * (i + 0.5) / bowls, 0.08 * d
    oval({x, y}, min(0.27, 0.38 * w / bowls), 0.33 * d, "water")
    circle({x, y}, 0.02, "deep", "none")
    local spout = vec(x, back + 0.1 * d)
    circle(spout, 0.024, "metal")
    segment(spout, {x, spout[2] + 0.24 * d}, "outline")
  end
end
