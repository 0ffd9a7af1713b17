-- SPDX-License-Identifier: GPL-3.0-or-later
-- Tables and desks.

local function top_thickness()
  return min(0.032, 0.12 * h, 0.2 * smaller)
end

local function leg_half(usual)
  return min(usual, 0.05 * smaller)
end

local function is_round()
  return says("round", "oval", "circular")
end

local function rectangular_top(thick)
  local low, high = vec(-w / 2, -d / 2), vec(w / 2, d / 2)
  slab("hard", rounded(low, high, 0.02), h - thick, h, 0.005)
end

-- A table top on four legs with an apron.
local function four_legs(leg, apron)
  local thick, rail, x, y = top_thickness(), min(0.09, 0.16 * h), w / 2 - 1.8 * leg, d / 2 - 1.8 * leg
  rectangular_top(thick)
  local metal = says("metal legs", "steel legs", "hairpin", "metal frame", "industrial")
  local legs = metal and "metal" or "hard"
  legs_at(legs, x, y, h - thick, metal and 0.7 * leg or leg, metal and 1 or 0.62)
  if not apron then return end
  local inset = 0.55 * leg
  for side in each{-1, 1} do
    box(legs, {-x, side * y - inset, h - thick - rail}, {x, side * y + inset, h - thick}, 0.003)
    box(legs, {side * x - inset, -y, h - thick - rail}, {side * x + inset, y, h - thick}, 0.003)
  end
end

-- A round or oval top on a turned pedestal with a spreading foot.
local function pedestal()
  local thick, r, foot = top_thickness(), min(0.06, 0.09 * smaller), min(0.34, 0.33 * smaller)
  slab("hard", ellipse({}, w / 2, d / 2, 40), h - thick, h, 0.007)
  slab("hard", ellipse({}, 0.36 * w, 0.36 * d, 32), h - 1.9 * thick, h - thick, 0.003)
  lathe("hard", {}, {{foot, 0}, {foot, 0.02 * h}, {0.8 * foot, 0.05 * h}, {0.5 * foot, 0.08 * h}, {r, 0.16 * h},
      {0.8 * r, 0.3 * h}, {1.25 * r, 0.5 * h}, {0.75 * r, 0.72 * h}, {r, 0.86 * h}, {2.4 * r, h - 1.8 * thick}}, 24)
end

-- Drawers side by side in [left, right], below `top`.
local function drawers(left, right, bottom, top, count, rows)
  local wide, high = (right - left) / count, (top - bottom) / rows
  for row = 0, rows - 1 do
    for i = 0, count - 1 do
      local x, z, gap = left + wide * i, bottom + high * row, min(0.004, 0.03 * high)
      panel("hard", {x + gap, z + gap}, {x + wide - gap, z + high - gap}, d / 2 - 0.03, 0.016)
      knob({x + wide / 2, d / 2 - 0.015, z + high / 2}, min(0.011, 0.12 * high))
    end
  end
end

function mesh.round_table()
  pedestal()
end

function plan.round_table()
  oval({0, 0}, w / 2, d / 2, "body", "outline")
  oval({0, 0}, 0.45 * w, 0.45 * d, "light", "faint")
  oval({0, 0}, 0.12 * w, 0.12 * d, "none", "faint")
end

function mesh.coffee_table()
  local leg, thick = leg_half(0.024), top_thickness()
  if is_round() then
    slab("hard", ellipse({}, w / 2, d / 2, 36), h - thick, h, 0.006)
    for i = 0, 3 do
      local turn = pi / 4 + pi / 2 * i
      local x, y = cos(turn), sin(turn)
      bar("hard", {0.42 * w * x, 0.42 * d * y, 0}, {0.34 * w * x, 0.34 * d * y, h - thick}, 0.5 * leg, leg, 10)
    end
    slab("hard", ellipse({}, 0.33 * w, 0.33 * d, 30), 0.32 * h, 0.32 * h + 0.6 * thick, 0.004)
  else
    four_legs(leg, false)
    box("hard", {-0.46 * w, -0.43 * d, 0.3 * h}, {0.46 * w, 0.43 * d, 0.3 * h + 0.6 * thick}, 0.004)
  end
  if smaller < 0.35 then return end
  -- books below, nothing above: others may stand there
  local size = min(0.26, 0.3 * smaller)
  book({-0.24 * w, -size / 2, 0.3 * h + 0.55 * thick}, {-0.24 * w + size, size / 2, 0.3 * h + 0.55 * thick + 0.03}, 3)
end

