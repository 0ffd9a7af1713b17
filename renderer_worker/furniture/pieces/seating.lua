-- SPDX-License-Identifier: GPL-3.0-or-later
-- Sofas and what is upholstered.

local function shape_of()
  local seat = rest
  return { arm = min(0.2, 0.16 * w), back = min(0.24, 0.27 * d), seat = seat, base = min(0.12, 0.3 * seat),
      arm_height = min(h, seat + 0.45 * (h - seat)) }
end

-- Frame with arms and back on short legs; cushions come on top.
local function carcass(s, rolled)
  local x, y, soft = w / 2, d / 2, min(0.05, 0.3 * s.arm)
  legs_at("hard", x - min(0.07, 0.1 * w), y - min(0.07, 0.1 * d), s.base + 0.01, min(0.028, 0.04 * smaller), 0.6)
  local deck = max(s.base + 0.02, s.seat - min(0.16, 0.4 * s.seat))
  cushion("soft", {-x + 0.6 * s.arm, -y + 0.5 * s.back, s.base}, {x - 0.6 * s.arm, y - 0.03 * d, deck}, soft)
  cushion("soft", {-x + 0.02 * w, -y, s.base}, {x - 0.02 * w, -y + s.back, h}, soft, 0.01)
  for side in each{-1, 1} do
    local inner, outer = side * (x - s.arm), side * x
    local top = rolled and s.arm_height - 0.45 * s.arm or s.arm_height
    cushion("soft", {inner, -y, s.base}, {outer, y, top}, soft)
    if not rolled then goto continue end
    inside(facing_front({side * (x - 0.5 * s.arm), -y, s.arm_height - 0.55 * s.arm}), function()
      cylinder("soft", {}, 0.55 * s.arm, d, 0.02, 18)
      cylinder("accent", {0, 0, 0.985 * d}, 0.3 * s.arm, 0.02 * d, 0.004, 14)
    end)
    ::continue::
  end
end

-- Cushions side by side: on the seat and against the back.
local function seat_cushions(s, count)
  local left, pitch = -w / 2 + s.arm, (w - 2 * s.arm) / count
  local gap = min(0.006, 0.02 * pitch)
  local deck, rounding = max(s.base + 0.02, s.seat - min(0.16, 0.4 * s.seat)), min(0.045, 0.2 * pitch)
  local thick = min(0.2, 0.6 * s.back + 0.06 * d)
  for i = 0, count - 1 do
    local from = left + pitch * i + gap
    local to = from + pitch - 2 * gap
    cushion("soft", {from, -d / 2 + s.back, deck}, {to, d / 2, s.seat}, rounding, 0.012)
    inside(turned_x({0, -d / 2 + 0.9 * s.back, s.seat - 0.02 * h}, 0.13), function()
      cushion("soft", {from, 0, 0}, {to, thick, 0.98 * (h - s.seat)}, rounding, 0.035)
    end)
  end
end

local function scatter_cushion(at, size, lean, turn, material)
  inside(turned_z(at, turn), function()
    inside(turned_x({}, lean), function()
      pillow(material, {-size / 2, 0, 0}, {size / 2, 0.36 * size, size})
    end)
  end)
end

function mesh.sofa()
  local s = shape_of()
  carcass(s, says("chesterfield", "victorian", "classic", "rolled"))
  local count = clamp(round((w - 2 * s.arm) / 0.68), 1, 6)
  seat_cushions(s, count)
  if w < 1 then return end
  local size, front = min(0.42, 0.8 * (h - s.seat)), -d / 2 + s.back + 0.12 * d
  scatter_cushion(vec(-w / 2 + s.arm + 0.62 * size, front, s.seat), size, 0.3, 0.25, "accent")
  scatter_cushion(vec(w / 2 - s.arm - 0.62 * size, front, s.seat), 0.92 * size, 0.3, -0.3, "pale")
end

function plan.sofa()
  local arm = min(0.2, 0.12 * w)
  local backrest = min(0.22, 0.26 * d)
  area(whole, "dark", "outline", 0.08)
  local seat_left, seat_right = left + arm, right - arm
  local cushions = max(1, round((seat_right - seat_left) / 0.68))
  local pitch = (seat_right - seat_left) / cushions
  for i = 0, cushions - 1 do
    local x0 = seat_left + i * pitch
    local x1 = x0 + pitch
    area({x0, back + backrest, x1, front - 0.015}, "light", "detail", 0.06)
    area({x0 + 0.015, back + 0.45 * backrest, x1 - 0.015, back + backrest + 0.08}, "body", "detail", 0.05)
  end
  area({left, back + 0.3 * backrest, seat_left, front}, "body", "detail", 0.07)
  area({seat_right, back + 0.3 * backrest, right, front}, "body", "detail", 0.07)
