-- SPDX-License-Identifier: GPL-3.0-or-later
-- Cabinets and shelves.

local function solid_carcass(plinth, cornice)
  local c = { board = min(0.02, 0.06 * smaller), bottom = plinth, front = d / 2 - min(0.05, 0.14 * d) }
  box("hard", {-w / 2 + 0.5 * c.board, -d / 2, 0}, {w / 2 - 0.5 * c.board, c.front - 0.8 * c.board, plinth}, 0.003)
  box("hard", {-w / 2 + 0.3 * c.board, -d / 2, plinth}, {w / 2 - 0.3 * c.board, c.front, h - c.board}, 0.003)
  box("hard", {-w / 2, -d / 2, h - (cornice and 2 or 1) * c.board}, {w / 2, c.front + c.board, h}, 0.006)
  return c
end

-- Doors side by side between two heights; handles meet in pairs.
local function doors(c, left, right, bottom, top, mirrored)
  local count = clamp(round((right - left) / 0.52), 1, 8)
  local wide = (right - left) / count
  local gap = min(0.004, 0.02 * wide)
  local framed = not says("sleek") and not says("minimalist") and not says("modern") and not says("clean")
  for i = 0, count - 1 do
    local from = left + wide * i + gap
    local to = from + wide - 2 * gap
    panel("hard", {from, bottom + gap}, {to, top - gap}, c.front, 0.8 * c.board, framed)
    if mirrored then
      box("mirror", {from + 0.14 * wide, c.front, bottom + 0.1 * wide}, {to - 0.14 * wide, c.front + 0.95 * c.board,
          top - 0.1 * wide}, 0.002)
    end
    local hinge_left = i % 2 == 0 and count > 1
    local x = hinge_left and to - 0.05 * wide or from + 0.05 * wide
    local z = bottom + (top - bottom) * (top > 1.4 and 0.5 or 0.62)
    handle({x, c.front + 0.8 * c.board, z}, min(0.22, 0.3 * (top - bottom)), true)
  end
end

local function drawer_fronts(c, bottom, top, columns, rows, knobs)
  local wide, high = (w - c.board) / columns, (top - bottom) / rows
  for row = 0, rows - 1 do
    for i = 0, columns - 1 do
      local x, z = -w / 2 + 0.5 * c.board + wide * i, bottom + high * row
      local gap = min(0.004, 0.03 * high)
      panel("hard", {x + gap, z + gap}, {x + wide - gap, z + high - gap}, c.front, 0.9 * c.board)
      local y, middle = c.front + 0.9 * c.board, z + 0.55 * high
      if not knobs then
        handle({x + wide / 2, y, middle}, min(0.18, 0.4 * wide), false)
      elseif wide > 0.5 then
        for side in each{0.25, 0.75} do
          knob({x + side * wide, y, middle}, min(0.018, 0.14 * high))
        end
      else
        knob({x + wide / 2, y, middle}, min(0.018, 0.14 * high))
      end
    end
  end
end

-- Books that fill a shelf from `left` to `right`, some lying, with gaps now and then.
local function row_of_books(left, right, back, depth, z, room, index)
  local x = left
  local scale = room / 0.3
  local bevel = index < 60 and 0.0025 * scale or 0
  while x < right - 0.03 * scale and index < 150 do
    local pick, thick = chance(5 * index), scale * (0.022 + 0.03 * chance(5 * index + 1))
    -- a small stack
    if pick > 0.93 and right - x > 0.2 * scale then
      for i = 0, 2 do
        local from = z + 0.032 * scale * i
        box(cover(index + i), {x, back + 0.1 * depth, from},
            {x + 0.19 * scale, back + 0.85 * depth, from + 0.03 * scale}, 0.003)
      end
      x = x + 0.2 * scale
    elseif pick > 0.86 then
      x = x + 0.09 * scale
    elseif x + thick < right then
      local high = room * (0.62 + 0.26 * chance(5 * index + 2))
      local deep = depth * (0.66 + 0.24 * chance(5 * index + 3))
      box(cover(floor(7 * chance(5 * index + 4))), {x, back, z}, {x + thick, back + deep, z + high}, bevel)
      x = x + (thick + 0.001)
    else
      break
    end
    index = index + 1
  end
  return index
end

