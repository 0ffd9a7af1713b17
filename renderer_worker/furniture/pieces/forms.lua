-- SPDX-License-Identifier: GPL-3.0-or-later
-- Pieces that are named by their form: round, oval, curved, with corners cut or in a corner of the room.

local function regular(sides, scale)
  local points, turn = {}, pi / sides
  for i = 0, sides - 1 do
    local at = turn + 2 * turn * i
    push(points, {0.5 * w * scale * cos(at) / cos(turn), 0.5 * d * scale * sin(at) / cos(turn)})
  end
  for point in each(points) do
    point[1], point[2] = clamp(point[1], -w / 2 * scale, w / 2 * scale), clamp(point[2], -d / 2 * scale, d / 2 * scale)
  end
  return points
end

-- A top in this outline on a foot in the middle.
local function on_a_foot(outline, foot)
  local thick = min(0.035, 0.1 * h)
  slab("hard", outline, h - thick, h, 0.005)
  slab("hard", scaled(outline, 0.3, 0.3), 0.02 * h, h - thick, 0.004)
  slab("hard", scaled(outline, foot, foot), 0, 0.06 * h, 0.005)
end

local function grain(outline_share)
  for i = -2, 2 do
    local y = 0.15 * d * i
    local half = 0.5 * w * outline_share * sqrt(max(0, 1 - (2 * y / d / outline_share) ^ 2)) - 0.04 * w
    if half > 0.05 * w then segment({-half, y}, {half, y}, "faint") end
  end
end

function plan.oval_table()
  oval({0, 0}, w / 2, d / 2, "body", "outline")
  oval({0, 0}, w / 2 - 0.05 * smaller, d / 2 - 0.05 * smaller, "light", "faint")
  grain(0.9)
end

function mesh.octagonal_table() on_a_foot(regular(8, 1), 0.55) end
function mesh.hexagonal_table() on_a_foot(regular(6, 1), 0.55) end

local function plan_regular(sides)
  shape(regular(sides, 1), "body", "outline")
  shape(regular(sides, 0.88), "light", "faint")
  shape(regular(sides, 0.3), "none", "faint")
end
function plan.octagonal_table() plan_regular(8) end
function plan.hexagonal_table() plan_regular(6) end

function plan.round_coffee_table()
  oval({0, 0}, w / 2, d / 2, "body", "outline")
  oval({0, 0}, 0.42 * w, 0.42 * d, "light", "detail")
end

-- Half an ellipse, its straight side at the back.
local function half_moon(scale)
  return arc({0, -d / 2}, w / 2 * scale, d * scale, 0, pi, 24)
end

function mesh.half_moon_table()
  local thick = min(0.03, 0.1 * h)
  slab("hard", half_moon(1), h - thick, h, 0.004)
  slab("hard", half_moon(0.9), h - 0.16 * h, h - thick, 0.003)
  local leg = min(0.02, 0.05 * smaller)
  for at in each{vec(-0.42 * w, -d / 2 + 1.5 * leg), vec(0.42 * w, -d / 2 + 1.5 * leg), vec(0, 0.32 * d)} do
    taper("hard", {at[1], at[2], 0}, {0.6 * leg, 0.6 * leg}, {at[1], at[2], h - thick}, {leg, leg})
  end
end

function plan.half_moon_table()
  shape(half_moon(1), "body", "outline")
  shape(half_moon(0.88), "light", "faint")
end

-- Leaves at both ends that fold down.
function plan.drop_leaf_table()
  plan.table()
  for side in each{-1, 1} do segment({side * 0.26 * w, back}, {side * 0.26 * w, front}, "outline") end
end

function plan.trestle_table()
  plan.table()
  for side in each{-1, 1} do
    for x in each{0.33, 0.37} do segment({side * x * w, back + 0.06 * d}, {side * x * w, front - 0.06 * d}, "detail") end
  end
end

