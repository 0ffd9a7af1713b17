-- SPDX-License-Identifier: GPL-3.0-or-later
-- Figures and toys.

function mesh.orb()
  local stand = says("ball") and not says("crystal") and 0 or 0.16 * h
  local r = min(0.5 * smaller, 0.5 * (h - stand))
  local crystal = says("crystal", "glass", "orb")
  ellipsoid(crystal and "clear glass" or "hard", {0, 0, h - r}, {r, r, r}, 28, 16)
  if crystal then
    ellipsoid("soft", {0, 0, h - r}, {0.55 * r, 0.55 * r, 0.5 * r}, 18, 10)
  end
  if stand > 0 then
    lathe("metal", {}, {{0.8 * r, 0}, {0.78 * r, 0.25 * stand}, {0.4 * r, 0.6 * stand}, {0.62 * r, 1.3 * stand},
        {0.5 * r, 1.4 * stand}}, 22)
  end
end

function plan.orb()
  local r = smaller / 2
  circle({0, 0}, r, "dark", "outline")
  circle({0, 0}, 0.74 * r, "glass")
  circle({-0.2 * r, 0.24 * r}, 0.2 * r, "pale", "none")
end

function mesh.statue()
  local base, r = 0.12 * h, 0.5 * smaller
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.6 * base}, 0.006)
  box("hard", {-0.42 * w, -0.42 * d, 0.59 * base}, {0.42 * w, 0.42 * d, base}, 0.006)
  local rise = h - base
  if says("obelisk", "column", "pillar") then
    lathe("hard", {0, 0, base}, {{0.8 * r, 0}, {0.76 * r, 0.06 * rise}, {0.62 * r, 0.1 * rise},
        {0.56 * r, 0.88 * rise}, {0.74 * r, 0.94 * rise}, {0.8 * r, rise}}, 20)
    return
  end
  if says("bust") or rise < 1.6 * r then
    lathe("hard", {0, 0, base}, {{0.34, 0}, {0.2, 0.14 * rise}, {0.42, 0.34 * rise}, {0.36, 0.48 * rise},
        {0.13, 0.54 * rise}}, 22, {w, 0.8 * d})
    bar("hard", {0, 0, base + 0.5 * rise}, {0, 0, base + 0.68 * rise}, 0.24 * r, 14)
    ellipsoid("hard", {0, 0.04 * d, base + 0.8 * rise}, {0.36 * r, 0.42 * r, 0.2 * rise}, 20, 14)
    ellipsoid("hard", {0, 0.36 * r + 0.04 * d, base + 0.78 * rise}, {0.07 * r, 0.1 * r, 0.05 * rise}, 8, 6)
    return
  end
  -- A standing figure: robe, shoulders, arms, head.
  lathe("hard", {0, 0, base}, {{0.36, 0}, {0.3, 0.2 * rise}, {0.26, 0.45 * rise}, {0.24, 0.58 * rise},
      {0.34, 0.74 * rise}, {0.28, 0.8 * rise}, {0.08, 0.84 * rise}}, 22, {w, 0.8 * d})
  ellipsoid("hard", {0, 0, base + 0.92 * rise}, {0.2 * r, 0.22 * r, 0.08 * rise}, 16, 10)
  for side in each{-1, 1} do
    tube("hard", {{side * 0.3 * w, 0, base + 0.76 * rise}, {side * 0.42 * w, 0.06 * d, base + 0.58 * rise},
        {side * 0.2 * w, 0.32 * d, base + 0.54 * rise}}, {0.13 * r, 0.11 * r, 0.08 * r}, 10)
  end
end

function plan.statue()
  area(whole, "light", "outline", 0.01)
  area(grown(whole, -0.1 * smaller), "pale", "detail")
  local r = 0.34 * smaller
  oval({0, 0}, r, 0.55 * r, "body")
  oval({0, 0.1 * r}, 0.38 * r, 0.42 * r, "light")
  front_mark()
end

