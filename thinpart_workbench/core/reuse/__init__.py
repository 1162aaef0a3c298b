# SPDX-License-Identifier: LGPL-2.1-or-later
"""What two parts are to each other, judged by their forms; and how similar they are."""
