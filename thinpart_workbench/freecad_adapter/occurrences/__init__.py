# SPDX-License-Identifier: LGPL-2.1-or-later
"""From parts to their occurrences in a document and back."""