function plan.coffee_table()
  local radius = min(0.08, 0.2 * smaller)
  area(whole, "body", "outline", radius)
  area(grown(whole, -0.1 * smaller), "light", "detail", 0.7 * radius)
end

function mesh.table()
  if is_round() then
    pedestal()
  else
    four_legs(leg_half(0.036), true)
  end
end

-- Faint lines of wood grain along the longer side of `box`.
local function plan_grain(block)
  local wide = block.width >= block.height
  local length, across = wide and block.width or block.height, wide and block.height or block.width
  local lines = clamp(floor(across / 0.14), 2, 7)
  for i = 1, lines - 1 do
    local at = across * i / lines
    local start, tip = length * (0.06 + 0.05 * (i * 5 % 3)), length * (0.94 - 0.06 * (i * 7 % 4))
    if wide then
      segment({block.x0 + start, block.y0 + at}, {block.x0 + tip, block.y0 + at}, "faint")
    else
      segment({block.x0 + at, block.y0 + start}, {block.x0 + at, block.y0 + tip}, "faint")
    end
  end
end

function plan.table()
  area(whole, "body", "outline", 0.03)
  local top = grown(whole, -min(0.05, 0.08 * smaller))
  area(top, "light", "faint", 0.02)
  plan_grain(top)
end

function mesh.side_table()
  if is_round() or says("pedestal") or abs(w - d) < 0.02 * w and not says("drawer") and chance(7) < 0.5 then
    pedestal()
    return
  end
  local leg, thick = leg_half(0.02), top_thickness()
  four_legs(leg, true)
  box("hard", {-w / 2 + 1.5 * leg, -d / 2 + 1.5 * leg, 0.25 * h},
      {w / 2 - 1.5 * leg, d / 2 - 1.5 * leg, 0.25 * h + 0.7 * thick}, 0.003)
end

function mesh.nightstand()
  local thick, foot, leg, open = top_thickness(), min(0.12, 0.22 * h), leg_half(0.02), 0.42 * h
  rectangular_top(thick)
  legs_at("hard", w / 2 - 2 * leg, d / 2 - 2.4 * leg, foot + 0.01, leg, 0.6, 0.6 * leg)
  local side, x, y = min(0.02, 0.06 * w), w / 2 - 0.02 * w, d / 2 - 0.03
  for s in each{-1, 1} do
    box("hard", {s * x, -d / 2 + 0.01 * d, foot}, {s * (x - side), y, h - thick}, 0.003)
  end
  box("hard", {-x, -d / 2 + 0.01 * d, foot}, {x, y, foot + side}, 0.003)
  box("hard", {-x, -d / 2 + 0.01 * d, foot}, {x, -d / 2 + 0.01 * d + side, h - thick}, 0.003)
  box("hard", {-x, -d / 2 + 0.01 * d, open + 0.12 * h}, {x, y, h - thick}, 0.003)
  drawers(-x + side, x - side, open + 0.12 * h, h - 1.2 * thick, 1, 1)
  if w < 0.25 then return end
  book({-0.25 * w, -0.2 * d, foot + side}, {0.2 * w, 0.2 * d, foot + side + 0.035}, 1)
  book({-0.2 * w, -0.2 * d, foot + side + 0.036}, {0.18 * w, 0.16 * d, foot + side + 0.06}, 5)
end

function plan.nightstand()
  area(whole, "light", "outline", 0.02)
  local lip = min(0.05, 0.12 * d)
  area({left, front - lip, right, front}, "dark", "detail")
  area({-0.05, front - 0.25 * lip, 0.05, front}, "deep", "none")
end

function mesh.desk()
  local thick, leg, unit = top_thickness(), leg_half(0.024), min(0.42, 0.34 * w)
  local apron = min(0.12, 0.18 * h)
  rectangular_top(thick)
  local legs = says("metal", "industrial") and "metal" or "hard"
  legs_at(legs, w / 2 - 2 * leg, d / 2 - 2 * leg, h - thick, leg, 0.65)
  local y = d / 2 - 0.03
  box("hard", {-w / 2 + 2 * leg, -d / 2 + leg, h - thick - apron}, {w / 2 - 2 * leg, y, h - thick}, 0.004)
  -- Drawers under the right end of someone who sits at its front and looks over it: at -x.
  if w > 0.9 and not says("writing") and not says("simple") then
    box("hard", {-w / 2 + 0.02 * w, -d / 2 + leg, 0.14 * h}, {-w / 2 + unit, y, h - thick}, 0.004)
    drawers(-w / 2 + 0.02 * w, -w / 2 + unit, 0.14 * h, h - 1.3 * thick, 1, 3)
    drawers(-w / 2 + unit, w / 2 - 2.5 * leg, h - thick - apron, h - 1.3 * thick, 1, 1)
  else
    drawers(-w / 2 + 2.5 * leg, w / 2 - 2.5 * leg, h - thick - apron, h - 1.3 * thick, w > 0.7 and 2 or 1, 1)
  end
