# SPDX-License-Identifier: LGPL-2.1-or-later
"""Command-line arguments that follow from the preferences."""

import os

from ...freecad_adapter.preferences import changed_deflections, preference


def measuring_arguments():
    """list of str: how finely parts are measured, and the memory limit per file."""
    deflections = [text for name, value in changed_deflections().items()
                   for text in (f"--{name.replace('_', '-')}", str(value))]
    return ["--memory", str(preference("MemoryMegabytes")), "--accuracy", preference("Accuracy"), *deflections]


def check_arguments(processes):
    """list of str: the processes to check, given their names with commas between them; none where that is empty."""
    return ["--check", processes] if processes.strip() else []


def info_folder_arguments(folder):
    """list of str: the location of info files, given their common folder; none where that is empty."""
    return ["--info-dir", folder, "--info-tree", os.sep] if folder else []
