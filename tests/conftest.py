"""Settings for all tests: random search takes the time that it needs, and prints what reproduces a failure.

On a build server (CI is set) the search is the same every time, so that a verdict belongs to the change under test;
elsewhere it goes on looking in new places.
"""

from __future__ import annotations

import os

from hypothesis import settings

settings.register_profile("granular", deadline=None, print_blob=True, derandomize=bool(os.environ.get("CI")))
settings.load_profile("granular")