end

function plan.desk()
  area(whole, "light", "outline", 0.02)
  plan_grain(grown(whole, -0.03))
  -- A blotter where one sits, drawers below at the left.
  local half = min(0.3, 0.27 * w)
  local near = front - 0.06 * d
  local far = near - min(0.36, 0.52 * d)
  area({-half, far, half, near}, "body", "detail", 0.015)
  local lip = min(0.03, 0.05 * d)
  segment({left, front - lip}, {-half - 0.03, front - lip})
  segment({half + 0.03, front - lip}, {right, front - lip})
end

function mesh.vanity()
  local top, back = rest, -d / 2
  local thick, leg, apron = min(0.032, 0.12 * top, 0.2 * smaller), leg_half(0.022), 0.2 * top
  slab("hard", rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.04), top - thick, top, 0.006)
  legs_at("hard", w / 2 - 2.2 * leg, d / 2 - 2.2 * leg, top - thick, leg, 0.5)
  box("hard", {-w / 2 + 2 * leg, back + leg, top - thick - apron}, {w / 2 - 2 * leg, d / 2 - 0.03, top - thick},
      0.004)
  drawers(-w / 2 + 2 * leg, w / 2 - 2 * leg, top - thick - apron, top - 1.2 * thick, 3, 1)
  if top == h then return end
  local rx, rz = min(0.36 * w, 0.4), (h - top) / 2
  inside({{0, back + 0.02, top + rz}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}, function()
    slab("hard", ellipse({}, rx, rz, 36), -0.015, 0.02, 0.006)
    slab("mirror", ellipse({}, 0.9 * rx, 0.9 * rz, 36), -0.019, 0, 0.002)
  end)
end

function plan.vanity()
  area(whole, "light", "outline", 0.03)
  local lip = min(0.04, 0.1 * d)
  segment({left, front - lip}, {right, front - lip})
  oval({0, back + 0.16 * d}, 0.32 * w, 0.1 * d, "glass")
  circle({0.34 * w, 0.12 * d}, 0.035, "body")
  circle({0.25 * w, 0.05 * d}, 0.022, "dark")
end

function mesh.workbench()
  local leg, thick = leg_half(0.045), min(0.07, 0.12 * h)
  slab("hard", rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.015), h - thick, h, 0.008)
  legs_at("hard", w / 2 - 2 * leg, d / 2 - 2 * leg, h - thick, leg, 1)
  box("hard", {-w / 2 + leg, -d / 2 + leg, 0.2 * h}, {w / 2 - leg, d / 2 - leg, 0.2 * h + 0.5 * thick}, 0.004)
  box("hard", {-w / 2 + 2 * leg, -d / 2 + leg, h - 2.6 * thick}, {w / 2 - 2 * leg, d / 2 - 0.03, h - thick}, 0.004)
  drawers(-w / 2 + 3 * leg, w / 2 - 3 * leg, h - 2.6 * thick, h - 1.1 * thick, clamp(floor(w / 0.5), 1, 5), 1)
  -- boxes below
  for i = 0, clamp(floor(w / 0.45), 1, 5) - 1 do
    local x = -0.4 * w + 0.22 * w * i + 0.02 * w
    box(cover(i + 3), {x, -0.3 * d, 0.2 * h + 0.5 * thick}, {x + 0.16 * w, 0.25 * d, (0.34 + 0.1 * chance(i)) * h},
        0.006)
  end
end

function plan.workbench()
  area(whole, "body", "outline", 0.01)
  local planks = clamp(floor(d / 0.16), 2, 8)
  for i = 1, planks - 1 do
    local y = back + d * i / planks
    segment({left, y}, {right, y}, "detail")
  end
  -- The vice on the front edge.
  local vice = min(0.2, 0.15 * w)
  local x = right - 1.3 * vice
  area({x - vice / 2, front - 0.7 * vice, x + vice / 2, front}, "metal", "detail")
  segment({x - vice / 2, front - 0.3 * vice}, {x + vice / 2, front - 0.3 * vice})
end

