"""Contact files: one packing through every format, and every way in which a file can be wrong."""

from __future__ import annotations

import gzip
import sys
import tracemalloc
from pathlib import Path
from unittest.mock import patch

import numpy as np
import pyarrow
import pytest
from pyarrow import parquet

from granular.contacts import tables
from granular.contacts.contact_list import ContactList
from granular.contacts.files import open_table
from granular.contacts.pairs import Pairs
from granular.contacts.summary import summarise
from granular.errors import (
    BadOption,
    ContactColumnsMissing,
    ContactFileUnusable,
    ContactImpossible,
    ContactTwice,
    ContactValuesMissing,
    FileUnreadable,
)

sys.path.insert(0, str(Path(__file__).parent))
from contact_lists import EXAMPLE, HEADER, SOUND, refused, table, written


def arrays(path, **options):
    """All columns of a list, put together again."""
    blocks = list(ContactList(path, **options).blocks())
    return {name: np.concatenate([getattr(block, name) for block in blocks], axis=-1)
            for name in ("branch", "normal", "spheres", "radii", "normal_force", "shear_force", "kn", "ks")}


def as_csv(folder):
    header, rows = table()
    return written(folder / "list.csv", ",".join(header), *map(",".join, rows))


def as_semicolons(folder):
    header, rows = table()
    return written(folder / "list.csv", ";".join(f'"{name}"' for name in header), *map("; ".join, rows))


def as_yade(folder):
    header, rows = table()
    return written(folder / "list.txt", "# made by a script", "# " + " ".join(header), *map(" ".join, rows))


def as_dump(folder):
    header, rows = table()
    step = ["ITEM: NUMBER OF ENTRIES", str(len(rows)), "ITEM: BOX BOUNDS pp pp pp", "0 1", "0 1", "0 1",
            "ITEM: ENTRIES index " + " ".join(header), *(f"{k} " + " ".join(row) for k, row in enumerate(rows, 1))]
    early = ["ITEM: TIMESTEP", "1000", "ITEM: NUMBER OF ENTRIES", "1", "ITEM: BOX BOUNDS pp pp pp", "0 1", "0 1",
             "0 1", "ITEM: ENTRIES index " + " ".join(header), "1 " + " ".join(rows[0])]
    return written(folder / "local.2000", *early, "ITEM: TIMESTEP", "2000", *step)


def as_compressed_dump(folder):
    plain = as_dump(folder).read_bytes()
    path = folder / "run.dump.gz"
    path.write_bytes(gzip.compress(plain))
    return path


def as_parquet(folder):
    header, rows = table()
    columns = np.array(rows, dtype=float).T
    whole = {name: column.astype(int) if name.startswith("id") else column
             for name, column in zip(header, columns, strict=True)}
    parquet.write_table(pyarrow.table(whole), folder / "list.parquet", row_group_size=1000)
    return folder / "list.parquet"


@pytest.mark.parametrize("write", [as_csv, as_semicolons, as_yade, as_dump, as_compressed_dump, as_parquet])
def test_one_packing_through_every_format(write, tmp_path):
    # Breaks when a reader loses a row, mixes up columns, or rounds a number.
    expected, found = arrays(EXAMPLE), arrays(write(tmp_path))
    for name, array in expected.items():
        assert np.array_equal(found[name], array), name


def test_short_chunks_change_nothing(tmp_path, monkeypatch):
    # Breaks when a row is lost or read twice where one chunk ends and the next begins.
    expected = arrays(EXAMPLE)
    for module in ("text_table", "dump_local", "parquet_table"):
        monkeypatch.setattr(f"granular.contacts.{module}.ROWS", 1000)
    for write in (as_csv, as_dump, as_parquet):
        assert np.array_equal(arrays(write(tmp_path))["shear_force"], expected["shear_force"])
    assert tables.ROWS > 1000


def test_a_step_of_a_dump_by_its_number(tmp_path):
    # Breaks when another step than the one named is read.
    path = as_dump(tmp_path)
    assert arrays(path, step=1000)["kn"].size == 1
    with pytest.raises(BadOption, match="1000, 2000"):
        open_table(path, step=7)
    with pytest.raises(BadOption, match="table of text"):
        open_table(EXAMPLE, step=1000)


