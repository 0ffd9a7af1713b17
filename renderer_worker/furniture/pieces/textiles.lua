-- SPDX-License-Identifier: GPL-3.0-or-later
-- Rugs, mats, cushions, curtains.

-- A frame of cloth between two rectangles, `wide` broad and flush with its ground.
local function border(material, inset, wide, bottom, top)
  local x, y = w / 2 - inset, d / 2 - inset
  for side in each{-1, 1} do
    box(material, {-x, side * y, bottom}, {x, side * (y - wide), top}, 0)
    box(material, {side * x, -y + wide, bottom}, {side * (x - wide), y - wide, top}, 0)
  end
end

function mesh.rug()
  local fringe, thick = min(0.05, 0.04 * max(w, d)), h
  local along_x, plain = w >= d, says("plain", "fur", "sheepskin")
  local x, y = w / 2 - (along_x and fringe or 0), d / 2 - (along_x and 0 or fringe)
  slab("soft", rounded({-x, -y}, {x, y}, 0.01), 0, 0.86 * thick, min(0.004, 0.3 * thick))
  local threads = clamp(floor((along_x and d or w) / 0.03), 6, 60)
  for i = 0, threads - 1 do
    local t, half = (i + 0.5) / threads - 0.5, 0.3 * (along_x and d or w) / threads
    for side in each{-1, 1} do
      if along_x then
        box("pale", {side * x, t * d - half, 0}, {side * w / 2, t * d + half, 0.4 * thick}, 0)
      end
      if not along_x then
        box("pale", {t * w - half, side * y, 0}, {t * w + half, side * d / 2, 0.4 * thick}, 0)
      end
    end
  end
  local step = 0.045 * min(x, y) * 2
  if plain then
    slab("soft", rounded({-0.97 * x, -0.97 * y}, {0.97 * x, 0.97 * y}, 0.03), 0.5 * thick, thick,
        min(0.01, 0.3 * thick))
    return
  end
  border("accent", fringe + step, 1.3 * step, 0.5 * thick, 0.93 * thick)
  border("pale", fringe + 2.9 * step, 0.4 * step, 0.5 * thick, 0.94 * thick)
  -- Lozenges in the field.
  local field_x, field_y = x - 4.4 * step, y - 4.4 * step
  local r = 0.8 * min(field_x, field_y)
  if r < 0.02 then
    box("accent", {-0.4 * x, -0.4 * y, 0.5 * thick}, {0.4 * x, 0.4 * y, thick}, 0)
    return
  end
  local count = clamp(floor(max(field_x, field_y) / r), 1, 5)
  for i = 0, count - 1 do
    local along = (i - 0.5 * (count - 1)) * 2 * max(field_x, field_y) / count
    local c = field_x >= field_y and vec(along, 0) or vec(0, along)
    local function lozenge(size)
      return {{c[1] + size, c[2]}, {c[1], c[2] + size}, {c[1] - size, c[2]}, {c[1], c[2] - size}}
    end
    slab("accent", lozenge(r), 0.5 * thick, 0.95 * thick, 0)
    slab("pale", lozenge(0.62 * r), 0.5 * thick, 0.97 * thick, 0)
    slab("soft", lozenge(0.36 * r), 0.5 * thick, thick, 0)
  end
end

function plan.rug()
  -- Fringes at the ends of the longer side, a double border, a pale medallion.
  local along = w >= d
  local fringe = min(0.05, 0.05 * smaller)
  local cloth = along and rect(left + fringe, back, right - fringe, front) or rect(left, back + fringe, right,
      front - fringe)
  local threads = clamp(floor(smaller / 0.045), 6, 90)
  for i = 0, threads do
    local share = i / threads
    for side in each{-1, 1} do
      if along then
        local y = back + share * d
        segment({side * (right - fringe), y}, {side * right, y}, "faint")
      else
        local x = left + share * w
        segment({x, side * (front - fringe)}, {x, side * front}, "faint")
      end
    end
  end
  area(cloth, "light", "detail")
  local border = min(0.13, 0.09 * smaller)
  area(grown(cloth, -0.35 * border), "body", "faint")
  area(grown(cloth, -border), "light", "faint")
  area(grown(cloth, -1.35 * border), "none", "faint")
  local w, d = 0.22 * cloth.width, 0.22 * cloth.height
  local outer = {{0, -d}, {w, 0}, {0, d}, {-w, 0}}
  shape(outer, "body", "faint")
  local inner = {{0, -0.6 * d}, {0.6 * w, 0}, {0, 0.6 * d}, {-0.6 * w, 0}}
  shape(inner, "light", "faint")
end

function mesh.round_rug()
  local rings = {1, 0.9, 0.82, 0.56, 0.5, 0.16}
  for i = 0, #rings - 1 do
    local cloth = i % 3 == 0 and "soft" or i % 3 == 1 and "accent" or "pale"
    local top = h * (0.84 + 0.032 * i)
    slab(cloth, ellipse({}, rings[i + 1] * w / 2, rings[i + 1] * d / 2, i == 0 and 48 or 40), i == 0 and 0 or 0.4 * h,
        top, i == 0 and min(0.004, 0.3 * h) or 0)
  end
