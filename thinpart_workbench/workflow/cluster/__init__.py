# SPDX-License-Identifier: LGPL-2.1-or-later
"""Files analysed on a Dask cluster."""
