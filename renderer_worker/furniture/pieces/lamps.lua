-- SPDX-License-Identifier: GPL-3.0-or-later
-- What shines.

-- A shining ball, and its light.
local function bulb(at, radius, intensity_cd)
  ellipsoid("bulb", at, {radius, radius, radius}, 12, 6)
  shine(at, intensity_cd, radius)
end

-- Light shines through a shade in the shade's own colour.
local function shade_with_bulb(base, bottom, top, height, intensity_cd)
  local plain, soft = look("lamp shade"), look("soft")
  local name, colour, glow = plain.name, plain.colour, plain.emission
  if is_styled() then
    local tint = vec(glow[1] * soft.colour[1], glow[2] * soft.colour[2], glow[3] * soft.colour[3])
    name, colour, glow = "shining " .. soft.name, blend(soft.colour, colour, 0.5), blend(tint, glow, 0.55)
  end
  base = vec(base[1], base[2], base[3])
  shade(base, bottom, top, height, material{like = "lamp shade", name = name, colour = colour, emission = glow})
  bulb(base + vec(0, 0, 0.45 * height), min(0.035, 0.3 * min(top, height)), intensity_cd)
  -- A diffuser closes it: from above nobody wants to look at wires.
  local cover = material{like = "lamp shade", name = name .. " cover", colour = colour, emission = glow * 0.8}
  cylinder(cover, base + vec(0, 0, 0.95 * height), 0.99 * top, 0.02 * height, 0, 28)
end

