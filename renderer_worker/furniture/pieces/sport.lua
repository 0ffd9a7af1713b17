-- SPDX-License-Identifier: GPL-3.0-or-later
-- What one trains with.

-- A disc that stands upright, its axis along x.
local function upright_disc(material, centre, radius, thick, sides)
  sides = sides or 24
  inside(facing_right(centre), function()
    cylinder(material, {0, 0, -thick / 2}, radius, thick, 0.005, sides)
  end)
end

local function dumbbell(centre, length, radius, along_y)
  local axis = along_y and vec(0, 1, 0) or vec(1, 0, 0)
  local side = along_y and vec(-1, 0, 0) or vec(0, 1, 0)
  inside({centre, side, cross(axis, side), axis}, function()
    cylinder("metal", {0, 0, -length / 2}, 0.3 * radius, length, 0.001, 8)
    for z in each{-length / 2, 0.22 * length} do
      cylinder("rubber", {0, 0, z}, radius, 0.28 * length, 0.006, 6)
    end
  end)
end

function mesh.treadmill()
  -- One runs towards the back of the box, where the display is.
  local deck, rail, post, y = min(0.2, 0.16 * h), 0.09 * w, min(0.03, 0.05 * w), -0.36 * d
  box("hard", {-w / 2, -d / 2, 0.2 * deck}, {w / 2, d / 2, 0.8 * deck}, 0.02)
  for side in each{-1, 1} do
    box("hard", {side * (w / 2 - rail), -0.44 * d, 0.7 * deck}, {side * w / 2, 0.49 * d, deck}, 0.01)
  end
  box("rubber", {-w / 2 + rail, -0.44 * d, 0.7 * deck}, {w / 2 - rail, 0.49 * d, 0.93 * deck}, 0.004)
  cushion("hard", {-0.46 * w, -d / 2, 0.3 * deck}, {0.46 * w, -0.36 * d, 1.7 * deck}, 0.05, 0.01)
  for side in each{-1, 1} do
    local x = side * (w / 2 - 1.5 * post)
    taper("metal", {x, y, 0.6 * deck}, {post, 1.6 * post}, {x, y + 0.03 * d, 0.82 * h}, {0.8 * post, 1.2 * post})
    bar("rubber", {x, y, 0.72 * h}, {x, 0.02 * d, 0.7 * h}, 0.9 * post, 10)
  end
  for x in each{-0.42, 0.42} do
    box("rubber", {x * w - 0.03 * w, 0.46 * d, 0}, {x * w + 0.03 * w, 0.49 * d, 0.25 * deck}, 0.003)
  end
  inside(turned_x({0, y + 0.02 * d, 0.76 * h}, 0.5), function()
    box("hard", {-w / 2 + post, -0.04 * d, 0}, {w / 2 - post, 0, 0.24 * h}, 0.015)
    box("lit screen", {-0.26 * w, -0.004, 0.08 * h}, {0.26 * w, 0.006, 0.2 * h}, 0.002)
  end)
end

function plan.treadmill()
  -- One stands on the belt and looks to the console, which is at the back when its back is to the wall.
  local rail, console = 0.13 * w, min(0.28, 0.17 * d)
  area(whole, "body", "outline", 0.04)
  local belt = rect(left + rail, back + console, right - rail, front - 0.04)
  area(belt, "deep", "detail")
  for i = 1, 9 do
    local y = belt.y0 + belt.height * i / 10
    segment({belt.x0, y}, {belt.x1, y}, "faint")
  end
  area({left, back + 0.3 * console, right, back + console}, "dark", "detail", 0.03)
  area({0.45 * left, back + 0.42 * console, 0.45 * right, back + 0.84 * console}, "glass", "detail")
  for x in each{left + 0.35 * rail, right - 0.35 * rail} do
    segment({x, back + console}, {x, back + 0.5 * d}, "outline")
  end
end

