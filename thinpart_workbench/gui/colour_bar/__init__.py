# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of thickness maps, and the colour bar."""
