-- SPDX-License-Identifier: GPL-3.0-or-later
-- What one sleeps in, for a night or for good. Heads are at the back.

-- Mattress, pillows at the back, a blanket turned down; in [b.left, b.right] x [b.back, b.front] from b.bottom to b.top.
local function make_bedding(b, several_pillows)
  local width, depth, thick = b.right - b.left, b.front - b.back, b.top - b.bottom
  local rounding = min(0.05, 0.3 * thick)
  cushion("pale", {b.left, b.back, b.bottom}, {b.right, b.front, b.top - 0.12 * thick}, rounding, 0.006)
  -- The blanket hangs over the sides and the foot.
  local turned, over = b.back + min(0.62, 0.34 * depth), min(0.012, 0.02 * width)
  cushion("soft", {b.left - over, turned, b.bottom + 0.25 * thick}, {b.right + over, b.front + over, b.top}, rounding,
      0.008)
  cushion("pale", {b.left - over, turned - 0.02 * depth, b.bottom + 0.3 * thick},
      {b.right + over, turned + min(0.22, 0.12 * depth), b.top + 0.05 * thick}, rounding, 0.008)
  -- a throw at the foot
  if depth > 1.2 then
    local from = b.front - 0.26 * depth
    cushion("accent", {b.left - 1.4 * over, from, b.bottom + 0.15 * thick},
        {b.right + 1.4 * over, from + 0.16 * depth, b.top + 0.05 * thick}, rounding, 0.004)
  end
  local count = several_pillows and width > 1.15 and 2 or 1
  local pitch, size = width / count, min(0.42, 0.24 * depth)
  local wide = min(0.72, 0.88 * pitch)
  for i = 0, count - 1 do
    local x = b.left + pitch * (0.5 + i)
    inside(turned_x({x, b.back + 0.03 * depth, b.top - 0.1 * thick}, 0.22), function()
      pillow("pale", {-wide / 2, 0, 0}, {wide / 2, size, 0.42 * size})
    end)
  end
end

local function posts(half, top, knobs)
  for sx in each{-1, 1} do
    for sy in each{-1, 1} do
      local x, y = sx * (w / 2 - half), sy * (d / 2 - half)
      box("hard", {x - half, y - half, 0}, {x + half, y + half, top}, 0.005)
      if knobs then
        ellipsoid("hard", {x, y, top + 0.8 * half}, {half, half, 1.2 * half}, 12, 6)
      end
    end
  end
end

-- Four posts that carry a frame with a curtain gathered at each corner.
local function canopy(post)
  posts(post, h, false)
  local x, y, rail = w / 2 - post, d / 2 - post, 0.7 * post
  for side in each{-1, 1} do
    box("hard", {-x, side * y - rail, h - 2 * rail}, {x, side * y + rail, h}, 0.004)
    box("hard", {side * x - rail, -y, h - 2 * rail}, {side * x + rail, y, h}, 0.004)
  end
  for sx in each{-1, 1} do
    for sy in each{-1, 1} do
      sheet("accent", 12, 6, function(u, v)
        local narrow, fold = 1 - 0.6 * exp(-18 * (v - 0.42) * (v - 0.42)), 0.02 * sin(6.2832 * 3 * u)
        local along, out = 0.16 * d * u * narrow, 1.1 * post + fold * narrow
        return vec(sx * (x + 0.2 * post - out), sy * (y - post - along), 0.06 * h + 0.92 * h * (1 - v))
      end, 0.006)
    end
  end
end

