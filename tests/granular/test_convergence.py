"""The rule for slip converges as its strip of analyticity says."""

import pytest

from granular.checks.convergence import NODES, STATES, errors, predicted


@pytest.mark.parametrize("state", STATES)
def test_the_rule_converges_as_predicted(state: str) -> None:
    """Breaks when the error of the trapezoidal rule does not stay below its prediction until rounding is left."""
    for nodes, error in zip(NODES, errors(state), strict=True):
        assert error < max(predicted(nodes), 1e-15)
