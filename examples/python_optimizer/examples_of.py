# SPDX-License-Identifier: GPL-3.0-or-later
"""Short ways to write the examples of a constraint type: calls, and small furnished rooms."""

from flair import v1


def argument(name: str, text: str) -> v1.Argument:
    return v1.Argument(name=name, value=v1.ArgumentValue(text=text))


def room_of(width_m: float, depth_m: float) -> v1.Room:
    """An empty rectangle without doors."""
    corners = [(0, 0), (width_m, 0), (width_m, depth_m), (0, depth_m)]
    return v1.Room(
        room_type="room",
        title="example",
        floor=v1.Polygon(vertices=[v1.Point2(x_m=x, y_m=y) for x, y in corners]),
        walls=[v1.Wall(name=name) for name in ("south", "east", "north", "west")],
        height_m=3,
    )


def placed_example(
    room: v1.Room,
    sizes: dict[str, tuple[float, float]],
    poses: dict[str, tuple[float, float, float]],
    arguments: dict[str, str],
    satisfied: bool,
) -> v1.PlacedExample:
    """Objects by id: width and depth; x, y and heading of each. All are 0.5 m high and of one zone."""
    kind = {"role": v1.ObjectRole.OBJECT_ROLE_PRIMARY, "kind": v1.ObjectKind.OBJECT_KIND_FLOOR, "zone_id": "all"}
    objects = [v1.Object(id=name, name=name, width_m=width, depth_m=depth, height_m=0.5, **kind)
               for name, (width, depth) in sizes.items()]
    placements = [v1.Placement(object_id=name, x_m=x, y_m=y, theta_rad=heading)
                  for name, (x, y, heading) in poses.items()]
    return v1.PlacedExample(
        room=room,
        zone_plan=v1.ZonePlan(zones=[v1.Zone(id="all", name="all")]),
        object_list=v1.ObjectList(objects=objects),
        placements=placements,
        arguments=[argument(name, text) for name, text in arguments.items()],
        satisfied=satisfied,
    )
