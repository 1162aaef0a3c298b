# SPDX-License-Identifier: LGPL-2.1-or-later
"""Libraries of classified parts: search, similar parts, annotations, judging again."""