local function bike()
  local r, pipe, strip = min(0.24 * d, 0.26 * h), min(0.03, 0.08 * w), 0.9 * h
  local cycle = says("bicycle") or says("bike") and not says("exercise") and not says("stationary")
      and not says("spin")
  -- rides towards the back of its box
  local front, rear = -0.5 * d + r, 0.5 * d - r
  local function wheel(y)
    inside(facing_right({0, y, r}), function()
      hoop("rubber", {}, r - 0.5 * pipe, pipe, 30)
      for i = 0, 7 do
        local turn = pi / 4 * i
        bar("metal", {}, {0.94 * r * cos(turn), 0.94 * r * sin(turn), 0}, 0.1 * pipe, 4)
      end
    end)
  end
  local crank, seat = vec(0, 0.04 * d, 0.28 * h), vec(0, 0.2 * d, 0.76 * h)
  local head = vec(0, -0.24 * d, 0.76 * h)
  if cycle then
    wheel(front)
    wheel(rear)
    bar("hard", crank, {0, rear, r}, 0.6 * pipe)
    bar("hard", seat, {0, rear, r}, 0.5 * pipe)
    bar("hard", head, {0, front, r}, 0.6 * pipe)
  else
    upright_disc("metal", vec(0, -0.24 * d, 1.1 * r), r, 0.1 * w, 30)
    upright_disc("hard", vec(0, -0.24 * d, 1.1 * r), 0.6 * r, 0.16 * w, 24)
    for y in each{-0.46, 0.46} do
      box("hard", {-0.42 * w, y * d - pipe, 0}, {0.42 * w, y * d + pipe, 1.4 * pipe}, 0.01)
    end
    bar("hard", {0, -0.46 * d, pipe}, {0, 0.46 * d, pipe}, pipe, 10)
    bar("hard", {0, -0.24 * d, 0.2 * h}, head, 1.1 * pipe, 10)
    bar("hard", {0, 0.34 * d, pipe}, crank, 1.2 * pipe, 10)
  end
  bar("hard", crank, seat, pipe, 10)
  bar("hard", crank, head, pipe, 10)
  if cycle then
    bar("hard", seat, head, 0.8 * pipe, 10)
  end
  upright_disc("metal", crank, 0.09 * h, 0.3 * pipe)
  for side in each{-1, 1} do
    local pedal = crank + vec(side * 0.2 * w, side * 0.06 * d, side * 0.07 * h)
    bar("metal", crank + vec(side * 0.16 * w, 0, 0), pedal, 0.4 * pipe, 6)
    box("rubber", pedal + vec(side * 0.02 * w, -0.05 * d, -0.01 * h),
        pedal + vec(side * 0.22 * w, 0.05 * d, 0.01 * h), 0.004)
    tube("rubber", {head + vec(0, 0, 0.1 * h), {side * 0.3 * w, head[2], strip},
        {side * 0.48 * w, head[2] - 0.06 * d, strip}, {side * 0.48 * w, head[2] + 0.12 * d, strip + 0.02 * h}},
        0.6 * pipe, 8)
  end
  bar("metal", head, head + vec(0, 0, 0.14 * h), 0.7 * pipe, 8)
  cushion("rubber", seat + vec(-0.22 * w, -0.12 * d, 0), seat + vec(0.22 * w, 0.08 * d, 0.07 * h), 0.03 * h, 0.01)
  if not cycle then
    box("lit screen", {-0.2 * w, head[2] - 0.04 * d, strip + 0.01 * h}, {0.2 * w, head[2] + 0.02 * d, h}, 0.004)
  end
end

function mesh.exercise_bike() lengthwise(bike) end

function plan.exercise_bike()
  for y in each{back + 0.05 * d, front - 0.05 * d} do
    area({0.85 * left, y - 0.035 * d, 0.85 * right, y + 0.035 * d}, "dark", "detail", 0.02)
  end
  area({-0.07 * w, back + 0.05 * d, 0.07 * w, front - 0.05 * d}, "body", "outline", 0.02)
  oval({0, back + 0.3 * d}, 0.16 * w, 0.24 * d, "light", "outline")
  segment({left, back + 0.32 * d}, {right, back + 0.32 * d}, "outline")
  oval({0, front - 0.24 * d}, 0.24 * w, 0.13 * d, "deep", "outline")
  area({0.75 * left, -0.02 * d, 0.2 * left, 0.06 * d}, "dark", "detail")
  area({0.2 * right, -0.1 * d, 0.75 * right, -0.02 * d}, "dark", "detail")
end

