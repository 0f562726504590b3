"""Contact forces between aligned spheroids that balance the stress, by way of the stress they are estimated from."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from granular.spheroid import stress_carried

if TYPE_CHECKING:
    from granular.fabric import AxialFabric
    from granular.loading import Loading


def balancing(loading: Loading, fabric: AxialFabric) -> Loading:
    """Find the stress for which eq. (22) gives forces that balance another one on spheroids.

    The estimate is linear in the stress and each principal stress keeps to itself, so that dividing each by the share
    of it that its forces carry is enough.

    Parameters
    ----------
    loading : Loading
        Stress to be balanced, and friction.
    fabric : AxialFabric
        Contact normals and aspect ratio [-].

    Returns
    -------
    Loading
        Stress on the same scale; the same friction. For spheres the stress that was given.

    Notes
    -----
    Accuracy: 1e-15. Its mean is another one, so that moduli in Pa are those under the given stress only after a factor
    (new mean/old mean)^(1/3); ratios need none. Source: eqs (24) and (25).

    Examples
    --------
    >>> from granular.fabric import AxialFabric
    >>> from granular.loading import Loading
    >>> found = balancing(Loading.of_ratio(1), AxialFabric(aspect_ratio=0.8))
    >>> round(float(found.sigma33 / found.sigma11), 3)
    1.321
    """
    across, along = map(Fraction, stress_carried(fabric))
    return replace(loading, sigma11=loading.sigma11 / across, sigma33=loading.sigma33 / along)
