-- SPDX-License-Identifier: GPL-3.0-or-later
-- What one makes things with.

function mesh.easel()
  local r, tilt = min(0.02, 0.04 * w), atan(0.5 * d, h)
  for side in each{-1, 1} do
    taper("hard", {side * (w / 2 - r), d / 2 - r, 0}, {r, 0.7 * r}, {side * 0.07 * w, -0.12 * d, 0.97 * h},
        {r, 0.7 * r})
  end
  taper("hard", {0, -d / 2 + r, 0}, {r, r}, {0, -0.16 * d, 0.9 * h}, {r, r})
  inside(turned_x({0, 0.34 * d, 0.28 * h}, tilt), function()
    box("hard", {-0.46 * w, -r, -0.025 * h}, {0.46 * w, 0.12 * d, 0}, 0.004)
    box("hard", {-0.8 * r, -2 * r, -0.1 * h}, {0.8 * r, -r, 0.7 * h}, 0.003)
    local half, high = min(0.42 * w, 0.34 * h), 0.5 * h
    box("paper", {-half, -0.6 * r, 0}, {half, 0.6 * r, high}, 0.004)
    -- A painting begun: a few broad strokes.
    local hues = {style_colour(), rgb(0x6B93A8), rgb(0xD0A35A)}
    for i = 0, 2 do
      local x, z = half * (-0.5 + 0.5 * i), high * (0.35 + 0.2 * chance(i))
      local paint = paint("paint " .. i, hues[i + 1], 0.6)
      inside(facing_front({x, 0.6 * r, z}), function()
        slab(paint, ellipse({}, 0.42 * half, (0.2 + 0.1 * chance(9 + i)) * high, 14), -0.001, 0.002 + 0.0006 * i, 0)
      end)
    end
    box("hard", {-3 * r, -r, high}, {3 * r, r, high + 1.4 * r}, 0.003)
  end)
end

function plan.easel()
  local leg_back, left_foot = vec(0, back), vec(0.8 * left, 0.8 * front)
  local right_foot = vec(0.8 * right, 0.8 * front)
  segment(leg_back, left_foot, "outline")
  segment(leg_back, right_foot, "outline")
  segment(leg_back, {0, 0.4 * front}, "outline")
  -- The canvas leans on it and faces the painter.
  local y = 0.22 * d
  area({left, y, right, y + 0.08 * d}, "pale", "outline")
  area({0.9 * left, y + 0.08 * d, 0.9 * right, front}, "wood", "detail", 0.01)
  local dabs = {"fire", "leaf", "water", "deep"}
  for i = 0, 3 do
    circle({(0.3 * i - 0.45) * w, 0.4 * d}, 0.05 * smaller, dabs[i + 1], "faint")
  end
end