-- Long edges as the tree grew.
function plan.live_edge_table()
  local points = {}
  for i = 0, 24 do push(points, {left + w * i / 24, back + 0.035 * d * (1 + sin(1.3 * i) * cos(0.5 * i))}) end
  for i = 24, 0, -1 do push(points, {left + w * i / 24, front - 0.035 * d * (1 + cos(1.1 * i) * sin(0.4 * i + 1))}) end
  shape(points, "wood", "outline")
  for i = -2, 2 do
    curve({left + 0.05 * w, 0.16 * d * i}, {-0.15 * w, 0.2 * d * i + 0.03 * d}, {0.1 * w, 0.12 * d * i - 0.03 * d},
        {right - 0.05 * w, 0.16 * d * i}, "faint")
  end
end

-- A sector of a ring across the box, `deep` wide, its outer side at the back or, when `ahead`, at the front.
local function sector(deep, ahead, from, to)
  local sag = clamp(d - deep, 0.02 * smaller, 0.4 * w)
  local radius = (w * w / 4 + sag * sag) / (2 * sag)
  local half = atan(w / 2, radius - sag)
  local points = {}
  local function along(share, first, last)
    local r = max(0.05 * radius, radius - share)
    for i = 0, 20 do
      local at = half * (first + (last - first) * i / 20)
      local y = radius - r * cos(at)
      push(points, {r * sin(at), ahead and d / 2 - y or y - d / 2})
    end
  end
  along(from, -1, 1)
  along(to, 1, -1)
  if ahead then reverse(points) end
  return points
end

function mesh.curved_sofa()
  local deep, seat, base = 0.72 * d, rest, min(0.1, 0.3 * rest)
  slab("soft", sector(deep, false, 0.02 * d, deep), base, 0.72 * seat, 0.02)
  slab("soft", sector(deep, false, 0.2 * d, deep), 0.7 * seat, seat, 0.03)
  slab("soft", sector(deep, false, 0, 0.22 * d), base, h, 0.03)
  slab("hard", sector(deep, false, 0.1 * d, 0.9 * deep), 0, base, 0)
end

function plan.curved_sofa()
  local deep = 0.72 * d
  shape(sector(deep, false, 0, deep), "dark")
  shape(sector(deep, false, 0.2 * d, 0.97 * deep), "light", "detail")
  shape(sector(deep, false, 0.03 * d, 0.22 * d), "body", "detail")
end

function mesh.u_sofa()
  local arm, deep, wide, rear = min(0.2, 0.12 * w), min(0.95, 0.55 * d), min(0.9, 0.32 * w), min(0.24, 0.2 * d)
  local base, low, high, arms = min(0.1, 0.25 * rest), 0.68 * rest, rest, 0.5 * (rest + h)
  box("soft", {-w / 2, -d / 2, base}, {w / 2, deep - d / 2, low}, 0.02)
  box("soft", {-w / 2, -d / 2, base}, {w / 2, rear - d / 2, h}, 0.05)
  cushion("soft", {wide - w / 2, rear - d / 2, low}, {w / 2 - wide, deep - d / 2, high}, 0.045, 0.012)
  for side in each{-1, 1} do
    local inner, outer = side * (w / 2 - wide), side * w / 2
    box("soft", {inner, 0.9 * deep - d / 2, base}, {outer, d / 2, low}, 0.02)
    cushion("soft", {inner, rear - d / 2, low}, {outer - side * arm, d / 2, high}, 0.045, 0.012)
    box("soft", {outer - side * arm, -d / 2, base}, {outer, d / 2, arms}, 0.05)
    for y in each{-0.44, 0.44} do box("hard", {side * 0.44 * w - 0.02, y * d - 0.02, 0}, {side * 0.44 * w + 0.02, y * d + 0.02, base}, 0.002) end
  end
end

function plan.u_sofa()
  local deep, wide, arm, rear = min(0.95, 0.55 * d), min(0.9, 0.32 * w), min(0.2, 0.1 * w), min(0.24, 0.2 * d)
  shape({{left, back}, {right, back}, {right, front}, {right - wide, front}, {right - wide, back + deep},
      {left + wide, back + deep}, {left + wide, front}, {left, front}}, "dark")
  area({left + arm, back + rear, left + wide, front - 0.02}, "light", "detail", 0.06)
  area({right - wide, back + rear, right - arm, front - 0.02}, "light", "detail", 0.06)
  local cushions = max(1, round((w - 2 * wide) / 0.7))
  for i = 0, cushions - 1 do
    local pitch = (w - 2 * wide) / cushions
    area({left + wide + pitch * i, back + rear, left + wide + pitch * (i + 1), back + deep - 0.02}, "light", "detail",
        0.06)
  end
  area({left, back, right, back + rear}, "body", "detail", 0.07)
  area({left, back, left + arm, front}, "body", "detail", 0.07)
  area({right - arm, back, right, front}, "body", "detail", 0.07)
