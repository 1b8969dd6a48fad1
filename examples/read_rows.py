#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads the rows of a study from HDF5 into a table of pandas.

    strainwave sensitivity examples/article_scatter.toml --scatter --rows rows.h5
    python3 examples/read_rows.py rows.h5

Debian's packages python3-h5py and python3-pandas are enough.
"""

import sys

import h5py
import pandas


def dataset(file, column):
    """The numbers of a column.  In the name of a dataset, a slash would mean a group."""
    return file["rows"][column.replace("%", "%25").replace("/", "%2F")]


def units(path):
    """{column: SI unit of its numbers}."""
    with h5py.File(path) as file:
        return {name: dataset(file, name).attrs["unit"] for name in file["columns"].asstr()[:]}


def read_rows(path, first=0, last=None, columns=None):
    """The rows [first, last) as a table of pandas; the columns `status` and `rule` say which may be used.

    Only the chunks of these rows and columns are read, so a file may be larger than the memory.
    """
    with h5py.File(path) as file:
        if not str(file.attrs.get("format", "")).startswith("strainwave-rows/1"):
            raise ValueError(f"{path} is not a file of rows of strainwave")
        part = slice(first, last)
        names = file["columns"].asstr()[:] if columns is None else columns
        table = pandas.DataFrame({name: dataset(file, name)[part] for name in names})
        words = {code: word for word, code in h5py.check_enum_dtype(file["status"].dtype).items()}
        table["status"] = pandas.Series(file["status"][part]).map(words).astype("category")
        table["rule"] = pandas.Categorical.from_codes(file["rule"][part].astype("int64"),
                                                      list(file["rules"].asstr()[:]))
        table.attrs = {name: file.attrs[name] for name in file.attrs}
        table.index += first
    return table


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    table = read_rows(sys.argv[1])
    usable = table[table["status"] == "usable"]
    print(f"{table.attrs['row_count']} {table.attrs['rows_are']} of {table.attrs['input_file']}, "
          f"{len(usable)} usable")
    unit = units(sys.argv[1])
    for name in unit:
        print(f"{name} [{unit[name]}]: mean {usable[name].mean():.6g}, deviation {usable[name].std():.3g}")
    for rule, count in table["rule"].value_counts().items():
        if rule and count:
            print(f"{count} rows: {rule}")


if __name__ == "__main__":
    main()
