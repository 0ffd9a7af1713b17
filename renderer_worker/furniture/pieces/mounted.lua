-- SPDX-License-Identifier: GPL-3.0-or-later
-- What hangs, and screens.

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
      inside(facing_front(vec(0, 0, 0)), function()
        slab("hard", ellipse({}, w / 2 - 2.6 * leg, 0.45 * h, 36), -leg, leg, 0.005)
        slab("mirror", ellipse({}, w / 2 - 4.6 * leg, 0.45 * h - 2 * leg, 36), 0, leg + 0.002, 0)
      end)
    end)
    return
  end
  local rail = min(0.04, 0.08 * min(w, h))
  if rounding then
    inside(facing_front(vec(0, 0, h / 2)), function()
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
    inside(facing_front(centre), function()
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
    inside(facing_front(vec(0, -d / 2, 0.93 * h)), function()
      slab("hard", arc({}, x, 0.07 * h, 0, pi, 12), 0, 0.94 * d, 0.006)
    end)
    box("dark screen", {-0.5 * x, 0.39 * d, 0.27 * h}, {0.5 * x, 0.41 * d, hood - 0.04 * h}, 0)
    bar("metal", {0, 0.42 * d, 0.38 * h}, {0, 0.42 * d, hood - 0.05 * h}, 0.006, 6)
    inside(facing_front(vec(0, 0.41 * d, 0.37 * h)), function()
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
  face(vec(0, d / 2, h / 2), r, 0.5 * d)
  box("black plastic", {-0.6 * r, -d / 2, h / 2 - 0.6 * r}, {0.6 * r, 0, h / 2 + 0.6 * r}, 0)
end

function mesh.board()
  local rail = min(0.03, 0.06 * min(w, h))
  local white, dark = says("white", "whiteboard", "calendar", "projector", "projection"), says("blackboard",
      "chalkboard")
  frame_rails("hard", rail)
  box(white and "white glaze" or dark and "slate board" or "cork", {-w / 2 + 0.8 * rail, -d / 2, 0.8 * rail},
      {w / 2 - 0.8 * rail, 0.1 * d, h - 0.8 * rail}, 0)
  if white or dark then
    -- a few lines, written at the left
    for i = 0, says("projector", "projection") and -1 or 3 do
      local z = h * (0.82 - 0.1 * i)
      box(dark and "paper" or cover(1), {w * (0.42 - 0.1 * chance(i) - 0.2), 0.1 * d, z}, {0.42 * w, 0.11 * d,
          z + 0.012}, 0)
    end
    return
  end
  -- notes
  for i = 0, 5 do
    local x, z = w * (0.72 * chance(i) - 0.36), h * (0.2 + 0.55 * chance(10 + i))
    local s = 0.09 * min(w, h) * (1 + chance(20 + i))
    inside(facing_front(vec(x, 0.1 * d, z)), function()
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