end

-- Bars and desks that bend round whoever stands behind them.
function mesh.curved_counter()
  local deep = min(0.65, 0.6 * d)
  slab("hard", sector(deep, true, 0.1 * deep, 0.95 * deep), 0, 0.96 * h, 0.006)
  slab("hard", sector(deep, true, 0, deep), 0.95 * h, h, 0.006)
end

function plan.curved_counter()
  local deep = min(0.65, 0.6 * d)
  shape(sector(deep, true, 0, deep), "body")
  shape(sector(deep, true, 0.08 * deep, 0.8 * deep), "light", "faint")
end

-- Along the front and down the left side.
local function angle_shape(deep, inset)
  local x0, x1, y0, y1 = -w / 2 + inset, w / 2 - inset, -d / 2 + inset, d / 2 - inset
  return {{x0, y0}, {x0 + deep, y0}, {x0 + deep, y1 - deep}, {x1, y1 - deep}, {x1, y1}, {x0, y1}}
end

function mesh.l_counter()
  local deep = min(0.65, 0.45 * smaller)
  slab("hard", angle_shape(0.86 * deep, 0.05 * deep), 0, 0.96 * h, 0.005)
  slab("hard", angle_shape(deep, 0), 0.95 * h, h, 0.005)
end

function plan.l_counter()
  local deep = min(0.65, 0.45 * smaller)
  shape(angle_shape(deep, 0), "body")
  shape(angle_shape(0.8 * deep, 0.08 * deep), "light", "faint")
end

-- In the corner behind its left side.
local function corner_shape(inset, cut)
  local x0, x1, y0, y1 = -w / 2 + inset, w / 2 - inset, -d / 2 + inset, d / 2 - inset
  return {{x0, y0}, {x1, y0}, {x1, y0 + cut * d}, {x0 + cut * w, y1}, {x0, y1}}
end

function mesh.corner_shelf()
  local board = min(0.025, 0.03 * h)
  local shelves = clamp(round(h / 0.38), 2, 7)
  for i = 0, shelves do
    local z = (h - board) * i / shelves
    slab("hard", corner_shape(0, 0.3), z, z + board, 0.003)
  end
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, board - d / 2, h}, 0.003)
  box("hard", {-w / 2, -d / 2, 0}, {board - w / 2, d / 2, h}, 0.003)
  for i = 0, shelves - 1 do
    local z = (h - board) * i / shelves + board
    book({-0.3 * w, -0.3 * d, z}, {-0.05 * w, -0.1 * d, z + 0.04 * min(1, h)}, i)
  end
end

function plan.corner_shelf()
  shape(corner_shape(0, 0.3), "body")
  shape(corner_shape(0.04 * smaller, 0.26), "light", "detail")
end

local function corner_tub(inset)
  local x0, y0 = -w / 2 + inset, -d / 2 + inset
  local points = {{x0, y0}}
  for point in each(arc({x0, y0}, w - 2 * inset, d - 2 * inset, 0, pi / 2, 20)) do push(points, point) end
  return points
end

function mesh.corner_bath()
  slab("hard", corner_tub(0), 0, 0.97 * h, 0.02)
  slab("water", corner_tub(0.09 * smaller), 0.96 * h, 0.98 * h, 0)
  cylinder("brushed steel", {-0.36 * w, -0.36 * d, 0.97 * h}, 0.02, 0.03 * h, 0.003, 12)
end

function plan.corner_bath()
  shape(corner_tub(0), "pale")
  shape(corner_tub(0.09 * smaller), "water", "detail")
  circle({-0.3 * w, -0.3 * d}, 0.03, "metal")
end

