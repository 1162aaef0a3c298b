# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part record: the result that info files, colours, panels and tables use."""
