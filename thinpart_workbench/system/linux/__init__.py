# SPDX-License-Identifier: LGPL-2.1-or-later
"""What only Linux has: its system calls, and the privileges of processes."""