end

function mesh.armchair()
  local s = shape_of()
  s.arm = min(0.16, 0.2 * w)
  local winged = says("chesterfield", "wingback", "wing", "victorian", "gothic") or h > 1.05
  carcass(s, winged)
  seat_cushions(s, 1)
  if not winged then return end
  -- the wings
  for side in each{-1, 1} do
    cushion("soft", {side * (w / 2 - 0.6 * s.arm), -d / 2 + 0.5 * s.back, s.arm_height - 0.05 * h},
        {side * w / 2, -d / 2 + 0.42 * d, 0.97 * h}, 0.3 * s.arm, 0.01)
  end
end

function plan.armchair()
  local arm = min(0.15, 0.17 * w)
  local backrest = min(0.2, 0.24 * d)
  area(whole, "dark", "outline", 0.14)
  area({left + arm, back + backrest, right - arm, front - 0.015}, "light", "detail", 0.08)
  area({left, back + 0.5 * backrest, left + arm, front - 0.02}, "body", "detail", 0.07)
  area({right - arm, back + 0.5 * backrest, right, front - 0.02}, "body", "detail", 0.07)
  area({left + 0.7 * arm, back + 0.3 * backrest, right - 0.7 * arm, back + 1.25 * backrest}, "body", "detail", 0.07)
end

function mesh.daybed()
  local seat = rest
  local leg, head = 0.4 * seat, min(0.35, 0.3 * max(w, d))
  local along_x = w >= d
  legs_at("hard", w / 2 - 0.05 * w, d / 2 - 0.05 * d, leg + 0.01, min(0.03, 0.05 * smaller), 0.55)
  box("hard", {-w / 2, -d / 2, leg}, {w / 2, d / 2, leg + 0.25 * seat}, 0.012)
  cushion("soft", {-0.49 * w, -0.49 * d, 0.62 * seat}, {0.49 * w, 0.49 * d, seat}, 0.05, 0.015)
  -- A raised end to lean on, a back along half the length, a bolster.
  if along_x then
    cushion("soft", {-w / 2, -d / 2, leg}, {-w / 2 + 0.5 * head, d / 2, h}, 0.06, 0.02)
    cushion("soft", {-w / 2, -d / 2, leg}, {0.35 * w, -d / 2 + 0.18 * d, seat + 0.7 * (h - seat)}, 0.05, 0.015)
  else
    cushion("soft", {-w / 2, -d / 2, leg}, {w / 2, -d / 2 + 0.5 * head, h}, 0.06, 0.02)
  end
  local bolster = min(0.09, 0.3 * (h - seat) + 0.02)
  local length = 0.8 * (along_x and d or w)
  local at = along_x and vec(-w / 2 + 0.5 * head + bolster, 0, seat + 0.85 * bolster)
      or vec(0, -d / 2 + 0.5 * head + bolster, seat + 0.85 * bolster)
  local half = along_x and vec(0, length / 2, 0) or vec(length / 2, 0, 0)
  bar("accent", at - half, at + half, bolster, 16)
end

function plan.daybed()
  area(whole, "hard", "outline", 0.05)
  local frame = min(0.08, 0.1 * d)
  local mattress = rect(left + frame, back + frame, right - frame, front)
  area(mattress, "soft", "detail", 0.05)
  local cushion = min(0.42, 0.25 * w)
  for x in each{mattress.x0 + 0.03, mattress.x1 - 0.03 - cushion} do
    area({x, mattress.y0 + 0.03, x + cushion, mattress.y0 + 0.03 + 0.45 * cushion}, "pale", "detail", 0.07)
  end
  segment({mattress.x0 + 0.04, mattress.y1 - 0.07}, {mattress.x1 - 0.04, mattress.y1 - 0.07}, "faint")
end

