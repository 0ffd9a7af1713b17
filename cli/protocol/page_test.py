# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/protocol.md is what page.py makes, and its links lead somewhere."""

import os
import re
import sys
import unittest
from collections import Counter
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

from page import link, read_page  # noqa: E402

DESCRIPTORS = Path(os.environ["FLAIR_BIN"]).parent / "cli/protocol/flair_v1.desc"


class ProtocolPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.page = read_page(DESCRIPTORS)
        cls.text = cls.page.text()

    def test_is_not_stale(self) -> None:
        made = f"write it anew: /usr/bin/python3 cli/protocol/page.py {DESCRIPTORS} > docs/protocol.md"
        self.assertTrue((HERE.parents[1] / "docs/protocol.md").read_text(encoding="utf-8") == self.text, made)

    def test_every_link_leads_to_one_heading(self) -> None:
        anchors = Counter(link("", heading) for heading in re.findall(r"^#+ (.*)$", self.text, re.MULTILINE))
        links = re.findall(r"\]\(#[^)]*\)", self.text)
        self.assertGreater(len(links), 300)
        for one in set(links):
            self.assertEqual(anchors[f"[{one}"], 1, one)

    def test_files_have_a_title_and_declarations_a_comment(self) -> None:
        self.assertGreaterEqual(len(self.page.files), 26)
        for title, _ in self.page.files:
            self.assertFalse(title.endswith(".proto"), f"{title}: give it a place and a title in reading_order.json")
        self.assertNotRegex(self.text, r"\n### \w+\n\n\|")
        self.assertNotRegex(self.text, r"\| \d+ \|  \|")

    def test_comments_become_text_that_markdown_leaves_alone(self) -> None:
        for part in ("| `walls` | list of [Wall](#wall) | 4 | One per edge of `floor`, in the same order",
                     "see [Producer.build](#producer)",
                     "**WatchJob**: [WatchJobRequest](#watchjobrequest) → stream of [WatchJobResponse]",
                     "| `time_limit` | `google.protobuf.Duration` | 9 |"):
            self.assertIn(part, self.text)


if __name__ == "__main__":
    unittest.main()