function mesh.bed()
  local with_canopy = h > 1.5 or says("canopy") or says("four-poster") or says("four poster")
  local head, deck, board = h, min(0.34, 0.4 * h, 0.3 * d), min(0.06, 0.06 * d)
  local rail, leg = min(0.035, 0.05 * w), min(0.03, 0.06 * smaller)
  local top = rest
  local head_top = with_canopy and min(1.25, 0.6 * h) or head
  if with_canopy then
    canopy(min(0.045, 0.06 * smaller))
  else
    legs_at("hard", w / 2 - 1.6 * leg, d / 2 - 1.6 * leg, 0.5 * deck, leg, 0.7)
  end
  for side in each{-1, 1} do
    box("hard", {side * w / 2, -d / 2, 0.35 * deck}, {side * (w / 2 - rail), d / 2, deck}, 0.006)
  end
  box("hard", {-w / 2 + rail, d / 2 - rail, 0.35 * deck}, {w / 2 - rail, d / 2, 1.15 * deck}, 0.006)
  box("hard", {-w / 2 + rail, -d / 2 + board, 0.45 * deck}, {w / 2 - rail, d / 2 - rail, 0.75 * deck}, 0)
  local padded = says("upholstered", "upholstery", "fabric", "velvet", "tufted")
  if padded then
    local panels = clamp(floor(w / 0.3), 1, 7)
    for i = 0, panels - 1 do
      local pitch = w / panels
      local from = -w / 2 + pitch * i
      cushion("soft", {from, -d / 2, 0.1 * head_top}, {from + pitch, -d / 2 + 1.4 * board, head_top}, 0.03, 0.012)
    end
  else
    box("hard", {-w / 2, -d / 2, 0}, {w / 2, -d / 2 + board, 0.94 * head_top}, 0.012)
    box("hard", {-w / 2, -d / 2, 0.93 * head_top}, {w / 2, -d / 2 + 1.4 * board, head_top}, 0.012)
  end
  local inset = with_canopy and 0.03 * w or 0.02 * w
  make_bedding({ left = -w / 2 + inset, right = w / 2 - inset, back = -d / 2 + 1.3 * board,
      front = d / 2 - (with_canopy and 0.12 or 0.6 * rail), bottom = 0.72 * deck, top = top }, true)
end

-- Pillows side by side behind `y1`, each at most 0.8 m wide; one for a single bed.
local function plan_pillows(x0, x1, y0, y1)
  local count = x1 - x0 >= 1.15 and 2 or 1
  local pitch = (x1 - x0) / count
  for i = 0, count - 1 do
    local gap = min(0.07, 0.1 * pitch)
    local pillow = rect(x0 + i * pitch + gap, y0, x0 + (i + 1) * pitch - gap, y1)
    area(pillow, "pale", "detail", 0.09)
    local inset = 0.045
    curve({pillow.x0 + inset, pillow.y1 - inset}, {pillow.x0 + 2 * inset, pillow.y1 - 1.9 * inset},
        {pillow.x1 - 2 * inset, pillow.y1 - 1.9 * inset}, {pillow.x1 - inset, pillow.y1 - inset}, "faint")
  end
end

function plan.bed()
  local board = min(0.07, 0.06 * d)
  local head = back + board
  local margin = min(0.05, 0.04 * w)
  area(whole, "hard", "outline", 0.03)
  area({left + 0.4 * margin, head, right - 0.4 * margin, front - 0.02}, "pale", "faint", 0.03)
  area({left, back, right, head}, "hard", "detail", 0.02)
  local pillow_front = head + min(0.45, 0.22 * d)
  plan_pillows(left + margin, right - margin, head + 0.04, pillow_front)
  -- The duvet, its upper edge turned back, one corner folded open.
  local fold = pillow_front + 0.06
  local turned = fold + min(0.24, 0.12 * d)
  local duvet = rect(left + 0.4 * margin, fold, right - 0.4 * margin, front - 0.02)
  area(duvet, "soft", "detail", 0.05)
  area({duvet.x0, fold, duvet.x1, turned}, "light", "detail", 0.03)
  local corner = min(0.42, 0.3 * w)
  local flap = {{duvet.x1, turned}, {duvet.x1, turned + corner}, {duvet.x1 - corner, turned}}
  shape(flap, "pale", "detail")
  for i = 1, 2 do
    local y = turned + (duvet.y1 - turned) * (0.28 + 0.27 * i)
    curve({duvet.x0 + 0.08, y}, {duvet.x0 + 0.3 * duvet.width, y + 0.05}, {duvet.x1 - 0.4 * duvet.width, y - 0.05},
        {duvet.x1 - 0.1, y + 0.02}, "faint")
  end
end

