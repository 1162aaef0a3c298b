# SPDX-License-Identifier: LGPL-2.1-or-later
"""The processes that are timed, and what they measure."""
