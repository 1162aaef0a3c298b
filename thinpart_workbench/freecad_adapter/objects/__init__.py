# SPDX-License-Identifier: LGPL-2.1-or-later
"""Document objects of ThinPart: thickness maps and wall measurements; and snapshots of parts for worker processes."""
