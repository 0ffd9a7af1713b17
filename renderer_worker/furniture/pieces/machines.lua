-- SPDX-License-Identifier: GPL-3.0-or-later
-- Equipment of offices, workshops and gyms, and what heats and cools.

-- Ribs side by side between two pipes.
function mesh.radiator()
  local count = clamp(floor(w / 0.06), 3, 24)
  for i = 0, count - 1 do
    local x, half = w * ((i + 0.5) / count - 0.5), 0.42 * w / count
    box("hard", {x - half, -0.3 * d, 0.04 * h}, {x + half, d / 2, h}, 0.45 * half)
  end
  for z in each{0.12, 0.88} do bar("hard", {-w / 2, 0, z * h}, {w / 2, 0, z * h}, 0.16 * d, 8) end
  box("metal", {-0.4 * w, -d / 2, 0}, {-0.36 * w, 0, 0.9 * h}, 0)
  box("metal", {0.36 * w, -d / 2, 0}, {0.4 * w, 0, 0.9 * h}, 0)
end

function mesh.water_cooler()
  local top, r = 0.66 * h, 0.42 * smaller
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, 0.4 * d, top}, 0.02)
  box("black plastic", {-0.3 * w, 0.38 * d, 0.42 * h}, {0.3 * w, 0.41 * d, 0.6 * h}, 0.004)
  box("hard", {-0.3 * w, 0.3 * d, 0.38 * h}, {0.3 * w, d / 2, 0.42 * h}, 0.008)
  for side in each{-1, 1} do knob({side * 0.15 * w, 0.41 * d, 0.55 * h}, 0.05 * w) end
  lathe("clear water", {0, -0.05 * d, top}, {{0.3 * r, 0}, {0.4 * r, 0.1 * (h - top)}, {r, 0.3 * (h - top)},
      {r, 0.92 * (h - top)}, {0.8 * r, h - top}, {0, h - top}}, 24)
end

function mesh.server_rack()
  box("black plastic", {-w / 2, -d / 2, 0}, {w / 2, 0.46 * d, h}, 0.006)
  local units = clamp(floor(h / 0.09), 3, 24)
  for i = 0, units - 1 do
    local low, high = h * (0.04 + 0.92 * i / units), h * (0.04 + 0.92 * (i + 0.86) / units)
    box(chance(i) < 0.7 and "hard" or "dark screen", {-0.44 * w, 0.45 * d, low}, {0.44 * w, d / 2, high}, 0.002)
    for k = 0, 3 do
      box(chance(9 * i + k) < 0.3 and "flame" or "lit screen", {(0.2 + 0.05 * k) * w, 0.49 * d, (low + high) / 2},
          {(0.22 + 0.05 * k) * w, 0.505 * d, (low + high) / 2 + 0.008}, 0)
    end
  end
end

-- Fired clay's oven: a round body in bands, a lid, a controller at its side.
function mesh.kiln()
  lathe("hard", {}, {{0.4, 0}, {0.4, 0.12 * h}, {0.5, 0.13 * h}, {0.5, 0.84 * h}, {0.49, 0.85 * h}}, 12, {0.92 * w, d})
  lathe("hard", {0, 0, 0.86 * h}, {{0.5, 0}, {0.5, 0.1 * h}, {0.46, 0.14 * h}}, 12, {0.92 * w, d})
  for z in each{0.14, 0.48, 0.8} do
    ring("metal", {0, 0, z * h}, {{0.49, 0}, {0.505, 0}, {0.505, 0.03 * h}, {0.49, 0.03 * h}}, 12, {0.92 * w, d})
  end
  box("black plastic", {0.42 * w, -0.14 * d, 0.3 * h}, {w / 2, 0.14 * d, 0.62 * h}, 0.006)
  handle({0, 0.47 * d, 0.92 * h}, 0.2 * w, false)
end

-- A wheel head with a lump of clay in its splash pan, a pedal.
function mesh.pottery_wheel()
  local top, r = 0.72 * h, 0.34 * smaller
  legs_at("metal", 0.42 * w, 0.4 * d, top, 0.03 * smaller, 1)
  box("hard", {-0.46 * w, -d / 2, 0.6 * top}, {0.46 * w, 0.46 * d, top}, 0.02)
  ring("black plastic", {0, 0.08 * d, top}, {{1.3 * r, 0}, {1.4 * r, 0}, {1.4 * r, 0.14 * h}, {1.3 * r, 0.14 * h}}, 28)
  cylinder("brushed steel", {0, 0.08 * d, top}, r, 0.06 * h, 0.004, 28)
  lathe("terracotta", {0, 0.08 * d, top + 0.06 * h}, {{0.4 * r, 0}, {0.55 * r, 0.1 * h}, {0.45 * r, 0.22 * h},
      {0.38 * r, 0.22 * h}, {0.3 * r, 0.05 * h}, {0, 0.04 * h}}, 20)
  box("rubber", {0.3 * w, 0.3 * d, 0}, {w / 2, d / 2, 0.1 * h}, 0.01)
