"""The force estimate of eq. (23) for a list: what every contact would carry if the stress alone decided it."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    from granular.contacts.by_angle import ByAngle
    from granular.contacts.summary import ContactSummary

    Array = NDArray[np.float64]


def estimated_forces(summary: ContactSummary, by_angle: ByAngle | None = None) -> tuple[Array, Array] | None:
    """Estimate mean forces in classes of the angle from axis 3.

    Parameters
    ----------
    summary : ContactSummary
        A list with forces.
    by_angle : ByAngle, optional
        Classes of it, perhaps merged; its own by default.

    Returns
    -------
    fn, fs : (k,) array
        Estimated normal force of each class, and shear force along the meridian towards axis 3 [N]; None where the list
        has no forces, or its contacts do not span all directions.

    Notes
    -----
    f_j = sigma_pj H^-1_kp n_k/l with H_ik = (1/V) sum l_i n_k/l, averaged about axis 3; for branches along the normals
    that is eq. (23), since H = (M/V) N. Accuracy: about 1e-13. Source: eqs (22) and (23).

    Examples
    --------
    >>> from granular.contacts.example import example_facts, example_path
    >>> from granular.contacts.summary import summarise
    >>> normal, _ = estimated_forces(summarise(example_path(), volume=example_facts()["V"]))
    >>> bool(normal[0] > normal[-1])
    True
    """
    import numpy as np

    if summary.stress is None or abs(np.linalg.det(summary.balance)) <= 1e-12 * np.abs(summary.balance).max() ** 3:
        return None
    classes = summary.by_angle if by_angle is None else by_angle
    along = np.linalg.inv(summary.balance) @ summary.stress
    across, up = (along[0, 0] + along[1, 1]) / 2, along[2, 2]
    x2, inverse_length = classes.mean("x2"), classes.mean("inverse_length")
    assert x2 is not None  # every list has normals
    assert inverse_length is not None  # and branches
    return ((across * (1 - x2) + up * x2) * inverse_length,
            (up - across) * np.sqrt(x2 * (1 - x2)) * inverse_length)
