"""The C library: where it is found, what its functions take, what its structs look like.

Found in this order: $TAUT_LIBRARY (a path), the copy that the wheel carries, the system's. Structs that are laid out
otherwise than here mean another version: it is refused at import, not crashed into.
"""
from __future__ import annotations

import ctypes
import os
import pathlib
import sys
from ctypes import POINTER, Structure, Union, c_char, c_char_p, c_double, c_int, c_size_t, c_void_p
from typing import Any

VERSION = "0.2.0"
PROGRESS = ctypes.CFUNCTYPE(c_int, c_void_p, c_double, c_char_p)

OK, NOT_CONVERGED, CHECK_FAILED, BAD_ARGUMENT, BAD_INPUT, NO_SOLUTION, IO, NO_MEMORY, INTERNAL, INTERRUPTED = range(10)


class ErrorStruct(Structure):
    _fields_ = [("status", c_int), ("reason", c_char * 32), ("found", c_double), ("limit", c_double),
                ("expected", c_char * 192), ("where", c_char * 192), ("message", c_char * 768)]


class MonitorStruct(Structure):
    _fields_ = [("progress", PROGRESS), ("context", c_void_p)]


class MakeOptions(Structure):
    _fields_ = [("tolerance", c_double), ("threads", c_int), ("monitor", MonitorStruct), ("exact", c_int),
                ("time_limit", c_double)]


class CertifyOptions(Structure):
    _fields_ = [("threads", c_int), ("tolerance", c_double), ("exact", c_int), ("monitor", MonitorStruct)]


class MeasureOptions(Structure):
    _fields_ = [("grid", c_int), ("threads", c_int), ("monitor", MonitorStruct)]


class ReadOptions(Structure):
    _fields_ = [("untrim", c_int), ("edges", c_int), ("monitor", MonitorStruct)]


class JoinOptions(Structure):
    _fields_ = [("monitor", MonitorStruct)]


class WriteOptions(Structure):
    _fields_ = [("tolerance", c_double), ("divide", c_int), ("threads", c_int), ("format", c_char_p), ("formats", c_void_p),
                ("surface", c_char_p), ("short_knots", c_int), ("colour", c_int), ("no_net", c_int), ("has_view", c_int), ("view", c_double * 2),
                ("title", c_char_p), ("isolines", c_int), ("reflections", c_int), ("combs", c_int), ("side_by_side", c_int),
                ("width", c_int), ("labels", POINTER(c_char_p)), ("monitor", MonitorStruct), ("bound", POINTER(c_double)),
                ("thickness", c_double), ("coefficients", c_int), ("reactions", c_int), ("column", c_int),
                ("tiles", c_int), ("reduction", c_double), ("lagrange", c_int)]


class MeshOptions(Structure):
    _fields_ = [("tolerance", c_double), ("divide", c_int), ("threads", c_int), ("surface", c_char_p), ("monitor", MonitorStruct),
                ("thickness", c_double)]


class TraceStep(Structure):
    _fields_ = [("s", c_double), ("at", c_double * 2), ("point", c_double * 3), ("tangent", c_double * 3), ("normal", c_double * 3),
                ("k_n", c_double), ("k_g", c_double), ("tau_g", c_double)]


class TraceEnd(Structure):
    _fields_ = [("word", c_char_p), ("at", c_double * 2), ("length", c_double), ("steps", c_int)]


TRACE_SINK = ctypes.CFUNCTYPE(c_int, c_void_p, POINTER(TraceStep))


class BasisSpec(Structure):
    _fields_ = [("type", c_char_p), ("degree", c_int), ("count", c_int), ("knot_count", c_int), ("knots", c_void_p),
                ("alpha", c_double), ("beta", c_double), ("gamma", c_double), ("segments", c_int), ("has_range", c_int),
                ("range", c_double * 2)]


class ClaimStruct(Structure):
    _fields_ = [("claim", c_char_p), ("kind", c_int), ("residual", c_double), ("limit", c_double), ("holds", c_int),
                ("where", c_char_p), ("as_saved", c_int)]