function mesh.wardrobe()
  local c = solid_carcass(min(0.08, 0.06 * h), true)
  local drawer = says("drawer") and 0.2 * h or 0
  if drawer > 0 then
    drawer_fronts(c, c.bottom, c.bottom + drawer, w > 0.9 and 2 or 1, 1, false)
  end
  doors(c, -w / 2 + 0.5 * c.board, w / 2 - 0.5 * c.board, c.bottom + drawer, h - 2 * c.board,
      says("mirrored", "mirror"))
end

function plan.wardrobe()
  local door = min(0.04, 0.1 * d)
  area(whole, "body")
  area({left + 0.02, back + 0.02, right - 0.02, front - door}, "light", "detail")
  -- The rail with its hangers; the doors along the front.
  local y = (back + front - door) / 2
  local reach = min(0.2, 0.33 * d)
  segment({left + 0.02, y}, {right - 0.02, y}, "outline")
  local hangers = clamp(floor(w / 0.13), 2, 40)
  for i = 1, hangers - 1 do
    local x, lean = left + w * i / hangers, 0.016 * (i * 7 % 5 - 2)
    segment({x - lean, y - reach}, {x + lean, y + reach})
  end
  local doors = clamp(round(w / 0.55), 1, 8)
  area({left, front - door, right, front}, "dark", "detail")
  for i = 1, doors - 1 do
    local x = left + w * i / doors
    segment({x, front - door}, {x, front}, "outline")
  end
end

function mesh.dresser()
  local legs = h > 0.5 and not says("filing")
  local plinth = legs and min(0.13, 0.14 * h) or 0.05 * h
  local board, front = min(0.02, 0.06 * smaller), d / 2 - min(0.05, 0.14 * d)
  local c = { board = board, bottom = plinth, front = front }
  if legs then
    legs_at("hard", 0.46 * w, 0.4 * d, plinth + 0.01, min(0.022, 0.05 * smaller), 0.55, 0.01 * w)
  end
  box("hard", {-0.49 * w, -d / 2, legs and plinth or 0}, {0.49 * w, front, h - board}, 0.003)
  box("hard", {-w / 2, -d / 2, h - 1.2 * board}, {w / 2, front + 1.3 * board, h}, 0.007)
  local buffet = says("sideboard", "buffet", "credenza")
  local columns = w > 1.9 and 3 or w > 0.85 and 2 or 1
  local rows = clamp(round((h - plinth) / 0.2), 1, 6)
  if buffet and w > 0.9 then
    drawer_fronts(c, h - 1.2 * board - 0.22 * h, h - 1.2 * board, columns, 1, true)
    doors(c, -0.49 * w, 0.49 * w, plinth, h - 1.2 * board - 0.22 * h, false)
    return
  end
  drawer_fronts(c, plinth + 0.01 * h, h - 1.2 * board, columns, rows, not says("modern") and not says("filing")
      and not says("handle"))
end

-- Fronts of drawers or doors seen from above: a strip along the front edge, divided, a knob for each.
local function plan_fronts(strip, target_m)
  local count = clamp(round(w / target_m), 1, 8)
  area({left, front - strip, right, front}, "dark", "detail")
  for i = 0, count - 1 do
    local x = left + w * (i + 0.5) / count
    if i > 0 then
      segment({x - w / (2 * count), front - strip}, {x - w / (2 * count), front})
    end
    local half = min(0.05, 0.2 * w / count)
    area({x - half, front - 0.3 * strip, x + half, front}, "deep", "none")
  end
end

function plan.dresser()
  area(whole, "light", "outline", 0.015)
  area(grown(whole, -min(0.03, 0.07 * smaller)), "none", "faint")
  plan_fronts(min(0.055, 0.14 * d), 0.55)
end

