# SPDX-License-Identifier: GPL-3.0-or-later
"""Flair from Python.

    Client         submits briefs and batches to an orchestrator, watches jobs, fetches what their stages stored
    Optimizer      solves graphs, and layouts again after edits
    Renderer       draws layouts and exports scenes
    inspect()      a short text about any artifact or message
    flair.v1       all messages, enums and stubs
    flair.stage    what a stage of your own needs: a server as the others are, checks of what arrives
"""

from flair.client import Client
from flair.errors import AlreadyExists, Busy, FlairError, InvalidRequest, JobFailed, NotFound, TimedOut, Unavailable
from flair.events import STAGES, Event
from flair.summary import inspect
from flair.workers import Optimizer, Renderer

__all__ = [
    "STAGES", "AlreadyExists", "Busy", "Client", "Event", "FlairError", "InvalidRequest", "JobFailed", "NotFound",
    "Optimizer", "Renderer", "TimedOut", "Unavailable", "inspect",
]
