"""Files analysed on a Dask cluster."""
