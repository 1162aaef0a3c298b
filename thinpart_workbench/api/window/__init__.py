# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the window shows of parts, documents, profiles and limits: judged, summed up and grouped, for widgets to draw."""
