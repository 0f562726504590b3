"""Run the pages in kernels that know nothing of the builder's own IPython settings, and that start quietly.

Start-up files or extensions of a personal profile could change a page, and no build would tell.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from sphinx.application import Sphinx
    from sphinx.config import Config

SETTINGS = """\
# Written by the book; ERROR leaves out the advice on encryption, since the kernels talk to this machine alone.
c.IPKernelApp.log_level = 40
c.HistoryManager.enabled = False
"""


def use_own_profile(app: Sphinx, _config: Config) -> None:
    """Give the kernels a profile below the build folder."""
    home = Path(app.outdir).parent / "ipython"
    profile = home / "profile_default"
    profile.mkdir(parents=True, exist_ok=True)
    (profile / "ipython_kernel_config.py").write_text(SETTINGS, encoding="utf-8")
    os.environ["IPYTHONDIR"] = str(home)
    os.environ["JUPYTER_PREFER_ENV_PATH"] = "1"  # the kernel of this environment before one of the user's


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("config-inited", use_own_profile)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