function mesh.bunk_bed()
  local post = min(0.035, 0.05 * smaller)
  local rail = 0.6 * post
  posts(post, h, false)
  for level in each{0.16, 0.62} do
    local z, high = level * h, 0.07 * h
    for side in each{-1, 1} do
      box("hard", {side * (w / 2 - post) - rail, -d / 2 + post, z - high},
          {side * (w / 2 - post) + rail, d / 2 - post, z}, 0.005)
      box("hard", {-w / 2 + post, side * (d / 2 - post) - rail, z - high},
          {w / 2 - post, side * (d / 2 - post) + rail, z}, 0.005)
    end
    box("hard", {-w / 2 + post, -d / 2 + post, z - 0.6 * high}, {w / 2 - post, d / 2 - post, z - 0.3 * high}, 0)
    make_bedding({ left = -w / 2 + 2.2 * post, right = w / 2 - 2.2 * post, back = -d / 2 + 2.2 * post,
        front = d / 2 - 2.2 * post, bottom = z - 0.4 * high, top = z + 0.09 * h }, false)
  end
  -- guards of the upper bed
  for z in each{0.83, 0.93} do
    for side in each{-1, 1} do
      box("hard", {side * (w / 2 - post) - rail, -d / 2 + post, z * h - post},
          {side * (w / 2 - post) + rail, (side > 0 and 0.1 or 0.5) * d - post, z * h + post * 0.4}, 0.004)
      box("hard", {-w / 2 + post, side * (d / 2 - post) - rail, z * h - post},
          {w / 2 - post, side * (d / 2 - post) + rail, z * h + post * 0.4}, 0.004)
    end
  end
  -- the ladder
  local from, to, x = 0.18 * d, 0.42 * d, w / 2 - 0.6 * post
  for y in each{from, to} do
    box("hard", {x - rail, y - rail, 0}, {x + rail, y + rail, 0.95 * h}, 0.004)
  end
  for i = 1, 5 do
    local z = 0.11 * i * h
    bar("hard", {x, from, z}, {x, to, z}, 0.7 * rail, 8)
  end
end

function plan.bunk_bed()
  plan.bed()
  -- The ladder of the upper bunk on the right side.
  local x0 = right - min(0.16, 0.18 * w)
  local y0 = front - min(0.62, 0.36 * d)
  local y1 = front - min(0.2, 0.1 * d)
  area({x0, y0, right, y1}, "wood", "detail")
  for i = 1, 3 do
    segment({x0, y0 + (y1 - y0) * i / 4}, {right, y0 + (y1 - y0) * i / 4})
  end
  area({left + 0.03, back + 0.03, right - 0.03, front - 0.03}, "none", "dashed", 0.02)
end

function mesh.cot()
  local post = min(0.02, 0.05 * smaller)
  local rail, low, high = 0.9 * post, 0.2 * h, h - 2.2 * post
  posts(post, h - 1.2 * post, true)
  local function side(from, to)
    for z in each{low, high} do
      box("hard", from + vec(-rail, -rail, z - 1.2 * rail), to + vec(rail, rail, z + 1.2 * rail), 0.004)
    end
    local bars = clamp(floor(length(to - from) / 0.085), 3, 22)
    for i = 1, bars - 1 do
      local at = from + (to - from) * (i / bars)
      bar("hard", at + vec(0, 0, low), at + vec(0, 0, high), 0.45 * post, 6)
    end
  end
  local x, y = w / 2 - post, d / 2 - post
  side(vec(-x, -y, 0), vec(-x, y, 0))
  side(vec(x, -y, 0), vec(x, y, 0))
  side(vec(-x, -y, 0), vec(x, -y, 0))
  side(vec(-x, y, 0), vec(x, y, 0))
  box("hard", {-x, -y, low - 0.03 * h}, {x, y, low + 0.02 * h}, 0.003)
  local lengthwise = d >= w
  cushion("pale", {-0.93 * x, -0.95 * y, low}, {0.93 * x, 0.95 * y, 0.42 * h}, 0.03, 0.006)
  if lengthwise then
    cushion("soft", {-0.95 * x, -0.2 * y, low + 0.08 * h}, {0.95 * x, 0.97 * y, 0.45 * h}, 0.03, 0.008)
    cushion("pale", {-0.6 * x, -0.88 * y, 0.4 * h}, {0.6 * x, -0.5 * y, 0.49 * h}, 0.03, 0.015)
  else
    cushion("soft", {-0.2 * x, -0.95 * y, low + 0.08 * h}, {0.97 * x, 0.95 * y, 0.45 * h}, 0.03, 0.008)
    cushion("pale", {-0.88 * x, -0.6 * y, 0.4 * h}, {-0.5 * x, 0.6 * y, 0.49 * h}, 0.03, 0.015)
  end
end

function plan.cot()
  area(whole, "wood", "outline", 0.03)
  local rail = min(0.055, 0.09 * w)
  local mattress = grown(whole, -rail)
  area(mattress, "pale", "detail", 0.02)
  local bars = max(3, floor(d / 0.11))
  for i = 1, bars - 1 do
    local y = back + d * i / bars
    segment({left, y}, {mattress.x0, y})
    segment({mattress.x1, y}, {right, y})
  end
  local head = mattress.y0 + 0.05
  local middle = 0.3 * mattress.width
  area({-middle, head, middle, head + min(0.2, 0.2 * d)}, "light", "detail", 0.06)
  area({mattress.x0 + 0.02, mattress.y0 + 0.42 * mattress.height, mattress.x1 - 0.02, mattress.y1 - 0.02}, "body",
      "detail", 0.03)
