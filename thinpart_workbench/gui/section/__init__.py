# SPDX-License-Identifier: LGPL-2.1-or-later
"""The section plane of a thickness map."""