function mesh.tv_stand()
  local board, leg, front = min(0.022, 0.08 * smaller), min(0.14, 0.3 * h), d / 2 - 0.03
  local c = { board = board, bottom = leg, front = front }
  legs_at("hard", 0.42 * w, 0.36 * d, leg + 0.01, min(0.02, 0.07 * smaller), 0.5, 0.02 * w)
  for z in each{leg, h - board} do
    box("hard", {-w / 2, -d / 2, z}, {w / 2, front, z + board}, 0.004)
  end
  box("hard", {-w / 2, -d / 2, leg}, {w / 2, -d / 2 + board, h - 0.5 * board}, 0.003)
  for x in each{-0.5, -0.18, 0.18, 0.5} do
    local at = x * (w - board)
    box("hard", {at - board / 2, -d / 2, leg}, {at + board / 2, front, h - 0.5 * board}, 0.003)
  end
  doors(c, -w / 2 + board, -0.18 * w, leg + board, h - board, false)
  doors(c, 0.18 * w, w / 2 - board, leg + board, h - board, false)
  local middle = (leg + h) / 2
  box("hard", {-0.18 * w, -d / 2, middle}, {0.18 * w, 0.9 * front, middle + 0.7 * board}, 0.003)
  if h - leg > 0.2 then
    box("black plastic", {-0.13 * w, -0.2 * d, leg + board}, {0.13 * w, 0.3 * d, leg + board + 0.06}, 0.006)
  end
end

function mesh.cabinet()
  local c = solid_carcass(min(0.08, 0.08 * h), h > 1.2)
  local top = h - 2 * c.board
  if h > 1.5 then
    local middle = 0.45 * h
    doors(c, -w / 2 + 0.5 * c.board, w / 2 - 0.5 * c.board, c.bottom, middle, false)
    doors(c, -w / 2 + 0.5 * c.board, w / 2 - 0.5 * c.board, middle, top, false)
  else
    doors(c, -w / 2 + 0.5 * c.board, w / 2 - 0.5 * c.board, c.bottom, h - c.board, false)
  end
end

function plan.cabinet()
  area(whole, "body", "outline", 0.01)
  plan_fronts(min(0.05, 0.13 * d), 0.5)
  segment({left, back}, {right, front - min(0.05, 0.13 * d)}, "faint")
end

function mesh.bookshelf()
  local board = min(0.022, 0.05 * smaller)
  local back = -d / 2 + 0.4 * board
  local open = says("metal", "industrial", "ladder")
  local frame = open and "metal" or "hard"
  local rows, columns = clamp(round(h / 0.36), 1, 8), clamp(round(w / 0.95), 1, 5)
  if not open then
    box("hard", {-w / 2 + board, -d / 2, 0.02 * h}, {w / 2 - board, back, h - board}, 0)
  end
  local pitch = (w - board) / columns
  for i = 0, columns do
    local x, half = -w / 2 + board / 2 + pitch * i, open and 0.35 * board or board / 2
    if not open then
      box(frame, {x - half, -d / 2, 0}, {x + half, d / 2, h}, 0.003)
    else
      for y in each{-d / 2 + 0.7 * board, d / 2 - 0.7 * board} do
        box(frame, {x - 0.6 * board, y - 0.6 * board, 0}, {x + 0.6 * board, y + 0.6 * board, h}, 0.002)
      end
    end
  end
  local plinth = min(0.07, 0.05 * h)
  local step = (h - plinth - board) / rows
  local index = 0
  for row = 0, rows do
    local z = plinth + step * row
    box("hard", {-w / 2 + 0.6 * board, -d / 2, z}, {w / 2 - 0.6 * board, d / 2 - 0.2 * board, z + board}, 0.003)
    if row == rows then
      break
    end
    for i = 0, columns - 1 do
      local left, wide = -w / 2 + board + pitch * i, pitch - board
      local fill = 0.55 + 0.45 * chance(1000 + 10 * row + i)
      index = row_of_books(left + 0.01 * wide, left + fill * wide, back, 0.86 * d, z + board, step - board, index)
      if fill < 0.8 and step > 0.15 then
        lathe(cover(4 + row), {left + 0.9 * wide, 0, z + board}, {{0.04 * wide, 0}, {0.07 * wide, 0.2 * step},
            {0.06 * wide, 0.35 * step}, {0.03 * wide, 0.45 * step}, {0.04 * wide, 0.5 * step}}, 9)
      end
    end
  end
end

