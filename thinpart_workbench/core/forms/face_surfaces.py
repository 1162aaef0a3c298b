# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kinds of surfaces on which faces lie."""

PLANE, CYLINDER, CONE, SPHERE, TORUS, FREE_FORM = "plane", "cylinder", "cone", "sphere", "torus", "free-form"

SURFACES = (PLANE, CYLINDER, CONE, SPHERE, TORUS, FREE_FORM)
"""As records name them."""