class DirichletProblem(Structure):
    _fields_ = [("name", c_char_p), ("u", c_void_p), ("v", c_void_p), ("points", c_void_p), ("known", c_void_p),
                ("weights", c_void_p), ("aspect", c_double), ("aspect_auto", c_int), ("regular", c_int),
                ("through", c_void_p), ("through_count", c_int)]


class PlateauProblem(Structure):
    _fields_ = [("net", DirichletProblem), ("curves", c_void_p * 4), ("start", c_void_p), ("tolerance", c_double), ("max_iterations", c_int),
                ("method", c_int), ("refine", c_int), ("tolerance_area", c_double), ("without_least", c_int), ("gap", c_double)]


class HarmonicRows(Structure):
    _fields_ = [("points", c_void_p), ("known", c_void_p), ("exact", c_void_p), ("even", c_int), ("allow_ill_conditioned", c_int)]


class HarmonicDerivative(Structure):
    _fields_ = [("edge", c_void_p), ("cross", c_void_p), ("exact_edge", c_void_p), ("exact_cross", c_void_p), ("raise", c_int),
                ("allow_ill_conditioned", c_int)]


class HarmonicBoundary(Structure):
    _fields_ = [("points", c_void_p), ("known", c_void_p)]


class HarmonicGiven(Union):
    _fields_ = [("rows", HarmonicRows), ("derivative", HarmonicDerivative), ("boundary", HarmonicBoundary)]


class HarmonicProblem(Structure):
    _anonymous_ = ("part",)
    _fields_ = [("name", c_char_p), ("u", c_void_p), ("v", c_void_p), ("given", c_int), ("part", HarmonicGiven)]


class BiharmonicRows(Structure):
    _fields_ = [("name", c_char_p), ("u", c_void_p), ("v", c_void_p), ("points", c_void_p), ("known", c_void_p)]


class BiharmonicNeighbour(Structure):
    _fields_ = [("surface", c_void_p), ("edge", c_int), ("width", c_double), ("contact", c_int), ("allow_ill_conditioned", c_int)]


class BiharmonicGiven(Union):
    _fields_ = [("rows", BiharmonicRows), ("neighbour", BiharmonicNeighbour)]


class BiharmonicProblem(Structure):
    _anonymous_ = ("part",)
    _fields_ = [("given", c_int), ("part", BiharmonicGiven)]


class ExtensionC1(Structure):
    _fields_ = [("width", c_double)]


class ExtensionG1(Structure):
    _fields_ = [("width", c_double), ("c", c_double), ("alpha", c_double), ("beta", c_double)]


class ExtensionMerge(Structure):
    _fields_ = [("neighbour", c_void_p)]


class ExtensionGiven(Union):
    _fields_ = [("c1", ExtensionC1), ("g1", ExtensionG1), ("merge", ExtensionMerge)]


class ExtensionProblem(Structure):
    _anonymous_ = ("part",)
    _fields_ = [("surface", c_void_p), ("edge", c_int), ("given", c_int), ("part", ExtensionGiven)]


class BonnetProblem(Structure):
    _fields_ = [("lambda", c_double * 2), ("frames", c_int), ("sign", c_int), ("alpha", c_double), ("beta", c_double), ("bspline", c_int),
                ("segments", c_int * 2), ("theta", c_double), ("normalize", c_int), ("start", c_double * 2)]


class PipeEnd(Structure):
    _fields_ = [("point", c_double * 3), ("direction", c_double * 3), ("handle", c_double)]


class PipeAxisGiven(Union):
    _fields_ = [("polygon", c_double * 3 * 4), ("ends", PipeEnd * 2)]


class PipeAxis(Structure):
    _anonymous_ = ("part",)
    _fields_ = [("kind", c_int), ("part", PipeAxisGiven)]


class PipeEllipse(Structure):
    _fields_ = [("a", c_double), ("b", c_double), ("direction", c_double * 3)]


class PipeSectionGiven(Union):
    _fields_ = [("radius", c_double), ("ellipses", PipeEllipse * 2), ("radii", c_double * 2)]


