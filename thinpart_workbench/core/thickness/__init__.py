# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wall thickness: what each sample of the surface sees through the material, and the results derived from it."""
