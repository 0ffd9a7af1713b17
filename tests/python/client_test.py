# SPDX-License-Identifier: GPL-3.0-or-later
"""The client against a real orchestrator with real workers."""

import hashlib
import itertools
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import grpc

import flair
from flair import v1
from programs import BIN, Program, orchestrator, program

TEXT = "A bedroom that is 3m x 4m."


class TurnedAway(unittest.TestCase):
    """A server that has no room for a large message says so to gRPC, which tells it in words of its own."""

    def test_the_call_is_made_again(self) -> None:
        refusals = [(grpc.StatusCode.UNAVAILABLE, "GOAWAY received"),
                    (grpc.StatusCode.RESOURCE_EXHAUSTED, "Received RST_STREAM with error code 11")]

        class Orchestrator(grpc.GenericRpcHandler):
            def service(self, details):
                return grpc.unary_unary_rpc_method_handler(self.answer)

            def answer(self, request: bytes, context: grpc.ServicerContext) -> bytes:
                if refusals:
                    context.abort(*refusals.pop())
                return v1.GetJobResponse(job=v1.Job(id="7")).SerializeToString()

        server = grpc.server(ThreadPoolExecutor(1))
        server.add_generic_rpc_handlers((Orchestrator(),))
        port = server.add_insecure_port("127.0.0.1:0")
        server.start()
        with flair.Client(f"127.0.0.1:{port}") as client:
            self.assertEqual(client.job("7").id, "7")
        self.assertEqual(refusals, [])
        server.stop(None)


