-- SPDX-License-Identifier: GPL-3.0-or-later
-- Fire and water, carts and small things, and the block that everything else is shown as.

local function fire(at, size, intensity_cd)
  for i = 0, 2 do
    inside(turned_z(at + vec(0, 0, 0.16 * size * (i == 2 and 1 or 0)), i == 2 and 0.3 or 1.2 * i - 0.6), function()
      bar("bark", {-0.6 * size, 0, 0.12 * size}, {0.6 * size, 0, 0.12 * size}, 0.11 * size, 9)
    end)
  end
  flame(at + vec(0, 0, 0.2 * size), 1 * size, intensity_cd)
  for x in each{-0.34, 0.34} do
    lathe("flame", at + vec(x * size, 0.06 * size, 0.2 * size),
        {{0, 0}, {0.14 * size, 0.16 * size}, {0.08 * size, 0.4 * size}, {0, 0.66 * size}}, 8)
  end
end

function mesh.cauldron()
  local leg, body, pot_top = 0.18 * h, 0.62 * h, 0.86 * h
  lathe("hard", {}, {{0, leg}, {0.24, leg + 0.02 * h}, {0.4, leg + 0.14 * h}, {0.47, leg + 0.3 * h},
      {0.45, leg + 0.48 * h}, {0.37, body + 0.12 * h}, {0.4, pot_top}, {0.45, pot_top}, {0.45, pot_top + 0.03 * h},
      {0.37, pot_top + 0.03 * h}, {0.34, 0.76 * h}}, 30, {w, d})
  lathe("brew", {0, 0, 0.78 * h}, {{0.365, 0}, {0.365, 0.03 * h}}, 28, {w, d})
  for i = 0, 5 do
    ellipsoid("brew", {0.24 * w * (chance(i) - 0.5) * 2, 0.24 * d * (chance(9 + i) - 0.5) * 2, 0.81 * h},
        {0.04 * w, 0.04 * d, 0.025 * h}, 10, 6)
  end
  for i = 0, 2 do
    local turn = pi / 2 + 2 * pi / 3 * i
    bar("hard", {0.36 * w * cos(turn), 0.36 * d * sin(turn), 0},
        {0.28 * w * cos(turn), 0.28 * d * sin(turn), 0.3 * h}, 0.03 * smaller, 0.045 * smaller, 8)
  end
  local bail = {}
  for point in each(arc({0, 0.84 * h}, 0.49 * w, 0.15 * h, 0, pi, 12)) do
    push(bail, {point[1], 0, point[2]})
  end
  tube("hard", bail, 0.014 * smaller, 6)
  fire(vec(0, 0, 0), 0.16 * smaller, 25)
  shine({0, 0, 0.98 * h}, 2, 0.05 * smaller, {0.6, 1, 0.35})
end

function plan.cauldron()
  local rx, ry = w / 2, d / 2
  for side in each{-1, 1} do
    oval({0.9 * side * rx, 0}, 0.1 * rx, 0.16 * ry, "dark", "outline")
  end
  oval({0, 0}, 0.92 * rx, ry, "deep", "outline")
  oval({0, 0}, 0.74 * rx, 0.8 * ry, "leaf")
  for at in each{vec(-0.25, 0.2), vec(0.2, 0.3), vec(0.3, -0.2), vec(-0.1, -0.35)} do
    circle({at[1] * rx, at[2] * ry}, (0.07 + 0.06 * abs(at[1] + at[2])) * smaller, "pale", "faint")
  end
end

function mesh.fireplace()
  if says("stove", "burner", "fire pit") then
    local leg = 0.14 * h
    local body, r = min(h, leg + 0.7 * h), 0.5 * smaller
    legs_at("metal", 0.4 * w, 0.36 * d, leg + 0.01, 0.04 * smaller, 0.6)
    box("metal", {-0.47 * w, -0.47 * d, leg}, {0.47 * w, 0.46 * d, body - 0.03 * h}, 0.01)
    box("metal", {-w / 2, -d / 2, body - 0.04 * h}, {w / 2, d / 2, body}, 0.008)
    box("embers", {-0.3 * w, 0.45 * d, leg + 0.14 * h}, {0.3 * w, 0.47 * d, leg + 0.46 * h}, 0.002)
    bar("metal", {0, -0.1 * d, body}, {0, -0.1 * d, h}, 0.24 * r, 16)
    shine({0, 0.6 * d, leg + 0.3 * h}, 40, 0.1 * r, {1, 0.6, 0.28})
    return
  end
  local jamb, lintel, mantel, back = 0.2 * w, 0.72 * h, min(0.07, 0.08 * h), -d / 2 + 0.12 * d
  for side in each{-1, 1} do
    box("hard", {side * 0.48 * w, -d / 2, 0}, {side * (w / 2 - jamb), 0.4 * d, lintel}, 0.01)
  end
  box("hard", {-0.48 * w, -d / 2, lintel - 0.004}, {0.48 * w, 0.4 * d, h - mantel}, 0.01)
  box("hard", {-w / 2, -d / 2, h - mantel}, {w / 2, d / 2, h}, 0.012)
  box("soot", {-w / 2 + 0.9 * jamb, -d / 2, 0}, {w / 2 - 0.9 * jamb, back, lintel}, 0)
  box("hard", {-0.5 * w, -d / 2, 0}, {0.5 * w, d / 2, 0.04 * h}, 0.008)
  local size = min(0.4 * (w - 2 * jamb), 0.5 * d, 0.4 * lintel)
  for x in each{-0.5, 0.5} do
    bar("metal", {x * size, -0.3 * d, 0.09 * h}, {x * size, 0.25 * d, 0.09 * h}, 0.03 * size, 6)
  end
  fire(vec(0, -0.06 * d, 0.1 * h), size, 60)
