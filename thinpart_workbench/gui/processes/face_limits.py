# SPDX-License-Identifier: LGPL-2.1-or-later
"""Limits of the wall for single faces, as info files have them."""

from .region_notes import KeptWithParts


class FaceLimits(KeptWithParts):
    """Reads and keeps limits for single faces through a RequestQueue."""

    def __init__(self, requests, parent=None):
        super().__init__(requests, "document_info.limited_faces", "document_info.keep_face_limits", parent)

    def keep(self, document, part, faces, **limits):
        """Keep limits for faces of a part: names, and ``reason``, ``min_mm``, ``max_mm`` as of `limit_faces`."""
        self.ask_to_keep(document=document, part=part, faces=faces, **limits)
