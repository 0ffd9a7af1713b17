-- SPDX-License-Identifier: GPL-3.0-or-later
-- What stands about.

function mesh.vase()
  local flowers = says("flower", "bouquet") or says("vase") and h > 0.24
  local bowl, tub = says("bowl") or h < 0.6 * smaller, says("jar", "pot", "potion", "bottle")
  if bowl then
    lathe("hard", {}, {{0.2, 0}, {0.22, 0.06 * h}, {0.36, 0.3 * h}, {0.46, 0.66 * h}, {0.5, 0.98 * h}, {0.47, h},
        {0.42, 0.7 * h}, {0.3, 0.4 * h}, {0, 0.28 * h}}, 28, {w, d})
    if says("fruit") then
      for i = 0, 4 do
        ellipsoid(cover(i % 2 == 0 and 3 or 0), {0.2 * w * cos(1.3 * i), 0.2 * d * sin(1.3 * i), 0.7 * h},
            {0.13 * w, 0.13 * w, 0.26 * h}, 12, 8)
      end
    end
    return
  end
  local tall, wide = flowers and 0.55 * h or h, flowers and 0.62 or 1
  local size = vec(wide * w, wide * d)
  -- Several side by side where there is room for them.
  if tub then
    local count = clamp(floor(1.4 * w / d), 1, 6)
    for i = 0, count - 1 do
      local at, size, high = {w * ((i + 0.5) / count - 0.5), 0, 0}, {w / count, d},
          tall * (1 - 0.3 * chance(i) * min(1, i))
      lathe("hard", at, {{0.4, 0}, {0.48, 0.08 * high}, {0.5, 0.4 * high}, {0.44, 0.62 * high}, {0.22, 0.74 * high},
          {0.2, 0.84 * high}, {0.24, 0.86 * high}, {0.24, 0.9 * high}}, 24, size)
      lathe("cork", {at[1], 0, 0.89 * high}, {{0.2, 0}, {0.22, 0.11 * high}}, 16, size)
    end
    return
  end
  lathe("hard", {}, {{0.24, 0}, {0.27, 0.02 * tall}, {0.4, 0.2 * tall}, {0.5, 0.42 * tall}, {0.44, 0.62 * tall},
      {0.26, 0.82 * tall}, {0.22, 0.9 * tall}, {0.32, tall}, {0.28, tall}, {0.18, 0.9 * tall}, {0, 0.86 * tall}}, 28,
      size)
  if not flowers then return end
  for i = 0, 10 do
    local turn, out = 2.39996 * i, 0.46 * sqrt((i + 0.5) / 11)
    local z = h * (0.9 - 0.5 * out + 0.06 * chance(i))
    local tip = vec(out * w * cos(turn), out * d * sin(turn), z)
    local size_of = 0.11 * smaller
    bar(leaf(2), {0, 0, 0.9 * tall}, tip, 0.012 * smaller, 5)
    ellipsoid(cover(i % 3 == 0 and 4 or i % 3 == 1 and 0 or 3), tip, {size_of, size_of, 0.75 * size_of}, 9, 6)
    if i % 2 == 0 then
      ellipsoid(leaf(i), tip * 0.8 + vec(0, 0, 0.1 * h), {0.9 * size_of, 0.5 * size_of, 0.3 * size_of}, 7, 4)
    end
  end
end

function plan.vase()
  local rx, ry = w / 2, d / 2
  oval({0, 0}, rx, ry, "body", "outline")
  for i = 0, 4 do
    local angle = 2 * pi * i / 5 + 0.4
    oval({0.45 * rx * cos(angle), 0.45 * ry * sin(angle)}, 0.32 * rx, 0.32 * ry, i % 2 == 0 and "pale" or "leaf",
        "faint")
  end
end

function mesh.tray()
  local wall, deck, rim = min(0.012, 0.08 * smaller), min(0.25 * h, 0.02), min(h, max(0.05, 0.3 * h))
  slab("hard", rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.04), 0, deck, 0.003)
  for side in each{-1, 1} do
    box("hard", {side * w / 2, -0.46 * d, 0}, {side * (w / 2 - wall), 0.46 * d, rim}, 0.004)
    box("hard", {-0.46 * w, side * d / 2, 0}, {0.46 * w, side * (d / 2 - wall), rim}, 0.004)
  end
  local cup, high = min(0.13 * smaller, 0.05), h > 1.2 * rim and h - deck or min(h - deck, 0.05)
  for at in each{vec(-0.2 * w, 0.12 * d), vec(0.18 * w, -0.14 * d)} do
    lathe("white glaze", {at[1], at[2], deck}, {{0.6 * cup, 0}, {0.9 * cup, 0.3 * high}, {cup, high},
        {0.9 * cup, high}, {0.8 * cup, 0.3 * high}, {0, 0.2 * high}}, 18)
  end
end

function plan.tray()
  area(whole, "body", "outline", 0.12 * smaller)
  area(grown(whole, -0.1 * smaller), "light", "faint", 0.08 * smaller)
  circle({-0.16 * w, 0.02 * d}, 0.16 * smaller, "pale")
  circle({0.2 * w, -0.06 * d}, 0.12 * smaller, "pale")
