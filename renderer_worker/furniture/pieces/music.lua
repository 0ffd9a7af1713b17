-- SPDX-License-Identifier: GPL-3.0-or-later
-- Instruments and what sounds.

-- White keys with black ones on them; the player sits at +y.
local function keys(left, right, back, front, top)
  box("ivory", {left, back, top - 0.012}, {right, front, top}, 0.002)
  local octaves = clamp(floor((right - left) / 0.165), 1, 8)
  local white = (right - left) / (7 * octaves)
  for i = 1, 7 * octaves - 1 do
    local x = left + white * i
    local step = i % 7
    if step ~= 0 and step ~= 3 then
      box("black plastic", {x - 0.3 * white, back, top - 0.002}, {x + 0.3 * white, back + 0.62 * (front - back),
          top + 0.008}, 0.001)
    end
  end
end

function mesh.upright_piano()
  local key, body, board = min(0.68, 0.6 * h), 0.14 * d, min(0.03, 0.06 * d)
  box("hard", {-0.49 * w, -d / 2, 0.04 * h}, {0.49 * w, body, h - 0.03 * h}, 0.006)
  box("hard", {-w / 2, -d / 2, h - 0.035 * h}, {w / 2, body + board, h}, 0.008)
  box("hard", {-0.49 * w, body - 0.01, key - 3 * board}, {0.49 * w, d / 2, key - board}, 0.006)
  keys(-0.44 * w, 0.44 * w, body + 0.3 * board, d / 2 - 0.6 * board, key)
  for side in each{-1, 1} do
    box("hard", {side * 0.445 * w, body, key - board}, {side * w / 2, d / 2, key + 1.4 * board}, 0.008)
    taper("hard", {side * 0.47 * w, d / 2 - 1.4 * board, 0}, {0.9 * board, board},
        {side * 0.47 * w, d / 2 - 1.4 * board, key - 2 * board}, {1.1 * board, 1.1 * board})
    box("hard", {side * 0.43 * w, -d / 2, 0}, {side * w / 2, d / 2, 0.05 * h}, 0.006)
  end
  box("hard", {-0.3 * w, body, 0.72 * h}, {0.3 * w, body + 0.6 * board, 0.9 * h}, 0.004)
  for x in each{-0.1, 0.09} do
    box("paper", {x * w - 0.08 * w, body + 0.6 * board, 0.74 * h}, {x * w + 0.08 * w, body + 0.75 * board, 0.92 * h},
        0)
  end
  for x in each{-0.06, 0, 0.06} do
    box("metal", {x * w - 0.012, body, 0.05 * h}, {x * w + 0.012, body + 0.12 * d, 0.065 * h}, 0.004)
  end
end

-- A keyboard seen from above: white keys towards y1, black keys in twos and threes from y0.
local function plan_keys(x0, x1, y0, y1)
  area({x0, y0, x1, y1}, "pale", "detail")
  local key_depth = clamp(floor((x1 - x0) / 0.047), 7, 52)
  for i = 1, key_depth - 1 do
    local x = x0 + (x1 - x0) * i / key_depth
    segment({x, y0}, {x, y1}, "faint")
    if i % 7 == 3 or i % 7 == 0 then goto continue end
    local half = 0.28 * (x1 - x0) / key_depth
    area({x - half, y0, x + half, y0 + 0.58 * (y1 - y0)}, "deep", "none")
    ::continue::
  end
end

function plan.upright_piano()
  area(whole, "body", "outline", 0.01)
  local key_back = back + 0.52 * d
  area({left, back, right, back + 0.46 * d}, "dark", "detail")
  segment({0.5 * left, back + 0.4 * d}, {0.5 * right, back + 0.4 * d})
  plan_keys(0.9 * left, 0.9 * right, key_back, front - 0.08 * d)
end

