"""How long the pages of a build were computed, as their cache of outputs keeps it."""

from __future__ import annotations

from pathlib import Path

from jupyter_cache import get_cache


def seconds_of_pages(caches: Path) -> dict[str, float]:
    """Seconds that each page with cells took, by its name, from the newest cache below a folder."""
    newest = max((path for path in caches.glob("*") if path.is_dir()), key=lambda path: path.stat().st_mtime)
    records = get_cache(str(newest)).list_cache_records()
    found = {Path(record.uri).stem: round(float(record.data["execution_seconds"]), 1) for record in records}
    return dict(sorted(found.items()))