-- a rocking horse when there is room, else a bear
function mesh.toy()
  -- walls open to the front, two floors, a gable roof
  if says("house", "dollhouse") then
    local wall, eaves = min(0.02, 0.04 * w), 0.64 * h
    box("pale", {-0.46 * w, -0.46 * d, 0}, {0.46 * w, -0.46 * d + wall, eaves}, 0)
    for x in each{-0.46, 0, 0.46} do box("pale", {x * w - wall / 2, -0.46 * d, 0}, {x * w + wall / 2, 0.44 * d,
        eaves}, 0) end
    for z in each{0, 0.5, 1} do box("hard", {-0.47 * w, -0.46 * d, z * eaves}, {0.47 * w, 0.46 * d, z * eaves + wall},
        0) end
    inside(facing_front({0, -d / 2, eaves}), function()
      slab("accent", {{-w / 2, 0}, {w / 2, 0}, {0, h - eaves}}, 0, d, 0.004)
    end)
    return
  elseif says("toys", "block", "blocks") then
    for i = 0, 6 do
      local x, y, s = w * (0.32 * (i % 3) - 0.32), d * (0.5 * (i % 2) - 0.25), min(0.14 * w, 0.2 * d)
      if i % 3 == 1 then
        ellipsoid(cover(i), {x, y, s}, {s, s, s}, 14, 8)
      else
        box(cover(i), {x - s, y - s, 0}, {x + s, y + s, i == 0 and h or 2 * s}, 0.004)
      end
    end
    return
  elseif says("horse") then
    lengthwise(function()
      local length, width = d, w
      for side in each{-1, 1} do
        local runner = {}
        for i = 0, 10 do
          local t = -1 + i / 5
          push(runner, {side * 0.44 * width, 0.5 * length * t, 0.03 * h + 0.12 * h * t * t})
        end
        tube("oak", runner, 0.06 * width, 8)
        for y in each{-0.24, 0.22} do
          bar("hard", {side * 0.42 * width, y * length, 0.06 * h}, {side * 0.2 * width, 0.8 * y * length, 0.5 * h},
              0.06 * width, 0.09 * width, 8)
        end
      end
      ellipsoid("hard", {0, 0, 0.52 * h}, {0.3 * width, 0.3 * length, 0.13 * h}, 18, 10)
      bar("hard", {0, 0.2 * length, 0.55 * h}, {0, 0.3 * length, 0.86 * h}, 0.2 * width, 0.14 * width, 12)
      ellipsoid("hard", {0, 0.37 * length, 0.88 * h}, {0.15 * width, 0.13 * length, 0.08 * h}, 14, 8)
      cushion("soft", {-0.28 * width, -0.14 * length, 0.6 * h}, {0.28 * width, 0.1 * length, 0.68 * h}, 0.03 * h,
          0.01)
      bar("accent", {0, 0.2 * length, 0.68 * h}, {0, 0.28 * length, 0.96 * h}, 0.07 * width, 0.04 * width, 6)
      tube("accent", {{0, -0.28 * length, 0.56 * h}, {0, -0.4 * length, 0.5 * h}, {0, -0.42 * length, 0.3 * h}},
          0.06 * width, 6)
    end)
    return
  end
  local fur = "soft"
  ellipsoid(fur, {0, -0.05 * d, 0.32 * h}, {0.34 * w, 0.36 * d, 0.3 * h}, 16, 10)
  ellipsoid(fur, {0, 0, 0.74 * h}, {0.27 * w, 0.28 * d, 0.22 * h}, 16, 10)
  ellipsoid("pale", {0, 0.26 * d, 0.69 * h}, {0.12 * w, 0.1 * d, 0.08 * h}, 10, 6)
  for side in each{-1, 1} do
    ellipsoid(fur, {side * 0.2 * w, 0, 0.93 * h}, {0.1 * w, 0.06 * d, 0.07 * h}, 10, 6)
    ellipsoid(fur, {side * 0.38 * w, 0.06 * d, 0.4 * h}, {0.12 * w, 0.16 * d, 0.14 * h}, 10, 6)
    ellipsoid(fur, {side * 0.26 * w, 0.34 * d, 0.12 * h}, {0.14 * w, 0.16 * d, 0.12 * h}, 10, 6)
    ellipsoid("black plastic", {side * 0.1 * w, 0.25 * d, 0.79 * h}, {0.03 * w, 0.03 * d, 0.03 * h}, 8, 4)
  end
end

function plan.toy()
  area(whole, "light", "outline", 0.04)
  local s = 0.3 * smaller
  area({-1.2 * s, -0.2 * s, -0.2 * s, 0.8 * s}, "fire", "detail")
  circle({0.7 * s, 0.3 * s}, 0.5 * s, "water")
  local wedge = {{-0.5 * s, -1.2 * s}, {0.5 * s, -1.2 * s}, {0, -0.35 * s}}
  shape(wedge, "leaf", "detail")
end