function mesh.grand_piano()
  -- Keyboard at the front; the case narrows to a round tail at the back. The straight side is at the player's left
  -- (+x).
  local x, y, low, rim = w / 2, d / 2, min(0.72, 0.55 * h), min(1.02, 0.76 * h)
  local key_depth = min(0.3, 0.2 * d)
  local outline = {{x, y - key_depth}, {x, -0.55 * y}}
  for point in each(arc({x - 0.42 * w, -0.55 * y}, 0.42 * w, 0.45 * y, 0, -pi, 10)) do
    push(outline, point)
  end
  push(outline, {x - 0.86 * w, -0.2 * y})
  push(outline, {-0.44 * w, 0.05 * y})
  push(outline, {-x, 0.35 * y})
  push(outline, {-x, y - key_depth})
  reverse(outline)
  slab("hard", outline, low, rim, 0.008)
  local plate = scaled(outline, 0.9, 0.9)
  slab("metal", plate, rim - 0.01, rim + 0.003, 0.001)
  box("hard", {-x, y - key_depth, low}, {x, y, low + 0.35 * (rim - low)}, 0.008)
  for side in each{-1, 1} do
    box("hard", {side * x, y - key_depth, low}, {side * (x - 0.07 * w), y, low + 0.75 * (rim - low)}, 0.01)
  end
  keys(-x + 0.075 * w, x - 0.075 * w, y - 0.62 * key_depth, y - 0.05 * key_depth, low + 0.45 * (rim - low))
  -- The lid stands open along the straight side.
  local lift = atan(0.98 * (h - rim), w)
  inside({{x, 0, rim}, {cos(lift), 0, -sin(lift)}, {0, 1, 0}, {sin(lift), 0, cos(lift)}}, function()
    local lid = {}
    for point in each(outline) do
      push(lid, {(point[1] - x) * 0.99 / cos(lift), point[2]})
    end
    slab("hard", lid, 0.004, 0.03, 0.006)
  end)
  bar("hard", {-0.2 * w, 0.2 * y, rim}, {-0.3 * w, 0.2 * y, rim + 0.78 * (h - rim)}, 0.012, 8)
  local leg = min(0.05, 0.05 * smaller)
  for at in each{vec(-0.42 * w, 0.72 * y), vec(0.42 * w, 0.72 * y), vec(0.12 * w, -0.6 * y)} do
    lathe("hard", {at[1], at[2], 0}, {{0.8 * leg, 0}, {leg, 0.06 * low}, {0.7 * leg, 0.12 * low},
        {1.1 * leg, 0.85 * low}, {1.4 * leg, low + 0.005}}, 14)
  end
  box("metal", {-0.08 * w, 0.5 * y, 0.08 * low}, {0.08 * w, 0.62 * y, 0.12 * low}, 0.004)
  bar("hard", {0, 0.54 * y, 0.1 * low}, {0, 0.54 * y, low}, 0.03 * min(1, w), 8)
end

function plan.grand_piano()
  -- Keys at the front, the long bass side on the right, the curved rim on the left, as seen by somebody behind it.
  local y_key = front - min(0.3, 0.2 * d)
  local tail = right - 0.42 * w
  local rim = {{right, y_key}, {right, back + 0.05 * d}, {right - 0.08 * w, back}, {tail, back + 0.02 * d},
      {tail - 0.12 * w, back + 0.12 * d}, {tail - 0.17 * w, back + 0.3 * d}, {tail - 0.28 * w, back + 0.44 * d},
      {left + 0.08 * w, back + 0.55 * d}, {left, back + 0.68 * d}, {left, y_key}}
  shape(rim, "body")
  area({left, y_key, right, front}, "dark", "outline", 0.02)
  plan_keys(0.9 * left, 0.9 * right, y_key + 0.2 * (front - y_key), front - 0.02)
  segment({0.55 * left, y_key - 0.07}, {0.55 * right, y_key - 0.07})
  for i = 0, 5 do
    local x = right - 0.06 * w - 0.06 * w * i
    segment({x, back + 0.12 * d}, {x - 0.1 * w, y_key - 0.14}, "faint")
  end
end

function mesh.keyboard()
  local desk = h < 0.3
  local computer = desk and w < 0.6
  local low = desk and 0 or h - min(0.12, 0.3 * h)
  box("hard", {-w / 2, -d / 2, low}, {w / 2, d / 2, h - 0.12 * (h - low)}, 0.008)
  local top = h - 0.1 * (h - low)
  if computer then
    for row = 0, 3 do
      for i = 0, 11 do
        local x, y = w * (-0.46 + 0.077 * i), d * (-0.4 + 0.21 * row)
        box("white glaze", {x, y, top - 0.002}, {x + 0.066 * w, y + 0.17 * d, h}, 0.001)
      end
    end
    return
  end
  keys(-0.47 * w, 0.47 * w, -0.08 * d, 0.46 * d, h - 0.008)
  box("dark screen", {-0.12 * w, -0.42 * d, top - 0.004}, {0.12 * w, -0.2 * d, top + 0.004}, 0.001)
  if desk then return end
  for side in each{-1, 1} do
    local x, r = side * 0.32 * w, 0.016 * min(1, d / 0.3)
    bar("metal", {x, -0.42 * d, r}, {x, 0.42 * d, low}, r, 8)
    bar("metal", {x, 0.42 * d, r}, {x, -0.42 * d, low}, r, 8)
  end
