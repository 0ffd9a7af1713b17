-- SPDX-License-Identifier: GPL-3.0-or-later
-- What things are put into or hung on.

function mesh.trunk()
  local body, strap, y = 0.62 * h, min(0.04, 0.06 * w), d / 2 - 0.015 * d
  box("hard", {-0.49 * w, -y, 0}, {0.49 * w, y, body}, 0.008)
  -- Straps round body and lid, the outer ones a little in from the ends, which they would cover.
  local straps = {-0.47 * w, -0.16 * w - strap / 2, 0.16 * w - strap / 2, 0.47 * w - strap}
  -- A vaulted lid: an arc from front to back, drawn out along x.
  local flat = says("crate", "box")
  local vault = flat and rounded({-y, 0}, {y, 0.37 * h}, 0.02) or arc({0, 0}, y, 0.37 * h, 0, pi, 14)
  inside(facing_right({-0.49 * w, 0, body + 0.008 * h}), function()
    slab("hard", vault, 0, 0.98 * w, 0.006)
    local band = scaled(vault, 1.03, 1.03)
    for x in each(straps) do
      slab("metal", band, x + 0.49 * w, x + 0.49 * w + strap, 0.002)
    end
  end)
  for x in each(straps) do
    box("metal", {x, -d / 2, 0}, {x + strap, d / 2, body}, 0.003)
  end
  box("metal", {-0.06 * w, y, body - 0.1 * h}, {0.06 * w, d / 2, body + 0.09 * h}, 0.004)
end

function plan.trunk()
  area(whole, "body", "outline", 0.02)
  for share in each{0.2, 0.8} do
    local x, half = left + share * w, min(0.025, 0.04 * w)
    area({x - half, back, x + half, front}, "dark", "detail")
  end
  segment({left, back + 0.12 * d}, {right, back + 0.12 * d}, "faint")
  local lock = min(0.05, 0.1 * w)
  area({-lock / 2, front - lock, lock / 2, front}, "deep", "none")
end

function mesh.barrel()
  local profile = {}
  for i = 0, 10 do
    local t = i / 10
    push(profile, {0.4 + 0.1 * sin(pi * t), h * t})
  end
  push(profile, {0.36, h})
  push(profile, {0.36, 0.965 * h})
  lathe("hard", {}, profile, 24, {w, d})
  for t in each{0.08, 0.28, 0.72, 0.92} do
    local low, high = t - 0.025, t + 0.025
    local function r(at)
      return 0.4 + 0.1 * sin(pi * at)
    end
    ring("metal", {}, {{r(low) - 0.02, low * h}, {r(low) + 0.008, low * h}, {r(high) + 0.008, high * h},
        {r(high) - 0.02, high * h}}, 24, {w, d})
  end
end

function plan.barrel()
  oval({0, 0}, w / 2, d / 2, "dark", "outline")
  oval({0, 0}, 0.42 * w, 0.42 * d, "light", "detail")
  for i = -2, 2 do
    local x = 0.15 * i * w
    local y = 0.42 * d * sqrt(1 - 0.15 * i / 0.42 * (0.15 * i / 0.42))
    segment({x, -y}, {x, y}, "faint")
  end
  circle({0.1 * w, 0.18 * d}, 0.05 * smaller, "deep")
end

function mesh.basket()
  local bin = says("bin", "trash", "bucket")
  local stretch = vec(w, d)
  lathe("hard", {}, {{0.38, 0}, {0.42, 0.04 * h}, {0.49, 0.93 * h}, {0.49, 0.97 * h}, {0.455, 0.97 * h},
      {0.4, 0.12 * h}, {0, 0.12 * h}}, 26, stretch)
  if bin then
    ring("metal", {}, {{0.45, 0.95 * h}, {0.5, 0.95 * h}, {0.5, h}, {0.45, h}}, 26, stretch)
    return
  end
  -- rows of the weave
  for i = 0, 8 do
    local t = (i + 0.5) / 9.5
    local r = 0.42 + 0.075 * t
    ring("hard", {0, 0, t * h}, {{r - 0.01, -0.03 * h}, {r + 0.008, 0}, {r - 0.01, 0.03 * h}, {r - 0.02, 0}}, 22,
        stretch)
  end
  ellipsoid("pale", {0, 0, 0.78 * h}, {0.4 * w, 0.4 * d, 0.18 * h}, 16, 8)
  for side in each{-1, 1} do
    local loop = {}
    for i = 0, 8 do
      local turn = pi * i / 8
      push(loop, {side * 0.475 * w, 0.14 * d * cos(turn), 0.9 * h + 0.1 * h * sin(turn)})
    end
    tube("hard", loop, 0.02 * smaller, 6)
  end
