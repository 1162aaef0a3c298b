# SPDX-License-Identifier: LGPL-2.1-or-later
"""The form of a part, wherever it lies and however it is turned: what two parts are compared by."""
