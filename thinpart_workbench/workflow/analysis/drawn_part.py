# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pictures that a worker draws of a part while it measures it, transferred as text: no code, no image decoding.

Numpy is imported late: the process that starts the worker has to be quick.
"""

import base64
from contextlib import suppress
from dataclasses import dataclass, fields
from typing import Optional


@dataclass
class DrawnPart:
    """Pictures of one part.

    Attributes
    ----------
    thumbnail : bytes or None
        See `write_thumbnail`.
    page, picture : bytes or None
        A page of a report, and the PNG file beside it.
    """

    thumbnail: Optional[bytes] = None
    page: Optional[bytes] = None
    picture: Optional[bytes] = None

    def draw_thumbnail(self, mesh, record):
        """Draw a part with its thin faces, if there is enough memory."""
        from ...core.rendering.picture import picture
        from ...freecad_adapter.thin_colours import preferred_colours

        # A failed picture must not lose the measurement; it can be drawn again.
        with suppress(OSError, MemoryError):
            self.thumbnail = picture(mesh, preferred_colours(record)).tobytes()

    def content(self):
        """The pictures as a dict for JSON."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: base64.b64encode(value).decode() for name, value in values.items() if value is not None}

    @classmethod
    def from_content(cls, content):
        """The DrawnPart from a dict of `content`. Raises ValueError if the dict is invalid."""
        try:
            return cls(**{field.name: base64.b64decode(content[field.name], validate=True)
                          for field in fields(cls) if field.name in content})
        except TypeError as error:
            raise ValueError(str(error)) from None
