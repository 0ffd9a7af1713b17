-- SPDX-License-Identifier: GPL-3.0-or-later
-- Chairs, stools and benches.

local function seat_height()
  return rest
end

-- Legs, seat rails and an upholstered or wooden seat.
local function seat_on_legs(seat, leg, padded)
  local x, y, board = w / 2 - 1.3 * leg, d / 2 - 1.3 * leg, min(0.03, 0.08 * seat)
  for sx in each{-1, 1} do
    taper("hard", {sx * (w / 2 - leg), d / 2 - leg, 0}, {0.6 * leg, 0.6 * leg}, {sx * x, y, seat - board}, {leg, leg})
  end
  box("hard", {-x, -y, seat - 2.6 * board}, {x, y, seat - board}, 0.004)
  box("hard", {-0.49 * w, -0.47 * d, seat - board}, {0.49 * w, d / 2, seat}, 0.008)
  if padded then
    cushion("soft", {-0.47 * w, -0.42 * d, seat - 0.004}, {0.47 * w, 0.48 * d, seat + 1.5 * board}, 0.018, 0.008)
  end
end

-- Rear legs that go on as posts and lean back.
local function posts(seat, leg, top)
  for sx in each{-1, 1} do
    local x = sx * (w / 2 - 1.2 * leg)
    taper("hard", {x, -d / 2 + 1.5 * leg, 0}, {0.7 * leg, 0.7 * leg}, {x, -d / 2 + 2.4 * leg, seat}, {leg, leg})
    taper("hard", {x, -d / 2 + 2.4 * leg, seat - 0.01}, {leg, leg}, {x, -d / 2 + 0.8 * leg, top},
        {0.75 * leg, 0.75 * leg})
  end
end

function mesh.chair()
  local seat, leg = seat_height(), min(0.019, 0.06 * smaller)
  local above = h - seat
  local padded = not says("stone") and (not made_of("soft", "linen, soft") or says("upholstered") or says("cushion"))
  seat_on_legs(seat, leg, padded or says("dining"))
  posts(seat, leg, h)
  local back, x = -d / 2 + 1.2 * leg, w / 2 - 1.2 * leg
  if says("high chair") then
    slab("pale", rounded({-w / 2, 0.05 * d}, {w / 2, d / 2}, 0.06), seat + 0.4 * above, seat + 0.46 * above, 0.004)
  end
  box("hard", {-x, back - 0.8 * leg, h - 0.2 * above}, {x, back + 0.7 * leg, h - 0.01 * above}, 0.008)
  if says("upholstered", "velvet", "leather") then
    cushion("soft", {-0.92 * x, back, seat + 0.18 * above}, {0.92 * x, back + 3 * leg, h - 0.03 * above}, 0.02, 0.01)
    return
  end
  box("hard", {-x, back + 0.3 * leg, seat + 0.16 * above}, {x, back + 1.5 * leg, seat + 0.25 * above}, 0.004)
  -- slats
  for i = 0, 3 do
    local at, half = x * (-0.6 + 0.4 * i), 0.09 * x
    taper("hard", {at, back + 0.9 * leg, seat + 0.24 * above}, {half, 0.35 * leg}, {at, back, h - 0.19 * above},
        {half, 0.35 * leg})
  end
end

function plan.chair()
  local backrest = min(0.08, 0.17 * d)
  local taper = 0.06 * w
  local seat = {{left + taper, back + 0.4 * backrest}, {right - taper, back + 0.4 * backrest},
      {right - 0.2 * taper, front}, {left + 0.2 * taper, front}}
  shape(seat, "hard")
  local inset = 0.07 * smaller
  area({left + 1.4 * inset, back + backrest + inset, right - 1.4 * inset, front - inset}, "soft", "faint", 0.05)
  area({left, back, right, back + backrest}, "hard", "outline", 0.5 * backrest)
end

