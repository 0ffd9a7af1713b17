-- SPDX-License-Identifier: GPL-3.0-or-later
-- What hangs, and screens.

-- x to the left of someone who looks at it, y up, z to the front: shapes drawn on a wall.
local function on_wall(origin)
  return facing_front(origin)
end

-- Four rails about an area; the area's half sizes and how broad they are.
local function frame_rails(material, rail)
  local x, y = w / 2, d / 2
  for side in each{-1, 1} do
    box(material, {side * x, -y, 0}, {side * (x - rail), y, h}, 0.005)
    box(material, {-x + rail, -y, side < 0 and 0 or h - rail}, {x - rail, y, side < 0 and rail or h}, 0.005)
  end
end

-- Hills below a sky with a sun, or overlapping shapes; flush slabs, one over the other.
local function motif(x, z, y, abstract)
  local base = style_colour()
  local pale, deep = blend(base, {0.8, 0.78, 0.72}, 0.7), base * 0.45
  local wide, high = x, z
  inside(on_wall(vec(0, y, h / 2)), function()
    if abstract then
      local hues = {deep, rgb(0xC98B4B), pale * 0.8, rgb(0x3E5A6B)}
      for i = 0, 3 do
        local cx, cz = wide * (1 * chance(i) - 0.5), high * (1 * chance(10 + i) - 0.5)
        local r = min(wide, high) * (0.28 + 0.2 * chance(20 + i))
        slab(paint("figure " .. i + 1, hues[i + 1]), i % 2 == 0 and ellipse({cx, cz}, r, r, 24)
            or rounded({cx - r, cz - 0.6 * r}, {cx + r, cz + 0.6 * r}, 0.01, 1), 0, 0.0008 * (i + 1), 0)
      end
      return
    end
    slab(paint("sun", rgb(0xE3B061)), ellipse({-0.4 * wide, 0.42 * high}, 0.18 * min(wide, high),
        0.18 * min(wide, high), 20), 0, 0.0008, 0)
    for layer = 0, 2 do
      local hills = {{-wide, -high}, {wide, -high}}
      for i = 0, 10 do
        local t = 1 - 0.2 * i
        push(hills, {wide * t, high * (0.16 - 0.34 * layer + 0.16 * sin(2.2 * t * (1 + layer) + 6 * chance(layer)))})
      end
      slab(paint(layer == 0 and "hills far" or layer == 1 and "hills" or "hills near",
          blend(pale, deep, 0.33 * (layer + 1))), hills, 0, 0.0012 * (layer + 1), 0)
    end
  end)
end

function mesh.picture()
  local rail = min(0.045, 0.08 * min(w, h))
  if says("tapestry") then
    bar("hard", {-w / 2, 0, 0.97 * h}, {w / 2, 0, 0.97 * h}, min(0.02, 0.4 * d), 10)
    box("soft", {-0.46 * w, -0.2 * d, 0.06 * h}, {0.46 * w, 0.1 * d, 0.98 * h}, 0.002)
    for z in each{0.16, 0.44, 0.72} do
      box(z == 0.44 and "pale" or "accent", {-0.44 * w, 0.05 * d, z * h}, {0.44 * w, 0.2 * d, (z + 0.12) * h}, 0)
    end
    for i = 0, 15 do
      local x = w * (-0.45 + 0.06 * i)
      box("pale", {x - 0.01 * w, -0.1 * d, 0}, {x + 0.01 * w, 0.05 * d, 0.07 * h}, 0)
    end
    return
  end
  local standing = says("photo") or d > 0.4 * h
  frame_rails(says("gold", "ornate") and "metal" or "hard", rail)
  box(says("canvas") and "pale" or "paper", {-w / 2 + 0.8 * rail, -d / 2, 0.8 * rail},
      {w / 2 - 0.8 * rail, 0.1 * d, h - 0.8 * rail}, 0)
  local mount = says("canvas") and 1 or 1.9
  local x, z = w / 2 - mount * rail, h / 2 - mount * rail
  if min(x, z) < 0.004 then return end
  box(paint("sky", blend(style_colour(), {0.72, 0.76, 0.78}, 0.75)), {-x, 0, h / 2 - z}, {x, 0.12 * d, h / 2 + z}, 0)
  motif(x, z, 0.12 * d, says("abstract", "modern") or not standing and chance(1) < 0.4)
