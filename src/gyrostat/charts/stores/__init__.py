"""Charts larger than memory, in a Zarr store that survives a crash.

`chart_stores` computes and writes block by block, `store_frame` writes what is not in blocks, such as the
axes, and `power_cuts` keeps checksums by which an interrupted run is continued.
"""
