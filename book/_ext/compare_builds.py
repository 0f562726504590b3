"""Compare two built books byte by byte: ``python compare_builds.py A B``; exit code 1 if they differ.

With one folder, say what is in it: the number of its files, and a digest that only an equal book has.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path


def files_below(root: Path) -> dict[str, Path]:
    """All files of a built book by their path inside it."""
    return {path.relative_to(root).as_posix(): path for path in sorted(root.rglob("*")) if path.is_file()}


def differences(first: Path, second: Path) -> list[str]:
    """One line for each file that is missing on one side or whose bytes differ."""
    left, right = files_below(first), files_below(second)
    found = [f"only in {first}: {name}" for name in left.keys() - right.keys()]
    found += [f"only in {second}: {name}" for name in right.keys() - left.keys()]
    found += [f"differs: {name}" for name in left.keys() & right.keys()
              if left[name].read_bytes() != right[name].read_bytes()]
    return sorted(found)


def digest(root: Path) -> str:
    """SHA-256 of what ``sha256sum`` prints for the files of a built book, in the order of their names."""
    lines = (f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {name}\n" for name, path in files_below(root).items())
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def main() -> int:
    """Compare the two folders named on the command line, or describe the only one."""
    if len(sys.argv) not in {2, 3}:
        print("usage: compare_builds.py FIRST [SECOND]", file=sys.stderr)
        return 2
    if len(sys.argv) == 2:
        root = Path(sys.argv[1])
        print(f"{len(files_below(root))} files, SHA-256 {digest(root)}")
        return 0
    first, second = map(Path, sys.argv[1:])
    if not files_below(first) or not files_below(second):
        print(f"nothing built in {first if not files_below(first) else second}", file=sys.stderr)
        return 2
    found = differences(first, second)
    print(*found, f"{len(files_below(first))} files, {len(found)} differ", sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
