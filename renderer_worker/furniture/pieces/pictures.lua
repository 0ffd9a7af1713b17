-- SPDX-License-Identifier: GPL-3.0-or-later
-- What is in frames.

-- Motifs in half sizes x and z, of flush slabs one over the other: each calls put(colour, outline).
local sienna, ochre, navy, forest = 0xB5573A, 0xD9A441, 0x2F4A5E, 0x4F6B4A

local function hills(put, x, z, pale, deep)
  put(rgb(ochre), ellipse({-0.4 * x, 0.42 * z}, 0.18 * min(x, z), 0.18 * min(x, z), 20))
  for layer = 0, 2 do
    local ridge = {{-x, -z}, {x, -z}}
    for i = 0, 10 do
      local t = 1 - 0.2 * i
      push(ridge, {x * t, z * (0.16 - 0.34 * layer + 0.16 * sin(2.2 * t * (1 + layer) + 6 * chance(layer)))})
    end
    put(blend(pale, deep, 0.33 * (layer + 1)), ridge)
  end
end

local function forms(put, x, z, pale, deep)
  for i = 0, 3 do
    local at, r = {x * (chance(i) - 0.5), z * (chance(10 + i) - 0.5)}, min(x, z) * (0.28 + 0.2 * chance(20 + i))
    put(({deep, rgb(ochre), pale * 0.8, rgb(navy)})[i + 1], i % 2 == 0 and ellipse(at, r, r, 24)
        or rounded({at[1] - r, at[2] - 0.6 * r}, {at[1] + r, at[2] + 0.6 * r}, 0.01, 1))
  end
end

local function block(x0, z0, x1, z1) return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}} end

local function sea(put, x, z, pale, deep)
  put(rgb(navy), block(-x, -z, x, -0.1 * z))
  put(blend(rgb(navy), pale, 0.3), block(-x, -0.42 * z, x, -0.1 * z))
  put(deep, {{-0.3 * x, -0.3 * z}, {0.24 * x, -0.3 * z}, {0.32 * x, -0.16 * z}, {-0.4 * x, -0.16 * z}})
  put(vec(0.8, 0.78, 0.72), {{-0.02 * x, -0.12 * z}, {0.26 * x, -0.12 * z}, {-0.02 * x, 0.62 * z}})
  put(rgb(sienna), {{-0.3 * x, -0.12 * z}, {-0.06 * x, -0.12 * z}, {-0.06 * x, 0.44 * z}})
end

local function skyline(put, x, z, pale, deep)
  for row = 0, 1 do
    for i = 0, 8 do
      local low, wide = x * (-1 + i * 2 / 9), x * 2 / 9
      put(blend(pale, deep, 0.35 + 0.5 * row), block(low, -z, min(x, low + wide),
          z * (0.55 - 0.65 * row + 0.4 * (chance(i + 20 * row) - 0.5))))
    end
  end
end

local function birches(put, x, z, pale, deep)
  put(rgb(forest), block(-x, -z, x, -0.55 * z))
  for i = 0, 6 do
    local at, half = x * (-0.85 + 0.28 * i + 0.1 * chance(i)), 0.035 * x * (1 + chance(10 + i))
    put(vec(0.78, 0.76, 0.7), block(at - half, z * (-0.75 + 0.3 * chance(20 + i)), at + half, z))
    for k = 0, 2 do
      put(deep, block(at - half, z * (0.7 * chance(30 + 3 * i + k) - 0.3), at,
          z * (0.7 * chance(30 + 3 * i + k) - 0.26)))
    end
  end
end

local function leaf_study(put, x, z, pale, deep)
  put(rgb(forest), block(-0.015 * x, -0.85 * z, 0.015 * x, 0.8 * z))
  for i = 0, 8 do
    local side, at, long = i % 2 * 2 - 1, z * (-0.6 + 0.16 * i), min(0.62 * x, 0.5 * z) * (1 - 0.06 * i)
    put(i % 3 == 0 and blend(rgb(forest), pale, 0.35) or rgb(forest), side > 0 and {{0, at}, {0.5 * long,
        at - 0.02 * z},
        {long, at + 0.4 * long}, {0.4 * long, at + 0.4 * long}} or {{0, at}, {-0.4 * long, at + 0.4 * long},
        {-long, at + 0.4 * long}, {-0.5 * long, at - 0.02 * z}})
  end