function mesh.rowing_machine()
  lengthwise(function()
    local length, width = d, w
    local r, pipe = min(0.42 * h, 0.14 * length), min(0.035, 0.08 * width)
    local y = -0.5 * length + r
    inside(facing_right({0, y, h - r}), function()
      cylinder("hard", {0, 0, -0.24 * width}, r, 0.48 * width, 0.02, 28)
    end)
    bar("metal", {0, y, 0.5 * h}, {0, 0.48 * length, 0.32 * h}, 1.3 * pipe, 10)
    for at in each{y, 0.46 * length} do
      box("hard", {-0.5 * width, at - pipe, 0}, {0.5 * width, at + pipe, 1.6 * pipe}, 0.01)
      bar("hard", {0, at, pipe}, {0, at, at < 0 and h - r or 0.34 * h}, 1.2 * pipe, 10)
    end
    cushion("rubber", {-0.36 * width, 0.12 * length, 0.4 * h}, {0.36 * width, 0.28 * length, 0.52 * h}, 0.04 * h,
        0.01)
    for side in each{-1, 1} do
      box("rubber", {side * 0.12 * width, -0.2 * length, 0.36 * h}, {side * 0.4 * width, -0.1 * length, 0.44 * h},
          0.01)
    end
    bar("rubber", {-0.38 * width, -0.12 * length, 0.58 * h}, {0.38 * width, -0.12 * length, 0.58 * h}, 0.6 * pipe, 8)
    bar("metal", {0, y + 0.7 * r, h - r}, {0, -0.12 * length, 0.58 * h}, 0.2 * pipe, 6)
  end)
end

function plan.rowing_machine()
  for y in each{back + 0.12 * d, front - 0.05 * d} do area({left, y - 0.02 * d, right, y + 0.02 * d}, "dark", "detail") end
  area({-0.05 * w, back + 0.1 * d, 0.05 * w, front - 0.02 * d}, "metal", "detail")
  area({-0.24 * w, back, 0.24 * w, back + 0.26 * d}, "body", "outline", 0.05 * w)
  for side in each{-1, 1} do area({side * 0.12 * w, -0.2 * d, side * 0.4 * w, -0.1 * d}, "dark", "detail") end
  segment({-0.38 * w, -0.08 * d}, {0.38 * w, -0.08 * d}, "outline")
  area({-0.36 * w, 0.12 * d, 0.36 * w, 0.28 * d}, "deep", "outline", 0.08 * w)
end

function mesh.weight_bench()
  local lengthwise = d >= w or h > 0.8
  local width, length, seat = lengthwise and w or d, lengthwise and d or w, min(0.44, 0.5 * h)
  local pipe = min(0.035, 0.05 * width)
  inside(lengthwise and {} or quarter_turn(), function()
    local pad = min(0.16, 0.3 * width)
    for y in each{-0.28, 0.38} do
      box("hard", {-0.24 * width, y * length - pipe, 0}, {0.24 * width, y * length + pipe, 2 * pipe}, 0.006)
      box("hard", {-pipe, y * length - pipe, pipe}, {pipe, y * length + pipe, seat - 0.05 * h}, 0.006)
    end
    box("hard", {-pipe, -0.4 * length, seat - 0.1 * h - pipe}, {pipe, 0.42 * length, seat - 0.1 * h + pipe}, 0.006)
    cushion("rubber", {-pad, -0.44 * length, seat - 0.08 * h}, {pad, 0.2 * length, seat}, 0.03, 0.006)
    cushion("rubber", {-pad, 0.22 * length, seat - 0.08 * h}, {pad, 0.48 * length, seat}, 0.03, 0.006)
    local rack, y = h > 1.25 * seat and 0.88 * h or seat + 0.1, -0.36 * length
    local disc = min(0.22, 0.2 * length, h > 1.2 * seat and h - rack or 0.1)
    for side in each{-1, 1} do
      box("hard", {side * 0.3 * width - pipe, y - pipe, 0}, {side * 0.3 * width + pipe, y + pipe, rack}, 0.006)
      box("hard", {side * 0.3 * width - pipe, y - 0.12 * length, 0}, {side * 0.3 * width + pipe, y + 0.2 * length,
          2 * pipe}, 0.006)
      for out in each{0.42, 0.46} do
        upright_disc("rubber", vec(side * out * width, y + 1.6 * pipe, rack), max(disc, 0.12 * h), 0.03 * width)
      end
    end
    bar("metal", {-0.5 * width, y + 1.6 * pipe, rack}, {0.5 * width, y + 1.6 * pipe, rack}, 0.5 * pipe, 8)
  end)
