# SPDX-License-Identifier: GPL-3.0-or-later
"""Clients of single workers: edits of a layout, pictures and scenes of it."""

import uuid
from collections.abc import Iterable
from typing import Any

from flair import v1
from flair.client import Connection

# A ray-traced view of many samples takes its time.
_DRAWING_S = 3600.0


class Optimizer(Connection):
    """A connection to flair-optimizer."""

    def __init__(self, address: str, **options: Any) -> None:
        super().__init__(address, **options)
        self._stub = v1.OptimizerServiceStub(self._calls)

    def solve(self, graph: v1.LayoutGraph | v1.Artifact, options: v1.SolveOptions | None = None) -> v1.SolveResponse:
        """Places the objects of a graph."""
        graph = graph.layout_graph if isinstance(graph, v1.Artifact) else graph
        request = v1.SolveRequest(request_id=str(uuid.uuid4()), layout_graph=graph, options=options)
        return self._call(self._stub.Solve, request, _DRAWING_S)

    def resolve(
        self,
        layout: v1.SolvedLayout | v1.Artifact,
        edits: Iterable[v1.LayoutEdit],
        options: v1.SolveOptions | None = None,
    ) -> v1.ResolveResponse:
        """Changes a layout and solves again what the edits affect: `solved_layout` and `moved_object_ids`."""
        request = v1.ResolveRequest(
            request_id=str(uuid.uuid4()), solved_layout=_layout(layout), edits=edits, options=options)
        return self._call(self._stub.Resolve, request, _DRAWING_S)


class Renderer(Connection):
    """A connection to flair-renderer."""

    def __init__(self, address: str, **options: Any) -> None:
        super().__init__(address, **options)
        self._stub = v1.RendererServiceStub(self._calls)

    def render(
        self, layout: v1.SolvedLayout | v1.Artifact, options: v1.RenderOptions | None = None
    ) -> v1.Preview:
        """A picture of a layout: its plan unless the options say otherwise; `image` has the bytes of the file."""
        request = v1.RenderRequest(request_id=str(uuid.uuid4()), solved_layout=_layout(layout), options=options)
        return self._call(self._stub.Render, request, _DRAWING_S).preview

    def draw_plan_parts(
        self, layout: v1.SolvedLayout | v1.Artifact, object_ids: Iterable[str] = ()
    ) -> v1.PlanParts:
        """The plan as SVG elements that can be moved, of these objects or of everything; optional for renderers."""
        request = v1.DrawPlanPartsRequest(
            request_id=str(uuid.uuid4()), solved_layout=_layout(layout), object_ids=object_ids)
        return self._call(self._stub.DrawPlanParts, request, _DRAWING_S).parts

    def export_scene(
        self,
        layout: v1.SolvedLayout | v1.Artifact,
        scene_format: "v1.SceneFormat" = v1.SceneFormat.SCENE_FORMAT_GLB,
    ) -> bytes:
        """The furnished room in three dimensions, as the bytes of a .glb file."""
        request = v1.ExportSceneRequest(
            request_id=str(uuid.uuid4()), solved_layout=_layout(layout), format=scene_format)
        return self._call(self._stub.ExportScene, request, _DRAWING_S).scene


def _layout(layout: v1.SolvedLayout | v1.Artifact) -> v1.SolvedLayout:
    return layout.solved_layout if isinstance(layout, v1.Artifact) else layout
