# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the feature of a document that made a face."""