end

function plan.picture()
  area(whole, "body", "outline")
  segment({0.94 * left, 0.4 * front}, {0.94 * right, 0.4 * front}, "faint")
end

function mesh.mirror()
  local rounding = says("round", "oval", "circular")
  -- stands by itself, tilted in a frame
  if d > 0.25 and h > 0.8 then
    local leg = min(0.02, 0.05 * w)
    for side in each{-1, 1} do
      box("hard", {side * w / 2, -d / 2, 0}, {side * (w / 2 - 2 * leg), d / 2, 2 * leg}, 0.006)
      box("hard", {side * w / 2, -leg, leg}, {side * (w / 2 - 2 * leg), leg, 0.62 * h}, 0.004)
    end
    inside(turned_x({0, 0, 0.55 * h}, 0.08), function()
      inside(on_wall(vec(0, 0, 0)), function()
        slab("hard", ellipse({}, w / 2 - 2.6 * leg, 0.45 * h, 36), -leg, leg, 0.005)
        slab("mirror", ellipse({}, w / 2 - 4.6 * leg, 0.45 * h - 2 * leg, 36), 0, leg + 0.002, 0)
      end)
    end)
    return
  end
  local rail = min(0.04, 0.08 * min(w, h))
  if rounding then
    inside(on_wall(vec(0, 0, h / 2)), function()
      slab("hard", ellipse({}, w / 2, h / 2, 44), -d / 2, d / 2, 0.006)
      slab("mirror", ellipse({}, w / 2 - rail, h / 2 - rail, 44), 0, d / 2 + 0.001, 0)
    end)
    return
  end
  frame_rails("hard", rail)
  box("mirror", {-w / 2 + 0.8 * rail, -d / 2, 0.8 * rail}, {w / 2 - 0.8 * rail, 0.3 * d, h - 0.8 * rail}, 0)
end

function plan.mirror()
  area(whole, "glass", "outline")
  local strokes = clamp(floor(w / 0.12), 2, 12)
  for i = 1, strokes - 1 do
    local x = left + w * i / strokes
    local lean = min(0.3 * d, 0.4 * w / strokes)
    segment({x - lean, back}, {x + lean, front}, "faint")
  end
end

function mesh.clock()
  local function face(centre, r, thick)
    inside(on_wall(centre), function()
      lathe("hard", {0, 0, -thick}, {{r, 0}, {r, 0.8 * thick}, {0.94 * r, thick}, {0.88 * r, 0.75 * thick}}, 36)
      cylinder("paper", {0, 0, -thick}, 0.9 * r, 0.8 * thick, 0, 32)
      for i = 0, 11 do
        local turn, half = pi / 6 * i, (i % 3 == 0 and 0.035 or 0.018) * r
        inside(turned_z({}, turn), function()
          box("black plastic", {-half, 0.7 * r, -0.25 * thick}, {half, 0.84 * r, -0.15 * thick}, 0)
        end)
      end
      -- ten past ten
      for hand in each{vec(0.9, 0.48, 0.04), vec(-1.05, 0.68, 0.025)} do
        inside(turned_z({}, hand[1]), function()
          box("black plastic", {-hand[3] * r, -0.1 * r, -0.2 * thick}, {hand[3] * r, hand[2] * r, -0.1 * thick}, 0)
        end)
      end
      cylinder("metal", {0, 0, -0.2 * thick}, 0.06 * r, 0.14 * thick, 0, 12)
    end)
  end
  -- a long-case clock
  if h > 1 then
    local x, hood = w / 2, 0.74 * h
    box("hard", {-x, -d / 2, 0}, {x, d / 2, 0.22 * h}, 0.008)
    box("hard", {-0.74 * x, -d / 2, 0.21 * h}, {0.74 * x, 0.4 * d, hood}, 0.006)
    box("hard", {-x, -d / 2, hood}, {x, 0.44 * d, 0.94 * h}, 0.008)
    inside(on_wall(vec(0, -d / 2, 0.93 * h)), function()
      slab("hard", arc({}, x, 0.07 * h, 0, pi, 12), 0, 0.94 * d, 0.006)
    end)
    box("dark screen", {-0.5 * x, 0.39 * d, 0.27 * h}, {0.5 * x, 0.41 * d, hood - 0.04 * h}, 0)
    bar("metal", {0, 0.42 * d, 0.38 * h}, {0, 0.42 * d, hood - 0.05 * h}, 0.006, 6)
    inside(on_wall(vec(0, 0.41 * d, 0.37 * h)), function()
      cylinder("metal", {}, 0.34 * x, 0.03 * d, 0.003, 24)
    end)
    face(vec(0, 0.5 * d, 0.84 * h), min(0.8 * x, 0.09 * h), 0.06 * d)
    return
  end
  local r = 0.5 * min(w, h)
  -- stands on furniture
  if d > 0.5 * h and h < 0.4 then
    cushion("hard", {-w / 2, -d / 2, 0}, {w / 2, 0.42 * d, h}, 0.2 * min(w, d, h))
    face(vec(0, d / 2, 0.52 * h), 0.8 * r, 0.1 * d)
    return
  end
  face(vec(0, d / 2, h / 2), r, d)