end

local function fields(put, x, z, pale, deep)
  local hues = {rgb(sienna), rgb(ochre), deep, rgb(navy), rgb(forest)}
  local first, split = floor(5 * chance(4)), z * (0.5 * chance(5) - 0.25)
  put(hues[first + 1], rounded({-0.84 * x, split + 0.04 * z}, {0.84 * x, 0.86 * z}, 0.04 * x))
  put(hues[(first + 2) % 5 + 1], rounded({-0.84 * x, -0.86 * z}, {0.84 * x, split - 0.04 * z}, 0.04 * x))
end

local function target(put, x, z, pale, deep)
  local r = 0.84 * min(x, z)
  for i, colour in ipairs{deep, rgb(ochre), pale, rgb(sienna), rgb(navy)} do
    put(colour, ellipse({}, r * (1.1 - 0.2 * i), r * (1.1 - 0.2 * i), 36))
  end
end

local function mosaic(put, x, z, pale, deep)
  local columns = clamp(floor(5 * x / z), 3, 9)
  for i = 0, columns - 1 do
    for k = 0, 4 do
      local hue = ({rgb(sienna), rgb(ochre), rgb(navy), deep, pale, rgb(forest)})[floor(6 * chance(7 * i + k)) + 1]
      put(hue, block(x * (-1 + 2 * i / columns), z * (-1 + 0.4 * k), x * (-1 + 2 * (i + 0.94) / columns),
          z * (-0.63 + 0.4 * k)))
    end
  end
end

local function sitter(put, x, z, pale, deep)
  local r = min(0.3 * x, 0.26 * z)
  put(deep, arc({0, -z}, min(0.8 * x, 2.4 * r), 0.95 * z, 0, pi, 20))
  put(rgb(0x3A2A22), ellipse({0, 0.34 * z}, 1.1 * r, 1.25 * r, 24))
  put(rgb(0xD9B08C), ellipse({0, 0.26 * z}, 0.82 * r, 1.05 * r, 24))
end

local function still_life(put, x, z, pale, deep)
  put(blend(deep, pale, 0.3), block(-x, -z, x, -0.3 * z))
  put(rgb(navy), {{-0.45 * x, -0.5 * z}, {-0.15 * x, -0.5 * z}, {-0.05 * x, 0}, {-0.22 * x, 0.4 * z}, {-0.38 * x,
      0.4 * z},
      {-0.55 * x, 0}})
  for i = 0, 3 do
    local r = min(0.16 * x, 0.2 * z)
    put(rgb(i % 2 == 0 and sienna or ochre), ellipse({(0.1 + 0.2 * i) * x, (-0.5 + 0.12 * (i % 2)) * z}, r, r, 20))
  end
end

local function night(put, x, z, pale, deep)
  put(rgb(0x1E2A3A), block(-x, -z, x, z))
  put(rgb(0xEDE6CF), ellipse({0.4 * x, 0.46 * z}, 0.2 * min(x, z), 0.2 * min(x, z), 24))
  for i = 0, 11 do
    local at, r = {x * (1.8 * chance(i) - 0.9), z * (chance(20 + i) - 0.1)}, 0.012 * min(x, z) * (1 + chance(40 + i))
    put(rgb(0xEDE6CF), ellipse(at, r, r, 6))
  end
  for i = 0, 3 do put(blend(rgb(0x1E2A3A), deep, 0.25 * i), {{x * (-1 + 0.4 * i), -z}, {min(x, x * (0.1 + 0.4 * i)),
      -z},
      {x * (-0.5 + 0.4 * i), z * (0.1 - 0.2 * chance(i))}}) end
end

local function waves(put, x, z, pale, deep)
  for i = 0, 5 do
    local band = {}
    for t = 0, 12 do push(band, {x * (1 - t / 6), z * (0.8 - 0.3 * i + 0.1 * sin(0.9 * t + 2 * chance(i)))}) end
    push(band, {-x, -z})
    push(band, {x, -z})
    put(({rgb(ochre), rgb(sienna), deep, rgb(navy), blend(deep, pale, 0.5), rgb(forest)})[i + 1], band)
  end