function mesh.office_chair()
  local seat, foot = rest / 1.04, 0.5 * smaller
  local wheel = min(0.03, 0.08 * seat)
  for i = 0, 4 do
    local turn = pi / 2 + 2 * pi / 5 * i
    local tip = vec((foot - wheel) * cos(turn), (foot - wheel) * sin(turn), 2.1 * wheel)
    bar("metal", {0, 0, 3.4 * wheel}, tip, 0.75 * wheel, 0.5 * wheel, 8)
    inside({tip - vec(0, 0, 1.1 * wheel), {cos(turn), sin(turn), 0}, {0, 0, 1}, {sin(turn), -cos(turn), 0}}, function()
      for z in each{-0.9, 0.2} do
        cylinder("rubber", {0, 0, z * wheel}, wheel, 0.7 * wheel, 0.004, 12)
      end
    end)
  end
  bar("metal", {0, 0, 2.8 * wheel}, {0, 0, 0.88 * seat}, 0.028 * min(1, w / 0.5), 12)
  box("black plastic", {-0.18 * w, -0.2 * d, 0.84 * seat}, {0.18 * w, 0.2 * d, 0.9 * seat}, 0.01)
  cushion("soft", {-0.4 * w, -0.34 * d, 0.88 * seat}, {0.4 * w, 0.42 * d, 1.04 * seat}, 0.03, 0.012)
  local back, above = -0.36 * d, h - seat
  box("black plastic", {-0.06 * w, back - 0.03 * d, 0.86 * seat}, {0.06 * w, back + 0.02 * d, seat + 0.5 * above},
      0.01)
  inside(turned_x({0, back, seat + 0.12 * above}, 0.1), function()
    sheet("soft", 8, 6, function(u, v)
      local x, wide = 2 * u - 1, w * (0.4 - 0.06 * v * v * v)
      return vec(-wide * x, 0.09 * d * x * x + 0.05 * d * sin(pi * v), 0.86 * above * v)
    end, 0.045 * min(1, d / 0.5))
  end)
  local arm = seat + 0.28 * above
  for side in each{-1, 1} do
    local x = side * 0.46 * w
    bar("black plastic", {side * 0.3 * w, 0, 0.88 * seat}, {x, 0, 0.92 * seat}, 0.014, 8)
    bar("black plastic", {x, 0, 0.9 * seat}, {x, 0, arm}, 0.014, 8)
    cushion("black plastic", {x - 0.04 * w, -0.2 * d, arm}, {x + 0.04 * w, 0.24 * d, arm + 0.03}, 0.012)
  end
end

function plan.office_chair()
  -- The five-star base, the seat, the curved back and two arm rests.
  local r = smaller / 2
  for i = 0, 4 do
    local angle = pi / 2 + 2 * pi * i / 5
    local tip = vec(0.9 * r * cos(angle), 0.9 * r * sin(angle))
    segment({0, 0}, tip, "outline")
    circle(tip, 0.1 * r, "deep", "none")
  end
  area({-0.72 * r, -0.66 * r, 0.72 * r, 0.74 * r}, "light", "outline", 0.3 * r)
  area({-0.98 * r, -0.4 * r, -0.76 * r, 0.36 * r}, "dark", "detail", 0.1 * r)
  area({0.76 * r, -0.4 * r, 0.98 * r, 0.36 * r}, "dark", "detail", 0.1 * r)
  area({-0.78 * r, -1 * r, 0.78 * r, -0.68 * r}, "body", "outline", 0.16 * r)
end

function mesh.rocking_chair()
  local seat, leg = seat_height(), min(0.02, 0.05 * smaller)
  local above = h - seat
  for side in each{-1, 1} do
    local x = side * (w / 2 - leg)
    local runner = {}
    for i = 0, 12 do
      local y = -1 + i / 6
      push(runner, {x, 0.5 * d * y, leg + 0.16 * seat * y * y})
    end
    tube("hard", runner, leg, 8)
    for y in each{-0.28, 0.3} do
      bar("hard", {x, y * d, 0.05 * seat}, {x, 0.92 * y * d, seat + 0.34 * above}, leg, 8)
    end
    box("hard", {x - 1.6 * leg, -0.3 * d, seat + 0.32 * above}, {x + leg, 0.4 * d, seat + 0.37 * above}, 0.006)
  end
  box("hard", {-w / 2 + leg, -0.3 * d, 0.9 * seat}, {w / 2 - leg, 0.38 * d, 0.96 * seat}, 0.01)
  cushion("soft", {-0.42 * w, -0.28 * d, 0.95 * seat}, {0.42 * w, 0.37 * d, 1.08 * seat}, 0.025, 0.01)
  inside(turned_x({0, -0.3 * d, 0.92 * seat}, 0.2), function()
    for i = 0, 6 do
      local x = w * (-0.39 + 0.13 * i)
      bar("hard", {x, 0, 0}, {x, 0, above}, (i == 0 or i == 6) and leg or 0.6 * leg, 8)
    end
    box("hard", {-0.42 * w, -leg, 0.94 * above}, {0.42 * w, leg, 1.1 * above}, 0.01)
  end)
