# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of parts, drawn without a graphics card."""