end

function plan.round_rug()
  local rx, ry = w / 2, d / 2
  oval({0, 0}, rx, ry, "light", "detail")
  for share in each{0.9, 0.82, 0.5, 0.44} do
    oval({0, 0}, share * rx, share * ry, (share == 0.9 or share == 0.5) and "body" or "light", "faint")
  end
end

function mesh.mat()
  local cloth = "soft"
  slab(cloth, rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.04), 0, 0.9 * h, min(0.01, 0.3 * h))
  local x, y = 0.44 * w, 0.44 * d
  slab("accent", rounded({-x, -y}, {x, y}, 0.03), 0.4 * h, 0.95 * h, 0)
  local inset = 0.05 * smaller
  slab(cloth, rounded({-x + inset, -y + inset}, {x - inset, y - inset}, 0.03), 0.4 * h, h, 0)
end

function plan.mat()
  area(whole, "light", "detail", min(0.05, 0.1 * smaller))
  area(grown(whole, -0.08 * smaller), "none", "faint", min(0.04, 0.08 * smaller))
  local along = w >= d
  local stripes = clamp(floor(max(w, d) / 0.16), 3, 16)
  for i = 1, stripes - 1 do
    local share = i / stripes - 0.5
    if along then
      segment({share * w, 0.38 * back}, {share * w, 0.38 * front}, "faint")
    else
      segment({0.38 * left, share * d}, {0.38 * right, share * d}, "faint")
    end
  end
end

function mesh.cushion()
  pillow("soft", {-w / 2, -d / 2, 0}, {w / 2, d / 2, h})
  if h > 1.4 * d then return end
  ellipsoid("accent", {0, 0, 0.985 * h}, {0.035 * w, 0.035 * d, 0.02 * h}, 12, 6)
end

function plan.cushion()
  area(whole, "light", "outline", 0.28 * smaller)
  area(grown(whole, -0.14 * smaller), "none", "faint", 0.22 * smaller)
  circle({0, 0}, 0.05 * smaller, "dark", "faint")
end

-- folded cloth: blankets and towels
function mesh.blanket()
  local layers = clamp(floor(h / 0.03), 2, 5)
  local thick = h / layers
  for i = 0, layers - 1 do
    local z, inset = thick * i, 0.02 * smaller * chance(i)
    cushion(i % 2 == 0 and "soft" or "accent", {-w / 2 + (i > 0 and inset or 0), -d / 2, z},
        {w / 2 - (i > 0 and inset or 0), d / 2 - (i > 0 and inset or 0), z + thick}, 0.48 * thick)
  end
end

function mesh.curtain()
  local rod = min(0.014, 0.2 * d, 0.02 * h)
  local top, deep = h - 2.4 * rod, 0.42 * d
  bar("metal", {-w / 2 + 2 * rod, 0, h - rod}, {w / 2 - 2 * rod, 0, h - rod}, rod, 10)
  for side in each{-1, 1} do
    ellipsoid("metal", {side * (w / 2 - 2 * rod), 0, h - rod}, {2 * rod, min(2 * rod, 0.5 * d), rod}, 10, 6)
  end
  -- drawn aside, the window between
  local wide = w > 0.9 and 0.3 * w or 0.47 * w
  local folds = clamp(floor(wide / 0.09), 2, 9)
  for side in each{-1, 1} do
    sheet("soft", 8 * folds, 5, function(u, v)
      local gather = 1 - 0.22 * sin(pi * v) * (h > 1.2 and 1 or 0.3)
      local x = side > 0 and w / 2 - 2 * rod - (1 - u) * wide * gather or -w / 2 + 2 * rod + u * wide * gather
      return vec(x, -deep * (0.4 + 0.6 * (1 - v)) * cos(2 * pi * folds * u), top * v)
    end, 0.004)
    if h > 1.2 then
      local x = side * (w / 2 - 2 * rod - 0.42 * wide)
      inside({{x, 0, 0.45 * h}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, function()
        ring("accent", {}, {{0.47, -0.012 * h}, {0.5, -0.012 * h}, {0.5, 0.012 * h}, {0.47, 0.012 * h}}, 24,
            {0.84 * wide, 0.94 * d})
      end)
    end
  end
end

function plan.curtain()
  -- Gathered to both sides: a wave along the rail.
  segment({left, back}, {right, back}, "detail")
  local waves = clamp(floor(w / 0.1), 4, 60)
  for i = 0, waves - 1 do
    local x0, x1 = left + w * i / waves, left + w * (i + 1) / waves
    local swing = (i % 2 == 0 and 1 or -1) * 0.62 * d
    curve({x0, 0}, {x0 + 0.3 * (x1 - x0), swing}, {x1 - 0.3 * (x1 - x0), swing}, {x1, 0}, "outline")
  end
end