end

function plan.fireplace()
  area(whole, "body")
  local jamb, y0 = 0.17 * w, back + 0.18 * d
  local opening = {{left + 1.5 * jamb, y0}, {right - 1.5 * jamb, y0}, {right - jamb, front}, {left + jamb, front}}
  shape(opening, "deep", "detail")
  local r = 0.24 * d
  for i = -1, 1 do
    oval({0.13 * i * w, y0 + 1.5 * r}, 0.07 * w, r, "fire", "faint")
  end
  for x in each{left, right} do
    segment({0.8 * x, front}, {x, 0.2 * front}, "faint")
  end
end

function mesh.log_stack()
  local post, r = min(0.02, 0.05 * smaller), min(0.07, 0.16 * h, 0.16 * w)
  for side in each{-1, 1} do
    for y in each{-0.3, 0.3} do
      box("metal", {side * w / 2, y * d - post, 0}, {side * (w / 2 - post), y * d + post, h}, 0.003)
    end
  end
  for y in each{-0.3, 0.3} do
    box("metal", {-w / 2, y * d - post, 0}, {w / 2, y * d + post, post}, 0.003)
  end
  -- Logs in rows, each in the hollow between two of the row below; their cut ends are pale.
  local pitch = 2.04 * r
  local rise = 0.87 * pitch
  local rows = clamp(floor((h - 2 * r - post) / rise) + 1, 1, 9)
  local columns = clamp(floor((w - 2 * post) / pitch), 1, 12)
  for row = 0, rows - 1 do
    for i = 0, columns - row % 2 - 1 do
      local x = pitch * (i - 0.5 * (columns - 1 - row % 2))
      local z, half = post + r + rise * row, d * (0.44 + 0.06 * chance(20 * row + i))
      bar("hard", {x, -0.98 * half, z}, {x, 0.98 * half, z}, r, 9)
      bar("pine", {x, -half, z}, {x, half, z}, 0.86 * r, 9)
    end
  end
end

function mesh.aquarium()
  local stand, glass = h > 0.8 and 0.52 * h or 0.05 * h, min(0.008, 0.03 * smaller)
  local level = h - 0.1 * (h - stand)
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, stand}, 0.006)
  if h > 0.8 then
    for side in each{-1, 1} do
      panel("hard", {side < 0 and -0.48 * w or 0.005, 0.06 * h}, {side < 0 and -0.005 or 0.48 * w, 0.95 * stand},
          d / 2 - 0.01, 0.008)
    end
  end
  local x, y = w / 2 - 2 * glass, d / 2 - 2 * glass
  box("sand", {-x, -y, stand}, {x, y, stand + 0.1 * (h - stand)}, 0.003)
  for i = 0, 8 do
    local at = vec(x * 1.7 * (chance(i) - 0.5), y * 1.5 * (chance(20 + i) - 0.5), stand + 0.08 * (h - stand))
    if i < 6 then
      lathe(leaf(i), at, {{0.03 * smaller, 0}, {0.08 * smaller, 0.25 * (h - stand)},
          {0.04 * smaller, 0.45 * (h - stand)}, {0, 0.6 * (h - stand)}}, 7, {1, 0.4})
    end
    ellipsoid(i % 2 == 0 and "flame" or cover(3),
        {-at[1], -at[2] * 0.8, stand + (0.3 + 0.45 * chance(40 + i)) * (h - stand)},
        {0.05 * smaller, 0.012 * smaller, 0.025 * smaller}, 9, 5)
  end
  box("clear water", {-0.995 * x, -0.99 * y, stand + 0.08 * (h - stand)}, {0.995 * x, 0.99 * y, level}, 0)
  for side in each{-1, 1} do
    box("clear glass", {side * (x + glass), -y, stand}, {side * (x + 2 * glass), y, h - glass}, 0)
    box("clear glass", {-x - glass, side * (y + glass), stand}, {x + glass, side * (y + 2 * glass), h - glass}, 0)
    box("black plastic", {-w / 2, side * d / 2, h - 3 * glass}, {w / 2, side * (d / 2 - 3 * glass), h}, 0.002)
    box("black plastic", {side * w / 2, -d / 2, h - 3 * glass}, {side * (w / 2 - 3 * glass), d / 2, h}, 0.002)
  end
