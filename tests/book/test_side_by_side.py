"""Pages computed side by side: what succeeds is in the cache, what fails is named with the line of its cell."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from jupyter_cache import get_cache
from myst_nb.core.config import NbParserConfig
from myst_parser.config.main import MdParserConfig
from side_by_side import Page, compute_before_reading, missing_pages
from sphinx.errors import ExtensionError

PAGE = """\
---
file_format: mystnb
kernelspec: {{name: python3}}
---
# A page

```{{code-cell}} python
kept = 6
```

```{{code-cell}} python
{last}
```
"""
LINE_OF_LAST_CELL = 12


@pytest.fixture
def env(tmp_path: Path) -> Any:
    """Two pages with cells and one without, in the place of what Sphinx knows of a book."""
    for name, last in (("good", "print(7 * kept)"), ("bad", "1 / 0")):
        (tmp_path / f"{name}.md").write_text(PAGE.format(last=last), encoding="utf-8")
    (tmp_path / "prose.md").write_text("# No cells\n", encoding="utf-8")
    return SimpleNamespace(doc2path=lambda name: str(tmp_path / f"{name}.md"), myst_config=MdParserConfig(),
                           mystnb_config=NbParserConfig())


def missing(env: Any, cache_path: Path) -> list[Page]:
    return list(missing_pages(env, ["good", "bad", "prose"], get_cache(cache_path)))


def test_pages_are_kept_or_named(env: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch,
                                 capsys: pytest.CaptureFixture[str]) -> None:
    """Breaks when a failing cell passes or is not named, or when a page is computed once more in the next build."""
    told = []
    monkeypatch.setattr("side_by_side.LOGGER.error", lambda text, location: told.append((text, location)))
    cache_path = tmp_path / "cache"
    app: Any = SimpleNamespace(config=SimpleNamespace(nb_execution_cache_path=str(cache_path), nb_execution_timeout=60))
    good, bad = missing(env, cache_path)
    assert (good.name, bad.name) == ("good", "bad")
    with pytest.raises(ExtensionError, match="cells failed on bad"):
        compute_before_reading(app, env, ["good", "bad", "prose"])
    [(text, location)] = told
    assert "1 / 0" in text and "ZeroDivisionError" in text
    assert location == ("bad", LINE_OF_LAST_CELL)
    said = capsys.readouterr().err
    assert "good computed in" in said and "bad failed in" in said and said.rstrip().endswith("0 left")

    [left] = missing(env, cache_path)
    assert left.name == "bad"
    _, kept = get_cache(cache_path).merge_match_into_notebook(good.notebook)
    assert kept.cells[-1].outputs[0].text == "42\n"
