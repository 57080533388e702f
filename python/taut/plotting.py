"""Pictures by matplotlib, which is imported only here."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from .geometry import Curve, Surface
    from .model import Model


def _axes(ax: Any) -> Any:
    """Those given, or new ones in space."""
    if ax is not None:
        return ax
    try:
        from matplotlib import pyplot
    except ImportError:
        raise ImportError("plot needs matplotlib (Debian: python3-matplotlib); model.write('x.svg') draws without it") from None
    return pyplot.figure().add_subplot(projection="3d")


def _fit(ax: Any) -> Any:
    """One scale along all axes."""
    limits = np.array([ax.get_xlim(), ax.get_ylim(), ax.get_zlim()])
    sizes = np.ptp(limits, axis=1)
    ax.set_box_aspect(np.maximum(sizes, 1e-3 * sizes.max()))
    return ax


def plot_surface(surface: Surface, ax: Any = None, net: bool = False, tolerance: float = 0.0, **options: Any) -> Any:
    """See Surface.plot."""
    from .model import Model
    axes = _axes(ax)
    mesh = Model([surface]).mesh(tolerance)
    axes.plot_trisurf(*mesh.vertices.T, triangles=mesh.triangles, **{"linewidth": 0, **options})
    if net:
        points = surface.points
        for line in (*points, *points.transpose(1, 0, 2)):
            axes.plot(*line.T, color="0.4", linewidth=0.6, marker="o", markersize=2)
    return _fit(axes)


def plot_curve(curve: Curve, ax: Any = None, count: int = 200, **options: Any) -> Any:
    """See Curve.plot."""
    axes = _axes(ax)
    low, high = curve.t.range
    axes.plot(*curve(np.linspace(low, high, count)).T, **options)
    return _fit(axes)


def plot_model(model: Model, ax: Any = None, net: bool = False, tolerance: float = 0.0) -> Any:
    """See Model.plot."""
    axes = _axes(ax)
    for surface in model.surfaces:
        plot_surface(surface, axes, net, tolerance)
    for curve in model.curves:
        plot_curve(curve, axes)
    return axes
