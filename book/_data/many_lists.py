"""Read every contact list of a folder: python many_lists.py FOLDER VOLUME."""

import sys
from pathlib import Path

from granular.contacts import fitted_fabric, summarise
from granular.errors import GranularError

folder, volume = Path(sys.argv[1]), float(sys.argv[2])
print("file,contacts,D33,standard_error,C3333_Pa,C2323_Pa")
for path in sorted(folder.iterdir()):
    try:
        found = summarise(path, volume=volume)
    except GranularError as refusal:
        print(f"{path.name}: {refusal}", file=sys.stderr)
        continue
    if found.kinematic is None:
        print(f"{path.name}: {found.no_kinematic}", file=sys.stderr)
        continue
    six = found.kinematic.components
    print(path.name, found.contacts, f"{fitted_fabric(found).D33:.4f}", f"{found.doubt_of('normals'):.4f}",
          f"{six['C3333']:.5g}", f"{six['C2323']:.5g}", sep=",")