end

function mesh.cart()
  local wheel, r = min(0.04, 0.1 * h), min(0.012, 0.05 * smaller)
  for sx in each{-1, 1} do
    for sy in each{-1, 1} do
      local x, y = sx * (w / 2 - 2 * r), sy * (d / 2 - 2 * r)
      bar("metal", {x, y, 1.6 * wheel}, {x, y, h - r}, r, 8)
      inside(facing_right({x, y, wheel}), function()
        cylinder("rubber", {0, 0, -0.4 * wheel}, wheel, 0.8 * wheel, 0.003, 14)
      end)
    end
    bar("metal", {sx * (w / 2 - 2 * r), -d / 2 + 2 * r, h - r}, {sx * (w / 2 - 2 * r), d / 2 - 2 * r, h - r}, r, 8)
  end
  local levels = h > 0.85 and 3 or 2
  for i = 0, levels - 1 do
    local z, rim = 2 * wheel + (h - 0.14 * h - 2 * wheel) * i / (levels - 1), 0.05 * h
    box("hard", {-w / 2 + r, -d / 2 + r, z}, {w / 2 - r, d / 2 - r, z + 0.02 * h}, 0.004)
    for side in each{-1, 1} do
      bar("metal", {-w / 2 + 2 * r, side * (d / 2 - 2 * r), z + rim},
          {w / 2 - 2 * r, side * (d / 2 - 2 * r), z + rim}, 0.6 * r, 6)
    end
    -- bottles and boxes
    for k = 0, 3 do
      local x, tall, wide = w * (-0.33 + 0.22 * k), 0.24 * h * (0.6 + 0.4 * chance(8 * i + k)), 0.07 * w
      lathe(cover(k + 2 * i), {x, d * (0.3 * chance(60 + 8 * i + k) - 0.15), z + 0.02 * h},
          {{wide, 0}, {wide, 0.6 * tall}, {0.35 * wide, 0.75 * tall}, {0.35 * wide, tall}}, 12)
    end
  end
end

-- pots of pens, trays of small things, what stands on desks
function mesh.organizer()
  if says("knife") then
    taper("hard", {0, 0.06 * d, 0}, {w / 2, 0.44 * d}, {0, -0.06 * d, 0.7 * h}, {w / 2, 0.36 * d})
    for i = 0, 4 do
      local x, y = w * (i % 3 - 1) * 0.3, d * (i < 3 and -0.2 or 0.1)
      box("black plastic", {x - 0.07 * w, y, 0.68 * h}, {x + 0.07 * w, y + 0.08 * d, h * (i < 3 and 1 or 0.88)}, 0.004)
    end
    return
  end
  -- a pot with what is put upright into it
  if h > 1.1 * max(w, d) then
    local tub = 0.55 * h
    lathe("hard", {}, {{0.44, 0}, {0.5, 0.04 * tub}, {0.48, tub}, {0.42, tub}, {0.42, 0.2 * tub}}, 22, {w, d})
    for i = 0, 3 do
      local turn = 1.7 * i + chance(i)
      local x, y = 0.2 * w * cos(turn), 0.2 * d * sin(turn)
      bar(i == 0 and "metal" or cover(i), {0.3 * x, 0.3 * y, 0.2 * tub},
          {x, y, h * (i == 0 and 1 or 0.75 + 0.2 * chance(9 + i))}, min(0.008, 0.06 * smaller), 6)
    end
    return
  end
  local wall, low = min(0.006, 0.06 * smaller), 0.55 * h
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.12 * low}, 0.002)
  for side in each{-1, 1} do
    box("hard", {side * w / 2, -d / 2, 0}, {side * (w / 2 - wall), d / 2, low}, 0.002)
    box("hard", {-w / 2, side * d / 2, 0}, {w / 2, side * (d / 2 - wall), side < 0 and low or 0.7 * low}, 0.002)
  end
  if w > 1.5 * d then
    box("hard", {-wall / 2, -d / 2, 0}, {wall / 2, d / 2, low}, 0.002)
  end
  for i = 0, 5 do
    local x, y = w * (0.7 * chance(i) - 0.35), d * (0.6 * chance(10 + i) - 0.3)
    local lean = 0.08 * w * (chance(20 + i) - 0.5)
    bar(cover(i), {x, y, 0.1 * low}, {x + lean, y, h * (0.8 + 0.2 * chance(30 + i))}, min(0.005, 0.05 * smaller), 6)
  end
end

-- Nothing is known of it but its size: a plain block.
function mesh.box()
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, h}, min(0.008, 0.04 * smaller))
end

function plan.plain_box()
  area(whole, "body", "outline")
  area(grown(whole, -min(0.04, 0.08 * smaller)), "light", "faint")
  front_mark()
end