end

function plan.rocking_chair()
  local runner = 0.1 * w
  area({left, back, left + runner, front}, "dark", "detail", 0.5 * runner)
  area({right - runner, back, right, front}, "dark", "detail", 0.5 * runner)
  local y0, y1 = back + 0.12 * d, front - 0.14 * d
  area({left + 0.5 * runner, y0, right - 0.5 * runner, y1}, "soft", "outline", 0.08)
  local backrest = 0.13 * d
  area({left + 0.5 * runner, y0, right - 0.5 * runner, y0 + backrest}, "body", "outline", 0.04)
  for i = 1, 5 do
    local x = left + w * i / 6
    segment({x, y0}, {x, y0 + backrest}, "faint")
  end
end

function mesh.stool()
  local leg, top = min(0.018, 0.06 * smaller), min(0.05, 0.12 * h)
  local stump = made_of("hard", "bark") or says("stump") or says("log")
  if stump then
    lathe("hard", {}, {{0.5, 0}, {0.45, 0.2 * h}, {0.44, 0.9 * h}, {0.46, h - 0.01}}, 18, {w, d})
    lathe("pine", {0, 0, h - 0.012}, {{0.43, 0}, {0.43, 0.012}}, 18, {w, d})
    return
  end
  round_legs_at("hard", 0.26 * w, 0.26 * d, h - top, 1.2 * leg, 0.1 * smaller)
  local circlet = 0.3 * h
  for side in each{-1, 1} do
    bar("hard", {-0.33 * w, side * 0.33 * d, circlet}, {0.33 * w, side * 0.33 * d, circlet}, 0.7 * leg, 8)
    bar("hard", {side * 0.33 * w, -0.33 * d, circlet}, {side * 0.33 * w, 0.33 * d, circlet}, 0.7 * leg, 8)
  end
  lathe("hard", {0, 0, h - top}, {{0.46, 0}, {0.5, 0.3 * top}, {0.5, 0.6 * top}, {0.47, 0.7 * top}}, 24, {w, d})
  lathe("soft", {0, 0, h - 0.35 * top}, {{0.47, 0}, {0.47, 0.15 * top}, {0.4, 0.3 * top}, {0.2, 0.35 * top}}, 24,
      {w, d})
end

function plan.stool()
  oval({0, 0}, w / 2, d / 2, "hard", "outline")
  oval({0, 0}, 0.4 * w, 0.4 * d, "soft", "faint")
end

function mesh.bench()
  local seat, leg = rest, min(0.03, 0.08 * smaller)
  local board = min(0.05, 0.12 * seat)
  if made_of("hard", "stone") or made_of("hard", "marble") then
    for side in each{-1, 1} do
      taper("hard", {side * 0.36 * w, 0, 0}, {0.07 * w, 0.44 * d}, {side * 0.36 * w, 0, seat - board},
          {0.05 * w, 0.36 * d})
    end
    box("hard", {-w / 2, -d / 2, seat - 1.3 * board}, {w / 2, d / 2, seat}, 0.015)
  elseif says("storage", "blanket") then
    box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2 - 0.02 * d, seat - 2 * board}, 0.006)
    for side in each{-1, 1} do
      panel("hard", {side > 0 and 0.01 * w or -0.48 * w, 0.08 * seat},
          {side > 0 and 0.48 * w or -0.01 * w, seat - 2.3 * board}, 0.48 * d - 0.005, 0.012, true)
    end
    cushion("soft", {-w / 2, -d / 2, seat - 2 * board}, {w / 2, d / 2, seat}, 0.03, 0.01)
  else
    legs_at("hard", w / 2 - 0.06 * w - leg, d / 2 - 2 * leg, seat - board, leg, 0.7, 0.8 * leg)
    box("hard", {-0.42 * w, -0.3 * d, seat - 2.4 * board}, {0.42 * w, 0.3 * d, seat - board}, 0.004)
    box("hard", {-w / 2, -d / 2, seat - board}, {w / 2, d / 2, seat - 0.3 * board}, 0.01)
    cushion("soft", {-0.49 * w, -0.48 * d, seat - 0.35 * board}, {0.49 * w, 0.48 * d, seat + 0.4 * board}, 0.02,
        0.008)
  end
  if seat == h then return end
  for x in each{-0.46, 0, 0.46} do
    taper("hard", {x * w, -d / 2 + 2 * leg, seat - board}, {leg, leg}, {x * w, -d / 2 + leg, h},
        {0.7 * leg, 0.7 * leg})
  end
  for z in each{0.45, 0.8} do
    box("hard", {-w / 2, -d / 2 + leg, seat + (z - 0.1) * (h - seat)},
        {w / 2, -d / 2 + 2.2 * leg, seat + (z + 0.16) * (h - seat)}, 0.008)
  end