class PipeSection(Structure):
    _anonymous_ = ("part",)
    _fields_ = [("kind", c_int), ("part", PipeSectionGiven)]


class PipeShape(Structure):
    _fields_ = [("kind", c_int), ("alpha", c_double), ("beta", c_double), ("gamma", c_double), ("extended", c_int)]


class PipeProblem(Structure):
    _fields_ = [("axis", PipeAxis), ("section", PipeSection), ("shape", PipeShape), ("joint", c_int), ("frame", c_int), ("lengths", c_double * 2),
                ("bend_radius", c_double), ("caps", c_int)]


class GradientRequest(Structure):
    _fields_ = [("of", c_int), ("factors", c_void_p), ("monitor", MonitorStruct)]


class FilmGradientRequest(Structure):
    _fields_ = [("of", c_int), ("edge", c_int), ("corner", c_int), ("axis", c_int), ("monitor", MonitorStruct)]


class FilmSlopes(Structure):
    _fields_ = [("corners", c_double * 12), ("laws", c_double * 4), ("stiffness", c_double * 4), ("points", c_void_p)]


# Function: what it gives and what it takes: p a pointer of any kind, s a text, i an int, d a double, z a size, - nothing.
SIGNATURES = {
    "taut_abi": "p:", "taut_version": "s:", "taut_kernel_in_use": "s:", "taut_status_text": "s:i",
    "taut_basis_new": "i:pipp", "taut_basis_copy": "i:pp", "taut_basis_free": "-:p", "taut_basis_spec_of": "-:pp",
    "taut_basis_count": "i:p", "taut_basis_local": "i:p", "taut_basis_span_count": "i:p", "taut_basis_breaks": "p:p",
    "taut_basis_degree": "i:p", "taut_basis_span": "i:pd", "taut_basis_first": "i:pi", "taut_basis_eval": "i:pidip",
    "taut_surface_new": "i:spppppp", "taut_surface_free": "-:p", "taut_surface_name": "s:p", "taut_surface_u": "p:p",
    "taut_surface_v": "p:p", "taut_surface_points": "p:p", "taut_surface_weights": "p:p", "taut_surface_copy": "i:pp",
    "taut_surface_eval": "i:pddip", "taut_surface_eval_points": "i:pippiip",
    "taut_surface_eval_grid": "i:pipipiip",
    "taut_curve_new": "i:sppppp", "taut_curve_free": "-:p", "taut_curve_name": "s:p", "taut_curve_t": "p:p",
    "taut_curve_points": "p:p", "taut_curve_weights": "p:p", "taut_curve_copy": "i:pp", "taut_curve_eval": "i:pdip", "taut_curve_eval_points": "i:pipiip",
    "taut_model_new": "i:p", "taut_model_copy": "i:pp", "taut_model_free": "-:p", "taut_model_add_surface": "i:pp",
    "taut_model_add_curve": "i:pp", "taut_model_set_unit": "i:ps", "taut_model_set_certificate": "-:pp",
    "taut_model_surface_count": "i:p", "taut_model_surface": "p:pi", "taut_model_curve_count": "i:p",
    "taut_model_curve": "p:pi", "taut_model_details": "p:p", "taut_model_certificate": "p:p", "taut_model_unit": "s:p",
    "taut_problem_read": "i:spp", "taut_problem_read_text": "i:szspp", "taut_problem_free": "-:p",
    "taut_problem_or_model_read": "i:sppp", "taut_model_read_with": "i:sppp", "taut_model_read_text": "i:szspp",
    "taut_problem_list_read": "i:spp", "taut_problem_list_read_text": "i:szspp", "taut_problem_list_free": "-:p",
    "taut_problem_list_count": "i:p", "taut_problem_list_at": "p:pi", "taut_problem_list_is_list": "i:p",
    "taut_construct_count": "i:", "taut_construct_name": "s:i", "taut_make": "i:pppp", "taut_certify": "i:ppppp",
    "taut_certificate_free": "-:p", "taut_certificate_construct": "s:p", "taut_certificate_holds": "i:p",
    "taut_certificate_claim_count": "i:p", "taut_certificate_claim": "p:pi", "taut_certificate_figures": "p:p",
    "taut_claim_kind_name": "s:i", "taut_record_new": "p:", "taut_record_free": "-:p", "taut_record_status": "i:p",
    "taut_record_write": "i:ppp", "taut_text_free": "-:p", "taut_model_write": "i:pspp", "taut_model_write_text": "i:pspppp",
    "taut_measure_surface": "i:pppp", "taut_measure_curve": "i:pppp", "taut_measure_surface_record": "-:ppp",
    "taut_measure_curve_record": "-:ppp", "taut_join_measure_with": "i:pipippp", "taut_join_record": "-:pp",
    "taut_model_split": "i:psidpp", "taut_model_refine": "i:psiipp", "taut_model_pieces": "i:pspp",
    "taut_model_to_nurbs": "i:pdppp", "taut_model_to_unit": "i:pspp", "taut_surface_transform": "i:pppp", "taut_curve_transform": "i:pppp",
    "taut_surface_reverse": "i:pipp", "taut_surface_transpose": "i:ppp", "taut_curve_reverse": "i:ppp",
    "taut_surface_elevate": "i:piipp", "taut_curve_elevate": "i:pipp", "taut_surface_insert": "i:pidipp",
    "taut_curve_insert": "i:pdipp", "taut_surface_to_nurbs": "i:pdppp", "taut_curve_to_nurbs": "i:pdppp",
    "taut_mesh_new": "i:pppp", "taut_mesh_free": "-:p", "taut_mesh_vertex_count": "z:p", "taut_mesh_positions": "p:p",
    "taut_mesh_normals": "p:p", "taut_mesh_parameters": "p:p", "taut_mesh_quad_count": "z:p", "taut_mesh_quads": "p:p",
    "taut_mesh_triangles": "p:p", "taut_mesh_welded": "p:p", "taut_mesh_group_count": "i:p", "taut_mesh_group_at": "p:pi",
    **{f"taut_{construct}_{verb}": signature for construct in ("biharmonic", "bonnet", "dirichlet", "harmonic", "harmonic_extension", "pipe", "plateau")
       for verb, signature in (("make", "i:pppp"), ("certify", "i:ppppp"))},
    "taut_trace_follow": "i:piippdpppp", "taut_gradient": "i:ppppp", "taut_gradient_of_film": "i:ppppp",
}
_TYPES = {"p": c_void_p, "s": c_char_p, "i": c_int, "d": c_double, "z": c_size_t, "-": None}