end

function mesh.books()
  local open, stack = h < 0.03, says("stack", "pile")
  local upright = h > 0.9 * w and not stack and w > 0.1
  if open then
    return book({-w / 2, -d / 2, 0}, {w / 2, d / 2, h}, 0)
  end
  if upright or not stack and w > 1.3 * max(d, h) then
    local count = clamp(floor(w / 0.035), 2, 14)
    local x = -w / 2
    for i = 0, count - 1 do
      local thick, tall = w / count, h * (i == count // 2 and 1 or 0.72 + 0.28 * chance(i))
      book({x, -d / 2, 0}, {x + 0.96 * thick, d * (0.2 + 0.3 * chance(30 + i)), tall}, i)
      x = x + thick
    end
    return
  end
  local count = clamp(floor(h / 0.035), 1, 8)
  for i = 0, count - 1 do
    local thick, turn = h / count, i == 0 and 0 or 0.3 * (chance(i) - 0.5)
    local size = i == 0 and 1 or 0.78 + 0.14 * chance(20 + i)
    inside(turned_z({0, 0, thick * i}, turn), function()
      local x, y, lining = w / 2 * size, d / 2 * size, 0.14 * thick
      box(cover(floor(7 * chance(40 + i))), {-x, -y, 0}, {x, y, lining}, 0.001)
      box(cover(floor(7 * chance(40 + i))), {-x, -y, 0.96 * thick - lining}, {x, y, 0.96 * thick}, 0.001)
      box(cover(floor(7 * chance(40 + i))), {-x, -y, 0}, {-x + lining, y, 0.96 * thick}, 0.001)
      box("paper", {-x + lining, -0.95 * y, lining}, {0.96 * x, 0.95 * y, 0.96 * thick - lining}, 0)
    end)
  end
end

function plan.books()
  area(whole, "light", "outline")
  local upper = grown(whole, -0.1 * smaller)
  area(upper, "body", "detail")
  segment({upper.x0 + 0.1 * upper.width, upper.y0}, {upper.x0 + 0.1 * upper.width, upper.y1})
end

function mesh.candles()
  local branched = says("candelabra", "candelabrum") or h > 0.3 and h > 1.4 * w
  local r = 0.5 * smaller
  local function candle(at, radius, high)
    cylinder("ivory", at, radius, high, 0.15 * radius, 14)
    flame(at + vec(0, 0, high), min(0.035, 0.3 * high) * 1.4, 4)
  end
  if not branched then
    local plate = 0.06 * h
    lathe("metal", {}, {{0.46, 0}, {0.5, plate}, {0.46, plate}, {0.44, 0.5 * plate}}, 24, {w, d})
    local flame = 0.16 * h
    candle(vec(-0.34 * r, -0.2 * r, 0.5 * plate), 0.34 * r, h - flame)
    candle(vec(0.42 * r, -0.1 * r, 0.5 * plate), 0.28 * r, 0.64 * (h - flame))
    candle(vec(0, 0.5 * r, 0.5 * plate), 0.26 * r, 0.45 * (h - flame))
    return
  end
  lathe("metal", {}, {{0.8 * r, 0}, {0.78 * r, 0.03 * h}, {0.2 * r, 0.08 * h}, {0.12 * r, 0.3 * h},
      {0.2 * r, 0.36 * h}, {0.1 * r, 0.62 * h}}, 18)
  for i = 0, 2 do
    local x, z = (i - 1) * (0.5 * w - 0.16 * r), (i == 1 and 0.64 or 0.56) * h
    if i ~= 1 then
      tube("metal", {{0, 0, 0.5 * h}, {0.5 * x, 0, 0.42 * h}, {x, 0, 0.46 * h}, {x, 0, z}}, 0.06 * r, 7)
    end
    lathe("metal", {x, 0, z - 0.02 * h}, {{0.1 * r, 0}, {0.16 * r, 0.03 * h}}, 12)
    candle(vec(x, 0, z), 0.08 * r, 0.24 * h)
  end
end

function plan.candles()
  local r = smaller / 2
  circle({0, 0}, r, "body", "outline")
  for i = 0, 2 do
    local angle = pi / 2 + 2 * pi * i / 3
    local at = vec(0.5 * r * cos(angle), 0.5 * r * sin(angle))
    circle(at, 0.3 * r, "pale")
    circle(at, 0.11 * r, "fire", "none")
  end
end

-- Long blades that bend outwards from one root.
local function fronds(root, reach_x, reach_y, rise, count, width, material)
  for i = 0, count - 1 do
    local turn, out = 2.39996 * i + 0.5 * chance(i), 0.55 + 0.45 * chance(50 + i)
    local high = rise * (0.7 + 0.3 * chance(90 + i)) * (1.15 - 0.4 * out)
    local c, s = cos(turn), sin(turn)
    sheet(i % 3 == 0 and leaf(1) or material, 2, 6, function(u, v)
      local across = (2 * u - 1) * width * sin(pi * min(0.98, 0.14 + 0.86 * v))
      local along, up = out * v * (0.35 + 0.65 * v), high * (1.7 * v - 0.75 * v * v)
      return root + vec(c * along * reach_x - s * across, s * along * reach_y + c * across, up + 0.25 * abs(across))
    end, 0.003 * min(1, smaller / 0.3))
  end
end

function mesh.plant()
  local hanging = says("hanging", "ceiling")
  local r = 0.5 * smaller
  local tub = min(0.34 * h, 1.5 * r)
  local rim = min(0.62 * r, 0.55 * tub)
  local clay = says("woven", "basket") and "rattan" or "hard"
  local frond = leaf(0)
  if hanging then
    local base = 0.3 * h
    pot({0, 0, base}, 0.8 * rim + 0.1 * r, 0.8 * tub, clay)
    for i = 0, 2 do
      local turn = 2 * pi / 3 * i
      bar("soft", {rim * cos(turn), rim * sin(turn), base + 0.7 * tub}, {0, 0, h}, 0.004, 5)
    end
    foliage({0, 0, base + 0.8 * tub}, {r, r, 0.2 * h}, 30, 0.5 * r, frond)
    -- trailing shoots
    for i = 0, 8 do
      local turn = 2.39996 * i
      local c, s, low = cos(turn) * r * 0.9, sin(turn) * r * 0.9, base * chance(i)
      tube(frond, {{0.5 * c, 0.5 * s, base + 0.8 * tub}, {c, s, base + 0.5 * tub}, {c, s, low}}, 0.004, 4)
      for k = 0, 3 do
        ellipsoid(leaf(k), {c * (1 + 0.06 * chance(k + 9 * i)), s, low + 0.24 * k * (base + 0.4 * tub - low)},
            {0.1 * r, 0.1 * r, 0.06 * r}, 6, 4)
      end
    end
    return
  end
  pot({}, rim, tub, clay)
  local top = 0.85 * tub
  local rise = h - top
  if says("cactus") then
    for c in each{vec(0, 0, 0.5), vec(-0.5, 0, 0.55), vec(0.5, 0, 0.45)} do
      local wide = c[1] == 0 and 0.34 * r or 0.17 * r
      ellipsoid(leaf(2), {c[1] * r, 0, top + c[3] * rise}, {wide, wide, (c[1] == 0 and 0.5 or 0.28) * rise}, 14, 10)
      if c[1] ~= 0 then
        bar(leaf(2), {0, 0, top + 0.35 * rise}, {c[1] * r, 0, top + 0.4 * rise}, 0.8 * wide, 10)
      end
    end
  elseif h > 1.1 * smaller and (says("tree", "olive", "fig", "ficus") or h > 1.5) then
    local crown = top + 0.62 * rise
    tube("bark", {{0, 0, top - 0.05 * tub}, {0.05 * r, 0, top + 0.2 * rise}, {-0.04 * r, 0.03 * r, top + 0.4 * rise},
        {0, 0, crown}}, {0.07 * r, 0.05 * r, 0.045 * r, 0.02 * r}, 8)
    foliage({0, 0, crown}, {r, r, 0.38 * rise}, 90, min(0.2, 0.42 * r), frond)
    foliage({0.1 * r, -0.1 * r, crown - 0.06 * rise}, {0.6 * r, 0.6 * r, 0.25 * rise}, 40, min(0.18, 0.4 * r),
        leaf(2))
  elseif says("palm", "fern", "snake", "grass") or chance(3) < 0.35 then
    local upright = says("snake", "grass")
    fronds(vec(0, 0, top), (upright and 0.85 or 1) * r, (upright and 0.85 or 1) * r, rise * (upright and 1 or 0.95),
        upright and 18 or 30, min(0.05, 0.14 * r), frond)
  else
    foliage({0, 0, top + 0.36 * rise}, {r, r, 0.6 * rise}, 64, min(0.26, 0.62 * r), frond)
    tube(leaf(2), {{0, 0, top - 0.04 * tub}, {0, 0, top + 0.6 * rise}}, 0.06 * r, 6)
  end
end

function plan.plant()
  local rx, ry = w / 2, d / 2
  oval({0, 0}, 0.5 * rx, 0.5 * ry, "hard", "outline")
  -- Two whorls of leaves, the upper ones smaller and between the lower.
  for whorl = 0, 1 do
    local reach, half = 1 - 0.36 * whorl, 0.36 - 0.04 * whorl
    for i = 0, 6 do
      local angle, blade = 2 * pi * (i + 0.5 * whorl) / 7, {}
      for step = 0, 10 do
        local t = step <= 5 and step / 5 or 2 - step / 5
        local turn = angle + (step <= 5 and 1 or -1) * half * sin(pi * t ^ 0.8)
        push(blade, {reach * rx * t * cos(turn), reach * ry * t * sin(turn)})
      end
      shape(blade, "leaf", "faint")
      segment({0, 0}, {0.85 * reach * rx * cos(angle), 0.85 * reach * ry * sin(angle)}, "faint")
    end
  end
end
