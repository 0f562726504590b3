"""Compute the pages with the library beside the book, and again whenever that library changes.

The execution cache of Jupyter Book keys on the text of a page alone, and Sphinx reads a page again only when
the page itself changed; both would go on showing the numbers of an older library. So a digest of everything
that decides the numbers is part of the cache's path, and a configuration value whose change makes Sphinx read
all pages.
"""

from __future__ import annotations

import hashlib
import os
import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sphinx.application import Sphinx
    from sphinx.config import Config

WATCHED = (
    "granular/**/*",
    "derivations/**/*",
    "book/_data/**/*",
    "book/_ext/**/*.py",
    "book/_formulas/*",
    "constraints.txt",
)


def library_digest(root: Path) -> str:
    """Digest of the interpreter's version and of all watched files below ``root``, names and contents."""
    digest = hashlib.sha256(sys.version.encode())
    for pattern in WATCHED:
        for path in sorted(path for path in root.glob(pattern) if path.is_file() and "__pycache__" not in path.parts):
            digest.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes() + b"\0")
    return digest.hexdigest()[:16]


def use_library(app: Sphinx, config: Config) -> None:
    """Point the kernels at the library and the page tools beside the book; key the cache on them."""
    root = Path(app.srcdir).parent
    inherited = os.environ.get("PYTHONPATH")
    before = [str(root), str(root / "book" / "_ext")]
    os.environ["PYTHONPATH"] = os.pathsep.join([*before, inherited] if inherited else before)
    key = library_digest(root)
    caches = Path(app.outdir).parent / ".jupyter_cache"
    config["library_key"] = key
    config["nb_execution_cache_path"] = str(caches / key)
    forget_old_caches(caches, keep=key)


def forget_old_caches(caches: Path, *, keep: str, newest: int = 3) -> None:
    """Delete the pages computed with older libraries, except for the newest few, to which one may return."""
    others = [path for path in caches.glob("*") if path.is_dir() and path.name != keep]
    for path in sorted(others, key=lambda path: path.stat().st_mtime, reverse=True)[newest:]:
        shutil.rmtree(path)


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_config_value("library_key", "", "env")
    app.connect("config-inited", use_library)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
