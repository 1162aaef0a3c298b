# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pages and folders of reports."""
