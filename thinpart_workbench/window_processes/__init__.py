# SPDX-License-Identifier: LGPL-2.1-or-later
"""The processes that the window starts: each takes requests as JSON lines and has them done by `api`."""
