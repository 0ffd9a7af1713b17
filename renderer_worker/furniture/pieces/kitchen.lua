-- SPDX-License-Identifier: GPL-3.0-or-later
-- Kitchens and what washes.

-- A base unit with doors and a drawer above each, without its worktop.
local function base_unit(height)
  local thick = min(0.04, 0.08 * height)
  local u = { top = height - thick, plinth = min(0.1, 0.12 * height), front = d / 2 - min(0.06, 0.12 * d),
      board = thick }
  box("hard", {-0.497 * w, -d / 2, u.plinth}, {0.497 * w, u.front, u.top}, 0.002)
  box("black plastic", {-0.49 * w, -d / 2, 0}, {0.49 * w, u.front - 0.05 * d, u.plinth}, 0)
  local count = clamp(round(w / 0.6), 1, 10)
  local wide = w * 0.994 / count
  local gap, split = min(0.003, 0.02 * wide), u.top - 0.2 * (u.top - u.plinth)
  for i = 0, count - 1 do
    local from = -0.497 * w + wide * i + gap
    local to = from + wide - 2 * gap
    panel("hard", {from, u.plinth + gap}, {to, split - gap}, u.front, 0.018, not says("modern"))
    panel("hard", {from, split + gap}, {to, u.top - gap}, u.front, 0.018)
    handle({(from + to) / 2, u.front + 0.018, (split + u.top) / 2}, min(0.14, 0.4 * wide), false)
    handle({i % 2 == 0 and to - 0.06 * wide or from + 0.06 * wide, u.front + 0.018,
        split - 0.16 * (split - u.plinth)}, min(0.14, 0.4 * wide), true)
  end
  return u
end

local function worktop()
  return look("hard").pattern == "SLABS" and "hard" or "worktop"
end

local function tap(at, height, reach)
  local r = min(0.012, 0.06 * height)
  cylinder("brushed steel", at, 2.2 * r, 0.1 * height, 0.002, 14)
  local path = {at, at + vec(0, 0, 0.6 * height)}
  for i = 1, 8 do
    local turn = pi * i / 8
    push(path, at + vec(0, reach / 2 * (1 - cos(turn)), (0.62 + 0.35 * sin(turn)) * height))
  end
  tube("brushed steel", path, r, 8)
end

-- A rectangular basin sunk into a worktop: rim and inner faces.
local function sunk_basin(low, high, top, deep, material)
  local wall = min(0.012, 0.05 * (high[1] - low[1]))
  box(material, {low[1], low[2], top - deep}, {high[1], high[2], top - deep + wall}, 0.002)
  for x in each{low[1], high[1] - wall} do
    box(material, {x, low[2], top - deep}, {x + wall, high[2], top + 0.004}, 0.003)
  end
  for y in each{low[2], high[2] - wall} do
    box(material, {low[1], y, top - deep}, {high[1], y + wall, top + 0.004}, 0.003)
  end
  cylinder("black plastic", {(low[1] + high[1]) / 2, (low[2] + high[2]) / 2, top - deep + wall - 0.001},
      0.1 * (high[2] - low[2]), 0.003, 0.001, 14)
end

-- A worktop with a rectangular hole in it.
local function worktop_around(low, high, bottom, top)
  local m = worktop()
  box(m, {-w / 2, -d / 2, bottom}, {low[1], d / 2, top}, 0.005)
  box(m, {high[1], -d / 2, bottom}, {w / 2, d / 2, top}, 0.005)
  box(m, {low[1], -d / 2, bottom}, {high[1], low[2], top}, 0.005)
  box(m, {low[1], high[2], bottom}, {high[1], d / 2, top}, 0.005)
end

local function rings(top, width, depth)
  local count = width > 0.75 and 5 or width > 0.4 and 4 or 2
  for i = 0, count - 1 do
    local x = i == 4 and 0 or (i % 2 == 0 and -0.25 or 0.25) * width
    local y = i == 4 and 0 or (i < 2 and -0.22 or 0.22) * depth
    local r = (i % 3 == 0 and 0.15 or 0.12) * min(width, 1.4 * depth) * (count == 5 and 0.75 or 1)
    cylinder("brushed steel", {x, y, top - 0.001}, r, 0.006, 0.002, 24)
    cylinder("black plastic", {x, y, top}, 0.84 * r, 0.008, 0.002, 24)
  end
end