end

function plan.bench()
  area(whole, "hard", "outline", 0.03)
  area(grown(whole, -0.06 * smaller), "soft", "faint", 0.04)
  local slots = max(2, floor(w / 0.4))
  for i = 1, slots - 1 do
    local x = left + w * i / slots
    circle({x, 0}, 0.018, "dark", "faint")
  end
end

function mesh.throne()
  local seat, post = rest, min(0.05, 0.08 * w)
  local above = h - seat
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, d / 2, 0.18 * seat}, 0.012)
  box("hard", {-0.45 * w, -0.46 * d, 0.17 * seat}, {0.45 * w, 0.44 * d, 0.82 * seat}, 0.01)
  cushion("soft", {-0.4 * w, -0.38 * d, 0.8 * seat}, {0.4 * w, 0.45 * d, seat}, 0.04, 0.015)
  local gable = {{-0.44 * w, 0}, {0.44 * w, 0}, {0.44 * w, 0.7 * above}, {0, 0.97 * above}, {-0.44 * w, 0.7 * above}}
  inside({{0, -0.36 * d, 0.8 * seat}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, function()
    slab("hard", gable, 0, 0.1 * d, 0.012)
    local padded = gable
    for i, point in ipairs(padded) do
      padded[i] = vec(0.74 * point[1], 0.1 * above + 0.78 * point[2])
    end
    slab("soft", padded, -0.035, 0.02, 0.03)
  end)
  for side in each{-1, 1} do
    local x = side * (w / 2 - post)
    box("hard", {x - post, -d / 2, 0.15 * seat}, {x + post, -d / 2 + 2 * post, seat + 0.8 * above}, 0.01)
    ellipsoid("metal", {x, -d / 2 + post, seat + 0.8 * above + post}, {post, post, 1.3 * post}, 12, 8)
    box("hard", {x - post, d / 2 - 2.4 * post, 0.15 * seat}, {x + post, d / 2 - 0.2 * post, seat + 0.26 * above},
        0.008)
    box("hard", {x - 1.1 * post, -0.45 * d, seat + 0.24 * above}, {x + 1.1 * post, d / 2, seat + 0.32 * above}, 0.014)
    ellipsoid("metal", {x, d / 2 - post, seat + 0.34 * above}, {post, post, post}, 12, 6)
  end
  ellipsoid("metal", {0, -0.4 * d, h - 0.04 * above}, {0.06 * w, 0.04 * d, 0.06 * above}, 12, 8)
end

function plan.throne()
  local backrest, arm = 0.2 * d, 0.17 * w
  area({left, back + 0.5 * backrest, right, front}, "hard", "outline", 0.03)
  -- A back with three points, seen from above as a crown.
  local y0, y1 = back, back + backrest
  local crown = {{left, y1}, {left, y0}, {0.6 * left, y0 + 0.5 * backrest}, {0.28 * left, y0},
      {0, y0 + 0.45 * backrest}, {0.28 * right, y0}, {0.6 * right, y0 + 0.5 * backrest}, {right, y0}, {right, y1}}
  shape(crown, "body")
  area({left + arm, y1, right - arm, front - 0.02}, "soft", "detail", 0.05)
  for side in each{left + arm / 2, right - arm / 2} do
    circle({side, front - 0.55 * arm}, 0.36 * arm, "body")
    circle({side, y1 + 0.5 * arm}, 0.2 * arm, "body")
  end
  circle({0, y1 + 0.5 * (front - y1)}, 0.09 * smaller, "body")
end