end

function mesh.board()
  local rail = min(0.03, 0.06 * min(w, h))
  local white, dark = says("white", "whiteboard", "calendar"), says("blackboard", "chalkboard")
  frame_rails("hard", rail)
  box(white and "white glaze" or dark and "slate board" or "cork", {-w / 2 + 0.8 * rail, -d / 2, 0.8 * rail},
      {w / 2 - 0.8 * rail, 0.1 * d, h - 0.8 * rail}, 0)
  -- notes
  for i = 0, 5 do
    local x, z = w * (0.72 * chance(i) - 0.36), h * (0.2 + 0.55 * chance(10 + i))
    local s = 0.09 * min(w, h) * (1 + chance(20 + i))
    inside(on_wall(vec(x, 0.1 * d, z)), function()
      inside(turned_z({}, 0.3 * (chance(30 + i) - 0.5)), function()
        box(i % 3 == 0 and cover(i) or "paper", {-s, -s, 0}, {s, 1.2 * s, 0.0012 * (i + 1)}, 0)
      end)
    end)
  end
end

function mesh.television()
  local stands = d > 0.12 and h > 0.25
  local foot, thick = stands and 0.1 * h or 0, min(0.05, 0.5 * d)
  local y = stands and thick / 2 or d / 2
  box("hard", {-w / 2, y - thick, foot}, {w / 2, y, h}, 0.006)
  local bezel = min(0.012, 0.02 * min(w, h))
  box("dark screen", {-w / 2 + bezel, y - 0.002, foot + 1.6 * bezel}, {w / 2 - bezel, y + 0.002, h - bezel}, 0)
  if not stands then
    return box("hard", {-0.2 * w, -d / 2, 0.3 * h}, {0.2 * w, y - 0.9 * thick, 0.7 * h}, 0.004)
  end
  for side in each{-1, 1} do
    bar("hard", {side * 0.3 * w, 0, foot + 0.01 * h}, {side * 0.36 * w, d / 2 - 0.01, 0.008}, 0.008, 8)
    bar("hard", {side * 0.3 * w, 0, foot + 0.01 * h}, {side * 0.36 * w, -d / 2 + 0.01, 0.008}, 0.008, 8)
  end
end

function plan.television()
  area(whole, "deep", "outline", 0.01)
  area({0.97 * left, 0.3 * front, 0.97 * right, front}, "glass", "faint")
end

function mesh.screen()
  local foot, low, thick = min(0.02, 0.06 * h), 0.26 * h, min(0.03, 0.3 * d)
  slab("hard", rounded({-0.26 * w, -d / 2}, {0.26 * w, d / 2}, 0.03), 0, foot, 0.004)
  box("hard", {-0.05 * w, -0.3 * d, 0.5 * foot}, {0.05 * w, -0.1 * d, 0.5 * h}, 0.006)
  box("hard", {-w / 2, -0.12 * d, low}, {w / 2, -0.12 * d + thick, h}, 0.006)
  local bezel, y = min(0.012, 0.03 * h), -0.12 * d + thick
  box("lit screen", {-w / 2 + bezel, y - 0.001, low + 1.8 * bezel}, {w / 2 - bezel, y + 0.002, h - bezel}, 0)
  box("white glaze", {-0.42 * w, y + 0.001, low + 0.2 * h}, {0.05 * w, y + 0.003, h - 0.12 * h}, 0)