local function oven_front(bottom, top, front)
  local high = top - bottom
  local fascia = 0.16 * high
  panel("black plastic", {-0.47 * w, bottom}, {0.47 * w, top - fascia}, front, 0.02)
  box("dark screen", {-0.36 * w, front + 0.018, bottom + 0.15 * high}, {0.36 * w, front + 0.024, bottom + 0.6 * high},
      0.002)
  bar("brushed steel", {-0.4 * w, front + 0.045, top - fascia - 0.06 * high},
      {0.4 * w, front + 0.045, top - fascia - 0.06 * high}, 0.009, 8)
  for x in each{-0.36, 0.36} do
    bar("brushed steel", {x * w, front, top - fascia - 0.06 * high},
        {x * w, front + 0.045, top - fascia - 0.06 * high}, 0.006, 6)
  end
  for i = 0, 4 do
    knob({w * (-0.32 + 0.16 * i), front + 0.004, top - 0.5 * fascia}, min(0.016, 0.25 * fascia))
  end
end

function mesh.counter()
  local u = base_unit(h)
  box(worktop(), {-w / 2, -d / 2, u.top}, {w / 2, d / 2, h}, 0.006)
end

local function plan_sink_bowl(bowl, with_tap)
  area(bowl, "metal", "detail", 0.06)
  area(grown(bowl, -0.025), "water", "faint", 0.05)
  circle(bowl.centre, 0.022, "deep", "none")
  if not with_tap then return end
  local spout = vec(bowl.centre[1], bowl.y0 - 0.03)
  circle(spout, 0.022, "metal")
  segment(spout, {spout[1], spout[2] + 0.13}, "outline")
end

local function plan_rings(plate)
  area(plate, "deep", "detail", 0.02)
  local dx, dy = plate.width / 4, plate.height / 4
  local large, small = 0.8 * min(dx, dy), 0.62 * min(dx, dy)
  local c = plate.centre
  for at in each{vec(c[1] - dx, c[2] - dy), vec(c[1] + dx, c[2] + dy)} do
    circle(at, large, "metal")
  end
  for at in each{vec(c[1] + dx, c[2] - dy), vec(c[1] - dx, c[2] + dy)} do
    circle(at, small, "metal")
  end
  for x in each{c[1] - dx, c[1] + dx} do
    for y in each{c[2] - dy, c[2] + dy} do
      circle({x, y}, 0.35 * small, "none", "faint")
    end
  end
end

-- A run of worktop: a sink with drainer and, when there is room, a hob.
function plan.counter()
  area(whole, "light")
  local lip = min(0.04, 0.08 * d)
  segment({left, front - lip}, {right, front - lip})
  local fronts = clamp(round(w / 0.6), 1, 12)
  for i = 1, fronts - 1 do
    local x = left + w * i / fronts
    segment({x, front - lip}, {x, front})
  end
  segment({left, back + lip}, {right, back + lip}, "faint")
end

function mesh.kitchen_island()
  local u = base_unit(h)
  box(worktop(), {-w / 2, -d / 2, u.top}, {w / 2, d / 2, h}, 0.008)
end

function mesh.sink()
  local top = rest
  local spout = h - top
  local u = base_unit(top)
  local low, high = vec(-min(0.3, 0.38 * w), -0.24 * d), vec(min(0.3, 0.38 * w), 0.34 * d)
  worktop_around(low, high, u.top, top)
  sunk_basin(low, high, top, 0.2 * top, says("stone", "ceramic") and "hard" or "brushed steel")
  tap(vec(0, -0.34 * d, top), spout, 0.3 * d)
end

function mesh.hob()
  local front, top = d / 2 - 0.05 * d, h - 0.008
  box("hard", {-0.495 * w, -d / 2, 0.06 * h}, {0.495 * w, front, top - 0.03 * h}, 0.003)
  box("black plastic", {-0.47 * w, -d / 2, 0}, {0.47 * w, front - 0.05 * d, 0.07 * h}, 0)
  box("hard", {-w / 2, -d / 2, top - 0.035 * h}, {w / 2, d / 2, top - 0.012}, 0.004)
  box("dark screen", {-0.48 * w, -0.46 * d, top - 0.02}, {0.48 * w, 0.46 * d, top}, 0.002)
  rings(top, 0.96 * w, 0.92 * d)
  oven_front(0.1 * h, top - 0.05 * h, front)
end

function plan.hob()
  area(whole, "light")
  local lip = min(0.06, 0.1 * d)
  area({left, front - lip, right, front}, "dark", "detail")
  for i = -2, 2 do
    circle({0.16 * i * w, front - lip / 2}, 0.3 * lip, "pale", "faint")
  end
  plan_rings(rect(0.88 * left, 0.88 * back, 0.88 * right, front - lip - 0.06 * d))
end

