# SPDX-License-Identifier: LGPL-2.1-or-later
"""What another profile would change in libraries, and writing it."""