function mesh.floor_lamp()
  local r = 0.5 * smaller
  local pole, shade_height = min(0.013, 0.06 * r * 2), min(0.3, 0.22 * h, 1.6 * r)
  if says("arc") and max(w, d) > 0.5 then
    local along_x = w >= d
    local reach, foot = 0.5 * max(w, d), min(0.16, 0.5 * r + 0.05)
    local bell = min(0.2, 0.5 * reach)
    inside(along_x and {} or quarter_turn(), function()
      cylinder("hard", {-reach + foot, 0, 0}, foot, 0.03, 0.006, 28)
      local bow = {{-reach + foot, 0, 0.02}}
      local half, drop = 0.5 * (2 * reach - foot - bell), 0.3 * bell + 0.02
      for point in each(arc({reach - bell - half, 0.55 * h}, half, 0.44 * h, pi, 0.06, 14)) do
        push(bow, {point[1], 0, point[2]})
      end
      tube("hard", bow, pole, 8)
      local tip = bow[#bow] - vec(0, 0, drop)
      ring("hard", tip - vec(0, 0, bell), {{0.95 * bell, 0}, {bell, 0}, {0.75 * bell, 0.6 * bell},
          {0.2 * bell, bell + drop}, {0.16 * bell, bell + drop}, {0.7 * bell, 0.6 * bell}}, 24)
      bulb(tip - vec(0, 0, 0.5 * bell), 0.25 * bell, 70)
    end)
    return
  end
  if says("tripod") then
    for i = 0, 2 do
      local turn = pi / 2 + 2 * pi / 3 * i
      bar("hard", {0.9 * r * cos(turn), 0.9 * r * sin(turn), 0},
          {0.06 * r * cos(turn), 0.06 * r * sin(turn), h - 0.8 * shade_height}, 1.1 * pole, 1.4 * pole, 8)
    end
  else
    lathe("hard", {}, {{0.62 * r, 0}, {0.64 * r, 0.008 * h}, {0.5 * r, 0.016 * h}, {0.12 * r, 0.03 * h},
        {pole, 0.05 * h}}, 28)
    bar("hard", {0, 0, 0.04 * h}, {0, 0, h - 0.5 * shade_height}, pole, 10)
  end
  bar("metal", {0, 0, h - shade_height}, {0, 0, h - 0.06 * shade_height}, 0.8 * pole, 8)
  shade_with_bulb(vec(0, 0, h - shade_height), r, 0.72 * r, shade_height, 70)
end

function mesh.table_lamp()
  local r, shade_height = 0.5 * smaller, 0.48 * h
  if says("lantern", "oil") then
    slab("metal", rounded({-r, -r}, {r, r}, 0.2 * r), 0, 0.08 * h, 0.004)
    taper("metal", {0, 0, 0.7 * h}, {r, r}, {0, 0, 0.88 * h}, {0.3 * r, 0.3 * r})
    for x in each{-0.85, 0.85} do
      for y in each{-0.85, 0.85} do
        bar("metal", {x * r, y * r, 0.06 * h}, {x * r, y * r, 0.72 * h}, 0.06 * r, 6)
      end
    end
    box("clear glass", {-0.8 * r, -0.8 * r, 0.08 * h}, {0.8 * r, 0.8 * r, 0.7 * h}, 0)
    cylinder("ivory", {0, 0, 0.08 * h}, 0.35 * r, 0.24 * h, 0.003, 14)
    flame({0, 0, 0.33 * h}, 0.2 * h, 12)
    inside({{0, 0, 0.88 * h}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, function()
      hoop("metal", {0, 0.05 * h, 0}, 0.06 * h, 0.02 * h, 16)
    end)
    return
  end
  if says("desk", "task", "adjustable", "work", "reading", "industrial") then
    -- Jointed arm: up to the back, then over to the front.
    local foot, y, thick = min(0.36 * smaller, 0.09), 0.5 * d, min(0.008, 0.08 * smaller)
    local bell = min(0.3 * smaller, 0.09)
    local knee, tip = vec(0, -y + thick, 0.62 * h), vec(0, y - bell, 0.92 * h)
    cylinder("hard", {0, -0.1 * d, 0}, max(foot, 0.3 * w), 0.04 * h, 0.006, 26)
    bar("hard", {0, -0.1 * d, 0.03 * h}, knee, thick, 8)
    ellipsoid("metal", knee, {1.8 * thick, 1.8 * thick, 1.8 * thick}, 10, 6)
    bar("hard", knee, tip, thick, 8)
    inside(turned_x(tip, 0.35), function()
      ring("hard", {0, 0, -0.16 * h}, {{0.95 * bell, 0}, {bell, 0}, {0.7 * bell, 0.1 * h}, {0.3 * bell, 0.2 * h},
          {0.26 * bell, 0.2 * h}, {0.64 * bell, 0.1 * h}}, 22)
      cylinder("hard", {0, 0, 0.02 * h}, 0.3 * bell, 0.05 * h, 0.003, 14)
    end)
    bulb(tip + vec(0, 0.03 * d, -0.1 * h), 0.4 * bell, 30)
    return
  end
  local z = h - shade_height
  lathe("hard", {}, {{0.44 * r, 0}, {0.46 * r, 0.03 * h}, {0.2 * r, 0.07 * h}, {0.42 * r, 0.2 * h},
      {0.48 * r, 0.3 * h}, {0.36 * r, 0.42 * h}, {0.12 * r, 0.5 * h}, {0.08 * r, 0.56 * h}}, 26)
  bar("metal", {0, 0, 0.5 * h}, {0, 0, h - 0.04 * h}, 0.06 * r, 8)
  shade_with_bulb(vec(0, 0, z), r, 0.66 * r, shade_height, 40)
end

function mesh.wall_lamp()
  local r = min(0.42 * w, 0.5 * d)
  local y = d / 2 - r
  inside(facing_front({0, -d / 2, 0.34 * h}), function()
    slab("metal", ellipse({}, 0.3 * w, 0.24 * h, 24), 0, 0.1 * d, 0.006)
  end)
  tube("metal", {{0, -d / 2, 0.3 * h}, {0, 0.5 * (y - d / 2), 0.12 * h}, {0, y, 0.08 * h}, {0, y, 0.42 * h}},
      min(0.012, 0.1 * r), 8)
  if says("torch", "candle") then
    lathe("hard", {0, y, 0.02 * h}, {{0.25 * r, 0}, {0.4 * r, 0.4 * h}, {0.7 * r, 0.5 * h}, {0.6 * r, 0.56 * h}}, 14)
    flame({0, y, 0.55 * h}, 0.45 * h, 18)
    return
  end
  shade_with_bulb(vec(0, y, 0.42 * h), r, 0.7 * r, 0.58 * h, 25)
end

function plan.wall_lamp()
  area({0.6 * left, back, 0.6 * right, 0}, "body", "outline")
  oval({0, 0.1 * d}, w / 2, 0.4 * d, "pale", "outline")
end

function mesh.pendant()
  local r = 0.5 * smaller
  local shade_height, rod = min(0.7 * h, 1.2 * r), min(0.006, 0.1 * r)
  -- close to the ceiling
  if h < 0.16 or says("flush") or says("recessed") or h < 0.4 * smaller then
    lathe(is_styled() and "hard" or "white glaze", {0, 0, 0.72 * h}, {{0.46, 0}, {0.5, 0.1 * h}, {0.5, 0.28 * h}}, 30,
        {w, d})
    lathe("lamp shade", {}, {{0, 0}, {0.2, 0.04 * h}, {0.36, 0.2 * h}, {0.44, 0.45 * h}, {0.46, 0.74 * h},
        {0.4, 0.76 * h}}, 28, {w, d})
    shine({0, 0, 0.4 * h}, 90, 0.3 * r)
    return
  end
  lathe("metal", {0, 0, h - 0.05 * h}, {{0.2 * r, 0}, {0.36 * r, 0.03 * h}, {0.36 * r, 0.05 * h}}, 20)
  bar("black plastic", {0, 0, 0.9 * shade_height}, {0, 0, h - 0.04 * h}, rod, 6)
  if says("globe", "glass", "lantern") then
    ellipsoid("lamp shade", {0, 0, shade_height / 2}, {r, r, shade_height / 2}, 24, 14)
    shine({0, 0, shade_height / 2}, 90, 0.8 * r)
    return
  end
  local bell = {{0.96 * r, 0}, {r, 0}, {0.93 * r, 0.3 * shade_height}, {0.6 * r, 0.72 * shade_height},
      {0.2 * r, shade_height}, {0.16 * r, 0.98 * shade_height}, {0.56 * r, 0.7 * shade_height},
      {0.89 * r, 0.3 * shade_height}}
  ring("hard", {}, bell, 28)
  cylinder("metal", {0, 0, 0.94 * shade_height}, 0.2 * r, 0.1 * shade_height, 0.003, 14)
  bulb(vec(0, 0, 0.28 * shade_height), min(0.05, 0.4 * r), 90)
end

function plan.pendant()
  local r = smaller / 2
  oval({0, 0}, w / 2, d / 2, "none", "dashed")
  segment({-0.35 * r, 0}, {0.35 * r, 0})
  segment({0, -0.35 * r}, {0, 0.35 * r})
end

function mesh.chandelier()
  local r = 0.5 * smaller
  local thick = min(0.012, 0.04 * r)
  local arms = r > 0.45 and 8 or 6
  lathe("metal", {0, 0, 0.94 * h}, {{0.06 * r, 0}, {0.2 * r, 0.04 * h}, {0.2 * r, 0.06 * h}}, 20)
  bar("metal", {0, 0, 0.5 * h}, {0, 0, 0.97 * h}, thick, 8)
  lathe("metal", {}, {{0, 0}, {0.06 * r, 0.03 * h}, {0.03 * r, 0.06 * h}, {0.14 * r, 0.14 * h}, {0.12 * r, 0.22 * h},
      {0.05 * r, 0.28 * h}, {0.09 * r, 0.36 * h}, {0.04 * r, 0.46 * h}, {0.03 * r, 0.55 * h}}, 18)
  for i = 0, arms - 1 do
    local turn = 2 * pi * i / arms
    local c, s = cos(turn), sin(turn)
    local function at(out, z)
      return vec(c * out * r, s * out * r, z * h)
    end
    tube("metal", {at(0.05, 0.22), at(0.3, 0.13), at(0.55, 0.12), at(0.78, 0.18), at(0.86, 0.27), at(0.86, 0.32)},
        thick, 7)
    lathe("metal", at(0.86, 0.31), {{0.03 * r, 0}, {0.13 * r, 0.025 * h}, {0.14 * r, 0.035 * h}}, 12)
    cylinder("ivory", at(0.86, 0.34), 0.045 * r, 0.16 * h, 0.002, 10)
    lathe("bulb", at(0.86, 0.5), {{0.02 * r, 0}, {0.05 * r, 0.03 * h}, {0.03 * r, 0.07 * h}, {0, 0.11 * h}}, 8)
    if i % 2 == 0 then
      shine(at(0.86, 0.54), 240 / arms, 0.05 * r)
    end
    tube("metal", {at(0.03, 0.55), at(0.4, 0.36), at(0.7, 0.3), at(0.86, 0.33)}, 0.4 * thick, 5)
  end
end

function plan.chandelier()
  local rx, ry = w / 2, d / 2
  oval({0, 0}, rx, ry, "none", "dashed")
  oval({0, 0}, 0.14 * rx, 0.14 * ry, "none", "faint")
  for i = 0, 3 do
    local x, y = rx * cos(pi / 2 * i), ry * sin(pi / 2 * i)
    segment({0.14 * x, 0.14 * y}, {x, y}, "faint")
  end
end

function plan.lamp()
  local r = smaller / 2
  circle({0, 0}, r, "pale", "outline")
  circle({0, 0}, 0.45 * r, "light", "detail")
  segment({-r, 0}, {r, 0}, "faint")
  segment({0, -r}, {0, r}, "faint")
end