function mesh.fridge()
  local front, split = d / 2 - min(0.1, 0.2 * d), w > 0.85 and 0 or 0.64 * h
  local door = 0.6 * (d / 2 - front)
  box("hard", {-w / 2, -d / 2, 0.03 * h}, {w / 2, front, h}, 0.01)
  box("black plastic", {-0.48 * w, -0.48 * d, 0}, {0.48 * w, 0.9 * front, 0.04 * h}, 0)
  local z = 0.04 * h
  local function strip(x, from, to)
    bar("brushed steel", {x, d / 2 - 0.012, from}, {x, d / 2 - 0.012, to}, 0.012, 10)
    for at in each{from, to} do
      bar("brushed steel", {x, front + 0.5 * door, at}, {x, d / 2 - 0.012, at}, 0.009, 8)
    end
  end
  -- two doors side by side
  if split == 0 then
    for side in each{-1, 1} do
      box("hard", {side * 0.003, front, z}, {side * w / 2, front + door, h}, 0.012)
      strip(side * 0.06 * w, 0.4 * h, 0.72 * h)
    end
    box("dark screen", {-0.36 * w, front, 0.52 * h}, {-0.16 * w, front + 1.03 * door, 0.7 * h}, 0.003)
    return
  end
  box("hard", {-w / 2, front, z}, {w / 2, front + door, split - 0.003}, 0.012)
  box("hard", {-w / 2, front, split + 0.003}, {w / 2, front + door, h}, 0.012)
  strip(0.4 * w, 0.34 * h, 0.58 * h)
  strip(0.4 * w, 0.7 * h, 0.86 * h)
end

function plan.fridge()
  local door = min(0.06, 0.1 * d)
  area(whole, "light", "outline", 0.02)
  local body = rect(left, back, right, front - door)
  segment({body.x0, body.y0}, {body.x1, body.y1}, "faint")
  segment({body.x1, body.y0}, {body.x0, body.y1}, "faint")
  area({left, front - door, right, front}, "dark", "detail", 0.02)
  area({right - 0.12, front - 0.3 * door, right - 0.04, front}, "deep", "none")
end

function mesh.washing_machine()
  local front, fascia, r = d / 2 - min(0.05, 0.09 * d), 0.16 * h, min(0.3 * w, 0.27 * h)
  box("hard", {-w / 2, -d / 2, 0.02 * h}, {w / 2, front, h}, 0.012)
  box("black plastic", {-0.48 * w, -0.48 * d, 0}, {0.48 * w, 0.94 * front, 0.03 * h}, 0)
  box("white glaze", {-0.5 * w, front - 0.01, h - fascia}, {0.5 * w, front + 0.01, h - 0.01 * h}, 0.004)
  box("dark screen", {0.12 * w, front, h - 0.75 * fascia}, {0.42 * w, front + 0.013, h - 0.3 * fascia}, 0.001)
  knob({-0.05 * w, front + 0.008, h - 0.5 * fascia}, 0.2 * fascia)
  inside(facing_front({0, front, 0.44 * h}), function()
    ring("brushed steel", {}, {{0.78 * r, 0}, {r, 0}, {r, 0.025}, {0.92 * r, 0.045}, {0.78 * r, 0.03}}, 32)
    lathe("dark screen", {}, {{0.8 * r, 0}, {0.78 * r, 0.02}, {0.5 * r, 0.035}, {0, 0.04}}, 28)
  end)
end

function mesh.dishwasher()
  local front, fascia = d / 2 - min(0.06, 0.12 * d), 0.15 * h
  box("hard", {-w / 2, -d / 2, 0.1 * h}, {w / 2, front, h}, 0.008)
  box("black plastic", {-0.48 * w, -0.48 * d, 0}, {0.48 * w, 0.9 * front, 0.11 * h}, 0)
  panel("hard", {-0.49 * w, 0.12 * h}, {0.49 * w, h - fascia}, front, 0.02)
  panel("black plastic", {-0.49 * w, h - fascia + 0.004}, {0.49 * w, h - 0.01 * h}, front, 0.02)
  bar("brushed steel", {-0.38 * w, d / 2 - 0.01, h - fascia - 0.06 * h},
      {0.38 * w, d / 2 - 0.01, h - fascia - 0.06 * h}, 0.01, 8)
  for x in each{-0.35, 0.35} do
    bar("brushed steel", {x * w, front, h - fascia - 0.06 * h}, {x * w, d / 2 - 0.01, h - fascia - 0.06 * h}, 0.007,
        6)
  end
end

function plan.dishwasher()
  local lip = min(0.05, 0.09 * d)
  area(whole, "pale")
  area({left, front - lip, right, front}, "dark", "detail")
  for i = 1, 5 do
    local x = left + w * i / 6
    segment({x, 0.7 * back}, {x, 0.6 * front}, "faint")
  end
end

