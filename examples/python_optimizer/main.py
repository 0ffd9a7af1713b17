#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An optimizer in Python: two constraint functions, simulated annealing. Serves flair.v1.OptimizerService.

    python3 examples/python_optimizer/main.py --listen 127.0.0.1:50063
    flair design "A bedroom that is 4m x 5m." --optimizer 127.0.0.1:50063 --out out/bedroom
"""

import argparse
from pathlib import Path

import grpc

from flair import v1
from flair.stage import Refusal, Stage, answers, digest_of, require, serve

from against_wall import AGAINST_WALL
from measures import measure
from next_to import NEXT_TO
from problem import Problem
from solving import solve
from terms import built_in_types

PROGRAM, LIBRARY = "python-optimizer", "python-optimizer 1"
Context = grpc.ServicerContext
FUNCTIONS = {function.type.name: function for function in (AGAINST_WALL, NEXT_TO)}


class Optimizer(v1.OptimizerServiceServicer):
    """Every answer is a function of its request alone, so that a repeat with the same request_id gets the same."""

    @answers
    def ListConstraintTypes(
        self, request: v1.ListConstraintTypesRequest, context: Context
    ) -> v1.ListConstraintTypesResponse:
        types = [function.type for function in FUNCTIONS.values()] + built_in_types()
        types.sort(key=lambda item: item.name)
        response = v1.ListConstraintTypesResponse(catalog=v1.ConstraintCatalog(library=LIBRARY, types=types))
        if not request.with_placed_examples:
            for item in response.catalog.types:
                del item.placed_examples[:]
        return response

    @answers
    def Solve(self, request: v1.SolveRequest, context: Context) -> v1.SolveResponse:
        require(request, "layout_graph")

        def require_caller() -> None:
            if not context.is_active():
                raise Refusal(grpc.StatusCode.CANCELLED, "nobody waits for the layout any more")

        problem = Problem(request.layout_graph, request.options, FUNCTIONS)
        response = solve(problem, request.options, require_caller)
        response.producer.program, response.producer.method, response.producer.version = PROGRAM, "annealing", "1"
        return response

    @answers
    def Evaluate(self, request: v1.EvaluateRequest, context: Context) -> v1.EvaluateResponse:
        require(request, "layout_graph")
        problem = Problem(request.layout_graph, request.options, FUNCTIONS)
        poses = problem.poses(request.placements)
        return v1.EvaluateResponse(
            edge_outcomes=problem.edge_outcomes(poses),
            term_outcomes=problem.term_outcomes(poses),
            metrics=measure(problem.scene, poses),
        )

    @answers
    def Resolve(self, request: v1.ResolveRequest, context: Context) -> v1.ResolveResponse:
        raise Refusal(grpc.StatusCode.UNIMPLEMENTED, "this optimizer solves from the start only")

    @answers
    def SolveRestarts(self, request: v1.SolveRestartsRequest, context: Context) -> v1.SolveRestartsResponse:
        raise Refusal(grpc.StatusCode.UNIMPLEMENTED, "this optimizer does not share its restarts")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--listen", default="127.0.0.1:50063", metavar="HOST:PORT", help="port 0 takes a free one")
    worker = v1.GetWorkerResponse(
        program=PROGRAM,
        revision=digest_of(list(Path(__file__).parent.glob("*.py"))),
        protocols=["flair.v1"],
        capabilities=[v1.Capability.CAPABILITY_DETERMINISTIC, v1.Capability.CAPABILITY_EVALUATE],
    )
    stage = Stage(worker, "flair.v1.OptimizerService",
                  lambda server: v1.add_OptimizerServiceServicer_to_server(Optimizer(), server))
    serve(stage, parser.parse_args().listen)


if __name__ == "__main__":
    main()
