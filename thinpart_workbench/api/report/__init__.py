# SPDX-License-Identifier: LGPL-2.1-or-later
"""Folders of reports: about documents that are measured, and about libraries."""
