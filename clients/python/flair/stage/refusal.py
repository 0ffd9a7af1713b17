# SPDX-License-Identifier: GPL-3.0-or-later
"""How a handler says no."""

import functools
from collections.abc import Callable
from typing import Any

import grpc


class Refusal(Exception):
    """Ends a call with a status and one sentence: field, value and what would be right."""

    def __init__(self, status: grpc.StatusCode, message: str) -> None:
        super().__init__(message)
        self.status = status
        self.message = message


def answers(handler: Callable[..., Any]) -> Callable[..., Any]:
    """Makes a Refusal that a servicer's method raises the answer of its call."""

    @functools.wraps(handler)
    def handle(servicer: Any, request: Any, context: grpc.ServicerContext) -> Any:
        try:
            return handler(servicer, request, context)
        except Refusal as refusal:
            context.abort(refusal.status, refusal.message)

    return handle