class WithOrchestrator(unittest.TestCase):
    """All five programs, for all tests of a class."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        names = ("language", "translator", "optimizer", "renderer")
        cls.stages = {name: cls.enterClassContext(program(f"flair-{name}", cls.folder)).address for name in names}
        cls.orchestrator = cls.enterClassContext(orchestrator(cls.folder, **cls.stages))

    def setUp(self) -> None:
        self.client = self.enterContext(flair.Client(self.orchestrator.address))


class Designing(WithOrchestrator):
    def test_a_text_becomes_a_layout_and_a_picture(self) -> None:
        job = self.client.submit(TEXT, seed=3, render_options=v1.RenderOptions(size_px=256))
        events = list(self.client.watch(job))
        self.assertEqual([event.sequence for event in events], list(range(1, len(events) + 1)))
        self.assertEqual((events[-1].kind, events[-1].state), ("ended", "succeeded"))
        finished = {event.stage for event in events if event.kind == "stage_finished"}
        self.assertEqual(finished, set(flair.STAGES))
        self.assertEqual(self.client.wait(job).state, v1.JobState.JOB_STATE_SUCCEEDED)
        layout = self.client.fetch(job, "solve").solved_layout
        self.assertEqual(layout.graph.room.room_type, "bedroom")
        self.assertIn("bedroom, 3 m x 4 m", flair.inspect(self.client.fetch(job, "room")))
        self.assertIn(f"{len(layout.placements)} objects placed", flair.inspect(layout))
        self.assertEqual(self.client.fetch(job, "render").preview.image[:4], b"\x89PNG")
        self.assertIn(job.id, [other.id for other in self.client.jobs()])

    def test_every_stage_can_be_fetched_and_inspected(self) -> None:
        job = self.client.wait(self.client.submit(TEXT, seed=4))
        for stage in flair.STAGES:
            with self.subTest(stage):
                artifact = self.client.fetch(job.id, stage)
                self.assertEqual(self.client.artifact(artifact.id), artifact)
                self.assertGreater(len(flair.inspect(artifact).splitlines()), 1)

    def test_watching_goes_on_after_the_last_event_that_was_seen(self) -> None:
        job = self.client.submit(TEXT, seed=5)
        first = list(itertools.islice(self.client.watch(job), 3))
        rest = list(self.client.watch(job, after=first[-1].sequence))
        self.assertEqual(rest[0].sequence, first[-1].sequence + 1)
        self.assertEqual(rest[-1].kind, "ended")

    def test_the_same_request_id_is_the_same_job(self) -> None:
        first = self.client.submit(TEXT, request_id="once")
        self.assertEqual(self.client.submit(TEXT, request_id="once").id, first.id)
        with self.assertRaises(flair.AlreadyExists):
            self.client.submit("Another room.", request_id="once")

    def test_a_brief_may_bring_its_room(self) -> None:
        room = self.client.fetch(self.client.wait(self.client.submit(TEXT)), "room").room
        room.title = "Mine"
        job = self.client.wait(self.client.submit(v1.Brief(text="A study.", room=room)))
        self.assertEqual(self.client.fetch(job, "room").room.title, "Mine")

    def test_a_batch_ends_with_a_layout_for_every_brief(self) -> None:
        batch = self.client.submit_batch(["A bedroom.", v1.Brief(text="A small study.", seed=2)], label="two")
        ended = {job.batch_index: job for job in self.client.watch_batch(batch, timeout_s=120)}
        self.assertEqual([ended[i].state for i in sorted(ended)], [v1.JobState.JOB_STATE_SUCCEEDED] * 2)
        self.assertEqual(ended[1].spec.brief.text, "A small study.")
        self.assertEqual(self.client.batch(batch).succeeded_count, 2)
        self.assertGreater(len(self.client.fetch(ended[0], "solve").solved_layout.placements), 3)


class Workers(unittest.TestCase):
    def test_edits_pictures_and_scenes_are_made_of_a_layout(self) -> None:
        folder = Path(tempfile.mkdtemp())
        with program("flair-optimizer", folder) as optimizer, program("flair-renderer", folder) as renderer:
            with flair.Optimizer(optimizer.address) as solver, flair.Renderer(renderer.address) as drawer:
                layout = solver.solve(small_graph()).solved_layout
                self.assertEqual(len(layout.placements), 1)
                answer = solver.resolve(layout, [v1.LayoutEdit(pin_object_id="table")])
                self.assertEqual([p.object_id for p in answer.solved_layout.placements], ["table"])
                self.assertEqual(answer.solved_layout.graph.pinned_placements[0].object_id, "table")
                self.assertTrue(drawer.render(answer.solved_layout).image.startswith(b"\x89PNG"))
                self.assertTrue(drawer.export_scene(answer.solved_layout).startswith(b"glTF"))


def small_graph() -> v1.LayoutGraph:
    graph = v1.LayoutGraph()
    graph.room.room_type = "room"
    graph.room.height_m = 3
    for name, x, y in [("south", 0, 0), ("east", 3, 0), ("north", 3, 3), ("west", 0, 3)]:
        graph.room.walls.add(name=name)
        graph.room.floor.vertices.add(x_m=x, y_m=y)
    graph.zone_plan.zones.add(id="all", name="all")
    graph.object_list.objects.add(
        id="table", name="table", role=v1.ObjectRole.OBJECT_ROLE_PRIMARY, kind=v1.ObjectKind.OBJECT_KIND_FLOOR,
        zone_id="all", width_m=1, depth_m=0.8, height_m=0.75)
    return graph


class Failing(WithOrchestrator):
    def test_a_bad_request_names_its_field(self) -> None:
        with self.assertRaises(flair.InvalidRequest) as caught:
            self.client.submit("   ")
        self.assertEqual(caught.exception.status, grpc.StatusCode.INVALID_ARGUMENT)
        self.assertEqual(caught.exception.field, "spec.brief.text")

    def test_a_job_that_fails_says_where_and_why(self) -> None:
        job = self.client.submit("A bedroom that is 400m x 5m.")
        with self.assertRaises(flair.JobFailed) as caught:
            self.client.wait(job)
        self.assertEqual((caught.exception.status, caught.exception.stage, caught.exception.job_id),
                         (grpc.StatusCode.INVALID_ARGUMENT, "room", job.id))
        self.assertIn("400", caught.exception.message)

    def test_what_is_not_there_is_not_found(self) -> None:
        for ask in (self.client.job, self.client.wait, self.client.cancel, lambda job: self.client.fetch(job, "room")):
            with self.assertRaises(flair.NotFound):
                ask("no-such-job")
        with self.assertRaises(flair.NotFound):
            self.client.artifact("0" * 64)
        failed = self.client.submit("A bedroom that is 400m x 5m.")
        list(self.client.watch(failed))
        with self.assertRaisesRegex(flair.NotFound, 'has stored brief, not "solve"'):
            self.client.fetch(failed, "solve")
        with self.assertRaisesRegex(ValueError, '"layout" is none; one of brief, room'):
            self.client.fetch(failed, "layout")

    def test_a_cancelled_job_is_no_success(self) -> None:
        slow = v1.SolveOptions(max_restart_count=10000, thread_count=1)
        job = self.client.submit(TEXT, solve_options=slow)
        for event in self.client.watch(job):
            if (event.kind, event.stage) == ("stage_started", "solve"):
                self.client.cancel(job)
        with self.assertRaises(flair.JobFailed) as caught:
            self.client.wait(job)
        self.assertEqual(caught.exception.status, grpc.StatusCode.CANCELLED)

    def test_patience_has_an_end(self) -> None:
        job = self.client.submit(TEXT, solve_options=v1.SolveOptions(max_restart_count=10000, thread_count=1))
        with self.assertRaises(flair.TimedOut):
            self.client.wait(job, timeout_s=0.2)
        self.client.cancel(job)

    def test_nobody_there_is_unavailable(self) -> None:
        with flair.Client("127.0.0.1:1") as client, self.assertRaises(flair.Unavailable):
            client.submit(TEXT)


class Restarting(WithOrchestrator):
    def test_watching_survives_a_restart_of_the_orchestrator(self) -> None:
        path = self.folder / "socket"
        addresses = " ".join(f'{name}: "{address}"' for name, address in self.stages.items())
        (self.folder / "again.textproto").write_text(
            f'runtime {{ listen_address: "unix:{path}" log_level: "error" }}\n'
            f'store_path: "{path}.d"\nstages {{ {addresses} }}\n')
        command = (BIN / "flair-orchestrator", self.folder / "again.textproto")
        seen = []
        with flair.Client(f"unix:{path}") as client:
            with Program(*command):
                job = client.submit(TEXT, solve_options=v1.SolveOptions(max_restart_count=60, thread_count=1))
                events = client.watch(job)
                while not seen or (seen[-1].kind, seen[-1].stage) != ("stage_started", "solve"):
                    seen.append(next(events))
            with Program(*command):
                seen += list(events)
        self.assertEqual((seen[-1].kind, seen[-1].state), ("ended", "succeeded"))
        self.assertEqual([event.sequence for event in seen], sorted({event.sequence for event in seen}))


class Tls(unittest.TestCase):
    """A server of gRPC's own, as somebody else's proxy would be; docs/security.md and tests/security have Flair's."""

    class Orchestrator(v1.OrchestratorServiceServicer):
        def GetJob(self, request: v1.GetJobRequest, context: grpc.ServicerContext) -> v1.GetJobResponse:
            return v1.GetJobResponse(job=v1.Job(id=request.job_id))

    def test_only_certificates_that_are_trusted_are_taken(self) -> None:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        key, certificate = folder / "key.pem", folder / "certificate.pem"
        subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1",
                        "-nodes", "-keyout", key, "-out", certificate, "-subj", "/CN=localhost",
                        "-addext", "subjectAltName=DNS:localhost"], check=True, capture_output=True)
        server = grpc.server(ThreadPoolExecutor(2))
        v1.add_OrchestratorServiceServicer_to_server(self.Orchestrator(), server)
        pair = [(key.read_bytes(), certificate.read_bytes())]
        port = server.add_secure_port("localhost:0", grpc.ssl_server_credentials(pair))
        server.start()
        self.addCleanup(lambda: server.stop(None).wait())
        with flair.Client(f"localhost:{port}", tls=certificate) as client:
            self.assertEqual(client.job("j1").id, "j1")
        for other in (True, False):
            with flair.Client(f"localhost:{port}", tls=other) as client, self.assertRaises(flair.Unavailable):
                client.job("j1")