function mesh.small_appliance()
  local body = "hard"
  if says("kettle") then
    lathe(body, {0, 0, 0}, {{0.44, 0}, {0.46, 0.06 * h}, {0.44, 0.12 * h}, {0.4, 0.5 * h}, {0.3, 0.78 * h},
        {0.12, 0.88 * h}, {0, 0.88 * h}}, 20, {w * 0.86, d})
    ellipsoid("black plastic", {0, 0, 0.93 * h}, {0.06 * w, 0.06 * w, 0.07 * h}, 10, 6)
    tube("black plastic", {{-0.3 * w, 0, 0.75 * h}, {-0.5 * w, 0, 0.72 * h}, {-0.5 * w, 0, 0.3 * h},
        {-0.34 * w, 0, 0.2 * h}}, 0.03 * w, 8)
    bar(body, {0.3 * w, 0, 0.45 * h}, {0.48 * w, 0, 0.74 * h}, 0.08 * w, 0.04 * w, 10)
    return
  end
  if says("toaster") then
    cushion(body, {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.97 * h}, 0.2 * smaller)
    for y in each{-0.2, 0.1} do box("black plastic", {-0.36 * w, y * d, 0.94 * h}, {0.36 * w, (y + 0.12) * d, h}, 0) end
    return
  elseif says("coffee", "espresso") then
    box(body, {-w / 2, -d / 2, 0}, {w / 2, -0.1 * d, h}, 0.015)
    box(body, {-w / 2, -d / 2, 0.72 * h}, {w / 2, d / 2, h}, 0.015)
    box(body, {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.1 * h}, 0.01)
    lathe("dark screen", {0, 0.2 * d, 0.1 * h}, {{0.3 * smaller, 0}, {0.34 * smaller, 0.2 * h}, {0.2 * smaller,
        0.42 * h}}, 20)
    return
  elseif says("printer") then
    cushion(body, {-w / 2, -0.4 * d, 0}, {w / 2, 0.34 * d, 0.8 * h}, 0.03)
    box("paper", {-0.34 * w, -d / 2, 0.7 * h}, {0.34 * w, -0.44 * d, h}, 0)
    box("black plastic", {-0.36 * w, 0.3 * d, 0.2 * h}, {0.36 * w, d / 2, 0.26 * h}, 0.004)
    box("paper", {-0.32 * w, 0.3 * d, 0.26 * h}, {0.32 * w, 0.46 * d, 0.28 * h}, 0)
    return
  end
  box(body, {-w / 2, -d / 2, 0.04 * h}, {w / 2, 0.47 * d, h}, 0.012)
  box("black plastic", {-0.44 * w, -0.44 * d, 0}, {0.44 * w, 0.42 * d, 0.05 * h}, 0.002)
  box("dark screen", {-0.45 * w, 0.46 * d, 0.14 * h}, {0.2 * w, 0.485 * d, 0.9 * h}, 0.003)
  for z in each{0.3, 0.6} do
    knob({0.35 * w, 0.465 * d, z * h}, min(0.07 * w, 0.1 * h))
  end
  box("lit screen", {0.26 * w, 0.465 * d, 0.76 * h}, {0.44 * w, 0.476 * d, 0.87 * h}, 0)
end

function plan.small_appliance()
  area(whole, "light", "outline", 0.15 * smaller)
  area({0.7 * left, 0.6 * back, 0.25 * right, 0.6 * front}, "glass", "detail", 0.02)
  circle({0.65 * right, 0}, 0.1 * smaller, "dark")
end

function mesh.range_hood()
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.1 * h}, 0.006)
  taper("hard", {0, 0, 0.1 * h}, {0.49 * w, 0.49 * d}, {0, -0.18 * d, 0.55 * h}, {0.16 * w, 0.3 * d})
  box("hard", {-0.15 * w, -0.5 * d, 0.54 * h}, {0.15 * w, 0.1 * d, h}, 0.004)
  box("bulb", {-0.3 * w, -0.1 * d, -0.002}, {0.3 * w, 0.1 * d, 0.004}, 0)
end

function plan.kitchen_sink()
  area(whole, "light")
  local lip = min(0.04, 0.08 * d)
  segment({left, front - lip}, {right, front - lip})
  local y0, y1 = back + 0.24 * d, front - 0.16 * d
  if w < 0.8 then
    plan_sink_bowl(rect(0.72 * left, y0, 0.72 * right, y1), true)
    return
  end
  plan_sink_bowl(rect(0.86 * left, y0, -0.02, y1), true)
  for i = 1, 6 do
    local x = 0.04 + (0.84 * right - 0.04) * i / 7
    segment({x, y0}, {x, y1}, "faint")
  end
end

function plan.washer()
  area(whole, "pale", "outline", 0.02)
  circle({0, -0.04 * d}, 0.34 * smaller, "light")
  circle({0, -0.04 * d}, 0.24 * smaller, "water")
  local lip = min(0.05, 0.09 * d)
  area({left, front - lip, right, front}, "dark", "detail")
end
