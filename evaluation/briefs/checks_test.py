# SPDX-License-Identifier: GPL-3.0-or-later
"""Every check of the vocabulary: a plan that meets it, and one that does not."""

import math
import unittest
from pathlib import Path

import checks
from plan import Opening, Piece, Plan, Wall
from wishes import fault_of_wish

# Degrees, so that rows below can be read.
NORTH, WEST, SOUTH, EAST = 0, 90, 180, 270


def room(*pieces: Piece, windows: tuple[str, ...] = ("east",), doors: tuple[str, ...] = ("south",),
         width_m: float = 6, depth_m: float = 4, room_type: str = "living room") -> Plan:
    """A rectangle; openings are 1 m wide in the middle of their walls."""
    corners = [(0.0, 0.0), (width_m, 0.0), (width_m, depth_m), (0.0, depth_m)]
    walls = [Wall(begin, end) for begin, end in zip(corners, corners[1:] + corners[:1])]
    openings = []
    for kind, names in (("window", windows), ("door", doors)):
        for name in names:
            wall = next(wall for wall in walls if wall.compass == name)
            openings.append(Opening(kind, wall, wall.at_m(wall.length_m / 2 - 0.5), wall.at_m(wall.length_m / 2 + 0.5)))
    return Plan(walls, room_type, openings, list(pieces))


def piece(name: str, x_m: float, y_m: float, looks_deg: float = NORTH, width_m: float = 1.0,
          depth_m: float = 0.6) -> Piece:
    return Piece(name, x_m, y_m, math.radians(looks_deg), width_m, depth_m)


# check: (further fields of the wish, a plan that meets it, plans that do not)
CASES = {
    "count": ({"of": "@bed", "exactly": 2}, room(piece("single bed", 1, 1), piece("bunk bed", 4, 1)),
              [room(piece("single bed", 1, 1)), room(*(piece("bed", x, 1) for x in (1, 3, 5)))]),
    "piece_size": ({"of": "@desk", "sides_m": [0.7, 1.4], "exactly": 1},
                   room(piece("desk", 1, 1, width_m=1.4, depth_m=0.7), piece("desk", 4, 1)),
                   [room(piece("desk", 4, 1))]),
    "seats": ({"at_least": 5},
              room(piece("sofa", 3, 1, width_m=1.8), piece("armchair", 1, 1), piece("bar stool", 2, 1)),
              [room(piece("sofa", 3, 1, width_m=1.8), piece("workbench", 1, 1, width_m=3))]),
    "room_type": ({"contains": "kitchen"}, room(room_type="small kitchen"), [room(room_type="hall")]),
    "room_size": ({"sides_m": [4, 6]}, room(), [room(width_m=5.9), room(depth_m=4.1)]),
    "room_area": ({"area_m2": 24}, room(), [room(width_m=6.2)]),
    "opening_count": ({"opening": "window", "exactly": 0}, room(windows=()), [room()]),
    "opening_walls": ({"opening": "window", "walls": ["east", "north"]}, room(windows=("north", "east")),
                      [room(), room(windows=("north", "east", "west"))]),
    "opening_opposite": ({"opening": "window", "to_opening": "door", "exactly": 1}, room(windows=("north",)),
                         [room(), room(windows=("south",))]),
    "opening_one_wall": ({"opening": "window"}, room(windows=("north", "north")),
                         [room(windows=()), room(windows=("north", "east"))]),
    "at_wall": ({"of": "desk", "wall": "north", "back": True, "centred_m": 0.5}, room(piece("desk", 3.2, 3.6, SOUTH)),
                [room(piece("desk", 3.2, 3.6, NORTH)), room(piece("desk", 1, 3.6, SOUTH)),
                 room(piece("desk", 3, 0.4))]),
    "in_corner": ({"of": "lamp"},
                  room(piece("lamp", 0.6, 0.4)), [room(piece("lamp", 0.6, 2)), room(piece("lamp", 3, 0.4))]),
    "opposite_corner": ({"of": "desk", "to": "@bed"}, room(piece("desk", 0.6, 0.4), piece("bed", 5.4, 3.6)),
                        [room(piece("desk", 0.6, 2), piece("bed", 5.4, 3.6)),
                         room(piece("desk", 0.6, 0.4), piece("bed", 3, 2)),
                         room(piece("desk", 0.6, 0.4), piece("bed", 0.6, 0.4))]),
    "central": ({"of": "table"},
                room(piece("table", 3.5, 2.2)), [room(piece("table", 5, 2)), room(piece("table", 3, 3.5))]),
    "at_opening": ({"of": "desk", "opening": "window"}, room(piece("desk", 5, 2)),
                   [room(piece("desk", 4, 2)), room(piece("desk", 5, 0.5))]),
    "before_opening": ({"of": "sink", "opening": "window", "middle": True}, room(piece("sink", 5.7, 1.9, WEST)),
                       [room(piece("sink", 5.7, 1.2, WEST)), room(piece("sink", 5, 1.9, WEST))]),
    "near": ({"of": "lamp", "to": "@sofa", "within_m": 0.5}, room(piece("lamp", 1, 1), piece("sofa", 2.4, 1)),
             [room(piece("lamp", 1, 1), piece("sofa", 2.6, 1)), room(piece("lamp", 1, 1))]),
    "between": ({"of": "lamp", "ends": ["@armchair", "@armchair"]},
                room(piece("armchair", 1, 1), piece("lamp", 2.4, 1.2), piece("armchair", 4, 1)),
                [room(piece("armchair", 1, 1), piece("lamp", 1.4, 1), piece("armchair", 4, 1)),
                 room(piece("armchair", 1, 1), piece("lamp", 2.5, 2), piece("armchair", 4, 1)),
                 room(piece("lamp", 2.4, 1.2), piece("armchair", 4, 1))]),
    "facing": ({"of": "chair", "to": "window"}, room(piece("chair", 2, 2, EAST)),
               [room(piece("chair", 2, 2, WEST)), room(piece("chair", 2, 2, EAST + 45))]),
    "opposed": ({"of": "desk", "to": "desk", "at_least": 2},
                room(piece("desk", 2, 1, SOUTH), piece("desk", 2, 1.6, NORTH)),
                [room(piece("desk", 2, 1, NORTH), piece("desk", 2, 1.6, NORTH)),
                 room(piece("desk", 2, 1, SOUTH), piece("desk", 4, 1, NORTH)), room(piece("desk", 2, 1))]),
    "in_front": ({"of": "chest", "to": "@bed"}, room(piece("bed", 2, 1, NORTH, 1.5, 2), piece("chest", 2, 2.4)),
                 [room(piece("bed", 2, 1, SOUTH, 1.5, 2), piece("chest", 2, 2.4)),
                  room(piece("bed", 2, 1, NORTH, 1.5, 2), piece("chest", 2, 3.2))]),
    "behind": ({"of": "console", "to": "@sofa"}, room(piece("sofa", 2, 2, NORTH), piece("console", 2, 1.3)),
               [room(piece("sofa", 2, 2, SOUTH), piece("console", 2, 1.3)),
                room(piece("sofa", 2, 2), piece("console", 2, 0.9))]),
    "beside": ({"of": "table", "to": "@armchair", "side": "right"},
               room(piece("armchair", 2, 2, SOUTH), piece("table", 0.9, 2)),
               [room(piece("armchair", 2, 2, NORTH), piece("table", 0.9, 2)),
                room(piece("armchair", 4, 2, SOUTH), piece("table", 0.9, 2)),
                room(piece("armchair", 2, 2, SOUTH), piece("table", 2, 1.3))]),
    "in_row": ({"of": "desk"}, room(piece("desk", 1, 1), piece("desk", 3, 1.1), piece("desk", 5, 1)),
               [room(piece("desk", 1, 1), piece("desk", 3, 1.4)), room(piece("desk", 1, 1))]),
    "same_direction": ({"of": "chair"}, room(piece("chair", 1, 1, 5), piece("chair", 2, 1, 355)),
                       [room(piece("chair", 1, 1, NORTH), piece("chair", 2, 1, SOUTH)), room(piece("chair", 1, 1))]),
}


