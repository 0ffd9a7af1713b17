# SPDX-License-Identifier: GPL-3.0-or-later
"""Every question of the dashboard and every alert, answered by a real Prometheus that reads a cluster at work."""

import json
import re
import shutil
import subprocess
import tempfile
import threading
import unittest
import urllib.parse
import urllib.request
from collections.abc import Callable
from pathlib import Path

import yaml
from deployment_files import ROOT
from local_cluster import Cluster

PROMETHEUS = shutil.which("prometheus")
# Nothing to be seen of these while no model is asked and nothing fails.
WITHOUT_FIGURES = r"flair_llm_|state=\"failed\"|code!=\"OK\"|outcome!=\"ended\"|flair_rpcs_refused_total"


class PrometheusServer:
    """Reads what deploy/prometheus/prometheus.yml reads, at the addresses that the cluster has, more often."""

    def __init__(self, folder: Path, metrics: dict[str, str]) -> None:
        config = yaml.safe_load((ROOT / "deploy/prometheus/prometheus.yml").read_text(encoding="utf-8"))
        config["global"] = {"scrape_interval": "500ms", "evaluation_interval": "500ms"}
        config["rule_files"] = [str(ROOT / "deploy/prometheus/alerts.yml")]
        for group in config["scrape_configs"][0]["static_configs"]:
            group["targets"] = [metrics[group["labels"]["program"]]]
        file = folder / "prometheus.yml"
        file.write_text(yaml.safe_dump(config), encoding="utf-8")
        self._process = subprocess.Popen(
            [PROMETHEUS, f"--config.file={file}", f"--storage.tsdb.path={folder}/prometheus", "--web.listen-address=127.0.0.1:0"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        said = ""
        # It says both, in any order.
        signs = (r'msg="Listening on" address=(\S+)', r"Server is ready to receive web requests")
        for line in self._process.stderr:
            said += line
            address, ready = (re.search(sign, said) for sign in signs)
            if address and ready:
                self._url = f"http://{address[1]}/api/v1/"
                # Read on: a full pipe would hold it up.
                self._reader = threading.Thread(target=self._process.stderr.read)
                self._reader.start()
                return
        raise AssertionError(f"Prometheus did not start: {said}")

    def stop(self) -> None:
        self._process.terminate()
        self._process.wait()
        self._reader.join()
        self._process.stderr.close()

    def get(self, path: str, **arguments: str) -> dict:
        with urllib.request.urlopen(f"{self._url}{path}?{urllib.parse.urlencode(arguments)}", timeout=60) as answer:
            return json.load(answer)["data"]

    def ask(self, question: str) -> list:
        """The series of the answer; an error of HTTP when Prometheus does not understand."""
        return self.get("query", query=question)["result"]

    def wait_for(self, question: str, good: Callable[[list], bool] = bool) -> None:
        """Until the answer is as it should be: what happened is seen at the next look, and on a busy machine a look may fail."""
        self.wait_until(lambda: self.ask(question), good, question)

    @staticmethod
    def wait_until(look: Callable[[], list], good: Callable[[list], bool], what: str) -> None:
        for _ in range(1200):
            if good(seen := look()):
                return
            threading.Event().wait(0.1)
        raise AssertionError(f"Prometheus never says {what}, but {seen}")


def questions() -> list[tuple[str, str]]:
    """Title and expression of every curve, with the values that Grafana puts into it."""
    dashboard = json.loads((ROOT / "deploy/grafana/flair.json").read_text(encoding="utf-8"))
    panels = [panel for row in dashboard["panels"] for panel in row.get("panels", [row])]
    found = [(panel["title"], target["expr"]) for panel in panels for target in panel.get("targets", [])]
    return [(title, text.replace("$__rate_interval", "1m").replace("$job", "flair")) for title, text in found]


@unittest.skipUnless(PROMETHEUS, "needs Prometheus: apt-get install prometheus")
class Dashboard(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        holder = tempfile.TemporaryDirectory(prefix="flair-dashboard-")
        cls.addClassCleanup(holder.cleanup)
        folder = Path(holder.name)
        cluster = Cluster(folder)
        cls.addClassCleanup(cluster.stop)
        cluster.start()
        cls.prometheus = PrometheusServer(folder, cluster.metrics)
        cls.addClassCleanup(cls.prometheus.stop)
        cls.prometheus.wait_for("count(up == 1) == 5")
        # Curves are of what grows between two looks, and most counts begin with the first room; the third is the first again.
        for room_count, width in enumerate((3, 4, 3), start=1):
            run = cluster.client("design", f"A bedroom that is {width}m x 4m.", "--quiet", "--out",
                                 str(folder / f"room_{room_count}"), "--orchestrator", cluster.addresses["orchestrator"])
            assert run.returncode == 0, run.stderr
            cls.prometheus.wait_for(f"sum(flair_jobs_ended_total) == {room_count}")
        cls.prometheus.wait_for("sum(rate(flair_jobs_ended_total[1m])) > 0")

    def test_every_curve_has_figures(self) -> None:
        asked = questions()
        self.assertGreater(len(asked), 30)
        for title, question in asked:
            with self.subTest(title=title, question=question):
                self.prometheus.ask(question)
                if not re.search(WITHOUT_FIGURES, question):
                    # A curve of growth needs two looks at what it is of, and that may have begun with the last room.
                    self.prometheus.wait_for(question)

    def test_figures_are_those_of_the_work_done(self) -> None:
        value = dict(questions())
        # How many wait is counted now and then, and may have been while the last job did.
        self.prometheus.wait_for(value["Waiting"] + " == 0")
        self.prometheus.wait_for(value["Ended a minute"] + " > 0")
        self.prometheus.wait_for(value["Programs"], lambda answer: {series["metric"]["program"] for series in answer} ==
                                 {"orchestrator", "language", "translator", "optimizer", "renderer"})

    def test_alerts_are_evaluated_and_none_fires_of_a_cluster_that_is_well(self) -> None:
        self.prometheus.wait_for("min(count_over_time(up[1h])) > 8")

        def rules() -> list:
            return [rule for group in self.prometheus.get("rules")["groups"] for rule in group["rules"]]

        self.assertGreater(len(rules()), 5)
        # On a busy machine a look at a program may fail, and its alert is pending until the next look.
        self.prometheus.wait_until(lambda: [rule for rule in rules() if (rule["health"], rule["state"]) != ("ok", "inactive")],
                                   lambda others: not others, "that all alerts are evaluated and inactive")

    def test_choices_of_the_dashboard_are_there(self) -> None:
        self.assertEqual(self.prometheus.get("label/job/values", **{"match[]": "flair_build_info"}), ["flair"])


if __name__ == "__main__":
    unittest.main()
