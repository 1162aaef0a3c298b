# SPDX-License-Identifier: LGPL-2.1-or-later
"""The start of ThinPart's GUI: creates the application-wide objects and connects them.

Modules only emit signals and call hooks; all connections between application-wide objects are made here. Nothing here
imports numpy, so that FreeCAD starts as fast as without ThinPart.
"""

import FreeCADGui as Gui

from ..freecad_adapter.objects.map_recompute import RECOMPUTED
from ..freecad_adapter.objects.wall_measurement import add_wall_measurement
from .application import lifelong
from .application.faults import install_fault_handler
from .application.profile_signals import ProfileSignals
from .application.qt import translate
from .application.unit_watch import UnitWatch
from .commands import COMMANDS
from .document.active_task import close_session_of, follow_active_document
from .document.document_observer import DocumentObserver
from .document.face_colours import FaceColours
from .document.measurement_signals import MeasurementSignals
from .document.measurement_watch import MeasurementWatch
from .document.notifications import Notifications
from .guide.command import WhatsThis
from .on_save.auto_classifier import AutoClassifier
from .preferences.pages import add_pages
from .processes.face_limits import FaceLimits
from .processes.region_notes import RegionNotes
from .processes.request_queue import HANGING, RequestQueue
from .processes.running_jobs import RunningJobs
from .processes.standby_worker import StandbyWorker
from .profile.command import show_profile_editor
from .thickness.command import measure_map_again, show_thickness_map, stop_measuring
from .view3d.map_events import MapEvents
from .workbench import add_icons


def start():
    """Create and connect the application-wide objects; called once, by InitGui."""
    lifelong.notifications = Notifications()
    install_fault_handler()
    add_icons()
    add_pages()
    add_wall_measurement()
    lifelong.running_jobs = RunningJobs()
    lifelong.standby_worker = StandbyWorker()
    observer = lifelong.observer = DocumentObserver()
    lifelong.face_colours = FaceColours()
    lifelong.map_events = MapEvents()
    lifelong.measurement_signals = MeasurementSignals()
    lifelong.requests = RequestQueue("info-files", HANGING)
    lifelong.region_notes = RegionNotes(lifelong.requests)
    lifelong.face_limits = FaceLimits(lifelong.requests)
    lifelong.whats_this = WhatsThis()
    lifelong.whats_this.watch(Gui.getMainWindow())
    lifelong.units = UnitWatch(observer)
    lifelong.profile_signals = ProfileSignals()
    lifelong.profile_signals.edit_requested.connect(show_profile_editor)
    lifelong.auto_classifier = AutoClassifier(observer, lifelong.measurement_signals)
    _connect_face_colours(observer, lifelong.face_colours)
    _connect_maps(observer, lifelong.map_events)
    observer.restored.add(MeasurementWatch().on_object_restored)
    observer.closed.add(close_session_of)
    observer.activated.add(follow_active_document)
    lifelong.auto_classifier.clicked.add(_classify_or_explain)
    observer.begin()
    lifelong.auto_classifier.begin()
    lifelong.units.begin()
    observer.closed.add(stop_measuring)


def _classify_or_explain():
    """Classify the selected or active part, or explain in the status bar why that is not possible."""
    command = COMMANDS["ThinPart_Classify"]
    if command.IsActive():
        command.Activated()
    else:
        lifelong.notifications.show_message(translate(
            "ThinPart", "To classify a part, open a document and close the task that is open."))


def _connect_face_colours(observer, colours):
    """Keep analysis colours out of saved files, and remove them from changed shapes."""
    observer.shape_changed.add(colours.drop)
    observer.save_begun.add(colours.suspend)
    observer.save_ended.add(colours.resume)
    observer.closed.add(colours.forget)


def _connect_maps(observer, events):
    """Keep the thickness maps in the 3D views up to date with the documents."""
    RECOMPUTED.add(events.recomputed)
    observer.changed.add(events.refresh_soon)
    observer.closed.add(_forget_maps)
    lifelong.units.changed.connect(events.refresh_soon)  # colour bars and probes
    events.refresh_due.add(_sync_maps)
    events.measure_requested.add(measure_map_again)
    events.panel_requested.add(show_thickness_map)


def _sync_maps():
    # Imported late, because it imports numpy and scipy.
    from .view3d.scene_sync import SceneSync

    if lifelong.scene_sync is None:
        lifelong.scene_sync = SceneSync()
    lifelong.scene_sync.refresh()


def _forget_maps(document_name):
    if lifelong.scene_sync is not None:
        lifelong.scene_sync.forget(document_name)
    lifelong.map_events.refresh_soon()