function mesh.pouf()
  if w > 1.3 * d or d > 1.3 * w or says("storage") or says("rectangular") then
    legs_at("hard", 0.44 * w, 0.44 * d, 0.2 * h, min(0.025, 0.06 * smaller))
    cushion("soft", {-w / 2, -d / 2, 0.16 * h}, {w / 2, d / 2, 0.72 * h}, 0.03)
    cushion("soft", {-w / 2, -d / 2, 0.7 * h}, {w / 2, d / 2, h}, 0.05, 0.02)
    return
  end
  local side = arc({0.36, 0.5}, 0.14, 0.5, -pi / 2, pi / 2, 10)
  local profile = {}
  for point in each(side) do
    push(profile, {point[1], point[2] * h})
  end
  lathe("soft", {}, profile, 28, {w, d})
  -- seams
  for i = 0, 11 do
    local turn = pi / 6 * i
    local seam = {}
    for point in each(profile) do
      push(seam, {1.003 * w * point[1] * cos(turn), 1.003 * d * point[1] * sin(turn), point[2]})
    end
    tube("accent", seam, 0.006 * min(1, smaller / 0.4), 4)
  end
  ellipsoid("accent", {0, 0, 0.985 * h}, {0.06 * w, 0.06 * d, 0.03 * h}, 12, 4)
end

function plan.pouf()
  area(whole, "body", "outline", 0.32 * smaller)
  area(grown(whole, -0.09 * smaller), "light", "faint", 0.28 * smaller)
  for tip in each{vec(1, 1), vec(-1, 1), vec(1, -1), vec(-1, -1)} do
    segment({0.04 * tip[1], 0.04 * tip[2]}, {0.3 * w * tip[1], 0.3 * d * tip[2]}, "faint")
  end
  circle({0, 0}, 0.03, "dark")
end

function mesh.bean_bag()
  -- Sagging at the floor, sat in towards the front, gathered to a tuft at the top of its back.
  local round, up = 28, 12
  sheet("soft", round, up, function(u, v)
    local turn, swell = 2 * pi * u, sin(pi * min(1, 0.2 + 0.8 * v))
    local r = 0.5 * (v > 0.97 and 0.06 or swell^0.6 * (1 - 0.12 * v))
    local wrinkle = 1 + 0.025 * sin(7 * turn) * v
    local front = 0.5 + 0.5 * sin(turn)
    local sat = 0.3 * front * sin(pi * v) * v
    return vec(r * wrinkle * w * cos(turn), (r * wrinkle * sin(turn) - 0.16 * v * v) * d, (v - sat) * 0.94 * h)
  end, 0.02 * smaller)
  ellipsoid("accent", {0, -0.16 * d, 0.95 * h}, {0.05 * w, 0.05 * d, 0.05 * h}, 12, 6)
end

-- A sofa along the back, a long seat down the left side of its box.
function mesh.corner_sofa()
  local all, deep, wide = d, min(0.95, 0.6 * d), min(0.9, 0.4 * w)
  d = deep
  inside({{0, (deep - all) / 2, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, mesh.sofa)
  d = all
  local s = shape_of()
  box("soft", {-w / 2, -d / 2, s.base}, {wide - w / 2, d / 2, 0.65 * s.seat}, 0.03)
  cushion("soft", {s.arm - w / 2, deep - d / 2 - 0.05, 0.6 * s.seat}, {wide - w / 2, d / 2, s.seat}, 0.045, 0.012)
  cushion("soft", {-w / 2, -d / 2, s.base}, {s.arm - w / 2, d / 2, s.arm_height}, 0.05)
end

function plan.corner_sofa()
  local deep, wide, arm, backrest = min(0.95, 0.6 * d), min(0.9, 0.4 * w), min(0.2, 0.1 * w), min(0.24, 0.2 * d)
  shape({{left, back}, {right, back}, {right, back + deep}, {left + wide, back + deep}, {left + wide, front}, {left,
      front}},
      "dark")
  area({left + arm, back + backrest, left + wide, front - 0.02}, "light", "detail", 0.06)
  local cushions = max(1, round((w - wide - arm) / 0.7))
  for i = 0, cushions - 1 do
    local x0, pitch = left + wide + (w - wide - arm) * i / cushions, (w - wide - arm) / cushions
    area({x0, back + backrest, x0 + pitch, back + deep - 0.02}, "light", "detail", 0.06)
  end
  area({left, back, right, back + backrest}, "body", "detail", 0.07)
  area({left, back, left + arm, front}, "body", "detail", 0.07)
  area({right - arm, back, right, back + deep}, "body", "detail", 0.07)
end