end

function plan.keyboard()
  area(whole, "dark", "outline", 0.02)
  plan_keys(0.94 * left, 0.94 * right, 0.1 * back, 0.85 * front)
end

function mesh.drums()
  local s = smaller
  local function drum(centre, axis, r, length)
    local side = normalized(cross(abs(axis[2]) > 0.9 and vec(1, 0, 0) or vec(0, 1, 0), axis))
    inside({centre, side, cross(axis, side), axis}, function()
      cylinder("hard", {0, 0, -length / 2}, r, length, 0.004, 20)
      for z in each{-length / 2, length / 2} do
        ring("metal", {0, 0, z}, {{0.97 * r, -0.04 * r}, {1.04 * r, -0.04 * r}, {1.04 * r, 0.04 * r},
            {0.97 * r, 0.04 * r}}, 26)
        cylinder("ivory", {0, 0, z - 0.005 * s}, 0.97 * r, 0.01 * s, 0.001, 20)
      end
    end)
  end
  local function stand(top, foot)
    local r = 0.008 * s / 1.2
    bar("metal", {top[1], top[2], 0.12 * h}, top, r, 8)
    for i = 0, 2 do
      local turn = 2 * pi / 3 * i
      bar("metal", {top[1] + foot * cos(turn), top[2] + foot * sin(turn), r}, {top[1], top[2], 0.16 * h}, r, 6)
    end
  end
  drum(vec(0, -0.12 * d, 0.21 * s), vec(0, 1, 0), 0.21 * s, 0.34 * d)
  drum(vec(-0.13 * w, 0, 0.55 * h), normalized({0.15, 0.35, 1}), 0.12 * s, 0.16 * s)
  drum(vec(0.13 * w, 0, 0.55 * h), normalized({-0.15, 0.35, 1}), 0.13 * s, 0.17 * s)
  drum(vec(-0.28 * w, 0.2 * d, 0.46 * h), normalized({0, 0.1, 1}), 0.15 * s, 0.1 * s)
  drum(vec(0.3 * w, 0.18 * d, 0.32 * h), vec(0, 0, 1), 0.18 * s, 0.3 * s)
  stand(vec(-0.28 * w, 0.2 * d, 0.42 * h), 0.12 * s)
  for at in each{vec(-0.36 * w, -0.2 * d, 0.94 * h), vec(0.34 * w, -0.22 * d, h), vec(-0.4 * w, 0.3 * d, 0.72 * h)} do
    lathe("metal", at - vec(0, 0, 0.02 * h), {{0.155 * s, 0}, {0.155 * s, 0.003 * h}, {0.04 * s, 0.015 * h},
        {0, 0.02 * h}}, 26)
    stand(at - vec(0, 0, 0.015 * h), 0.1 * s)
  end
  cylinder("black plastic", {0.02 * w, 0.4 * d, 0.36 * h}, 0.13 * s, 0.07 * h, 0.015, 20)
  bar("metal", {0.02 * w, 0.4 * d, 0}, {0.02 * w, 0.4 * d, 0.37 * h}, 0.02 * s, 8)
end

function plan.drums()
  local r = smaller / 2
  local function drum(x, y, radius, tone)
    circle({x * w, y * d}, radius * r, tone, "outline")
    circle({x * w, y * d}, 0.82 * radius * r, "pale", "faint")
  end
  area({-0.36 * r, 0.02 * d, 0.36 * r, 0.46 * d}, "body", "outline", 0.05)
  drum(-0.16, 0, 0.3, "body")
  drum(0.16, 0, 0.3, "body")
  drum(-0.27, -0.2, 0.34, "light")
  drum(0.3, -0.18, 0.4, "body")
  for side in each{-1, 1} do
    circle({0.33 * side * w, 0.3 * d}, 0.32 * r, "fire")
    circle({0.33 * side * w, 0.3 * d}, 0.05 * r, "deep", "none")
  end
  circle({0, -0.36 * d}, 0.24 * r, "dark", "outline")
end

