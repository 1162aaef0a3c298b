# SPDX-License-Identifier: LGPL-2.1-or-later
"""Application-wide objects: one instance each, as long as FreeCAD runs. `start` creates them; this module imports nothing.

Read them at the time of use, as in ``lifelong.observer``: they are None until `start` has run.
"""

notifications = None
"""Notifications: shows messages without interrupting the user."""

standby_worker = None
"""StandbyWorker: the preloaded process that waits for a measuring job."""

observer = None
"""DocumentObserver: reports what happens to documents."""

units = None
"""UnitWatch: reports when the unit of lengths changes."""

face_colours = None
"""FaceColours: colours faces and restores their original appearance."""

profile_signals = None
"""ProfileSignals: announces that a profile is to be edited, was saved, or is used from now on."""

measurement_signals = None
"""MeasurementSignals: announces what the panels measure and write."""

requests = None
"""RequestQueue: reads and writes info files: labels, notes, mesh settings, results of documents."""

region_notes = None
"""RegionNotes: reads and keeps what the user says of wall regions."""

face_limits = None
"""FaceLimits: reads and keeps limits of the wall for single faces."""

map_events = None
"""MapEvents: requests from thickness maps and for them."""

scene_sync = None
"""SceneSync: keeps the 3D views in line with the maps; None until there is a map."""

running_jobs = None
"""RunningJobs: shows in the status bar what runs in the background, and leads to its window."""

whats_this = None
"""WhatsThis: answers FreeCAD's What's This with pages of the guide."""

auto_classifier = None
"""AutoClassifier: classifies documents when they are saved."""
