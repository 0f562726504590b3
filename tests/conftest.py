"""Settings for all tests: random search takes the time that it needs, and prints what reproduces a failure."""

from __future__ import annotations

from hypothesis import settings

settings.register_profile("granular", deadline=None, print_blob=True)
settings.load_profile("granular")