function mesh.tent()
  local poles = 6
  for i = 0, poles - 1 do
    local turn = 2 * pi * (i + 0.5) / poles
    local foot = vec(0.49 * w * cos(turn), 0.49 * d * sin(turn), 0)
    bar("hard", foot, {-0.08 * foot[1], -0.08 * foot[2], h}, 0.012 * min(1, smaller), 8)
  end
  -- Cloth all around but for the entrance at the front.
  sheet("soft", 30, 5, function(u, v)
    local open = 0.42 * (1 - v)
    local turn = pi / 2 + open + (2 * pi - 2 * open) * u
    local flat = 1 / cos(fmod(turn + 2 * pi, 2 * pi / poles) - pi / poles) * cos(pi / poles)
    local r = 0.5 * (1 - 0.9 * v) * flat
    return vec(r * w * cos(turn), r * d * sin(turn), 0.02 * h + 0.86 * h * v)
  end, 0.008)
  cushion("pale", {-0.26 * w, -0.26 * d, 0}, {0.26 * w, 0.2 * d, 0.06 * h}, 0.04)
end

function plan.tent()
  local sides = 6
  local rim = {}
  for i = 0, sides - 1 do
    local angle = pi / 2 + 2 * pi * (i + 0.5) / sides
    rim[i + 1] = vec(0.577 * w * cos(angle) * cos(pi / 6), 0.5 * d * sin(angle) / cos(pi / 6))
    rim[i + 1][1] = clamp(rim[i + 1][1] / cos(pi / 6), left, right)
    rim[i + 1][2] = clamp(rim[i + 1][2], back, front)
  end
  shape(rim, "light")
  for corner in each(rim) do
    segment({0, 0}, corner)
  end
  local door = {{0, 0.1 * d}, {0.16 * w, front}, {-0.16 * w, front}}
  shape(door, "deep", "detail")
end

-- Plates on legs, body, arms and head, the visor a dark slit.
function mesh.armour()
  local r = 0.5 * smaller
  box("walnut", {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.06 * h}, 0.01)
  for side in each{-1, 1} do
    bar("hard", {side * 0.16 * w, 0, 0.08 * h}, {side * 0.13 * w, 0, 0.5 * h}, 0.16 * r, 0.24 * r, 14)
    ellipsoid("hard", {side * 0.16 * w, 0.1 * d, 0.08 * h}, {0.16 * r, 0.36 * r, 0.025 * h}, 12, 6)
    ellipsoid("hard", {side * 0.34 * w, 0, 0.78 * h}, {0.26 * r, 0.28 * r, 0.05 * h}, 16, 8)
    tube("hard", {{side * 0.36 * w, 0, 0.77 * h}, {side * 0.42 * w, 0.06 * d, 0.62 * h}, {side * 0.36 * w, 0.2 * d,
        0.5 * h}},
        {0.18 * r, 0.15 * r, 0.13 * r}, 12)
  end
  lathe("hard", {0, 0, 0.46 * h}, {{0.3, 0}, {0.34, 0.05 * h}, {0.24, 0.13 * h}, {0.34, 0.26 * h}, {0.28, 0.34 * h},
      {0.12, 0.37 * h}}, 24, {w, 0.8 * d})
  lathe("hard", {0, 0, 0.83 * h}, {{0.26 * r, 0}, {0.32 * r, 0.05 * h}, {0.3 * r, 0.12 * h}, {0.1 * r, 0.17 * h}}, 20)
  box("black plastic", {-0.2 * r, 0.2 * r, 0.915 * h}, {0.2 * r, 0.34 * r, 0.925 * h}, 0)
end

-- Coins and bars in a mound.
function mesh.heap()
  lathe("hard", {}, {{0.5, 0}, {0.46, 0.22 * h}, {0.36, 0.52 * h}, {0.2, 0.82 * h}, {0.08, 0.96 * h}, {0, h}}, 28, {w,
      d})
  for i = 0, 60 do
    local turn, v = 2.39996 * i, sqrt((i + 0.5) / 61)
    local at = vec(0.48 * w * v * cos(turn), 0.48 * d * v * sin(turn), h * (1 - v ^ 2.2))
    inside(turned_x(at, chance(i) - 0.5), function()
      cylinder("hard", {0, 0, 0}, 0.03 * smaller, 0.012 * smaller, 0, 12)
    end)
  end
end

function plan.heap()
  oval({0, 0}, w / 2, d / 2, "body", "outline")
  for i = 0, 40 do
    local turn, v = 2.39996 * i, sqrt((i + 0.5) / 41)
    circle({0.45 * w * v * cos(turn), 0.45 * d * v * sin(turn)}, 0.03 * smaller, "light", "faint")
  end
end