function plan.freestanding_bath()
  oval({0, 0}, w / 2, d / 2, "pale", "outline")
  oval({0, 0}, w / 2 - 0.1 * smaller, d / 2 - 0.1 * smaller, "water", "detail")
  oval({0, 0}, w / 2 - 0.2 * smaller, d / 2 - 0.2 * smaller, "none", "faint")
  circle(w >= d and {-0.3 * w, 0} or {0, -0.3 * d}, 0.03, "metal")
end

function plan.four_poster_bed()
  plan.bed()
  local post = min(0.11, 0.1 * smaller)
  for sx in each{-1, 1} do
    for sy in each{-1, 1} do
      local x, y = sx * (w / 2 - post), sy * (d / 2 - post)
      area({x - (sx < 0 and post or 0), y - (sy < 0 and post or 0), x + (sx > 0 and post or 0), y + (sy > 0 and post or 0)},
          "deep", "outline")
    end
  end
  area(grown(whole, -0.5 * post), "none", "dashed")
end

function mesh.round_bed()
  slab("hard", ellipse({}, w / 2, d / 2, 40), 0, 0.55 * h, 0.02)
  slab("pale", ellipse({}, 0.47 * w, 0.47 * d, 40), 0.5 * h, 0.86 * h, 0.03)
  slab("soft", arc({0, 0}, 0.475 * w, 0.475 * d, -0.15, pi + 0.15, 32), 0.6 * h, 0.9 * h, 0.03)
  for side in each{-1, 1} do
    pillow("pale", {side * 0.2 * w - 0.17 * w, -0.4 * d, 0.84 * h}, {side * 0.2 * w + 0.17 * w, -0.2 * d, h})
  end
end

function plan.round_bed()
  oval({0, 0}, w / 2, d / 2, "hard", "outline")
  oval({0, 0}, 0.46 * w, 0.46 * d, "pale", "detail")
  shape(arc({0, 0}, 0.46 * w, 0.46 * d, -0.15, pi + 0.15, 32), "soft", "detail")
  for side in each{-1, 1} do
    area({side * 0.19 * w - 0.16 * w, -0.38 * d, side * 0.19 * w + 0.16 * w, -0.18 * d}, "pale", "detail", 0.08)
  end
end

function plan.tub_chair()
  oval({0, 0}, w / 2, d / 2, "dark", "outline")
  oval({0, 0.1 * d}, 0.34 * w, 0.36 * d, "light", "detail")
end

function plan.wing_chair()
  plan.armchair()
  local deep, wide = 0.42 * d, 0.13 * w
  for side in each{-1, 1} do
    shape({{side * w / 2, back}, {side * (w / 2 - 2 * wide), back}, {side * (w / 2 - wide), back + deep}, {side * w / 2,
        back + deep}}, "deep", "detail")
  end
end