def test_columns_by_other_names(tmp_path):
    # Breaks when a mapping is ignored, or x, y, z are not known for 1, 2, 3.
    path = written(tmp_path / "a.csv", "lx,ly,lz,c_n[1],c_n[2],c_n[3]", "0.002,0,0,1,0,0")
    found = ContactList(path, columns={f"n{k}": f"c_n[{k}]" for k in (1, 2, 3)})
    assert next(found.blocks()).normal[:, 0].tolist() == [1.0, 0.0, 0.0]


def test_centres_and_a_force_vector_stand_for_branch_and_forces(tmp_path):
    # Breaks when the branch is taken the other way round, or the normal part stays in the shear force.
    path = written(tmp_path / "a.csv", "x1,y1,z1,x2,y2,z2,f1,f2,f3", "1,1,1,1,1,3,0.5,0,2")
    block = next(ContactList(path, spheres_only=True).blocks())
    assert block.branch[:, 0].tolist() == [0.0, 0.0, 2.0]
    assert block.normal_force.tolist() == [2.0]
    assert block.shear_force[:, 0].tolist() == [0.5, 0.0, 0.0]


def with_row(folder, row, header=HEADER):
    return written(folder / "list.csv", header, *SOUND[:2], row, *SOUND[2:])


def test_the_sound_rows_are_sound(tmp_path):
    # Breaks when the tests below provoke something else than they say.
    assert sum(block.size for block in ContactList(written(tmp_path / "list.csv", HEADER, *SOUND)).blocks()) == 4