end

local function land(put, x, z, pale, deep)
  put(rgb(0x9DBBC4), block(-x, -z, x, z))
  for i = 0, 6 do
    local at, coast = {x * (1.5 * chance(i) - 0.75), z * (1.3 * chance(10 + i) - 0.65)}, {}
    for k = 0, 13 do
      local turn, r = 2 * pi * k / 14, 0.34 * (0.7 + 0.6 * chance(14 * i + k))
      push(coast, {clamp(at[1] + r * x * cos(turn), -x, x), clamp(at[2] + r * z * sin(turn), -z, z)})
    end
    put(rgb(i % 2 == 0 and 0xC9B37E or 0xA9AE7A), coast)
  end
end

local motifs = {hills, forms, sea, skyline, birches, leaf_study, fields, target, sitter, still_life, night, waves,
    mosaic}

local function paint_motif(x, z, y)
  local base = style_colour()
  local motif = says("star", "night", "moon") and night or says("map") and land or says("mosaic", "collage") and mosaic
      or says("portrait") and sitter or says("landscape", "mountain") and hills or says("abstract", "modern") and forms
      or says("botanical", "floral") and leaf_study or says("seascape", "ship", "sea") and sea
      or motifs[floor(#motifs * chance(1)) + 1]
  local layer, paints = 0, {}
  local function painted(colour)
    for used in each(paints) do if dot(used[1] - colour, used[1] - colour) < 1e-6 then return used[2] end end
    push(paints, {colour, paint("figure " .. #paints + 1, colour)})
    return paints[#paints][2]
  end
  inside(facing_front(vec(0, y, h / 2)), function()
    motif(function(colour, outline)
      layer = layer + 1
      slab(painted(colour), outline, 0, 0.0005 * layer, 0)
    end, x, z, blend(base, {0.8, 0.78, 0.72}, 0.7), base * 0.45)
  end)
end

function mesh.picture()
  local rail = min(0.045, 0.08 * min(w, h))
  if says("tapestry") then
    bar("hard", {-w / 2, 0, 0.97 * h}, {w / 2, 0, 0.97 * h}, min(0.02, 0.4 * d), 10)
    box("soft", {-0.46 * w, -0.2 * d, 0.06 * h}, {0.46 * w, 0.1 * d, 0.98 * h}, 0.002)
    for z in each{0.16, 0.44, 0.72} do
      box(z == 0.44 and "pale" or "accent", {-0.44 * w, 0.05 * d, z * h}, {0.44 * w, 0.2 * d, (z + 0.12) * h}, 0)
    end
    for i = 0, 15 do
      local x = w * (-0.45 + 0.06 * i)
      box("pale", {x - 0.01 * w, -0.1 * d, 0}, {x + 0.01 * w, 0.05 * d, 0.07 * h}, 0)
    end
    return
  end
  -- between two rods
  if says("scroll") then
    for z in each{0.015, 0.985} do bar("hard", {-w / 2, 0, z * h}, {w / 2, 0, z * h}, 0.015 * h, 10) end
    box("paper", {-0.44 * w, -0.1 * d, 0.02 * h}, {0.44 * w, 0, 0.98 * h}, 0)
    return paint_motif(0.38 * w, 0.4 * h, 0)
  end
  frame_rails(says("gold", "ornate") and "metal" or "hard", rail)
  box(says("canvas") and "pale" or "paper", {-w / 2 + 0.8 * rail, -d / 2, 0.8 * rail},
      {w / 2 - 0.8 * rail, 0.1 * d, h - 0.8 * rail}, 0)
  local mount = says("canvas") and 1 or 1.9
  local x, z = w / 2 - mount * rail, h / 2 - mount * rail
  if min(x, z) < 0.004 then return end
  box(paint("sky", blend(style_colour(), {0.72, 0.76, 0.78}, 0.75)), {-x, 0, h / 2 - z}, {x, 0.12 * d, h / 2 + z}, 0)
  paint_motif(x, z, 0.12 * d)
end

function plan.picture()
  area(whole, "body", "outline")
  segment({0.94 * left, 0.4 * front}, {0.94 * right, 0.4 * front}, "faint")
end