end

function plan.basket()
  area(whole, "body", "outline", 0.3 * smaller)
  area(grown(whole, -0.12 * smaller), "light", "detail", 0.24 * smaller)
  for i = 0, 15 do
    local angle = 2 * pi * i / 16
    local c, s = cos(angle), sin(angle)
    segment({0.38 * w * c, 0.38 * d * s}, {0.46 * w * c, 0.46 * d * s}, "faint")
  end
end

function mesh.coat_stand()
  local r, foot = min(0.022, 0.06 * smaller), 0.5 * smaller
  bar("hard", {0, 0, 0.03 * h}, {0, 0, 0.97 * h}, 1.2 * r, 0.9 * r, 12)
  ellipsoid("hard", {0, 0, 0.98 * h}, {1.5 * r, 1.5 * r, 0.02 * h}, 12, 6)
  for i = 0, 3 do
    local turn = pi / 4 + pi / 2 * i
    local x, y = cos(turn), sin(turn)
    tube("hard", {{0, 0, 0.14 * h}, {0.6 * foot * x, 0.6 * foot * y, 0.05 * h},
        {foot * x * 1.35, foot * y * 1.35, 0}}, r, 8)
    for z in each{0.72, 0.9} do
      local up = turn + (z > 0.8 and pi / 4 or 0)
      local cx, cy = cos(up), sin(up)
      tube("hard", {{0, 0, z * h}, {0.5 * foot * cx, 0.5 * foot * cy, z * h},
          {0.8 * foot * cx, 0.8 * foot * cy, (z + 0.06) * h}}, 0.8 * r, 8)
    end
  end
  -- A coat and a hat, so that it is seen for what it is.
  sheet("soft", 14, 6, function(u, v)
    local turn = 2 * pi * u
    local wide = foot * (0.14 + 0.34 * v) * (1 + 0.1 * sin(5 * turn))
    return vec(0.4 * foot + wide * cos(turn), 0.4 * foot + 0.8 * wide * sin(turn), h * (0.74 - 0.42 * v))
  end, 0.008)
  lathe("accent", {-0.6 * foot, -0.45 * foot, 0.93 * h},
      {{0.36 * foot, 0}, {0.2 * foot, 0.012 * h}, {0.18 * foot, 0.05 * h}, {0.1 * foot, 0.065 * h}, {0, 0.066 * h}},
      16)
end

function mesh.garment_rack()
  local r, rail = min(0.014, 0.06 * smaller), 0.97 * h
  local towels = says("towel", "drying") or h < 1.2
  for side in each{-1, 1} do
    local x = side * (w / 2 - 2 * r)
    bar("metal", {x, 0, r}, {x, 0, h - r}, r, 10)
    bar("metal", {x, -d / 2, r}, {x, d / 2, r}, r, 10)
  end
  bar("metal", {-w / 2, 0, rail - r}, {w / 2, 0, rail - r}, r, 10)
  bar("metal", {-w / 2 + 2 * r, 0, 0.16 * h}, {w / 2 - 2 * r, 0, 0.16 * h}, 0.8 * r, 10)
  local count = towels and 2 or clamp(floor(w / 0.1), 3, 14)
  local pitch = (w - 8 * r) / count
  for i = 0, count - 1 do
    local x = -w / 2 + 4 * r + pitch * (i + 0.5)
    local length = towels and 0.5 or 0.42 + 0.2 * chance(i)
    local thick = towels and 0.42 * pitch or 0.34 * pitch
    local cloth = i % 3 == 0 and "soft" or i % 3 == 1 and "accent" or "pale"
    local half = towels and 3 * r or 0.46 * d
    -- shoulders that slope, on a hanger
    if not towels then
      taper(cloth, {x, 0, rail * (1 - length)}, {thick, half}, {x, 0, 0.9 * rail}, {0.7 * thick, 0.8 * half})
      taper(cloth, {x, 0, 0.9 * rail}, {0.7 * thick, 0.8 * half}, {x, 0, 0.955 * rail}, {0.3 * thick, 0.16 * half})
      bar("metal", {x, 0, 0.95 * rail}, {x, 0, rail}, 0.3 * r, 6)
    else
      cushion(cloth, {x - thick, -half, rail * (1 - length)}, {x + thick, half, rail + 1.2 * r}, 0.8 * half)
    end
  end
