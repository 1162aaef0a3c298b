# SPDX-License-Identifier: LGPL-2.1-or-later
"""General widgets that do not depend on parts or documents."""
