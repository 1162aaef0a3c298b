# SPDX-License-Identifier: LGPL-2.1-or-later
"""What lies opposite of the surface through the material, and where it is thinnest."""
