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

    def refused(self, name, *words):
        """The file is refused with these words, in little time and memory."""
        status, seconds, memory, printed = damaged_inputs.run(("info", name), self.folder, PROGRAM, SLOWNESS == 1)
        self.assertEqual(status, BAD_INPUT, printed)
        for word in (name,) + words:
            self.assertIn(word, printed)
        if SLOWNESS == 1:
            self.assertLess(seconds, 3)
            self.assertLess(memory, 400e6)

    @unittest.skipUnless(damaged_inputs.netCDF4, "skipped: no h5py")
    def test_groups_that_lead_back_to_themselves(self):
        """The library followed them until the memory was full."""
        for name, target in (("to_itself.h5", "a"), ("to_the_root.h5", "/"), ("soft.h5", None)):
            damaged_inputs.write_hdf5(self.path(name))
            with damaged_inputs.h5py.File(self.path(name), "a") as file:
                group = file.create_group("a").create_group("b")
                group["again"] = file[target] if target else damaged_inputs.h5py.SoftLink("/a")
            self.refused(name, "/a/b/again is a link back to the group /", "delete the link")
        damaged_inputs.write_hdf5(self.path("twofold.h5"))
        with damaged_inputs.h5py.File(self.path("twofold.h5"), "a") as file:
            group = file["horizons"]
            for k in range(14):
                above = file.create_group("g%d" % k)
                above["a"], above["b"] = group, group
                group = above
        self.refused("twofold.h5", "linked to each other so often")
        damaged_inputs.write_hdf5(self.path("deep.h5"))
        with damaged_inputs.h5py.File(self.path("deep.h5"), "a") as file:
            file.create_group("/".join("a" * 3000))
        self.refused("deep.h5", "groups deep")
        damaged_inputs.write_hdf5(self.path("linked.h5"))  # one more name of a group is none of these
        with damaged_inputs.h5py.File(self.path("linked.h5"), "a") as file:
            file["alias"] = file["horizons"]
        self.assertIn("surface alias/top", self.run_program("info", "linked.h5"))

    @unittest.skipUnless(damaged_inputs.netCDF4, "skipped: no h5py")
    def test_small_files_that_claim_much(self):
        """They took the memory of all that they claim."""
        n = 3000
        with damaged_inputs.h5py.File(self.path("constants.h5"), "w") as file:
            file["x"], file["y"] = range(n), range(n)
            file.create_dataset("flat", data=damaged_inputs.numpy.full((n, n), 1.0, "f4"), compression="gzip", compression_opts=9)
        self.refused("constants.h5", "its variable flat of 3000 by 3000 numbers is too large", "every n-th node")
        with damaged_inputs.h5py.File(self.path("many.h5"), "w") as file:
            file["x"], file["y"] = range(500), range(500)
            for k in range(40):
                file.create_dataset("flat%d" % k, data=damaged_inputs.numpy.full((500, 500), 1.0, "f4"), compression="gzip", compression_opts=9)
        self.refused("many.h5", "of 500 by 500 numbers is too large", "numbers were read before it")
        damaged_inputs.write_hdf5(self.path("unwritten.h5"))
        with damaged_inputs.h5py.File(self.path("unwritten.h5"), "a") as file:
            file["horizons"].create_dataset("base", shape=file["horizons/top"].shape, dtype="f8", chunks=(3, 3))
        printed = self.run_program("info", "unwritten.h5")
        self.assertIn("surface horizons/top", printed)
        self.assertIn("passed over: horizons/base (no value of it was ever written)", printed)

    @unittest.skipUnless(damaged_inputs.netCDF4, "skipped: no netCDF4")
    def test_records_that_are_missing_are_no_zeros(self):
        damaged_inputs.write_netcdf_with_records(self.path("whole.nc"))
        self.run_program("info", "whole.nc")
        with open(self.path("whole.nc"), "rb") as file:
            whole = file.read()
        for left_out in (1, 100, 300):
            self.write("cut.nc", whole[:-left_out])
            self.refused("cut.nc", "records that its header counts", "copy or write it again")

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
