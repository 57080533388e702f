"""What the functions of the constructions do: keywords to a document, or straight to C where that is quicker."""
from __future__ import annotations

from typing import Any, Mapping, Sequence

import numpy as np

from ._handle import numbers
from ._watch import Progress
from .bases import Basis
from .errors import InputError
from .making import dirichlet_direct, make
from .model import Model


def take_words(said: dict[str, Any], members: Mapping[str, Any], words: Sequence[str]) -> None:
    """Adds members whose names are no names in Python, or are old ones: `**{"lambda": 0.5}`."""
    for key, value in members.items():
        if key not in words:
            raise TypeError(f"there is no member {key!r}")
        said[key] = value


def made_of(construct: str, members: Mapping[str, Any], known: Any, tolerance: float | None = None, threads: int | None = None,
            progress: Progress | None = None, strict: bool = False, exact: bool = False) -> Model:
    """The model of a construction; members that are None are not said."""
    said = {key: value for key, value in members.items() if value is not None}
    if known is not None:
        said["points"] = _masked(said.get("points"), known)
    if construct == "dirichlet" and _is_direct(said):
        net = np.ascontiguousarray(said["points"], dtype=np.float64)
        mask = np.logical_and.reduce(net == net, axis=-1).view(np.uint8)  # not where NaN; what is infinite is C's to refuse
        try:
            return dirichlet_direct(net, said["u"], said["v"], mask, None, said.get("aspect", 0.0), bool(said.get("regular", False)),
                                    said.get("name"), tolerance, threads, progress, strict)
        except InputError:
            pass  # which number is wrong, the document says
    model: Model = make({"construct": construct, **said}, tolerance, threads, progress, strict, exact)
    return model


def _masked(points: Any, known: Any) -> Any:
    net = np.array(numbers(points, None, "points"))
    mask = np.asarray(known, dtype=bool)
    if net.ndim != 3 or mask.shape != net.shape[:2]:
        raise InputError(f"known has the shape {mask.shape}; expected {net.shape[:2]}, as points", "/known", "size")
    if not np.isfinite(net[mask]).all():
        raise InputError("a known point is not finite", "/points", "value")
    net[~mask] = np.nan
    return net


def _is_direct(said: Mapping[str, Any]) -> bool:
    """Arrays of numbers on bases that are there: all is as C takes it."""
    net = said.get("points")
    return (set(said) <= {"points", "u", "v", "aspect", "regular", "name"} and type(net) is np.ndarray and net.dtype == np.float64
            and net.ndim == 3 and net.shape[2] == 3 and isinstance(said.get("u"), Basis) and isinstance(said.get("v"), Basis)
            and net.shape[:2] == (said["u"].count, said["v"].count)
            and all(type(said[key]) is kind for key, kind in (("regular", bool), ("name", str)) if key in said)
            and (said.get("aspect", 1) == "auto" or (type(said.get("aspect", 1)) in (int, float) and 0 < said.get("aspect", 1) < 1e300)))
