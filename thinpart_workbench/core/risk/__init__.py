# SPDX-License-Identifier: LGPL-2.1-or-later
"""The risk of the automatic mesh: judged from what was measured, by a model learned from the solver, and in words."""