function mesh.pool_table()
  local rim, thick, leg = min(0.1, 0.08 * smaller), 0.22 * h, min(0.08, 0.08 * smaller)
  legs_at("hard", w / 2 - 2 * leg, d / 2 - 2 * leg, h - thick, leg, 0.6)
  box("hard", {-0.47 * w, -0.47 * d, h - thick}, {0.47 * w, 0.47 * d, h - 0.06 * h}, 0.01)
  box("soft", {-w / 2 + 0.6 * rim, -d / 2 + 0.6 * rim, h - 0.08 * h},
      {w / 2 - 0.6 * rim, d / 2 - 0.6 * rim, h - 0.04 * h}, 0)
  for side in each{-1, 1} do
    box("hard", {-w / 2, side * d / 2, h - 0.4 * thick}, {w / 2, side * (d / 2 - rim), h}, 0.012)
    box("hard", {side * w / 2, -d / 2, h - 0.4 * thick}, {side * (w / 2 - rim), d / 2, h}, 0.012)
  end
  local r = min(0.03, 0.03 * smaller)
  local along_x = w > d
  for a in each{-1, 1} do
    for b in each{-1, 0, 1} do
      local x = along_x and b * (w / 2 - rim) or a * (w / 2 - rim)
      local y = along_x and a * (d / 2 - rim) or b * (d / 2 - rim)
      cylinder("black plastic", {x, y, h - 0.03 * h}, 1.9 * r, 0.032 * h, 0.001, 14)
    end
  end
  for i = 0, 9 do
    local row = i < 1 and 0 or i < 3 and 1 or i < 6 and 2 or 3
    local along = 0.22 * max(w, d) + 1.8 * r * row
    local across = 2.1 * r * (i - row * (row + 1) // 2 - 0.5 * row)
    ellipsoid(cover(i), {along_x and along or across, along_x and across or along, h - 0.04 * h + r}, {r, r, r}, 10,
        6)
  end
end

function plan.pool_table()
  local rail = min(0.12, 0.1 * smaller)
  area(whole, "wood", "outline", 0.05)
  area(grown(whole, -rail), "leaf", "detail")
  local wide = w >= d
  for x in each{left + rail, right - rail} do
    for y in each{back + rail, front - rail} do
      circle({x, y}, 0.5 * rail, "deep")
    end
    if not wide then
      circle({x, 0}, 0.42 * rail, "deep")
    end
  end
  if not wide then return end
  for y in each{back + rail, front - rail} do
    circle({0, y}, 0.42 * rail, "deep")
  end
end

function mesh.table_tennis()
  local all, net = h, w >= d and vec(0.004, d / 2) or vec(w / 2, 0.004)
  h = 0.84 * h
  four_legs(leg_half(0.03), true)
  slab("white glaze", rounded({-w / 2, -d / 2}, {w / 2, d / 2}, 0.01), h, h + 0.002, 0)
  slab("soft", rounded({0.02 - w / 2, 0.02 - d / 2}, {w / 2 - 0.02, d / 2 - 0.02}, 0.01), h, h + 0.004, 0)
  box("white glaze", {-(w >= d and w / 2 or 0.002), -(w >= d and 0.002 or d / 2), h}, {w >= d and w / 2 or 0.002,
      w >= d and 0.002 or d / 2, h + 0.005}, 0)
  box("black plastic", -net, {net[1], net[2], all}, 0)
  h = all
end

function plan.table_tennis()
  area(whole, "soft")
  area(grown(whole, -0.03), "none", "detail")
  if w >= d then
    segment({left, 0}, {right, 0}, "faint")
    segment({0, back}, {0, front}, "outline")
  else
    segment({0, back}, {0, front}, "faint")
    segment({left, 0}, {right, 0}, "outline")
  end
end

-- A top in the corner of a room: along the back and down the left side of its box.
function mesh.corner_desk()
  local thick, leg, deep = top_thickness(), leg_half(0.024), min(0.7, 0.55 * d)
  slab("hard", {{-w / 2, -d / 2}, {w / 2, -d / 2}, {w / 2, deep - d / 2}, {deep - w / 2, deep - d / 2}, {deep - w / 2,
      d / 2},
      {-w / 2, d / 2}}, h - thick, h, 0.005)
  for at in each{vec(-0.48 * w, -0.48 * d), vec(0.48 * w, -0.48 * d), vec(0.48 * w, deep - 0.53 * d), vec(-0.48 * w,
      0.48 * d),
      vec(deep - 0.53 * w, 0.48 * d)} do
    box("metal", {at[1] - leg, at[2] - leg, 0}, {at[1] + leg, at[2] + leg, h - thick}, 0.003)
  end
end

function plan.corner_desk()
  local deep = min(0.7, 0.55 * d)
  shape({{left, back}, {right, back}, {right, back + deep}, {left + deep, back + deep}, {left + deep, front}, {left,
      front}},
      "light")
end
