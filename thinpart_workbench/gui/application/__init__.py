# SPDX-License-Identifier: LGPL-2.1-or-later
"""Used by every module of the GUI: Qt, translation, theme, units, fault handling and application-wide objects."""
