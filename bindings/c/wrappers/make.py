#!/usr/bin/env python3
"""Writes the C++ headers and the Fortran modules of objects from the C header and the table of methods: make.py [FOLDER].

The files go to include/stickslip and fortran in the folder, which is the folder of the C interface by default."""

import sys
from pathlib import Path

sys.dont_write_bytecode = True

import cpp  # noqa: E402
import fortran  # noqa: E402
from model import FILES, read  # noqa: E402


def main():
    home = Path(__file__).parent.parent
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else home
    header = read(home / "include/stickslip.h")
    for file in FILES:
        (folder / f"include/stickslip/{file.cpp}.hpp").write_text(cpp.write(header, file), encoding="utf-8")
        (folder / f"fortran/stickslip_{file.f}.f90").write_text(fortran.write(header, file), encoding="utf-8")
    header.check()


if __name__ == "__main__":
    main()