-- A plant on a small table.
function mesh.plant_stand()
  local all, top = h, 0.5 * h
  local board, leg = min(0.025, 0.05 * h), min(0.015, 0.05 * smaller)
  slab("hard", rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.02), top - board, top, 0.003)
  legs_at("hard", w / 2 - 2 * leg, d / 2 - 2 * leg, top - board, leg, 0.7)
  inside({{0, 0, top}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, function()
    h = all - top
    mesh.plant()
    h = all
  end)
end

function plan.plant_stand()
  area(whole, "hard", "outline", 0.02)
  plan.plant()
end

-- For a bird: a bar on a post, a dish at one end.
function mesh.perch()
  local r = min(0.02, 0.06 * smaller)
  cylinder("hard", {0, 0, 0}, 0.48 * smaller, 0.04 * h, 0.006, 28)
  bar("hard", {0, 0, 0.03 * h}, {0, 0, 0.97 * h}, r, 12)
  bar("hard", {-w / 2, 0, h - r}, {w / 2, 0, h - r}, r, 12)
  cylinder("metal", {0.42 * w, 0, h - 3 * r}, 0.07 * w, 3 * r, 0.003, 16)
end

function plan.perch()
  circle({0, 0}, 0.46 * smaller, "hard", "detail")
  circle({0, 0}, 0.34 * smaller, "light", "faint")
  area({left, -0.03 * w, right, 0.03 * w}, "deep", "outline", 0.02)
  circle({0.4 * w, 0}, 0.07 * w, "metal")
end

-- Drawn from end to end, on a rail that hangs from the ceiling.
function mesh.privacy_curtain()
  local rail = min(0.015, 0.2 * d)
  bar("metal", {-w / 2, 0, h - rail}, {w / 2, 0, h - rail}, rail, 8)
  local folds = clamp(floor(w / 0.14), 3, 24)
  sheet("soft", 8 * folds, 4, function(u, v)
    return vec(w * (u - 0.5), 0.42 * d * cos(2 * pi * folds * u), 0.08 * h + 0.9 * h * v)
  end, 0.004)
end

-- Sloped pockets, one above the other.
function mesh.leaflet_rack()
  local rows = clamp(round(h / 0.32), 2, 5)
  local columns = clamp(round(w / 0.24), 1, 5)
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, 0.02 - d / 2, h}, 0.003)
  for side in each{-1, 1} do box("hard", {side * w / 2, -d / 2, 0}, {side * (w / 2 - 0.02), 0.1 * d, h}, 0.003) end
  for i = 0, rows - 1 do
    local z, y = h * (i + 0.15) / rows, d / 2 - 0.6 * d * i / rows
    box("hard", {-w / 2, -d / 2, z}, {w / 2, y, z + 0.015 * h}, 0.002)
    for k = 0, columns - 1 do
      local x, pitch = -w / 2 + w * (k + 0.12) / columns, 0.76 * w / columns
      box(cover(i * 3 + k), {x, y - 0.12 * d, z + 0.015 * h}, {x + pitch, y - 0.04 * d, z + 0.62 * h / rows}, 0.002)
    end
  end
end

function plan.leaflet_rack()
  area(whole, "body", "outline", 0.01)
  local columns = clamp(round(w / 0.24), 1, 5)
  for i = 0, 1 do
    local y0, y1 = back + d * (0.2 + 0.4 * i), back + d * (0.44 + 0.4 * i)
    for k = 0, columns - 1 do
      area({left + w * (k + 0.12) / columns, y0, left + w * (k + 0.88) / columns, y1}, i == 0 and "light" or "pale", "detail")
    end
  end
end

function plan.aquarium()
  area(whole, "glass", "outline", 0.01)
  area(grown(whole, -min(0.03, 0.1 * smaller)), "water", "detail")
  for at in each{vec(-0.25, -0.1), vec(0.1, 0.15), vec(0.3, -0.2)} do
    local x, y, size = at[1] * w, at[2] * d, 0.1 * smaller
    oval({x, y}, 1.3 * size, 0.6 * size, "fire", "faint")
    shape({{x + 1.2 * size, y}, {x + 2 * size, y - 0.6 * size}, {x + 2 * size, y + 0.6 * size}}, "fire", "faint")
  end
end

-- Two benches that face each other along the wall, a table between.
function mesh.diner_booth()
  local deep, seat = 0.3 * w, 0.41 * h
  for side in each{-1, 1} do
    box("soft", {side * w / 2, -d / 2, 0.05 * h}, {side * (w / 2 - deep), d / 2, seat}, 0.03)
    box("soft", {side * w / 2, -d / 2, 0.05 * h}, {side * (w / 2 - 0.3 * deep), d / 2, h}, 0.03)
  end
  slab("hard", rounded({-0.22 * w, -d / 2}, {0.22 * w, 0.47 * d}, 0.04), 0.64 * h, 0.68 * h, 0.004)
  box("metal", {-0.03 * w, -0.05 * d, 0}, {0.03 * w, 0.05 * d, 0.65 * h}, 0.004)
end

function plan.diner_booth()
  local deep = 0.3 * w
  area({left, back, left + deep, front}, "soft", "outline", 0.04)
  area({right - deep, back, right, front}, "soft", "outline", 0.04)
  area({left, back, left + 0.3 * deep, front}, "deep", "detail", 0.03)
  area({right - 0.3 * deep, back, right, front}, "deep", "detail", 0.03)
  area({-0.22 * w, back, 0.22 * w, front - 0.03 * d}, "light", "outline", 0.05)
end
