# SPDX-License-Identifier: GPL-3.0-or-later
"""Ensembles: many realisations of one project whose surfaces, throws and files are uncertain (docs/ensemble.md).

    geomesh ensemble study.yaml          the program
    python3 -m geomesh.ensemble ...      the same

A study is read by `study`, one realisation is drawn by `draws`, `fields` and `displace` and meshed by `realise`; `store` keeps its
result as one file, complete or absent. `pool` runs many, `slurm` writes the scripts of a batch system, `collect` makes tables, grids and
the page.
"""
