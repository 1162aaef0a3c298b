# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dock that finds parts in libraries."""
