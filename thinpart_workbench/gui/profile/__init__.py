# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editor of profiles and of limits of the wall."""
