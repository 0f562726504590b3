"""Read the contact lists of a folder: many_lists.py FOLDER VOLUME."""

import sys
from pathlib import Path

from granular.contacts import fitted_fabric, summarise
from granular.errors import GranularError

folder, volume = Path(sys.argv[1]), float(sys.argv[2])
print("file,contacts,D33,error,C3333_Pa,C2323_Pa")
for path in sorted(folder.iterdir()):
    try:
        found = summarise(path, volume=volume)
    except GranularError as refusal:
        print(f"{path.name}: {refusal}", file=sys.stderr)
        continue
    row = [fitted_fabric(found).D33, found.doubt_of("normals")]
    if found.kinematic is not None:
        for name in ("C3333", "C2323"):
            row.append(found.kinematic.component(name))
    print(path.name, found.contacts, *(f"{one:.5g}" for one in row), sep=",")