end

-- hooks or rails on a wall
function mesh.rack()
  -- bars with towels over them; a bar to hold on to
  if says("rail", "ring") then
    local bars = says("grab") and 1 or clamp(floor(h / 0.25), 1, 4)
    for side in each{-1, 1} do
      box("metal", {side * w / 2, -d / 2, 0}, {side * (w / 2 - 0.03 * w), 0.2 * d, h}, 0.004)
    end
    for i = 0, bars - 1 do
      local z, y = h * (i + 0.8) / bars, 0.2 * d
      bar("metal", {-w / 2, y, z}, {w / 2, y, z}, min(0.016, 0.2 * d), 10)
      if not says("grab") and i % 2 == (bars - 1) % 2 then
        cushion(i > 1 and "accent" or "soft", {-0.36 * w, -0.1 * d, z - 0.62 * h / bars}, {0.3 * w, d / 2, z + 0.02},
            0.02)
      end
    end
    return
  end
  local board = min(0.02, 0.3 * d)
  box("hard", {-w / 2, -d / 2, 0.3 * h}, {w / 2, -d / 2 + board, h}, 0.005)
  local count = clamp(floor(w / 0.16), 2, 10)
  for i = 0, count - 1 do
    local x, r = w * ((i + 0.5) / count - 0.5), min(0.008, 0.08 * d)
    tube("metal", {{x, -d / 2 + board, 0.55 * h}, {x, 0.1 * d, 0.3 * h}, {x, 0.4 * d, r}, {x, 0.5 * d - r, 0.5 * h}},
        r, 8)
  end
end

function plan.rack()
  area(whole, "pale", "detail", 0.02)
  segment({left, 0}, {right, 0}, "outline")
  local hooks = clamp(floor(w / 0.12), 2, 20)
  for i = 0, hooks - 1 do
    local x = left + w * (i + 0.5) / hooks
    segment({x, -0.3 * d}, {x, 0.3 * d})
    circle({x, 0.3 * d}, min(0.015, 0.08 * d), "deep", "none")
  end
end

function mesh.ladder()
  local rail = min(0.025, 0.08 * w)
  local lean = 0.5 * d - rail
  for side in each{-1, 1} do
    local x = side * (w / 2 - rail)
    taper("hard", {x * 1, lean, 0}, {rail, rail}, {0.86 * x, -lean, h}, {rail, rail})
  end
  local rungs = clamp(floor(h / 0.3), 2, 14)
  for i = 1, rungs - 1 do
    local t = i / rungs
    local y, x = lean * (1 - 2 * t), (w / 2 - rail) * (1 - 0.14 * t)
    box("hard", {-x, y - 0.7 * rail, t * h - 0.4 * rail}, {x, y + 0.7 * rail, t * h + 0.4 * rail}, 0.004)
  end
  cushion("soft", {-0.3 * w, lean * 0.2 - 2 * rail, 0.2 * h}, {0.3 * w, lean * 0.2 + 3 * rail, 0.42 * h}, rail)
end

function mesh.folding_screen()
  local panels = clamp(round(w / 0.5), 2, 6)
  local pitch, thick = w / panels, min(0.03, 0.3 * d)
  local rise, rail = d - thick, min(0.05, 0.12 * pitch)
  local length, turn = sqrt(pitch * pitch + rise * rise), atan(rise, pitch)
  for i = 0, panels - 1 do
    local up = i % 2 == 0
    local from = vec(-w / 2 + pitch * i, up and -rise / 2 or rise / 2, 0)
    inside(turned_z(from, up and turn or -turn), function()
      local half, low = thick / 2, 0.03 * h
      for x in each{0.01 * length, 0.99 * length - rail} do
        box("hard", {x, -half, 0}, {x + rail, half, h}, 0.004)
      end
      for z in each{low, 0.62 * h, h - rail} do
        box("hard", {rail, -half, z}, {length - rail, half, z + rail}, 0.004)
      end
      box("pale", {rail, -0.3 * half, low}, {length - rail, 0.3 * half, h - 0.5 * rail}, 0)
    end)
  end
end
