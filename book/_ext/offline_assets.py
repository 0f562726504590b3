"""Ship MathJax and plotly.js with the book, so that a reader needs no other machine.

They are copied into the output instead of lying in ``_static``, because Jupyter Book loads every script it
finds there on every page. Copying comes before the pages are written: their checksums are part of the pages.
"""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx
    from sphinx.config import Config

MATHJAX_OPTIONS: dict[str, Any] = {
    "tex": {"packages": {"[-]": ["noundefined"]}},  # an unknown macro is an error that inspect_book.py finds
    "loader": {"paths": {"fonts": "[mathjax]/fonts"}},  # MathJax 4 would fetch its font from a CDN
    "output": {"displayOverflow": "linebreak"},
    "options": {  # speech and braille need web workers, which browsers refuse to start from file://
        "enableSpeech": False,
        "enableBraille": False,
        "menuOptions": {"settings": {"enrich": False, "speech": False, "braille": False}},
    },
}
# The in-page configuration of sphinx-thebe: it names a CDN and a Binder repository on every page.
LIVE_CODE = re.compile(
    r'<script type="text/x-thebe-config">.*?</script>\s*<script>kernelName = .*?</script>', flags=re.DOTALL)


def use_local_mathjax(_app: Sphinx, config: Config) -> None:
    """Typeset with the vendored MathJax; Sphinx writes ``mathjax3_config`` for MathJax 4 just as well."""
    config["mathjax_path"] = "vendor/mathjax/tex-chtml.js"
    config["mathjax3_config"] = MATHJAX_OPTIONS


def copy_assets(app: Sphinx) -> None:
    """Copy MathJax and plotly.js into ``_static/vendor`` of the output."""
    if app.builder.format != "html":
        return
    import plotly

    vendor = Path(app.outdir, "_static", "vendor")
    shutil.rmtree(vendor / "mathjax", ignore_errors=True)  # the theme keeps its own files beside it
    shutil.copytree(Path(app.srcdir, "_vendor", "mathjax"), vendor / "mathjax")
    plotly_folder = Path(plotly.__file__).parent / "package_data"
    shutil.copyfile(plotly_folder / "plotly.min.js", vendor / "plotly.min.js")


def keep_page_local(
    app: Sphinx, _page: str, _template: str, context: dict[str, Any], _doctree: nodes.document | None
) -> None:
    """Load plotly.js where a page has an interactive figure; drop the live-code scripts everywhere."""
    body = context.get("body", "")
    if "plotly-graph-div" in body:
        app.add_js_file("vendor/plotly.min.js", priority=100)  # before the calls inside the page
    context["body"] = LIVE_CODE.sub("", body)
    scripts = context.get("script_files", [])
    scripts[:] = [script for script in scripts if not _is_live_code(script)]


def _is_live_code(script: Any) -> bool:
    return "thebe" in f"{getattr(script, 'filename', script)} {getattr(script, 'attributes', '')}"


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("config-inited", use_local_mathjax)
    app.connect("builder-inited", copy_assets, priority=400)
    app.connect("html-page-context", keep_page_local, priority=900)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
