# SPDX-License-Identifier: GPL-3.0-or-later
"""Flair from Python: flair.v1 has the messages, flair.stage what a stage of your own needs."""