function plan.bookshelf()
  area(whole, "body")
  local side = min(0.025, 0.04 * w)
  local y0 = back + 0.1 * d
  area({left + side, y0, right - side, front}, "pale", "detail")
  -- Book spines of uneven thickness and depth; a gap now and then.
  local x = left + side
  for i = 0, 399 do
    if x >= right - side - 0.012 then
      break
    end
    local thickness = 0.026 + 0.009 * ((i * 7 + i * i) % 5)
    if i * 11 % 13 == 6 then
      x = x + 0.05
      goto continue
    end
    local tip = min(x + thickness, right - side)
    local depth = d * (0.52 + 0.07 * (i * 5 % 4))
    local tones = {"light", "dark", "body", "pale"}
    area({x, y0, tip, y0 + depth}, tones[(i * 3 + i // 4) % 4 + 1], "faint")
    x = tip
    ::continue::
  end
  segment({left, front}, {right, front}, "outline")
end

function mesh.shelf()
  local board, post = min(0.025, 0.3 * h), min(0.018, 0.06 * smaller)
  -- a board on brackets, with a few things on it when there is room
  if h < 0.35 then
    local top = h > 0.12 and 0.35 * h or h
    box("hard", {-w / 2, -d / 2, top - board}, {w / 2, d / 2, top}, 0.005)
    for x in each{-0.36, 0.36} do
      box("metal", {x * w - 0.01, -d / 2, 0}, {x * w + 0.01, -d / 2 + 0.01, top - board}, 0.002)
      bar("metal", {x * w, -d / 2 + 0.005, 0.1 * top}, {x * w, 0.35 * d, top - board}, 0.006, 6)
    end
    local index = 0
    if top < h then
      index = row_of_books(-0.42 * w, 0.05 * w, -d / 2 + 0.02, 0.8 * d, top, h - top, index)
    end
    if top < h then
      lathe("soft", {0.3 * w, 0, top}, {{0.3, 0}, {0.5, 0.4}, {0.3, 0.8}, {0.36, 1}}, 14, {0.5 * d, h - top})
    end
    return
  end
  local rows = clamp(round(h / 0.38), 2, 7)
  local shoes, wine = says("shoe", "boot"), says("wine")
  for x in each{-1, 1} do
    for y in each{-1, 1} do
      box("hard", {x * (w / 2 - post) - post, y * (d / 2 - post) - post, 0},
          {x * (w / 2 - post) + post, y * (d / 2 - post) + post, h}, 0.003)
    end
  end
  for row = 0, rows - 1 do
    local step = (h - board) / (rows - 0.75)
    local z = step * (row + 0.25)
    box("hard", {-w / 2 + post, -d / 2 + 0.5 * post, z}, {w / 2 - post, d / 2 - 0.5 * post, z + board}, 0.003)
    if row == rows - 1 then
      break
    end
    local things = clamp(floor(w / (shoes and 0.16 or 0.34)), 1, 6)
    local pitch = (w - 3 * post) / things
    for i = 0, things - 1 do
      local x, room = -w / 2 + 1.5 * post + pitch * (i + 0.5), step - board
      local tint = floor(7 * chance(20 * row + i))
      if shoes then
        if chance(300 + 20 * row + i) < 0.25 then goto continue end
        local low = z + board
        local toe = vec(0.26 * pitch, min(0.15, 0.4 * d), min(0.04, 0.3 * room))
        local heel = vec(0.22 * pitch, min(0.08, 0.2 * d), min(0.055, 0.4 * room))
        ellipsoid(cover(tint), {x, 0, low + toe[3]}, toe, 9, 5)
        ellipsoid(cover(tint), {x, -min(0.07, 0.18 * d), low + heel[3]}, heel, 9, 5)
      elseif wine then
        bar(cover(2), {x, -0.4 * d, z + board + 0.04}, {x, 0.45 * d, z + board + 0.04}, min(0.038, 0.3 * room), 10)
      else
        box(i % 2 == 0 and "soft" or cover(tint), {x - 0.38 * pitch, -0.4 * d, z + board},
            {x + 0.38 * pitch, 0.36 * d, z + board + room * (0.4 + 0.4 * chance(400 + 20 * row + i))}, 0.008)
      end
      ::continue::
    end
  end
end

function plan.shelf()
  area(whole, "light")
  local bays = clamp(round(w / 0.45), 1, 10)
  for i = 1, bays - 1 do
    local x = left + w * i / bays
    segment({x, back}, {x, front})
  end
  local y = back + 0.14 * d
  segment({left, y}, {right, y}, "detail")
end