def wish_of(check: str, fields: dict) -> dict:
    return {"wish": "a wish", "check": check, "remark": ["word"], **fields}


class Checks(unittest.TestCase):
    def test_every_check_has_a_case(self) -> None:
        self.assertEqual(list(CASES), list(checks.CHECKS))

    def test_the_readme_tells_of_every_check(self) -> None:
        readme = (Path(__file__).parent / "README.md").read_text(encoding="utf-8")
        self.assertEqual([name for name in checks.CHECKS if f"`{name}`" not in readme], [])

    def test_plans_that_meet_a_wish_are_told_from_those_that_do_not(self) -> None:
        for check, (fields, good, bad) in CASES.items():
            with self.subTest(check):
                self.assertEqual(fault_of_wish(wish_of(check, fields)), "")
                self.assertTrue(checks.holds(good, wish_of(check, fields)))
                for number, plan in enumerate(bad):
                    self.assertFalse(checks.holds(plan, wish_of(check, fields)), f"plan {number}")


class Options(unittest.TestCase):
    def holds(self, plan: Plan, check: str, **fields: object) -> bool:
        self.assertEqual(fault_of_wish(wish_of(check, fields)), "")
        return checks.holds(plan, wish_of(check, fields))

    def test_a_thing_is_near_to_what_it_stands_on(self) -> None:
        plan = room(piece("lamp", 1, 1, width_m=0.1, depth_m=0.1), piece("desk", 1, 1))
        self.assertTrue(self.holds(plan, "near", of="lamp", to="desk", within_m=0.05))
        self.assertTrue(self.holds(plan, "near", of="desk", to="lamp", within_m=0.05))

    def test_numbers_bound_how_many_pieces_meet_a_check(self) -> None:
        two = room(piece("desk", 1, 0.3), piece("desk", 3, 2))
        at_south = {"of": "desk", "wall": "south"}
        self.assertTrue(self.holds(two, "at_wall", **at_south))
        self.assertTrue(self.holds(two, "at_wall", exactly=1, **at_south))
        self.assertFalse(self.holds(two, "at_wall", at_least=2, **at_south))
        self.assertFalse(self.holds(two, "at_wall", at_most=0, **at_south))
        self.assertFalse(self.holds(two, "at_wall", all=True, **at_south))
        self.assertFalse(self.holds(room(), "at_wall", all=True, **at_south))

    def test_left_and_right_are_those_of_who_comes_in(self) -> None:
        west = room(piece("desk", 0.5, 2))
        self.assertTrue(self.holds(west, "at_wall", of="desk", wall="left"))
        self.assertFalse(self.holds(west, "at_wall", of="desk", wall="right"))
        from_north = room(piece("desk", 0.5, 2), doors=("north",))
        self.assertTrue(self.holds(from_north, "at_wall", of="desk", wall="right"))
        self.assertFalse(self.holds(room(piece("desk", 0.5, 2), doors=()), "at_wall", of="desk", wall="left"))

    def test_the_longest_wall_and_any_wall(self) -> None:
        self.assertTrue(self.holds(room(piece("desk", 3, 0.3)), "at_wall", of="desk", wall="longest"))
        self.assertFalse(self.holds(room(piece("desk", 0.5, 2)), "at_wall", of="desk", wall="longest"))
        self.assertTrue(self.holds(room(piece("desk", 0.5, 2)), "at_wall", of="desk", wall="any"))
        self.assertFalse(self.holds(room(piece("desk", 3, 2)), "at_wall", of="desk", wall="any"))

    def test_the_widest_door_is_meant_when_said_so(self) -> None:
        plan = room(piece("table", 1, 2), doors=("south", "west"))
        south, west = plan.openings_of("door")
        wide = Opening("door", south.wall, south.wall.at_m(2), south.wall.at_m(4))
        for openings, held in (([wide, west], False), ([west], True)):
            plan = Plan(plan.walls, openings=openings, pieces=plan.pieces)
            self.assertTrue(self.holds(plan, "at_opening", of="table", opening="door"))
            self.assertEqual(self.holds(plan, "at_opening", of="table", opening="door", widest=True), held)

    def test_corners_of_a_side_and_by_a_door(self) -> None:
        south_west = room(piece("lamp", 0.6, 0.4))
        self.assertTrue(self.holds(south_west, "in_corner", of="lamp", side="left"))
        self.assertFalse(self.holds(south_west, "in_corner", of="lamp", side="right"))
        self.assertFalse(self.holds(south_west, "in_corner", of="lamp", opening="door"))
        self.assertTrue(self.holds(room(piece("lamp", 0.6, 0.4), width_m=4), "in_corner", of="lamp", opening="door"))

    def test_facing_each_other_takes_both_and_not_too_far(self) -> None:
        both = room(piece("sofa", 1, 2, EAST), piece("sofa", 4, 2, WEST))
        self.assertTrue(self.holds(both, "facing", of="@sofa", to="@sofa", each_other=True, at_least=2))
        self.assertFalse(self.holds(both, "facing", of="@sofa", to="@sofa", each_other=True, within_m=2))
        one = room(piece("sofa", 1, 2, EAST), piece("sofa", 4, 2, EAST))
        self.assertTrue(self.holds(one, "facing", of="@sofa", to="@sofa"))
        self.assertFalse(self.holds(one, "facing", of="@sofa", to="@sofa", each_other=True))

    def test_beside_on_either_hand(self) -> None:
        for x_m, held in ((4.2, True), (1.8, True), (3.1, False)):
            plan = room(piece("fireplace", 3, 0.3), piece("bookshelf", x_m, 0.3))
            self.assertEqual(self.holds(plan, "beside", of="bookshelf", to="fireplace", side="either"), held)

    def test_one_end_of_between_may_be_an_opening(self) -> None:
        ends = ["sideboard", "window"]
        self.assertTrue(self.holds(room(piece("sideboard", 1, 2), piece("cart", 3, 2)), "between",
                                   of="cart", ends=ends))
        self.assertFalse(self.holds(room(piece("sideboard", 1, 2), piece("cart", 3, 2), windows=("north",)), "between",
                                    of="cart", ends=ends))

    def test_pieces_on_the_floor_are_standing_and_rugs_are_not(self) -> None:
        rug = Piece("area rug", 5.5, 2, 0.0, 1, 1, walk_over=True)
        picture = Piece("painting", 5.9, 2, 0.0, 0.1, 1, kind="wall")
        free = {"of": "@standing", "opening": "window", "exactly": 0}
        self.assertTrue(self.holds(room(rug, picture), "before_opening", **free))
        self.assertFalse(self.holds(room(piece("desk", 5.5, 2)), "before_opening", **free))


if __name__ == "__main__":
    unittest.main()
