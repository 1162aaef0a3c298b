# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a library has more than once: parts that are the same, mirrored, scaled, or alike; and families of parts."""