@pytest.mark.parametrize(("row", "words"), [
    ("4,5,0,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["no length", "line 4"]),
    ("4,5,0.0019,0,0,0.99,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["no unit vector", "|n| = 0.99"]),
    ("4,5,0.0019,0,0,-1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["against its normal", "-0.0019"]),
    ("4,5,0.0019,0,0,1,0,0,1e-3,1e-3,-1,0,0,0,1e6,1e6", ["tensile", "fn = -1 N"]),
    ("4,5,0.0021,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["do not reach", "R1 + R2 = 0.002"]),
    ("4,5,0.0019,0,0,1,0,0,1e-3,0,1,0,0,0,1e6,1e6", ["R1 R2", "not positive"]),
    ("4,5,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,0,1e6", ["kn that is not positive"]),
    ("4,5,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,-1", ["ks below zero"]),
    ("4,4,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["touches itself"]),
    ("4,5,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e200,1e6", ["beyond all measure (kn)", "1e+200 in line 4"]),
    ("4,5,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e-200,0", ["kn that is next to nothing"]),
    ("4,5,1e-90,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["l that is next to nothing"]),
    ("-4,5,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6", ["number -4"]),
])
def test_contacts_that_cannot_be(row, words, tmp_path):
    # Breaks when an impossible contact takes part in a sum, or the message does not say which one it is.
    refused(with_row(tmp_path, row), ContactImpossible, *words)


def test_a_negative_overlap(tmp_path):
    # Breaks when pairs that the program itself says do not touch are summed.
    path = written(tmp_path / "list.csv", "l1,l2,l3,n1,n2,n3,overlap", "0.002,0,0,1,0,0,-1e-7")
    refused(path, ContactImpossible, "negative overlap", "-1e-07")


def test_the_same_pair_twice_in_either_order(tmp_path):
    # Breaks when a list written from the side of both grains is summed twice.
    refused(with_row(tmp_path, "2,1,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6"), ContactTwice, "1 pair", "1 and 2")


def test_clumps_share_several_contacts(tmp_path):
    # Breaks when the same two grains are taken for the same contact though different spheres touch.
    path = written(tmp_path / "list.csv", "id1,id2,grain1,grain2,l1,l2,l3,n1,n2,n3", "0,10,1,2,0.003,0,0,1,0,0",
                   "1,11,1,2,0.003,0,0,0.8,0.6,0")
    assert sum(block.size for block in ContactList(path).blocks()) == 2


def test_pairs_are_found_twice_on_disk_too(monkeypatch):
    # Breaks when equal pairs end up in different temporary files.
    monkeypatch.setattr("granular.contacts.pairs.IN_MEMORY", 100)
    rng = np.random.default_rng(1)
    numbers = np.array([np.arange(5000), 5000 + rng.permutation(5000)])
    pairs = Pairs("list")
    for start in range(0, 5000, 70):
        pairs.add(numbers[:, start:start + 70])
    pairs.refuse_twice()
    again = Pairs("list")
    for start in range(0, 5000, 70):
        again.add(numbers[:, start:start + 70])
    again.add(numbers[::-1, 17:19])
    with pytest.raises(ContactTwice, match="2 pairs"):
        again.refuse_twice()


@pytest.mark.parametrize("cell", ["nan", "", "NA", "inf", "null"])
def test_missing_values_are_counted_and_dropped_on_demand(cell, tmp_path):
    # Breaks when a NaN spreads into every sum, or rows vanish without being asked for.
    path = with_row(tmp_path, f"4,5,0.0019,0,0,1,0,0,1e-3,1e-3,{cell},0,0,0,1e6,1e6")
    refused(path, ContactValuesMissing, "1 of 5 contacts", "fn = ", "line 4", "--drop-bad")
    contacts = ContactList(path, drop_bad=True)
    assert sum(block.size for block in contacts.blocks()) == 4
    assert (contacts.read, contacts.dropped) == (4, 1)


def test_missing_values_are_counted_over_the_whole_file(tmp_path, monkeypatch):
    # Breaks when only the first chunk is counted, or a line is counted wrongly past comments and empty lines.
    monkeypatch.setattr("granular.contacts.text_table.ROWS", 2)
    rows = [SOUND[0], "", "# a remark", SOUND[1].replace("0.4", "nan"), SOUND[2], *(["1,2" + ",nan" * 14] * 4)]
    path = written(tmp_path / "list.csv", HEADER, *rows)
    refused(path, ContactValuesMissing, "5 of 7 contacts", "first fn = nan in line 5, l1 = nan in line 7, l1 = nan in "
            "line 8, allowed")
    text = as_dump(tmp_path).read_text("utf-8").splitlines()
    bad = written(tmp_path / "a.dump", *text[:-1], " ".join(["nan", *text[-1].split()[1:]]))
    assert len(arrays(bad)["kn"]) == 5753  # the index is not wanted
    bad = written(tmp_path / "b.dump", *text[:-1], " ".join([*text[-1].split()[:-1], "nan"]))
    refused(bad, ContactValuesMissing, "1 of 5753 contacts", f"not finite, ks = nan in line {len(text)}")


def test_missing_values_of_parquet_files_are_counted_too(tmp_path):
    # Breaks when a row of a file without lines has no name.
    columns = {"l1": [2e-3, None], "l2": [0.0, 2e-3], "l3": [0.0] * 2, "n1": [1.0, 0.0], "n2": [0.0, 1.0],
               "n3": [0.0] * 2}
    parquet.write_table(pyarrow.table(columns), tmp_path / "a.parquet")
    refused(tmp_path / "a.parquet", ContactValuesMissing, "1 of 2 contacts", "l1 = nan in row 2")


@pytest.mark.parametrize(("header", "row"), [
    ('"l1","l2","l3","n1","n2","n3","of"', '"0.002","0","0","1","0","0","glass, new"'),
    ("\ufeffl1, l2, l3, n1, n2, n3, of", "2.0E-03, -0.0, 0, 1e0, 0, -0.0, x\r"),
    ("of;n3;n2;n1;l3;l2;l1;", "x;0;0;1;0;0;.002;"),
])
def test_every_way_of_writing_a_row(header, row, tmp_path):
    # Breaks on quotes with a separator inside, a byte-order mark, Windows line ends, signs of zero, another order.
    path = written(tmp_path / "list.csv", header, row)
    block = next(ContactList(path).blocks())
    assert (block.branch[:, 0].tolist(), block.normal[:, 0].tolist()) == ([0.002, 0.0, 0.0], [1.0, 0.0, 0.0])


def test_what_is_no_number_to_other_programs_is_none_here(tmp_path):
    # Breaks when Python's way of writing 10 as 1_0 is taken for a number, or half a body is rounded to a whole one.
    refused(written(tmp_path / "a.csv", "l1,l2,l3,n1,n2,n3", "1_0,0,0,1,0,0"), ContactFileUnusable, '"1_0"')
    refused(with_row(tmp_path, "4.5,5,0.0019,0,0,1,0,0,1e-3,1e-3,1,0,0,0,1e6,1e6"), ContactImpossible, "list.csv",
            "id1 id2 = 4.5 5", "whole")


def test_rows_that_are_all_left_out_leave_no_contact(tmp_path):
    # Breaks when a block without contacts cannot be checked, or commas alone are taken for a header that can be read.
    path = written(tmp_path / "a.csv", HEADER, "nan" + ",1" * 15)
    refused(path, ContactValuesMissing, "no contact (1 left out)", drop_bad=True)
    refused(written(tmp_path / "b.csv", ",,,", "1,2,3,4"), ContactColumnsMissing, "no column l1 l2 l3")


def test_missing_columns_name_those_found(tmp_path):
    # Breaks when a user must guess how the columns are called.
    path = written(tmp_path / "list.csv", "l1,l2,l3,nx1,ny1,nz1", "0.002,0,0,1,0,0")
    refused(path, ContactColumnsMissing, "n1 n2 n3", '"nx1", "ny1", "nz1"', "--spheres")
    refused(path, ContactColumnsMissing, '"normal"', "which is to be n1", columns={"n1": "normal"})
    refused(path, BadOption, "--column nn1", columns={"nn1": "nx1"})
    refused(written(tmp_path / "b.csv", "l1,l2,l3,n1,n2,n3,fs1", "1,0,0,1,0,0,0"), ContactColumnsMissing, "fs2 fs3")
    refused(written(tmp_path / "c.csv", "l1,l1,l2,l3,n1,n2,n3", "1,1,0,0,1,0,0"), ContactColumnsMissing, "2 columns")
    refused(written(tmp_path / "d.csv", "1,0,0,1,0,0", "1,0,0,1,0,0"), ContactColumnsMissing, "names its columns")


def test_damaged_files(tmp_path):
    # Breaks when a file that was cut off is used as far as it goes.
    whole = EXAMPLE.read_bytes()
    for name, content, word in (("cut.csv.gz", whole[:-2000], "ends before"),
                                ("bad.csv.gz", whole[:90000] + b"\0" * 500 + whole[90500:], "damaged"),
                                ("bytes.csv", b"l1,l2\n\xff\xfe\n", "not text"),
                                ("zero.csv", b"\0" * 50, "no text"), ("empty.csv", b"", "is empty")):
        (tmp_path / name).write_bytes(content)
        refused(tmp_path / name, ContactFileUnusable, word)
    header, rows = table()
    text = "\n".join([",".join(header), *map(",".join, rows)])
    (tmp_path / "cut.csv").write_text(text[:-40], "utf-8")
    refused(tmp_path / "cut.csv", ContactFileUnusable, "line 5754", "header names 16")
    (tmp_path / "word.csv").write_text("l1,l2,l3,n1,n2,n3\n0.002,0,0,1,zero,0\n", "utf-8")
    refused(tmp_path / "word.csv", ContactFileUnusable, "line 2", '"zero"')
    refused(written(tmp_path / "none.csv", HEADER), ContactValuesMissing, "no contact")


def test_damaged_dumps(tmp_path):
    # Breaks when a dump that is still being written counts as whole.
    text = as_dump(tmp_path).read_text("utf-8").splitlines()
    refused(written(tmp_path / "a.dump", *text[:-100]), ContactFileUnusable, "5653 of 5753")
    refused(written(tmp_path / "b.dump", *text[:10], "hello", *text[10:]), ContactFileUnusable, '"hello"')
    refused(written(tmp_path / "c.dump", "ITEM: TIMESTEP", "now"), ContactFileUnusable, "whole number")
    refused(written(tmp_path / "d.dump", "ITEM: TIMESTEP", "1"), ContactFileUnusable, "no time step")


def test_damaged_parquet_files(tmp_path):
    # Breaks when an error of pyarrow reaches the user as it is.
    whole = as_parquet(tmp_path).read_bytes()
    for name, content in (("cut.parquet", whole[:-100]), ("mid.parquet", whole[:8] + b"\0" * 3000 + whole[3008:])):
        (tmp_path / name).write_bytes(content)
        refused(tmp_path / name, ContactFileUnusable, "cannot be read")


def test_files_that_are_not_what_their_name_says(tmp_path):
    # Breaks when a name is believed rather than the content.
    parquet, text = as_parquet(tmp_path).read_bytes(), as_csv(tmp_path).read_bytes()
    for name, content, word in (("a.csv", parquet, "is a Parquet file"), ("b.parquet", text, "is a table of text"),
                                ("c.csv.gz", text, "is not compressed"), ("d.csv", gzip.compress(text), "in .gz"),
                                ("e.dump", text, "is a table of text"),
                                ("f.csv", as_dump(tmp_path).read_bytes(), "is a dump")):
        (tmp_path / name).write_bytes(content)
        refused(tmp_path / name, ContactFileUnusable, word)


def test_paths_that_lead_nowhere(tmp_path):
    # Breaks when the operating system's own words reach the user.
    for path, word in ((tmp_path / "none.csv", "does not exist"), (tmp_path, "is a folder")):
        with pytest.raises(FileUnreadable, match=word):
            open_table(path)


def test_parquet_without_its_library(tmp_path):
    # Breaks when an optional library is needed for other files, or its absence is not explained.
    path = as_parquet(tmp_path)
    with patch.dict(sys.modules, {"pyarrow": None}):
        with pytest.raises(ContactFileUnusable, match=r"granular\[tables\]"):
            open_table(path)
        assert open_table(EXAMPLE).columns[0] == "id1"


def test_memory_does_not_grow_with_the_list(tmp_path, monkeypatch):
    # Breaks when something is kept of every contact: four times the contacts may take no more memory, but for the
    # byte a grain that the count of contacts takes, and a twentieth for what Python itself keeps.
    monkeypatch.setattr("granular.contacts.text_table.ROWS", 500)
    monkeypatch.setattr("granular.contacts.pairs.IN_MEMORY", 2000)
    header, rows = table()
    peaks = []
    for copies in (1, 4):
        path = tmp_path / f"{copies}.csv"
        with path.open("w", encoding="utf-8") as file:
            file.write(",".join(header) + "\n")
            for copy in range(copies):
                file.writelines(f"{int(row[0]) + 2000 * copy},{int(row[1]) + 2000 * copy},{','.join(row[2:])}\n"
                                for row in rows)
        tracemalloc.start()
        assert summarise(path, volume=1.0).contacts == copies * len(rows)
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.05 * peaks[0] + 6000


def test_a_dump_of_centres_and_forces_is_the_same_packing(tmp_path):
    # Breaks when what LIGGGHTS writes (pos, id, force of pair/gran/local) does not give the contacts that it came from.
    expected = arrays(EXAMPLE)
    branch, normal = expected["branch"], expected["normal"]
    force = expected["normal_force"] * normal + expected["shear_force"]
    rows = np.concatenate([0 * branch, branch, expected["spheres"], force])
    names = [f"c_fc[{k}]" for k in range(1, len(rows) + 1)]
    lines = [" ".join(f"{value:.17g}" for value in row) for row in rows.T]
    path = written(tmp_path / "fc.dump", "ITEM: TIMESTEP", "5", "ITEM: NUMBER OF ENTRIES", str(len(lines)),
                   "ITEM: BOX BOUNDS pp pp pp", "0 1", "0 1", "0 1", "ITEM: ENTRIES " + " ".join(names), *lines)
    mapping = dict(zip(["x1", "y1", "z1", "x2", "y2", "z2", "id1", "id2", "f1", "f2", "f3"], names, strict=True))
    block = next(ContactList(path, columns=mapping, spheres_only=True).blocks())
    # in a sheared periodic cell branches are up to 4e-4 rad off the normals, and fs is at most a fifth of fn
    assert block.normal == pytest.approx(normal, abs=5e-4)
    assert block.normal_force == pytest.approx(expected["normal_force"], rel=1e-4)
    exchanged = dict(mapping, x1=names[3], y1=names[4], z1=names[5], x2=names[0], y2=names[1], z2=names[2])
    refused(path, ContactImpossible, "tensile", "exchange the two grains", columns=exchanged, spheres_only=True)