function mesh.guitar()
  local x, body, thick, lean = 0.42 * w, 0.45 * h, min(0.1, 0.35 * d), 0.16
  inside(turned_x({0, 0.12 * d, 0.05 * h}, lean), function()
    inside(facing_front({}), function()
      local outline = {}
      -- two bouts and a waist
      for i = 0, 35 do
        local turn = 2 * pi * i / 36 - pi / 2
        local up = (1 + sin(turn)) / 2
        local waist = 1 - 0.32 * exp(-30 * (up - 0.6) * (up - 0.6)) - 0.2 * up * up
        push(outline, {x * waist * cos(turn), body * up})
      end
      slab("hard", outline, -thick / 2, thick / 2, 0.006)
      cylinder("black plastic", {0, 0.62 * body, thick / 2 - 0.001}, 0.24 * x, 0.003, 0.001, 20)
      box("black plastic", {-0.1 * x, 0.5 * body, thick / 2 - 0.002}, {0.1 * x, 0.86 * h, thick / 2 + 0.012}, 0.003)
      box("black plastic", {-0.3 * x, 0.26 * body, thick / 2 - 0.001}, {0.3 * x, 0.31 * body, thick / 2 + 0.01},
          0.003)
      box("hard", {-0.17 * x, 0.84 * h, thick / 2 - 0.006}, {0.17 * x, 0.96 * h, thick / 2 + 0.01}, 0.004)
    end)
  end)
  local r = min(0.01, 0.05 * smaller)
  for side in each{-1, 1} do
    bar("black plastic", {side * 0.44 * w, d / 2 - r, r}, {0, -0.2 * d, 0.5 * h}, r, 8)
    bar("black plastic", {side * 0.3 * w, 0.2 * d, 0.06 * h}, {side * 0.3 * w, d / 2 - r, 0.08 * h}, r, 8)
  end
  bar("black plastic", {0, -d / 2 + r, r}, {0, -0.2 * d, 0.5 * h}, r, 8)
end

function plan.guitar()
  local w = w / 2
  area({-0.12 * w, back, 0.12 * w, front - 0.2 * d}, "dark", "detail")
  oval({0, front - 0.17 * d}, w, 0.17 * d, "body", "outline")
  oval({0, front - 0.36 * d}, 0.78 * w, 0.12 * d, "body", "outline")
  oval({0, front - 0.26 * d}, 0.6 * w, 0.1 * d, "body", "none")
  circle({0, front - 0.3 * d}, 0.26 * w, "deep")
end

function mesh.music_stand()
  local r, desk = min(0.014, 0.06 * smaller), 0.7 * h
  bar("hard", {0, 0, 0.12 * h}, {0, 0, 0.8 * h}, 1.2 * r, 10)
  for i = 0, 2 do
    local turn = pi / 2 + 2 * pi / 3 * i
    bar("hard", {0.45 * smaller * cos(turn), 0.45 * smaller * sin(turn), r}, {0, 0, 0.22 * h}, r, 8)
  end
  inside(turned_x({0, 0.2 * d, desk}, 0.5), function()
    local high = 0.9 * (h - desk)
    box("hard", {-w / 2, -r, 0}, {w / 2, 0, high}, 0.003)
    box("hard", {-w / 2, -r, 0}, {w / 2, 0.12 * d, r}, 0.002)
    for side in each{-1, 1} do
      box("paper", {side * 0.004, 0, r}, {side * 0.42 * w, 0.006, 0.9 * high}, 0.001)
    end
  end)
end

function plan.music_stand()
  for foot in each{vec(0, 0.45), vec(-0.4, -0.35), vec(0.4, -0.35)} do
    segment({0, 0}, {foot[1] * w, foot[2] * d}, "outline")
  end
  area({left, -0.16 * d, right, 0.16 * d}, "pale", "outline")
  for i = -1, 1 do
    segment({0.9 * left, 0.08 * i * d}, {0.9 * right, 0.08 * i * d}, "faint")
  end
end

function mesh.speaker()
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, 0.46 * d, h}, 0.008)
  local function cone(x, z, r)
    inside(facing_front({x, 0.46 * d, z}), function()
      ring("rubber", {}, {{0.8 * r, 0}, {r, 0}, {r, 0.03 * d}, {0.85 * r, 0.04 * d}}, 24)
      lathe("metal", {}, {{0.82 * r, 0}, {0.8 * r, 0.015 * d}, {0.35 * r, 0.002 * d}, {0, 0.02 * d}}, 20)
    end)
  end
  -- a sound bar
  if w > 1.6 * h then
    box("rubber", {-0.47 * w, 0.45 * d, 0.14 * h}, {0.47 * w, d / 2, 0.86 * h}, 0.004)
    return
  end
  cone(0, 0.32 * h, min(0.4 * w, 0.22 * h))
  if h > 1.6 * w then
    cone(0, 0.6 * h, min(0.34 * w, 0.12 * h))
  end
  cone(0, 0.82 * h, min(0.22 * w, 0.09 * h))
end

function plan.speaker()
  area(whole, "dark", "outline", 0.02)
  area({left, front - 0.16 * d, right, front}, "deep", "detail")
  circle({0, -0.06 * d}, 0.2 * smaller, "light")
end