class AbiMember(Structure):
    _fields_ = [("name", c_char_p), ("type", c_char_p), ("offset", c_size_t), ("size", c_size_t)]


class AbiStruct(Structure):
    _fields_ = [("name", c_char_p), ("size", c_size_t), ("count", c_size_t), ("members", POINTER(AbiMember))]


class AbiTable(Structure):
    _fields_ = [("number", c_int), ("pointer_size", c_int), ("size_size", c_size_t), ("struct_count", c_size_t),
                ("structs", POINTER(AbiStruct))]


LAYOUTS: dict[str, type[Structure]] = {
    "taut_error": ErrorStruct, "taut_monitor": MonitorStruct, "taut_make_options": MakeOptions, "taut_certify_options": CertifyOptions,
    "taut_measure_options": MeasureOptions, "taut_read_options": ReadOptions, "taut_join_options": JoinOptions,
    "taut_write_options": WriteOptions, "taut_mesh_options": MeshOptions,
    "taut_basis_spec": BasisSpec, "taut_claim": ClaimStruct, "taut_dirichlet_problem": DirichletProblem, "taut_gradient_request": GradientRequest,
    "taut_trace_step": TraceStep, "taut_trace_end": TraceEnd, "taut_film_gradient_request": FilmGradientRequest, "taut_film_slopes": FilmSlopes,
    "taut_plateau_problem": PlateauProblem, "taut_harmonic_problem": HarmonicProblem, "taut_harmonic_rows": HarmonicRows,
    "taut_harmonic_derivative": HarmonicDerivative, "taut_harmonic_boundary": HarmonicBoundary, "taut_biharmonic_problem": BiharmonicProblem,
    "taut_biharmonic_rows": BiharmonicRows, "taut_biharmonic_neighbour": BiharmonicNeighbour, "taut_extension_c1": ExtensionC1,
    "taut_extension_g1": ExtensionG1, "taut_extension_merge": ExtensionMerge, "taut_harmonic_extension_problem": ExtensionProblem,
    "taut_bonnet_problem": BonnetProblem, "taut_pipe_problem": PipeProblem, "taut_pipe_axis": PipeAxis, "taut_pipe_end": PipeEnd,
    "taut_pipe_section": PipeSection, "taut_pipe_ellipse": PipeEllipse, "taut_pipe_shape": PipeShape,
}
sizes: dict[str, int] = {}  # of all public structs, in bytes


