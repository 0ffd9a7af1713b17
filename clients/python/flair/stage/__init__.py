# SPDX-License-Identifier: GPL-3.0-or-later
"""What a stage written in Python needs beside its subject: a server as the others are, and checks of what arrives.

    serve(Stage(worker, "flair.v1.OptimizerService", lambda server: add_..._to_server(servicer, server)), "127.0.0.1:0")
"""

from flair.stage.checks import problems_in, require
from flair.stage.refusal import Refusal, answers
from flair.stage.serve import Stage, digest_of, serve

__all__ = ["Refusal", "Stage", "answers", "digest_of", "problems_in", "require", "serve"]