function mesh.sewing_machine()
  local base = 0.16 * h
  cushion("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, base}, 0.3 * base)
  cushion("hard", {0.16 * w, -0.4 * d, 0.8 * base}, {0.48 * w, 0.4 * d, 0.96 * h}, 0.06 * w)
  cushion("hard", {-0.46 * w, -0.34 * d, 0.66 * h}, {0.3 * w, 0.34 * d, 0.96 * h}, 0.06 * w)
  cushion("hard", {-0.46 * w, -0.3 * d, 0.48 * h}, {-0.24 * w, 0.3 * d, 0.8 * h}, 0.04 * w)
  bar("metal", {-0.35 * w, 0, base}, {-0.35 * w, 0, 0.5 * h}, 0.012 * w, 6)
  box("metal", {-0.42 * w, -0.2 * d, base - 0.002}, {-0.26 * w, 0.25 * d, base + 0.006}, 0.001)
  inside(facing_right({0.47 * w, 0, 0.72 * h}), function()
    cylinder("black plastic", {}, 0.17 * h, 0.03 * w, 0.004, 20)
  end)
  for x in each{0.05, 0.14} do
    bar("metal", {x * w, -0.1 * d, 0.94 * h}, {x * w, -0.1 * d, h}, 0.006 * w, 6)
    cylinder("soft", {x * w, -0.1 * d, 0.95 * h}, 0.03 * w, 0.04 * h, 0.002, 12)
  end
  inside(facing_front({0.3 * w, 0.39 * d, 0.56 * h}), function()
    cylinder("black plastic", {}, 0.09 * h, 0.04 * d, 0.003, 16)
  end)
end

function plan.sewing_machine()
  area(whole, "pale", "outline", 0.03)
  area({0.94 * left, -0.2 * d, 0.86 * right, 0.16 * d}, "body", "detail", 0.06)
  area({0.5 * right, -0.34 * d, 0.86 * right, 0.3 * d}, "body", "detail", 0.03)
  oval({right - 0.06 * w, 0}, 0.055 * w, 0.16 * d, "metal")
  circle({-0.34 * w, 0.02 * d}, 0.06 * smaller, "deep")
  circle({0.06 * w, -0.02 * d}, 0.09 * smaller, "fire", "faint")
end

function mesh.mannequin()
  local hip, r = 0.48 * h, min(0.02, 0.06 * smaller)
  for i = 0, 2 do
    local turn = pi / 2 + 2 * pi / 3 * i
    tube("hard", {{0, 0, 0.12 * h}, {0.24 * smaller * cos(turn), 0.24 * smaller * sin(turn), 0.04 * h},
        {0.44 * smaller * cos(turn), 0.44 * smaller * sin(turn), 0}}, 0.8 * r, 8)
  end
  bar("hard", {0, 0, 0.08 * h}, {0, 0, hip}, r, 10)
  -- A torso: hips, waist, bust, shoulders, neck.
  lathe("soft", {}, {{0.34, hip}, {0.44, hip + 0.05 * h}, {0.42, hip + 0.12 * h}, {0.3, hip + 0.21 * h},
      {0.42, hip + 0.32 * h}, {0.47, hip + 0.38 * h}, {0.4, hip + 0.44 * h}, {0.13, hip + 0.47 * h},
      {0.11, 0.97 * h}}, 28, {min(w, 0.42), min(d, 0.28)})
  for side in each{-1, 1} do
    ellipsoid("soft", {side * 0.42 * min(w, 0.42), 0, hip + 0.41 * h},
        {0.1 * min(w, 0.42), 0.2 * min(d, 0.28), 0.05 * h}, 12, 8)
  end
  ellipsoid("hard", {0, 0, 0.98 * h}, {0.03, 0.03, 0.02 * h}, 10, 6)
  -- A tape about its neck.
  hoop("metal", {0, 0, hip + 0.455 * h}, 0.2 * min(d, 0.28), 0.02, 18)
end

function plan.mannequin()
  oval({0, 0}, w / 2, 0.3 * d, "body", "outline")
  oval({0, 0.08 * d}, 0.32 * w, 0.4 * d, "light", "detail")
  circle({0, 0}, 0.13 * smaller, "pale")
  front_mark()
end

function mesh.ironing_board()
  local along_x = w >= d
  local length, width = along_x and w or d, along_x and d or w
  local r = min(0.014, 0.06 * width)
  inside(along_x and {} or quarter_turn(), function()
    local outline = {{-0.5 * length, -0.46 * width}, {0.18 * length, -0.5 * width}, {0.36 * length, -0.4 * width},
        {0.46 * length, -0.22 * width}, {0.5 * length, 0}}
    for i = 0, 3 do
      push(outline, {outline[3 - i + 1][1], -outline[3 - i + 1][2]})
    end
    slab("soft", outline, 0.955 * h, h, 0.01)
    local tray = scaled(outline, 0.97, 0.9)
    slab("metal", tray, 0.94 * h, 0.957 * h, 0.002)
    for side in each{-1, 1} do
      bar("metal", {-side * 0.4 * length, side * 0.12 * width, r},
          {side * 0.26 * length, side * 0.12 * width, 0.94 * h}, r, 8)
      bar("metal", {side * 0.4 * length, -0.42 * width, r}, {side * 0.4 * length, 0.42 * width, r}, r, 8)
    end
    box("metal", {-0.49 * length, -0.2 * width, 0.99 * h}, {-0.38 * length, 0.2 * width, h + 0.002}, 0.002)
  end)
end

function plan.ironing_board()
  local along = w >= d
  area(whole, "light", "outline", 0.45 * smaller)
  area(grown(whole, -0.12 * smaller), "none", "faint", 0.38 * smaller)
  local s = 0.12 * smaller
  local at = along and vec(0.6 * right, 0) or vec(0, 0.6 * front)
  oval(at, along and 1.6 * s or s, along and s or 1.6 * s, "metal")
end

function mesh.loom()
  local post = min(0.05, 0.06 * smaller)
  for sx in each{-1, 1} do
    local x = sx * (w / 2 - post)
    for y in each{-0.44, 0, 0.44} do
      box("hard", {x - post, y * d - post, 0}, {x + post, y * d + post, (y == 0 and 1 or 0.66) * h}, 0.006)
    end
    for z in each{0.1, 0.6} do
      box("hard", {x - 0.7 * post, -d / 2, z * h}, {x + 0.7 * post, d / 2, z * h + 1.6 * post}, 0.006)
    end
  end
  for y in each{-0.44, 0.44} do
    bar("hard", {-w / 2, y * d, 0.6 * h}, {w / 2, y * d, 0.6 * h}, 1.3 * post, 14)
  end
  box("hard", {-w / 2, -post, h - 2 * post}, {w / 2, post, h}, 0.006)
  for z in each{0.5, 0.78} do
    box("hard", {-w / 2 + 2 * post, -0.05 * d, z * h}, {w / 2 - 2 * post, -0.02 * d, z * h + post}, 0.004)
  end
  local z = 0.6 * h + 1.3 * post
  local threads = clamp(floor(w / 0.045), 6, 36)
  for i = 0, threads - 1 do
    local x = (w - 5 * post) * ((i + 0.5) / threads - 0.5)
    bar("pale", {x, -0.44 * d, z}, {x, 0.44 * d, z}, 0.003, 4)
    bar("pale", {x, -0.03 * d, 0.52 * h}, {x, -0.03 * d, 0.78 * h}, 0.002, 4)
  end
  -- what is woven already
  for i = 0, 2 do
    local from = 0.16 + 0.09 * i
    box(i == 1 and "accent" or "soft", {-w / 2 + 2.5 * post, from * d, z - 0.006},
        {w / 2 - 2.5 * post, (from + 0.09) * d, z + 0.006}, 0.002)
  end
  box("hard", {-0.3 * w, 0.36 * d, 0.26 * h}, {0.3 * w, 0.5 * d, 0.3 * h}, 0.006)
end

function mesh.spinning_wheel()
  local r, leg = min(0.38 * h, 0.32 * d), min(0.018, 0.06 * smaller)
  local hub = vec(0, -0.12 * d, h - r)
  inside(facing_right(hub), function()
    ring("hard", {}, {{0.86 * r, -0.08 * w}, {r, -0.08 * w}, {r, 0.08 * w}, {0.86 * r, 0.08 * w}}, 32)
    cylinder("hard", {0, 0, -0.16 * w}, 0.12 * r, 0.32 * w, 0.006, 14)
    for i = 0, 9 do
      local turn = pi / 5 * i
      bar("hard", {}, {0.9 * r * cos(turn), 0.9 * r * sin(turn), 0}, 0.7 * leg, 6)
    end
  end)
  local bench = 0.36 * h
  box("hard", {-0.3 * w, -0.4 * d, bench}, {0.3 * w, 0.5 * d, bench + 0.06 * h}, 0.01)
  for side in each{-1, 1} do
    bar("hard", {side * 0.44 * w, -0.44 * d, 0}, {side * 0.2 * w, -0.3 * d, bench}, 1.2 * leg, 8)
    bar("hard", {side * 0.26 * w, hub[2], bench}, {side * 0.26 * w, hub[2], hub[3] + 0.04 * h}, 1.1 * leg, 8)
  end
  bar("hard", {0, 0.46 * d, 0}, {0, 0.34 * d, bench}, 1.2 * leg, 8)
  bar("hard", {0, 0.38 * d, bench}, {0, 0.38 * d, 0.74 * h}, leg, 8)
  bar("hard", {-0.5 * w, 0.38 * d, 0.66 * h}, {0.5 * w, 0.38 * d, 0.66 * h}, leg, 8)
  ellipsoid("pale", {0, 0.38 * d, 0.78 * h}, {0.2 * w, 0.08 * d, 0.1 * h}, 14, 8)
end

function mesh.telescope()
  local top = vec(0, 0, 0.66 * h)
  local r = min(0.1, 0.16 * smaller)
  for i = 0, 2 do
    local turn = -pi / 2 + 2 * pi / 3 * i
    taper("hard", {0.48 * w * cos(turn), 0.48 * d * sin(turn), 0}, {0.25 * r, 0.25 * r},
        {0.06 * w * cos(turn), 0.06 * d * sin(turn), top[3]}, {0.4 * r, 0.4 * r})
  end
  local along = normalized({0, 0.62 * d, 0.55 * h})
  local half = 0.5 * min(d / along[2], 0.66 * h / along[3])
  ellipsoid("metal", top, {0.6 * r, 0.6 * r, 0.8 * r}, 12, 8)
  local middle = top + vec(0, 0, 1.2 * r)
  tube("metal", {middle - along * (0.9 * half), middle - along * (0.5 * half), middle - along * (0.48 * half),
      middle + along * half}, {0.4 * r, 0.4 * r, 0.75 * r, r}, 20)
  tube("hard", {middle + along * (0.8 * half), middle + along * (1.02 * half)}, 1.12 * r, 20)
end

function plan.telescope()
  for i = 0, 2 do
    local angle = pi / 2 + 2 * pi * i / 3
    segment({0, 0}, {0.48 * w * cos(angle), 0.48 * d * sin(angle)}, "outline")
  end
  local half = 0.1 * smaller
  local pipe = {{-0.7 * half, back}, {0.7 * half, back}, {1.5 * half, front}, {-1.5 * half, front}}
  shape(pipe, "body")
  segment({-half, 0.1 * d}, {half, 0.1 * d})
end

function mesh.globe()
  local r = min(0.42 * smaller, 0.36 * h)
  local z = h - 1.12 * r
  ellipsoid("sea", {0, 0, z}, {r, r, r}, 26, 14)
  -- continents: caps a little larger than the sphere
  for i = 0, 6 do
    local up, turn = 1.6 * chance(i) - 0.8, 2 * pi * chance(20 + i)
    local flat = sqrt(1 - up * up)
    local out = vec(flat * cos(turn), flat * sin(turn), up)
    local side = normalized(cross({0, 0.1, 1}, out))
    local cap = 0.35 + 0.3 * chance(40 + i)
    inside({{0, 0, z}, side, cross(out, side), out}, function()
      local profile = arc({}, 1.012 * r, 1.012 * r, pi / 2 - cap, pi / 2, 4)
      profile[#profile][1] = 0
      lathe("land", {}, profile, 9, {1, 0.6 + 0.6 * chance(60 + i)})
    end)
  end
  inside(turned_y({0, 0, z}, 0.41), function()
    inside({{}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, function()
      hoop("metal", {}, 1.07 * r, 0.05 * r, 36)
    end)
    bar("metal", {0, 0, -1.08 * r}, {0, 0, 1.08 * r}, 0.03 * r, 6)
  end)
  lathe("hard", {}, {{0.9 * r, 0}, {0.88 * r, 0.02 * h}, {0.3 * r, 0.05 * h}, {0.14 * r, 0.14 * h},
      {0.2 * r, 0.4 * (z - r)}, {0.12 * r, 0.9 * (z - 1.1 * r)}, {0.2 * r, z - 1.05 * r}}, 20)
  if h > 0.7 then
    inside({{0, 0, z}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, function()
      ring("hard", {}, {{1.1 * r, -0.03 * r}, {1.19 * r, -0.03 * r}, {1.19 * r, 0.03 * r}, {1.1 * r, 0.03 * r}}, 36)
    end)
  end
end

function plan.globe()
  local r = smaller / 2
  circle({0, 0}, r, "wood", "outline")
  circle({0, 0}, 0.8 * r, "water")
  oval({0, 0}, 0.36 * r, 0.8 * r, "none", "faint")
  segment({-0.8 * r, 0}, {0.8 * r, 0}, "faint")
  oval({-0.25 * r, 0.28 * r}, 0.28 * r, 0.2 * r, "leaf", "faint")
  oval({0.3 * r, -0.25 * r}, 0.2 * r, 0.3 * r, "leaf", "faint")
end