end

function mesh.coffin()
  -- Wide at the shoulders; along the longer side, its head at the back.
  local lengthwise = d >= w
  local width, length = lengthwise and w or d, lengthwise and d or w
  local function outline(scale, inset)
    local x, y = width / 2 * scale - inset, length / 2 * scale - inset
    return {{-0.62 * x, -y}, {0.62 * x, -y}, {x, -0.42 * y}, {0.58 * x, y}, {-0.58 * x, y}, {-x, -0.42 * y}}
  end
  local frame = lengthwise and {} or quarter_turn()
  local wall, lid = min(0.035, 0.06 * width), 0.2 * h
  inside(frame, function()
    slab("hard", outline(0.97, 0), 0, 0.1 * h, 0.006)
    slab("hard", outline(0.93, 0), 0.09 * h, h - lid, 0.006)
    slab("soft", outline(0.955, wall * 0.2), h - lid - 0.03 * h, h - lid + 0.02 * h, 0.004)
    slab("hard", outline(1, 0), h - lid + 0.01 * h, h - 0.08 * h, 0.012)
    slab("hard", outline(0.9, wall), h - 0.09 * h, h - 0.02 * h, 0.02)
    -- A cross of metal on the lid, handles along the sides.
    local strip, z = 0.035 * width, h - 0.03 * h
    box("metal", {-strip, -0.36 * length, z}, {strip, 0.3 * length, h}, 0.004)
    box("metal", {-0.22 * width, -0.2 * length - strip, z}, {0.22 * width, -0.2 * length + strip, h}, 0.004)
    for side in each{-1, 1} do
      for y in each{-0.05, 0.2} do
        local x, z_handle = side * width * (0.44 - 0.28 * (y + 0.05)), 0.5 * h
        bar("metal", {x, (y - 0.06) * length, z_handle}, {x - side * 0.02 * width, (y + 0.06) * length, z_handle},
            0.02 * width, 8)
      end
    end
  end)
end

function plan.coffin()
  local function outline(inset)
    local w, y0, y1 = w / 2 - inset, back + inset, front - inset
    local shoulder = y0 + 0.3 * (y1 - y0)
    return {{-0.58 * w, y0}, {0.58 * w, y0}, {w, shoulder}, {0.5 * w, y1}, {-0.5 * w, y1}, {-w, shoulder}}
  end
  shape(outline(0), "body")
  shape(outline(min(0.05, 0.07 * w)), "light", "detail")
  shape(outline(min(0.09, 0.13 * w)), "body", "faint")
  -- A cross on the lid, head end at the back.
  local arm, strip = 0.17 * w, 0.05 * w
  local top, foot = back + 0.16 * d, back + 0.6 * d
  local y = top + 0.3 * (foot - top)
  local cross = {{-strip, top}, {strip, top}, {strip, y - strip}, {arm, y - strip}, {arm, y + strip},
      {strip, y + strip}, {strip, foot}, {-strip, foot}, {-strip, y + strip}, {-arm, y + strip}, {-arm, y - strip},
      {-strip, y - strip}}
  shape(cross, "deep", "detail")
end

-- Cloth between two posts.
function mesh.hammock()
  lengthwise(function()
    for side in each{-1, 1} do
      bar("hard", {0, side * 0.47 * d, 0}, {0, side * 0.49 * d, h}, 0.03 * min(1, w), 12)
      box("hard", {-w / 2, side * 0.47 * d - 0.03, 0}, {w / 2, side * 0.47 * d + 0.03, 0.05 * h}, 0.006)
    end
    sheet("soft", 10, 20, function(u, v)
      local a, b = 2 * u - 1, 2 * v - 1
      return vec(0.5 * w * a * (1 - 0.9 * b ^ 4), 0.46 * d * b, h * (0.4 + 0.5 * b * b + 0.14 * a * a * (1 - b * b)))
    end, 0.01)
  end)
end

function plan.hammock()
  shape({{0, back}, {right, 0.4 * back}, {right, 0.4 * front}, {0, front}, {left, 0.4 * front}, {left, 0.4 * back}},
      "soft")
  for x in each{-0.25, 0, 0.25} do segment({x * w, 0.8 * back}, {x * w, 0.8 * front}, "faint") end
end