class LibraryError(ImportError):
    """There is no libtaut, or one that this package does not know."""


def _places() -> list[str]:
    """Where the library may be, the likeliest first."""
    if "TAUT_LIBRARY" in os.environ:
        return [os.environ["TAUT_LIBRARY"]]
    name = "libtaut-0.dll" if sys.platform == "win32" else "libtaut.0.dylib" if sys.platform == "darwin" else "libtaut.so.0"
    carried = pathlib.Path(__file__).parent / "lib" / name
    return [str(carried), name] if carried.exists() else [name]


def _load() -> ctypes.CDLL:
    problems = []
    for place in _places():
        try:
            return ctypes.CDLL(place)
        except OSError as error:
            problems.append(str(error))
    raise LibraryError("taut: the library was not found: " + "; ".join(problems) +
                       " (set TAUT_LIBRARY to the path of libtaut)")


def _declare(library: ctypes.CDLL) -> None:
    for name, signature in SIGNATURES.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise LibraryError(f"taut: {library._name} has no {name}: it is of another version than this package") from None
        gives, takes = signature.split(":")
        function.restype = _TYPES[gives]
        function.argtypes = [_TYPES[kind] for kind in takes]


def _members(layout: Any) -> list[str]:
    """The names that C sees: those of a union without a name are the struct's."""
    names = []
    for name, kind, *_ in layout._fields_:
        names += _members(kind) if name in getattr(layout, "_anonymous_", ()) else [name]
    return names


def _check(library: ctypes.CDLL) -> None:
    version = library.taut_version().decode()
    if version.split(".")[:2] != VERSION.split(".")[:2]:
        raise LibraryError(f"taut: {library._name} is version {version}; this package is for {VERSION}")
    table = ctypes.cast(library.taut_abi(), POINTER(AbiTable)).contents
    for i in range(table.struct_count):
        struct = table.structs[i]
        name = struct.name.decode()
        sizes[name] = struct.size
        layout = LAYOUTS.get(name)
        if layout is None:
            continue
        theirs = [(member.name.decode(), member.offset, member.size) for member in struct.members[:struct.count]]
        ours = [(member, getattr(layout, member).offset, getattr(layout, member).size) for member in _members(layout)]
        if theirs != ours or struct.size != ctypes.sizeof(layout):
            raise LibraryError(f"taut: {library._name} lays out {name} otherwise than this package: they are not of one version")
    if not set(LAYOUTS) <= set(sizes):
        raise LibraryError(f"taut: {library._name} does not know {sorted(set(LAYOUTS) - set(sizes))[0]}")


def _draw_formats() -> int | None:
    """The formats of libtaut-draw (svg, png, pdf, html), which stands beside the library; None where it does not."""
    place = pathlib.Path(library._name)
    name = place.name.replace("libtaut", "libtaut-draw")
    try:
        drawing = ctypes.CDLL(str(place.with_name(name)) if place.parent != pathlib.Path(".") else name)
    except OSError:
        return None
    drawing.taut_draw_formats.restype = c_void_p
    formats: int | None = drawing.taut_draw_formats()
    return formats


library: Any = _load()
_declare(library)
_check(library)
DRAW_FORMATS = _draw_formats()
