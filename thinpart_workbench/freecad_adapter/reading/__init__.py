# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read files and documents, and reject unsafe or damaged ones."""
