"""Fabric and stress of a scene as tensors: as they are, or about the axis that they share."""

from __future__ import annotations

from functools import lru_cache

from granular.axial_scene import AxialScene
from granular.general.axis import axial_scene
from granular.general.fabric import GeneralFabric
from granular.general.loading import GeneralLoading
from granular.tensors import Tensor, Tensor4


@lru_cache(maxsize=256)
def general_fabric(D: Tensor, D4: Tensor4 | None, Dr: Tensor | None) -> GeneralFabric:
    """Build the fabric of tensors that a scene holds; the same one for the same tensors.

    Parameters
    ----------
    D, D4, Dr : nested tuples of float
        Contact normals of rank two and four, and branch lengths [-]; see :class:`granular.general.GeneralFabric`.

    Returns
    -------
    GeneralFabric
        The fabric [-].

    Raises
    ------
    TensorUnusable, FabricOutOfRange
        As ``GeneralFabric``.

    Notes
    -----
    Source: eq. (14).
    """
    return GeneralFabric(D, D4, Dr)


@lru_cache(maxsize=256)
def recognised(D: Tensor, D4: Tensor4 | None, Dr: Tensor | None, stress: Tensor) -> AxialScene | None:
    """Find the axis that the tensors of a scene share.

    Parameters
    ----------
    D, D4, Dr : nested tuples of float
        Fabric, as :func:`general_fabric` takes it [-].
    stress : nested tuple of float
        Stress tensor up to a positive factor [-].

    Returns
    -------
    AxialScene or None
        The scene about its axis, without friction; None when there is no such axis.

    Notes
    -----
    Accuracy: that of :func:`granular.general.axis.axial_scene`. Source: the same.

    Examples
    --------
    >>> tilted = ((0.125, 0.0, 0.375), (0.0, -0.25, 0.0), (0.375, 0.0, 0.125))
    >>> round(recognised(tilted, None, None, ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))).fabric.D33, 12)
    0.5
    """
    return axial_scene(general_fabric(D, D4, Dr), GeneralLoading(stress))
