# SPDX-License-Identifier: GPL-3.0-or-later
"""Which part of the floor belongs to which zone."""

from flair import v1

from functions import Poses
from geometry import cut
from scene import Scene


def zone_regions(scene: Scene, poses: Poses) -> list[v1.ZoneRegion]:
    """Voronoi cells of the mean points of the zones' furniture, cut to the floor."""
    centres: dict[str, tuple[float, float]] = {}
    for zone in scene.graph.zone_plan.zones:
        own = [poses[i] for i, item in enumerate(scene.objects)
               if item.zone_id == zone.id and scene.stands(i) and poses[i] is not None]
        if own:
            centres[zone.id] = (sum(p.x_m for p in own) / len(own), sum(p.y_m for p in own) / len(own))
    regions = []
    for name, (x, y) in centres.items():
        cell = scene.floor
        for other_x, other_y in centres.values():
            dx, dy = other_x - x, other_y - y
            middle = ((x + other_x) / 2, (y + other_y) / 2)
            if dx or dy:
                cell = cut(cell, middle, (middle[0] - dy, middle[1] + dx))
        corners = [v1.Point2(x_m=cx + 0.0, y_m=cy + 0.0) for cx, cy in cell]  # -0 has no JSON form
        parts = [v1.Polygon(vertices=corners)] if len(corners) > 2 else []
        regions.append(v1.ZoneRegion(zone_id=name, parts=parts, center=v1.Point2(x_m=x, y_m=y)))
    return regions