end

function plan.screen()
  -- The screen is a thin bar that faces the front, on a foot.
  local strip = max(0.05, 0.3 * d)
  oval({0, 0}, 0.22 * w, d / 2, "metal")
  area({left, -0.35 * strip, right, 0.65 * strip}, "deep", "outline", 0.01)
  segment({0.95 * left, 0.45 * strip}, {0.95 * right, 0.45 * strip}, "faint")
end

function mesh.laptop()
  local thick, hinge = min(0.018, 0.1 * h), -0.3 * d
  local lean = atan(d / 2 + hinge, h - thick)
  slab("hard", rounded({-w / 2, hinge}, {w / 2, d / 2}, 0.015), 0, thick, 0.003)
  box("black plastic", {-0.43 * w, hinge + 0.08 * d, thick - 0.001}, {0.43 * w, 0.16 * d, thick + 0.002}, 0)
  box("brushed steel", {-0.13 * w, 0.22 * d, thick - 0.001}, {0.13 * w, 0.43 * d, thick + 0.001}, 0)
  local length = sqrt((h - thick) * (h - thick) + (d / 2 + hinge) * (d / 2 + hinge))
  inside(turned_x({0, hinge, thick}, lean), function()
    box("hard", {-w / 2, -0.4 * thick, 0}, {w / 2, 0.2 * thick, length}, 0.003)
    box("lit screen", {-0.46 * w, 0.1 * thick, 0.06 * length}, {0.46 * w, 0.3 * thick, 0.95 * length}, 0)
  end)
end

function plan.laptop()
  area(whole, "metal", "outline", 0.015)
  area({left, back, right, back + 0.2 * d}, "deep", "detail", 0.01)
  area({0.85 * left, -0.22 * d, 0.85 * right, 0.16 * d}, "light", "faint")
  area({0.26 * left, 0.22 * d, 0.26 * right, 0.42 * d}, "pale", "faint")
end

function mesh.ceiling_fan()
  local r = 0.5 * smaller
  local hub, z = 0.16 * r, 0.4 * h
  bar("metal", {0, 0, z}, {0, 0, h}, min(0.02, 0.1 * r), 10)
  lathe("metal", {0, 0, 0.9 * h}, {{0.08 * r, 0}, {0.14 * r, 0.1 * h}}, 20)
  lathe("metal", {0, 0, 0.22 * h}, {{0.8 * hub, 0}, {hub, 0.06 * h}, {hub, 0.22 * h}, {0.5 * hub, 0.32 * h}}, 24)
  ellipsoid("lamp shade", {0, 0, 0.2 * h}, {0.9 * hub, 0.9 * hub, 0.2 * h}, 18, 10)
  shine({0, 0, 0.15 * h}, 70, 0.6 * hub)
  for i = 0, 4 do
    inside(turned_z({0, 0, z}, 2 * pi / 5 * i), function()
      inside({{}, {1, 0, 0}, {0, cos(0.2), sin(0.2)}, {0, -sin(0.2), cos(0.2)}}, function()
        slab("hard", rounded({0.8 * hub, -0.09 * r}, {r, 0.09 * r}, 0.06 * r), -0.01 * h, 0.03 * h, 0.002)
      end)
    end)
  end
end

function plan.ceiling_fan()
  local rx, ry = w / 2, d / 2
  oval({0, 0}, rx, ry, "none", "dashed")
  for i = 0, 3 do
    local angle = 2 * pi * i / 4 + 0.4
    local a = vec(0.95 * rx * cos(angle - 0.13), 0.95 * ry * sin(angle - 0.13))
    local b = vec(0.95 * rx * cos(angle + 0.13), 0.95 * ry * sin(angle + 0.13))
    local blade = {{0.1 * a[1], 0.1 * a[2]}, a, b, {0.1 * b[1], 0.1 * b[2]}}
    shape(blade, "none", "detail")
  end
  oval({0, 0}, 0.12 * rx, 0.12 * ry, "none", "detail")
end
