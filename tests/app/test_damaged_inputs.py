# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged files of the formats that libraries read, and of sticks of faults: read, or refused with a message that names them; no crash, no hang,
no memory taken. tests/fuzz/damaged_inputs.py makes more of them."""
import os
import sys
import unittest

from geomesh_program import BAD_INPUT, NIGHTLY, PROGRAM, SOURCE, ProgramTest, main

sys.path.insert(0, os.path.join(SOURCE, "tests", "fuzz"))
import damaged_inputs  # noqa: E402

COUNT = 60 if NIGHTLY else 4
SLOWNESS = 30 if os.environ.get("GEOMESH_SANITIZE") else 1


EXPECTED = 12  # formats


class DamagedInputs(ProgramTest):
    def test_all_formats_are_there(self):
        if len(damaged_inputs.FORMATS) < EXPECTED:
            self.skipTest("skipped: without netCDF4, h5py and ogr2ogr only " + ", ".join(damaged_inputs.FORMATS) + " are tried")

    def test_each_format_is_tried_whole_and_is_read(self):
        for name, (file, project, _) in damaged_inputs.FORMATS.items():
            with self.subTest(format=name):
                folder = self.path("whole_" + name)
                damaged_inputs.written(name, folder)
                self.write(os.path.join(folder, "project.yaml"), project % file)
                for arguments in (("info", file), ("project.yaml", "-o", "out")):
                    status, _, _, printed = damaged_inputs.run(arguments, folder, PROGRAM, SLOWNESS == 1)
                    self.assertEqual(status, 0, printed)

    @unittest.skipUnless(damaged_inputs.netCDF4, "skipped: no netCDF4")
    def test_a_grid_without_records_is_refused(self):
        """It ended with a segmentation fault."""
        with damaged_inputs.netCDF4.Dataset(self.path("no_records.nc"), "w", format="NETCDF3_CLASSIC") as data:
            data.createDimension("x", 5)
            data.createDimension("y", None)
            data.createVariable("x", "f8", ("x",))[:] = range(5)
            data.createVariable("y", "f8", ("y",))
            data.createVariable("z", "f8", ("y", "x"))
        self.assertIn("no_records.nc", self.run_program("info", "no_records.nc", status=BAD_INPUT))

    def test_damaged_files_are_read_or_refused_with_their_name(self):
        seen = set()
        for name in damaged_inputs.FORMATS:
            for k, command, outcome, fault in damaged_inputs.outcomes(name, range(COUNT), self.path("d"), PROGRAM, SLOWNESS):
                with self.subTest(format=name, damage=k, command=command):
                    self.assertEqual(fault, "", outcome[3])
                    seen.add(damaged_inputs.OUTCOMES[outcome[0]])
        self.assertEqual(seen, {"read", "refused"})


if __name__ == "__main__":
    main()