end

function plan.pottery_wheel()
  area(whole, "body", "outline", 0.04)
  circle({0, 0.08 * d}, 0.42 * smaller, "light")
  circle({0, 0.08 * d}, 0.3 * smaller, "metal")
end

-- Four uprights with a bar across, the safety arms below it.
function mesh.power_rack()
  local post, x, y = 0.03 * smaller, 0.36 * w, d / 2 - 0.03 * smaller
  for side in each{-1, 1} do
    for at in each{-y, y} do box("hard", {side * x - post, at - post, 0}, {side * x + post, at + post, h}, 0.004) end
    for z in each{0.02, 0.4, 0.98} do
      box("hard", {side * x - post, -y, z * h - post}, {side * x + post, y, z * h + post}, 0.004)
    end
    for out in each{0.43, 0.47} do
      inside(facing_right({side * out * w, 0.3 * d, 0.62 * h}), function()
        cylinder("rubber", {0, 0, -0.015 * w}, 0.1 * h, 0.03 * w, 0.004, 24)
      end)
    end
  end
  box("hard", {-x, -y - post, 0.96 * h}, {x, -y + post, h}, 0.004)
  box("hard", {-x, y - post, 0.96 * h}, {x, y + post, h}, 0.004)
  bar("metal", {-w / 2, 0.3 * d, 0.62 * h}, {w / 2, 0.3 * d, 0.62 * h}, 0.012 * smaller, 10)
end

function plan.power_rack()
  for x in each{-0.36 * w, 0.36 * w} do area({x - 0.03 * w, back, x + 0.03 * w, front}, "body", "detail") end
  area({left, 0.28 * d, right, 0.32 * d}, "metal", "detail")
  for x in each{0.9 * left, 0.9 * right} do area({x - 0.04 * w, 0.12 * d, x + 0.04 * w, 0.48 * d}, "deep") end
end

function mesh.trampoline()
  local legs = 6
  lathe("rubber", {0, 0, 0.9 * h}, {{0.4, 0}, {0.4, 0.02 * h}}, 32, {w, d})
  ring("soft", {0, 0, 0.88 * h}, {{0.39, 0}, {0.5, 0}, {0.5, 0.12 * h}, {0.39, 0.12 * h}}, 36, {w, d})
  for i = 0, legs - 1 do
    local x, y = 0.46 * w * cos(2 * pi * i / legs), 0.46 * d * sin(2 * pi * i / legs)
    bar("metal", {x, y, 0}, {x, y, 0.9 * h}, 0.015 * smaller, 8)
  end
end

-- A bench with a panel, hooks and a shelf above it.
function mesh.hall_tree()
  local seat, board = min(0.45, 0.3 * h), min(0.025, 0.06 * smaller)
  box("hard", {-w / 2, -d / 2, 0}, {w / 2, -d / 2 + board, h}, 0.004)
  for side in each{-1, 1} do box("hard", {side * w / 2, -d / 2, 0}, {side * (w / 2 - board), d / 2, seat}, 0.004) end
  box("hard", {-w / 2, -d / 2, seat - 1.4 * board}, {w / 2, d / 2, seat}, 0.006)
  box("hard", {-w / 2, -d / 2, 0.1 * seat}, {w / 2, 0.46 * d, 0.1 * seat + board}, 0.004)
  box("hard", {-w / 2, -d / 2, h - board}, {w / 2, 0.1 * d, h}, 0.006)
  local hooks = clamp(floor(w / 0.18), 3, 9)
  for i = 0, hooks - 1 do
    local x = w * ((i + 0.5) / hooks - 0.5)
    tube("metal", {{x, -d / 2 + board, 0.8 * h}, {x, -0.2 * d, 0.79 * h}, {x, -0.14 * d, 0.83 * h}}, 0.008, 8)
  end
end

function plan.hall_tree()
  area(whole, "body", "outline", 0.01)
  area({left, back, right, 0.1 * d}, "dark", "detail")
  for i = 1, 4 do segment({left + w * i / 5, 0.1 * d}, {left + w * i / 5, 0.22 * d}, "detail") end
end
