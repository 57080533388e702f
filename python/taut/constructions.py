"""A function for each construction, its arguments the members of its document: written by tools/python_constructions.py from
docs/schema/problem.json. Arguments that are None are left out of the document. Lengths are in `unit`, angles in radians."""
from __future__ import annotations

import os
from typing import Any, Literal, Mapping, Sequence, Union

import numpy.typing as npt

from ._direct import made_of, take_words
from ._watch import Progress
from .bases import BasisLike
from .geometry import Curve, Surface
from .model import Model

CurveLike = Union[Curve, Mapping[str, Any]]
SurfaceLike = Union[Surface, Mapping[str, Any]]
ModelLike = Union[Model, Mapping[str, Any]]


def asymptotic(*, unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, degree: int | None = None,
        corners: Mapping[str, Union[npt.ArrayLike, None, Mapping[str, npt.ArrayLike], Mapping[str, Any]]] | None = None,
        edges: Mapping[str, Mapping[str, npt.ArrayLike]] | None = None, curves: Mapping[str, CurveLike] | None = None,
        branch: str | None = None, surface: Literal["5n-7", "n+3"] | None = None,
        singular: Literal["refuse", "report"] | None = None, free: Literal["points", "all"] | None = None,
        boundary: Union[str, Mapping[str, Any]] | None = None, tolerance: float | None = None, threads: int | None = None,
        progress: Progress | None = None, strict: bool = False) -> Model:
    """A patch whose four edges are asymptotic curves: corner data, or the four curves.

    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    degree                 of the edges; at least 3
    corners                {"u0v0", "u1v0", "u0v1", "u1v1": (3,) | None | {"near": (3,)} | {"line": {"point",
                           "direction": (3,)}, "near"?: (3,)} | {"plane": {"point", "normal": (3,)}, "near"?: (3,)}}
    edges                  {"v0", "v1", "u0", "u1": {"legs": (n, 3), "curvature"?, "weights": numbers}}
    curves                 {"v0", "v1", "u0", "u1": a Curve}
    branch                 or four signs such as +-+-; "lowest" if not given
    surface                one of "5n-7", "n+3"; "5n-7" if not given
    singular               one of "refuse", "report"; "refuse" if not given
    free                   one of "points", "all"; "points" if not given
    boundary               a file with four curves (.step, .igs, .dxf, .json), beside this document; they bound the net;
                           or with others that are joined to four; or a file and which of its curves and edges; text |
                           {"file": text, "edges"?: [text | whole number, ..]}
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             not-bezier, far-away, too-large
    NoSolution             same-corner, not-closed, end-weights, no-leg, parallel-legs, parallel-planes, straight-edge,
                           cannot-bend, turns-over, no-curvature, osculating-plane, torsion, torsion-signs, closing,
                           no-minimum, no-branch, singular, inflection, twist, negative-weight
    NotConverged           ill-conditioned

    Source: [WangZhuLi2017]; docs/asymptotic.md
    """
    said: dict[str, Any] = {"unit": unit, "degree": degree, "corners": corners, "edges": edges, "curves": curves,
        "branch": branch, "surface": surface, "singular": singular, "free": free, "boundary": boundary}
    return made_of("asymptotic", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


def biharmonic(points: npt.ArrayLike | None = None, *, u: BasisLike | None = None, v: BasisLike | None = None,
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, name: str | None = None,
        surface: SurfaceLike | None = None, edge: Literal["u0", "u1", "v0", "v1"] | None = None,
        width: float | None = None, contact: Literal["c1", "c2"] | None = None, allow_ill_conditioned: bool | None = None,
        known: npt.ArrayLike | None = None, tolerance: float | None = None, threads: int | None = None,
        progress: Progress | None = None, strict: bool = False, **members: Any) -> Model:
    """The biharmonic Bezier surface with four given rows, or the neighbour of one across an edge.

    points                 (nu, nv, 3); a point with a NaN, or where `known` is False, is to be found; the four boundary
                           rows; null inside
    u                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    v                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    name                   at most 255 bytes of UTF-8
    surface                a Surface
    edge                   one of "u0", "u1", "v0", "v1"
    width                  default: that of the surface; above 0
    contact                one of "c1", "c2"; "c1" if not given
    allow_ill_conditioned  build a neighbour also where rounding leaves nothing of least bending; false if not given
    known                  (nu, nv) of truth values: which points are given
    members                also as the document spells them: insist
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             mask, not-bezier
    NoSolution             degree, ill-conditioned, not-biharmonic

    Source: [NiWang2015] section 8.4; docs/biharmonic.md
    """
    said: dict[str, Any] = {"points": points, "u": u, "v": v, "unit": unit, "name": name, "surface": surface, "edge": edge,
        "width": width, "contact": contact, "allow_ill_conditioned": allow_ill_conditioned}
    take_words(said, members, ["insist"])
    return made_of("biharmonic", said, known, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


def bonnet(*, sign: Literal["+", "-"], alpha: float, beta: float, unit: Literal["mm", "m", "cm", "in", "ft"] | None = None,
        lambda_: Union[float, npt.ArrayLike] | None = None, mesh: Literal["bezier", "bspline"] | None = None,
        segments: npt.ArrayLike | None = None, theta: float | None = None, normalize: bool | None = None,
        start: npt.ArrayLike | None = None, frames: int | None = None, tolerance: float | None = None,
        threads: int | None = None, progress: Progress | None = None, strict: bool = False, **members: Any) -> Model:
    """Minimal surfaces with planar curvature lines, from the catenoid to Enneper's surface.

    sign                   one of "+", "-"
    alpha                  length of a segment in u; above 0
    beta                   length of a segment in v; above 0
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    lambda_                below 1, or with normalize also 1; with frames the first and the last
    mesh                   one of "bezier", "bspline"; "bezier" if not given
    segments               [1, 1] if not given
    theta                  angle of the associate family; 0 if not given
    normalize              the family that ends in Enneper's surface; false if not given
    start                  [0, 0] if not given
    frames                 at least 2
    members                also as the document spells them: lambda
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             segment-length
    NoSolution             lambda, segment-length, far-window, theta, large-panels, enneper, no-surface

    Source: [XuWang2006] sections 1 to 5, 8, 9; docs/bonnet.md
    """
    said: dict[str, Any] = {"sign": sign, "alpha": alpha, "beta": beta, "unit": unit, "lambda": lambda_, "mesh": mesh,
        "segments": segments, "theta": theta, "normalize": normalize, "start": start, "frames": frames}
    take_words(said, members, ["lambda"])
    return made_of("bonnet", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


def dirichlet(points: npt.ArrayLike | None = None, *, u: BasisLike | None = None, v: BasisLike | None = None,
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, name: str | None = None,
        weights: npt.ArrayLike | None = None, aspect: Union[float, Literal["auto"]] | None = None,
        boundary: Union[str, Mapping[str, Any]] | None = None, degree: npt.ArrayLike | None = None,
        refine: npt.ArrayLike | None = None, regular: bool | None = None, through: Sequence[Any] | None = None,
        known: npt.ArrayLike | None = None, tolerance: float | None = None, threads: int | None = None,
        progress: Progress | None = None, strict: bool = False) -> Model:
    """The surface of least Dirichlet energy through the known points of a net; any bases but ce-bezier.

    points                 (nu, nv, 3); a point with a NaN, or where `known` is False, is to be found; points[i][j];
                           null is to be found
    u                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    v                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    name                   at most 255 bytes of UTF-8
    weights                weights[i][j], the shape of points
    aspect                 1 if not given
    boundary               a file with four curves (.step, .igs, .dxf, .json), beside this document; they bound the net;
                           or with others that are joined to four; or a file and which of its curves and edges; text |
                           {"file": text, "edges"?: [text | whole number, ..]}
    degree                 at least these along u and v
    refine                 how often the spans along u and v are halved
    regular                true: the certificate claims `regular`, the surface has a tangent plane everywhere; false if
                           not given
    through                points that the surface passes through; not with "aspect": "auto"; [{"u"?, "v"?: number,
                           "point": numbers}, ..]
    known                  (nu, nv) of truth values: which points are given
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             basis
    NoSolution             nothing-known, no-best-aspect, through, overflow
    NotConverged           ill-conditioned, undetermined, weights-vary

    Source: [WuWang2011] sections 2 to 3, 7.3, 7.5, 7.6; docs/dirichlet.md
    """
    said: dict[str, Any] = {"points": points, "u": u, "v": v, "unit": unit, "name": name, "weights": weights,
        "aspect": aspect, "boundary": boundary, "degree": degree, "refine": refine, "regular": regular, "through": through}
    return made_of("dirichlet", said, known, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


def film(points: npt.ArrayLike | None = None, *, u: BasisLike | None = None, v: BasisLike | None = None,
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, name: str | None = None,
        corners: Mapping[str, Union[npt.ArrayLike, None, Mapping[str, npt.ArrayLike], Mapping[str, Any]]] | None = None,
        edges: Mapping[str, Union[Literal["fixed"], Mapping[str, Union[CurveLike, Union[Mapping[str, npt.ArrayLike], Mapping[str, Mapping[str, Any]]]]], Mapping[str, Any], Mapping[str, Mapping[str, npt.ArrayLike]]]] | None = None,
        seams: Sequence[Any] | None = None, patches: Sequence[Any] | None = None, cables: Sequence[Any] | None = None,
        cells: Sequence[Any] | None = None, curves: Sequence[Any] | None = None,
        boundary: Union[str, Mapping[str, Any]] | None = None, degree: int | None = None, count: int | None = None,
        images: Sequence[Any] | None = None, tension: float | None = None, force_density: npt.ArrayLike | None = None,
        prestress: npt.ArrayLike | None = None, reference: SurfaceLike | None = None, updates: int | None = None,
        tolerance: float | None = None, max_iterations: int | None = None, equilibrium: float | None = None,
        method: Literal["full", "normal"] | None = None, accept: Literal["minimum", "stationary"] | None = None,
        least: bool | None = None, start: ModelLike | None = None, refine: int | None = None,
        known: npt.ArrayLike | None = None, threads: int | None = None, progress: Progress | None = None,
        strict: bool = False) -> Model:
    """The film of least energy between edges that are held or drawn by cables.

    points                 (nu, nv, 3); a point with a NaN, or where `known` is False, is to be found; in place of
                           corners: the rows of edges that are held, of others where they start; null inside
    u                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    v                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    name                   at most 255 bytes of UTF-8
    corners                where no curve ends; null: free; of a ring there are none; {"u0v0"?, "u1v0"?, "u0v1"?,
                           "u1v1"?: (3,) | None | {"near": (3,)} | {"line": {"point", "direction": (3,)}, "near"?: (3,)}
                           | {"plane": {"point", "normal": (3,)}, "near"?: (3,)}}
    edges                  {"u0"?, "u1"?, "v0"?, "v1"?: "fixed" | {"fixed": a Curve | {"arc": (n, 3)} | {"line": (n, 3)}
                           | {"circle": {"center", "normal", "radius", "start"?: ..}}} | {"cable": {"force": number} |
                           {"length": number} | {"sag": number} | {"unstressed", "stiffness": number}, "plane"?:
                           {"point", "normal": (3,)}} | {"slide": {"point", "normal": (3,)}} | {"mirror": {"point",
                           "normal": (3,)}} | {"pole": ..}}
    seams                  of one patch a ring: the two edges, u0 and u1 or v0 and v1, are one curve inside the film,
                           which goes around; of many, edges that are one; [[text, ..] | {"edges": [text, ..], "cable"?:
                           {"force": number} | {"length": number} | {"sag": number} | {"unstressed", "stiffness":
                           number}, "plane"?: {"point", "normal": (3,)}}, ..]
    patches                in place of u, v, corners, edges and tension: a film of many patches; [{"name"?: text, "u"?,
                           "v"?: a basis, "corners"?, "edges"?: a dict, "points"?: [[(3,) | None, ..], ..], "tension"?:
                           number, "force_density"?, "prestress"?: numbers, "reference"?: a Surface}, ..]
    cables                 one cable along several edges, as it runs, with one force; its law counts the whole length;
                           [{"name"?: text, "along": [text, ..], "force"?, "length"?, "sag"?, "unstressed"?,
                           "stiffness"?: number}, ..]
    cells                  what sides of the film bound, each under a pressure or of a volume; [{"name"?: text, "sides":
                           [text, ..], "pressure"?, "volume"?: number, "from"?: (3,)}, ..]
    curves                 in place of patches: curves that go round, in their order, each run either way; [a Curve |
                           {"arc": (n, 3)} | {"line": (n, 3)} | {"circle": {"center", "normal", "start"?: (3,),
                           "radius": number}}, ..]
    boundary               in place of curves: those of a file, 3 to 12 that go round, in any order, or one or two
                           closed ones; or a file and which of its curves and edges; text | {"file": text, "edges"?:
                           [text | whole number, ..]}
    degree                 of the patches between curves, those of a boundary too; at least 2; 4 if not given
    count                  of their points either way; at least 3; 12 if not given
    images                 each in turn adds its images of all surfaces so far; [{"mirror"?: {"point", "normal": (3,)},
                           "half_turn"?, "turn"?: {"point", "direction": (3,)}, "angle"?: number, "translate"?: (3,),
                           "count"?: whole number}, ..]
    tension                of the film: a force per length; above 0; 1 if not given
    force_density          in place of a tension: along the threads, u and v over [0, 1]
    prestress              in place of a tension: forces per width along u and v on the reference
    reference              a surface on the bases of the film; with prestress
    updates                so often the film becomes the reference; at least 0; 0 if not given
    tolerance              of the claim stationary; at least 1e-14; 1e-10 if not given
    max_iterations         at least 1; 200 if not given
    equilibrium            adds the claim of that name; above 0
    method                 normal: the last steps are those alone that the energy sees; one of "full", "normal"; "full"
                           if not given
    accept                 stationary: films at rest that are no minimum too; one of "minimum", "stationary"; "minimum"
                           if not given
    least                  true if not given
    start                  a model with a surface of the film's name on its bases: where to begin
    refine                 so often the film is found anew with all spans halved; at least 0; 0 if not given
    known                  (nu, nv) of truth values: which points are given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             not-yet, basis, corner-missing, start, cell-sides, image-twice, curve-ends, edge-conflict,
                           corner-conflict, seam-mismatch
    NoSolution             free-edge, open-cell, pressure-too-high, unstable, no-area, point-support, no-corner,
                           floating, collapses, slides-away, crossed, cable-too-weak, cable-too-short, unbalanced,
                           overflow
    NotConverged           curve-fit, folds, not-converged, ill-conditioned

    Source: docs/film.md
    """
    said: dict[str, Any] = {"points": points, "u": u, "v": v, "unit": unit, "name": name, "corners": corners,
        "edges": edges, "seams": seams, "patches": patches, "cables": cables, "cells": cells, "curves": curves,
        "boundary": boundary, "degree": degree, "count": count, "images": images, "tension": tension,
        "force_density": force_density, "prestress": prestress, "reference": reference, "updates": updates,
        "tolerance": tolerance, "max_iterations": max_iterations, "equilibrium": equilibrium, "method": method,
        "accept": accept, "least": least, "start": start, "refine": refine}
    return made_of("film", said, known, threads=threads, progress=progress, strict=strict)


def harmonic(points: npt.ArrayLike | None = None, *, u: BasisLike | None = None, v: BasisLike | None = None,
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, name: str | None = None,
        from_: Literal["derivative"] | None = None, edge: npt.ArrayLike | None = None,
        cross_derivative: npt.ArrayLike | None = None, even: Literal["refuse", "corner", "project", "raise"] | None = None,
        allow_ill_conditioned: bool | None = None, fit: bool | None = None,
        boundary: Union[str, Mapping[str, Any]] | None = None, known: Literal["u", "v"] | None = None,
        widths: npt.ArrayLike | None = None, tolerance: float | None = None, threads: int | None = None,
        progress: Progress | None = None, strict: bool = False, exact: bool = False, **members: Any) -> Model:
    """The harmonic Bezier surface through two opposite edges, or from one edge and the derivative across it.

    points                 (nu, nv, 3); a point with a NaN is to be found; two opposite boundary rows or columns; null
                           elsewhere
    u                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    v                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    name                   at most 255 bytes of UTF-8
    from_                  complete from edge and cross_derivative; one of "derivative"
    edge                   (n, 3)
    cross_derivative       (n, 3)
    even                   one of "refuse", "corner", "project", "raise"; "refuse" if not given
    allow_ill_conditioned  build also where rounding grows past 1e15; false if not given
    fit                    the harmonic surface nearest to four boundary rows; false if not given
    boundary               a file with four curves (.step, .igs, .dxf, .json), beside this document; they bound the net;
                           or with others that are joined to four; or a file and which of its curves and edges; text |
                           {"file": text, "edges"?: [text | whole number, ..]}
    known                  with boundary: edges u0 and u1, or v0 and v1, are kept; one of "u", "v"; "v" if not given
    widths                 with boundary: of the parameter rectangle; [1, 1] if not given
    members                also as the document spells them: from, insist
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model
    exact                  in rational arithmetic

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             mask, not-bezier
    NoSolution             rational, degree, inconsistent, ill-conditioned, overflow, not-harmonic, other-surface

    Source: [NiWang2015] sections 2.2 to 2.7, 3, 8.2, 8.3, 8.6; docs/harmonic.md
    """
    said: dict[str, Any] = {"points": points, "u": u, "v": v, "unit": unit, "name": name, "from": from_, "edge": edge,
        "cross_derivative": cross_derivative, "even": even, "allow_ill_conditioned": allow_ill_conditioned, "fit": fit,
        "boundary": boundary, "known": known, "widths": widths}
    take_words(said, members, ["from", "insist"])
    return made_of("harmonic", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict, exact=exact)


def harmonic_extension(*, surface: SurfaceLike, edge: Literal["u0", "u1", "v0", "v1"],
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, neighbour: SurfaceLike | None = None,
        width: float | None = None, contact: Literal["c1", "g1"] | None = None, c: float | None = None,
        alpha: float | None = None, beta: float | None = None, tolerance: float | None = None, threads: int | None = None,
        progress: Progress | None = None, strict: bool = False, exact: bool = False) -> Model:
    """The harmonic neighbour of a harmonic surface across an edge.

    surface                a Surface
    edge                   one of "u0", "u1", "v0", "v1"
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    neighbour              the other piece, to be merged; without width and contact g1
    width                  default: that of the surface; above 0
    contact                one of "c1", "g1"; "c1" if not given
    c                      1 if not given
    alpha                  0 if not given
    beta                   0 if not given
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model
    exact                  in rational arithmetic

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             mask, not-bezier
    NoSolution             rational, degree, inconsistent, ill-conditioned, overflow, not-harmonic, other-surface

    Source: [NiWang2015] sections 2.2 to 2.7, 3, 8.2, 8.3, 8.6; docs/harmonic.md
    """
    said: dict[str, Any] = {"surface": surface, "edge": edge, "unit": unit, "neighbour": neighbour, "width": width,
        "contact": contact, "c": c, "alpha": alpha, "beta": beta}
    return made_of("harmonic-extension", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict, exact=exact)


def pipe(*, unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, radius: float | None = None,
        radii: npt.ArrayLike | None = None, surface: Literal["canal", "naive-sweep"] | None = None,
        sections: Sequence[Any] | None = None, polygon: npt.ArrayLike | None = None,
        from_: Mapping[str, Any] | None = None, to: Mapping[str, Any] | None = None,
        run: Union[npt.ArrayLike, Sequence[Any]] | None = None, closed: bool | None = None,
        bend_radius: Union[float, Literal["1D", "1.5D", "2D", "2.5D", "3D", "5D"]] | None = None,
        elbow: Literal["blend", "arc"] | None = None, caps: bool | None = None, wall: float | None = None,
        axes: Sequence[Any] | None = None,
        shape: Union[Literal["auto"], Mapping[str, Literal["bending", "curvature"]], Mapping[str, float]] | None = None,
        joint: Literal["g1", "g2"] | None = None, domain: Literal["strict", "extended"] | None = None,
        frame: Literal["rotation-minimizing", "frenet"] | None = None, pipe_lengths: Sequence[Any] | None = None,
        tolerance: float | None = None, threads: int | None = None, progress: Progress | None = None, strict: bool = False,
        **members: Any) -> Model:
    """Curved pipes between straight ones: from four points, two directed ends, two lines, or a run of many.

    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    radius                 this, radii or sections; above 0
    radii                  of pipe 1 and pipe 2
    surface                with radii: envelope of spheres, or circles swept across the axis; one of "canal", "naive-
                           sweep"; "canal" if not given
    sections               elliptic pipes: semi-axes of pipe 1 and pipe 2; [{"a", "b": number, "direction": (3,)}, ..]
    polygon                V_0, V_1 on axis 1, V_2, V_3 on axis 2
    from_                  {"point", "direction": (3,), "handle"?: number}
    to                     {"point", "direction": (3,), "handle"?: number}
    run                    a chain of pipes: corners, or straight pipes in order of flow; (n, 3) | [{"from", "to": (3,)}
                           | {"point", "direction": (3,)}, ..]
    closed                 the run comes round to where it begins; false if not given
    bend_radius            least radius of curvature of the axis, also in diameters; of corners three radii if not given
    elbow                  of corners: blends, or circular arcs of the bend radius; one of "blend", "arc"; "blend" if
                           not given
    caps                   discs over the free ends; false if not given
    wall                   of an open run: how thick it is, inwards from the radius; above 0
    axes                   two lines: V_1 and V_2 are the feet of their common perpendicular; [{"point", "direction":
                           (3,), "handle"?: number}, ..]
    shape                  "auto" if not given; "auto" | {"auto": "bending" | "curvature"} | {"alpha", "beta"?, "gamma":
                           number}
    joint                  equal tangent planes, or equal curvatures too; one of "g1", "g2"; "g1" if not given
    domain                 one of "strict", "extended"; "strict" if not given
    frame                  one of "rotation-minimizing", "frenet"; "rotation-minimizing" if not given
    pipe_lengths           of the straight pipes; null: a half line
    members                also as the document spells them: from
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    NoSolution             degenerate-edge, too-small, parallel-axes, parameter-domain, tangent-lost, not-regular,
                           self-intersect-local, self-intersect-global, bend-radius, leg-too-short, turns-back,
                           run-straight, arc-frame, canal-not-real, canal-not-regular, canal-joint, section-along,
                           frenet-undefined, too-fine

    Source: [WangBai2018]; docs/pipe.md
    """
    said: dict[str, Any] = {"unit": unit, "radius": radius, "radii": radii, "surface": surface, "sections": sections,
        "polygon": polygon, "from": from_, "to": to, "run": run, "closed": closed, "bend_radius": bend_radius,
        "elbow": elbow, "caps": caps, "wall": wall, "axes": axes, "shape": shape, "joint": joint, "domain": domain,
        "frame": frame, "pipe_lengths": pipe_lengths}
    take_words(said, members, ["from"])
    return made_of("pipe", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


def plateau(points: npt.ArrayLike | None = None, *, u: BasisLike | None = None, v: BasisLike | None = None,
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, name: str | None = None,
        weights: npt.ArrayLike | None = None, start: SurfaceLike | None = None, tolerance: float | None = None,
        max_iterations: int | None = None, method: Literal["full", "normal"] | None = None,
        curves: Mapping[str, CurveLike] | None = None, boundary: Union[str, Mapping[str, Any]] | None = None,
        degree: npt.ArrayLike | None = None, refine: Union[int, npt.ArrayLike] | None = None,
        tolerance_area: float | None = None, least: bool | None = None, gap: float | None = None,
        regular: bool | None = None, through: Sequence[Any] | None = None, known: npt.ArrayLike | None = None,
        threads: int | None = None, progress: Progress | None = None, strict: bool = False) -> Model:
    """The surface of least area through the known points of a net; any bases but ce-bezier.

    points                 (nu, nv, 3); a point with a NaN, or where `known` is False, is to be found; points[i][j];
                           null is to be found
    u                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    v                      A function basis on a parameter range; its functions are as many as the points along it; such
                           as taut.bspline(3, count=8)
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    name                   at most 255 bytes of UTF-8
    weights                weights[i][j], the shape of points
    start                  where to begin, in place of the Dirichlet surface: the same bases and known points
    tolerance              above 0; 1e-10 if not given
    max_iterations         at least 1; 500 if not given
    method                 one of "full", "normal"; "full" if not given
    curves                 the boundary, in place of points: fitted to u and v where these are given; {"u0", "u1", "v0",
                           "v1": a Curve}
    boundary               a file with four curves (.step, .igs, .dxf, .json), beside this document; they bound the net;
                           or with others that are joined to four; or a file and which of its curves and edges; text |
                           {"file": text, "edges"?: [text | whole number, ..]}
    degree                 with boundary: at least these along u and v
    refine                 how many finer spaces tell of the least area; with boundary: how often its spans are halved
    tolerance_area         at least 1e-11
    least                  false: no witness for the claim `least` is looked for
    gap                    put knots in until the area is proved to be within so much of itself from the least of all;
                           above 1e-12
    regular                true: the certificate claims `regular`, the surface has a tangent plane everywhere; false if
                           not given
    through                points that the surface passes through; not with refine, tolerance_area or gap; [{"u"?, "v"?:
                           number, "point": numbers}, ..]
    known                  (nu, nv) of truth values: which points are given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             basis, corners
    NoSolution             unclamped, no-area, free-edge, overflow
    NotConverged           curve-fit, folds, slides, saddle, iterations, work, no-step, gauss-points, area-gap, gap,
                           not-convex, ill-conditioned

    Source: [WuWang2011] sections 6, 7.1, 7.2; docs/plateau.md
    """
    said: dict[str, Any] = {"points": points, "u": u, "v": v, "unit": unit, "name": name, "weights": weights,
        "start": start, "tolerance": tolerance, "max_iterations": max_iterations, "method": method, "curves": curves,
        "boundary": boundary, "degree": degree, "refine": refine, "tolerance_area": tolerance_area, "least": least,
        "gap": gap, "regular": regular, "through": through}
    return made_of("plateau", said, known, threads=threads, progress=progress, strict=strict)


def trace(*, trace: Literal["asymptotic", "principal", "geodesic", "isoparametric"],
        of: Union[ModelLike, Surface, str, os.PathLike[str]], unit: Literal["mm", "m", "cm", "in", "ft"] | None = None,
        surface: str | None = None, carry: bool | None = None, families: Sequence[Any] | None = None,
        seeds: Sequence[Any] | None = None, max_length: float | None = None, panels: bool | None = None,
        untrim: bool | None = None, laths: Mapping[str, Any] | None = None, sheet: Mapping[str, Any] | None = None,
        tolerance: float | None = None, threads: int | None = None, progress: Progress | None = None, strict: bool = False) -> Model:
    """A net of asymptotic, principal, geodesic or isoparametric curves on a surface.

    trace                  which curves; one of "asymptotic", "principal", "geodesic", "isoparametric"
    of                     the surface: a model, a problem that is made first, or the name of a file that holds one
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    surface                its name, where the model has several
    carry                  curves go on to the model's other surfaces, across edges that join smoothly; false if not
                           given
    families               only these
    seeds                  where the curves begin; { "cells": 8 } if not given; [{"at"?, "direction"?, "to"?: numbers,
                           "surface"?, "lath"?: text, "both"?, "ends"?: True or False, "edge"?: "u0" | "u1" | "v0" |
                           "v1", "line"?: [numbers, ..], "count"?, "cells"?: whole number, "cell"?: number, "by"?:
                           "conformal" | "length" | "parameter", "family"?: "+" | "-" | "max" | "min" | "G" | "u" |
                           "v"}, ..]
    max_length             of a curve each way; 20 sizes if not given; above 0
    panels                 principal nets: judge the quads between nodes; false if not given
    untrim                 STEP, IGES: trimmed faces of the file in of are read as the whole surfaces under them; false
                           if not given
    laths                  laths on the curves: how they are cut, and what bending and twisting does to them; {"strip":
                           "standing" | "plank" | "developable" | "envelope", "width"?, "thickness"?, "play"?: number,
                           "material"?: "steel-s235" | "timber-c24" | {"E", "G", "strength": number}, "cut"?: "mean" |
                           "axis"}
    sheet                  what laths with a width are cut from; {"size"?: numbers, "gap"?: number}
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             net, family, edge, count, direction, outside, width, material
    NoSolution             no-geodesic, elliptic, parabolic, flat, umbilic, along, singular, crease, extreme-size,
                           too-many-laths, width, folds, slots, sheet, developable
    NotConverged           stalled

    Source: [doCarmo1976] chapter 3; [HairerNorsettWanner1993]; docs/trace.md
    """
    said: dict[str, Any] = {"trace": trace, "of": of, "unit": unit, "surface": surface, "carry": carry,
        "families": families, "seeds": seeds, "max_length": max_length, "panels": panels, "untrim": untrim, "laths": laths,
        "sheet": sheet}
    return made_of("trace", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


def pattern(*, pattern: Literal["cloth"], of: Union[ModelLike, Surface, str, os.PathLike[str]], seams: Sequence[Any],
        unit: Literal["mm", "m", "cm", "in", "ft"] | None = None, surface: str | None = None,
        seam_length: Literal["shared", "true"] | None = None, cloth: Mapping[str, Any] | None = None,
        untrim: bool | None = None, compensation: Mapping[str, float] | None = None,
        prestress: Union[npt.ArrayLike, Literal["film"]] | None = None, decompensate: Sequence[Any] | None = None,
        allowance: Mapping[str, Any] | None = None, held: Sequence[Any] | None = None,
        ends: Literal["free", "straight"] | None = None, hems: Sequence[Any] | None = None,
        marks: Mapping[str, Any] | None = None, strain: float | None = None,
        flatten: Literal["elastic", "conformal"] | None = None, tolerance: float | None = None, threads: int | None = None,
        progress: Progress | None = None, strict: bool = False) -> Model:
    """Flat pieces of cloth that are sewn together to a surface.

    pattern                what it is cut of
    of                     the surface: a model, a problem that is made first, or the name of a file that holds one
    seams                  how it is cut in pieces; [{"across"?: ["u0" | "u1" | "v0" | "v1", ..], "radial"?: "u0" | "u1"
                           | "v0" | "v1", "count"?: whole number, "width"?: true | number, "strain"?, "trim"?,
                           "spacing"?: number, "by"?: "length" | "parameter", "parallel"?, "geodesic"?: [numbers |
                           {"edge": "u0" | "u1" | "v0" | "v1", "part"?, "length"?, "parameter"?: number}, ..], "line"?:
                           {"u"?, "v"?: number | numbers}, "curve"?, "butt"?, "surface"?: text, "at"?: number |
                           numbers}, ..]
    unit                   of lengths; nothing is converted; one of "mm", "m", "cm", "in", "ft"; "mm" if not given
    surface                of several, the one to cut; all if not given
    seam_length            the mean of what both sides have alone, or that of the surface; one of "shared", "true";
                           "shared" if not given
    cloth                  the roll that the pieces are cut from; {"width"?, "length"?, "gap"?: number, "material"?:
                           "default" | "etfe" | "ptfe-glass" | "pvc-pes" | {"E": numbers, "nu", "G": number}, "thread"?:
                           "along" | "across" | number, "nap"?: True or False, "side"?: "upper" | "lower"}
    untrim                 STEP, IGES: trimmed faces of the file in of are read as the whole surfaces under them; false
                           if not given
    compensation           the shares by which the cloth is cut smaller than it is mounted; {"warp"?, "weft"?, "seam"?:
                           number}
    prestress              of warp and weft, in kN/m, in place of their compensation: e = D^-1 s, c = e/(1 + e)
    decompensate           edges that do not yield, near which compensation fades out; [{"edge": "u0" | "u1" | "v0" |
                           "v1", "length": number, "component"?: "along" | "both"}, ..]
    allowance              cloth that is left beyond the lines to sew; {"seam"?, "border"?, "overlap"?, "butt"?: number,
                           "split"?: True or False, "corner"?: "mitre" | "square" | "mirror"}
    held                   edges to which nothing is sewn, held at the length of the surface less the compensation
    ends                   straight: start and end of flat pieces are straight, and square to the warp; one of "free",
                           "straight"; "free" if not given
    hems                   borders that are folded over; [{"edge": "u0" | "u1" | "v0" | "v1", "pocket": number}, ..]
    marks                  marks that meet when a seam is sewn; {"spacing"?: number, "notch"?: "slit" | "v" | "dot"}
    strain                 claimed: no principal strain is larger; above 0
    flatten                so that cloth is strained least, or by angles, which are kept: for prints; one of "elastic",
                           "conformal"; "elastic" if not given
    tolerance              largest distance from the exact surface over its size, where one is approximated; 1e-6 if not
                           given
    threads                how many, 1 to 256; 1 if not given; the result is the same
    progress               called as progress(done, what), done in [0, 1] or NaN; what it raises stops the work
    strict                 a claim that does not hold raises CheckFailed, whose `model` is the model

    Gives the Model, with its certificate.

    Raises Error, with a `reason` that docs/errors.md explains; of this construction's own:
    InputError             rule, edge, count, outside, curve, material, held, compensation, allowance
    NoSolution             ends, no-geodesic, crossing, shape, singular, crease, extreme-size, width, length, allowance,
                           strain, overlap
    NotConverged           folds, not-converged

    Source: [LinhardWuechnerBletzinger2008]; [doCarmo1976] chapter 4; docs/pattern.md
    """
    said: dict[str, Any] = {"pattern": pattern, "of": of, "seams": seams, "unit": unit, "surface": surface,
        "seam_length": seam_length, "cloth": cloth, "untrim": untrim, "compensation": compensation, "prestress": prestress,
        "decompensate": decompensate, "allowance": allowance, "held": held, "ends": ends, "hems": hems, "marks": marks,
        "strain": strain, "flatten": flatten}
    return made_of("pattern", said, None, tolerance=tolerance, threads=threads, progress=progress, strict=strict)


__all__ = ["asymptotic", "biharmonic", "bonnet", "dirichlet", "film", "harmonic", "harmonic_extension", "pipe", "plateau", "trace", "pattern"]