class Tokens(unittest.TestCase):
    """An orchestrator that asks who calls; its stages need not be there."""

    def test_who_has_the_token_is_answered(self) -> None:
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        token = "flair_a-token-of-alice"
        digest = hashlib.sha256(token.encode()).hexdigest()
        (folder / "tokens.textproto").write_text(f'tokens {{ name: "alice" sha256: "{digest}" }}')
        stages = " ".join(f'{name}: "unix:{folder / name}"' for name in ("language", "translator", "optimizer", "renderer"))
        config = f'store_path: "{folder / "store"}" tokens_path: "{folder / "tokens.textproto"}" stages {{ {stages} }}'
        server = self.enterContext(program("flair-orchestrator", folder, config))
        (folder / "token").write_text(token + "\n")
        for known in (token, folder / "token"):
            client = self.enterContext(flair.Client(server.address, token=known))
            self.assertEqual(list(client.jobs()), [])
            with self.assertRaises(flair.NotFound):
                list(client.watch("none"))
        for stranger in (None, "flair_another-token"):
            client = self.enterContext(flair.Client(server.address, token=stranger))
            with self.assertRaises(flair.FlairError) as caught:
                list(client.jobs())
            self.assertEqual(caught.exception.status, grpc.StatusCode.UNAUTHENTICATED)

    def test_a_token_is_not_sent_in_plain_text(self) -> None:
        with self.assertRaisesRegex(ValueError, "10.1.2.3:50050"):
            flair.Client("10.1.2.3:50050", token="flair_a-token")


if __name__ == "__main__":
    unittest.main()