end

function plan.weight_bench()
  area({-0.16 * w, back + 0.16 * d, 0.16 * w, front}, "light", "outline", 0.05)
  segment({-0.16 * w, back + 0.55 * d}, {0.16 * w, back + 0.55 * d})
  for side in each{-0.24 * w, 0.24 * w} do
    area({side - 0.03 * w, back, side + 0.03 * w, back + 0.3 * d}, "dark", "detail")
  end
  local y = back + 0.17 * d
  area({left, y - 0.015, right, y + 0.015}, "metal", "detail")
  for side in each{-1, 1} do
    area({side * 0.38 * w, y - 0.15 * d, side * 0.42 * w, y + 0.15 * d}, "deep", "detail")
    area({side * 0.44 * w, y - 0.11 * d, side * 0.47 * w, y + 0.11 * d}, "deep", "detail")
  end
end

function mesh.weights()
  -- a pair on the floor
  if h < 0.35 and w < 0.7 then
    local r = min(0.5 * h, 0.25 * smaller)
    local along_y = w > 1.4 * d
    for side in each{-1, 1} do
      dumbbell(along_y and vec(side * 0.25 * w, 0, r) or vec(0, side * 0.25 * d, r), along_y and d or w, r, along_y)
    end
    return
  end
  local post, r = min(0.03, 0.06 * smaller), min(0.08, 0.2 * d, 0.12 * h)
  local rows, count = clamp(floor(h / 0.32), 1, 4), clamp(floor(w / (2.6 * r)), 1, 8)
  for side in each{-1, 1} do
    local x = side * (w / 2 - post)
    box("hard", {x - post, -d / 2, 0}, {x + post, d / 2, 2 * post}, 0.006)
    taper("hard", {x, 0.2 * d, post}, {post, 1.4 * post}, {x, -0.4 * d, h - r}, {post, 1.2 * post})
  end
  for row = 0, rows - 1 do
    local t = (row + 0.7) / (rows + 0.3)
    local z, y = t * (h - 1.8 * r), d * (0.22 - 0.42 * t)
    inside(turned_x({0, y, z}, -0.28), function()
      box("hard", {-w / 2 + post, -0.24 * d, -post}, {w / 2 - post, 0.24 * d, 0}, 0.004)
      for i = 0, count - 1 do
        local x = (w - 3 * post) * ((i + 0.5) / count - 0.5)
        dumbbell(vec(x, 0, 0.8 * r), 0.5 * d, r * (0.7 + 0.3 * (rows - row) / rows), true)
      end
    end)
  end
end

-- Dumbbells in a rack, side by side.
function plan.weights()
  area(whole, "light", "outline", 0.02)
  local count = clamp(floor(w / 0.17), 2, 12)
  for i = 0, count - 1 do
    local x, half = left + w * (i + 0.5) / count, 0.32 * w / count
    segment({x, 0.6 * back}, {x, 0.6 * front}, "outline")
    for side in each{-1, 1} do
      area({x - half, side * 0.36 * d, x + half, side * 0.16 * d}, "deep", "detail", 0.02)
    end
  end
end

function mesh.punching_bag()
  local r = 0.36 * smaller
  lathe("soft", {0, 0, 0.3 * h}, {{0.8 * r, 0}, {r, 0.03 * h}, {r, 0.55 * h}, {0.9 * r, 0.6 * h}, {0.4 * r, 0.66 * h},
      {0.1 * r, 0.7 * h}}, 24)
  ring("metal", {0, 0, 0.8 * h}, {{0.98 * r, 0}, {1.02 * r, 0}, {1.02 * r, 0.03 * h}, {0.98 * r, 0.03 * h}}, 24)
  bar("metal", {0, 0, 0.1 * h}, {0, 0, 0.34 * h}, 0.2 * r, 12)
  lathe("hard", {}, {{0.5, 0}, {0.5, 0.06 * h}, {0.4, 0.1 * h}, {0.12, 0.13 * h}}, 26, {w, d})
end
