"""Surfaces between selected curves, in Blender 3.4 and later. The package taut comes along in vendor/, unless there is another."""
bl_info = {"name": "Taut", "author": "The Taut authors", "version": (0, 2, 0), "blender": (3, 4, 0), "category": "Add Curve",
           "location": "3D View > Sidebar > Taut", "description": "Surfaces drawn tight across curves, each with a certificate"}

import json
import os
import sys

import bpy
import numpy as np
from mathutils import Vector

try:
    import taut
except ImportError:
    sys.path.append(os.path.join(os.path.dirname(__file__), "vendor"))
    try:
        import taut
    except ImportError as error:
        raise ImportError(f"the add-on Taut finds no package taut ({error}): install taut-blender.zip, which `make plugins` writes and which has "
                          "it in it, or a wheel of taut for the Python of Blender") from None
from taut import hosts

CONSTRUCTS = (("dirichlet", "Dirichlet", "the surface of least Dirichlet energy"), ("plateau", "Least area", "the surface of least area"),
              ("harmonic", "Harmonic", "the harmonic surface through the first curve and its opposite"),
              ("asymptotic", "Asymptotic", "the patch whose edges are asymptotic curves"))
RESULTS = (("mesh", "Mesh", "quads with smooth normals and curvature as a colour"), ("nurbs", "NURBS", "a NURBS surface, where Blender has its knots"))
LARGEST_MESH = 1000000  # quads


# --- Between Blender and Taut -----------------------------------------------------------------------------------------------


def curve_of(obj):
    """The one spline of a curve object, in the world: Bézier, NURBS with `Endpoint U`, or poly."""
    if obj.type != "CURVE" or len(obj.data.splines) != 1:
        raise taut.InputError(f"{obj.name}: expected a curve of one spline", "/boundary", "type")
    spline = obj.data.splines[0]
    if spline.use_cyclic_u:
        raise taut.InputError(f"{obj.name}: the curve is cyclic; switch that off or cut it", "/boundary", "knots")
    weights = None
    if spline.type == "BEZIER":
        points = [point for knot in spline.bezier_points for point in (knot.handle_left, knot.co, knot.handle_right)][1:-1]
        degree, spans = 3, len(spline.bezier_points) - 1
        knots = [0.0] * 4 + [float(i) for i in range(1, spans) for _ in range(3)] + [float(spans)] * 4
    elif spline.type == "NURBS":
        weights = [point.co[3] for point in spline.points]
        points = [Vector(point.co[:3]) for point in spline.points]
        degree, spans = spline.order_u - 1, len(spline.points) - spline.order_u + 1
        if not spline.use_endpoint_u or spline.use_bezier_u or spans < 1:
            raise taut.InputError(f"{obj.name}: switch Endpoint U on and Bézier U off", "/boundary", "knots")
        knots = [0.0] * degree + [float(i) for i in range(spans + 1)] + [float(spans)] * degree
    else:
        points = [Vector(point.co[:3]) for point in spline.points]
        degree, spans = 1, len(points) - 1
        knots = [0.0] + [float(i) for i in range(spans + 1)] + [float(spans)]
    if len(points) < 2:
        raise taut.InputError(f"{obj.name}: the curve has no two points", "/boundary", "size", len(points), 2)
    matrix = np.array(obj.matrix_world, dtype=float)
    places = np.array([list(point) for point in points], dtype=float) @ matrix[:3, :3].T + matrix[:3, 3]
    return hosts.curve(degree, knots, places, weights, obj.name)


def make(curves, settings, scene, draft=False):
    """The model between the curves, in the scene's metres; a draft when the mouse is still moving."""
    scale = scene.unit_settings.scale_length
    edges = [taut.Curve(one.t, one.points * scale, one.weights, one.name) for one in map(curve_of, curves)]
    members = {}
    if settings.construct in ("dirichlet", "plateau"):
        if max(settings.degree) > 0:
            members["degree"] = [max(1, one) for one in settings.degree]
        if settings.refine > 0:
            members["refine"] = [settings.refine] * 2
    if settings.construct == "plateau" and draft:
        members["least"] = False
    return hosts.between(settings.construct, edges, unit="m", **members)


def curvatures(surface, parameters):
    """Mean curvature at pairs (u, v)."""
    _, u, v, uu, uv, vv = surface(parameters[:, 0], parameters[:, 1], derivatives=2)
    normal = np.cross(u, v)
    length = np.linalg.norm(normal, axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        normal = normal / length[:, None]
        e, f, g = ((a * b).sum(-1) for a, b in ((u, u), (u, v), (v, v)))
        h = (e * (vv * normal).sum(-1) - 2 * f * (uv * normal).sum(-1) + g * (uu * normal).sum(-1)) / (2 * length ** 2)
    return np.nan_to_num(h)


def mesh_of(model, divide):
    """The quads to draw; too many are refused before they are made."""
    count = divide ** 2 * int(np.prod([len(one.breaks) - 1 for one in (model.surfaces[0].u, model.surfaces[0].v)]))
    if count > LARGEST_MESH:
        raise taut.InputError(f"the mesh would have {count} quads, expected at most {LARGEST_MESH}: lower Cells or Refine", "", "size", count, LARGEST_MESH)
    return model.mesh(divide=divide)


def fill_mesh(data, model, scale, mesh):
    """Quads, normals of the surface, the mean curvature as a number and as a colour: red above 0, blue
    below, full at twice the root of the mean square."""
    data.clear_geometry()
    data.from_pydata((mesh.vertices / scale).tolist(), [], mesh.quads.tolist())
    data.polygons.foreach_set("use_smooth", np.ones(len(data.polygons), dtype=bool))
    data.update()
    if hasattr(data, "use_auto_smooth"):  # until 4.0
        data.use_auto_smooth = True
    data.normals_split_custom_set_from_vertices(mesh.normals.tolist())
    mean = curvatures(model.surfaces[0], mesh.parameters) * scale
    data.attributes.new("mean_curvature", "FLOAT", "POINT").data.foreach_set("value", mean)
    part = np.clip(mean / max(2 * float(np.sqrt((mean ** 2).mean())), 1e-300), -1, 1)
    colour = np.stack([1 + np.minimum(part, 0), 1 - np.abs(part), 1 - np.maximum(part, 0), np.ones_like(part)], axis=-1)
    data.color_attributes.new("curvature", "FLOAT_COLOR", "POINT").data.foreach_set("color", colour.ravel())


def has_knots(shape, direction):
    """Whether Blender has these knots: clamped and uniform, degree at most 5, at least 1."""
    knots, counts, degree = shape.knots[direction], shape.multiplicities[direction], shape.degrees[direction]
    steps = np.diff(knots)
    return degree <= 5 and all(one == 1 for one in counts[1:-1]) and bool(np.all(np.abs(steps - steps[0]) <= 1e-12 * steps[0]))


def nurbs_object(context, shape, scale, name):
    """A NURBS surface object. Blender makes a net of rows by joining them: rows are added one by one, then made segments."""
    data = bpy.data.curves.new(name, "SURFACE")
    data.dimensions = "3D"
    nu, nv = shape.points.shape[:2]
    weights = np.ones((nu, nv)) if shape.weights is None else shape.weights
    homogeneous = np.concatenate([shape.points / scale, weights[..., None]], axis=-1)
    for j in range(nv):
        row = data.splines.new("NURBS")
        row.points.add(nu - 1)
        row.points.foreach_set("co", homogeneous[:, j].ravel())
        row.use_endpoint_u, row.order_u = True, shape.degrees[0] + 1
    obj = bpy.data.objects.new(name, data)
    context.collection.objects.link(obj)
    active = context.view_layer.objects.active
    for one in context.selected_objects:
        one.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.curve.select_all(action="SELECT")
    bpy.ops.curve.make_segment()
    bpy.ops.object.mode_set(mode="OBJECT")
    net = data.splines[0]
    net.use_endpoint_u = net.use_endpoint_v = True
    first = np.array([point.co[:] for point in net.points])
    along = net.point_count_u == nu and np.allclose(first[1, :3], homogeneous[1, 0, :3], atol=1e-5)
    net.order_u, net.order_v = [one + 1 for one in (shape.degrees if along else shape.degrees[::-1])]
    context.view_layer.objects.active = active or obj
    return obj


def put(obj, model, curves, settings):
    """What the object keeps: its problem's parameters, its curves, the model as JSON, the certificate as lines."""
    for name, value in vars(settings).items():
        setattr(obj.taut, name, value)
    for name, value in (*((f"curve_{i}", one) for i, one in enumerate(curves)), ("model", model.to_json()),
                        ("certificate", "\n".join(hosts.claims(model.certificate)))):
        obj["taut_" + name] = value


def in_place_of(context, old, new):
    """What a user gave the old object: name, place, collections, materials, that it is the active one."""
    active = context.view_layer.objects.active == old
    name, place, collections, materials = old.name, old.matrix_world.copy(), list(old.users_collection), [slot.material for slot in old.material_slots]
    bpy.data.objects.remove(old, do_unlink=True)
    for one in collections:
        if new.name not in one.objects:
            one.objects.link(new)
    for one in [one for one in new.users_collection if one not in collections]:
        one.objects.unlink(new)
    for one in materials:
        new.data.materials.append(one)
    new.name, new.matrix_world = name, place
    new.select_set(active)
    if active:
        context.view_layer.objects.active = new


class Kept:
    """Settings that outlive the object that has them."""

    def __init__(self, settings):
        self.construct, self.result, self.degree = settings.construct, settings.result, list(settings.degree)
        self.refine, self.divide = settings.refine, settings.divide


def build(context, curves, settings, obj=None, draft=False):
    """Makes the surface into `obj`, or into a new object."""
    settings, old = Kept(settings), obj
    scale = context.scene.unit_settings.scale_length
    model = make(curves, settings, context.scene, draft)
    if settings.result == "nurbs":
        shape = hosts.spline(model.surfaces[0])
        if not all(has_knots(shape, direction) for direction in (0, 1)):
            raise taut.InputError("Blender's NURBS surfaces have uniform knots and degree 5 at most, this one has not: take Mesh", "", "knots")
        obj = nurbs_object(context, shape, scale, "Taut")
    else:
        mesh = mesh_of(model, settings.divide)
        if obj is None or obj.type != "MESH":
            obj = bpy.data.objects.new("Taut", bpy.data.meshes.new("Taut"))
            context.collection.objects.link(obj)
        fill_mesh(obj.data, model, scale, mesh)
    if old is not None and old != obj:
        in_place_of(context, old, obj)
    put(obj, model, curves, settings)
    return obj


def curves_of(obj):
    """The curves that a surface was made from, whatever they are called by now, without those that were deleted (Blender keeps
    what a property still names, in no scene); [] of any other object."""
    found = [obj.get(f"taut_curve_{i}") for i in range(4)] if obj is not None else []
    return [one for one in found if one is not None and one.users_scene]


def shown(context):
    """The parameters that the panel shows: those of the active surface, else those of the next one."""
    return context.object.taut if context.object is not None and "taut_model" in context.object else context.scene.taut


# --- Operators and panel -------------------------------------------------------------------------------------------------------


class Settings(bpy.types.PropertyGroup):
    construct: bpy.props.EnumProperty(name="Construction", items=CONSTRUCTS)
    result: bpy.props.EnumProperty(name="Result", items=RESULTS)
    degree: bpy.props.IntVectorProperty(name="Degree", size=2, min=0, max=25, description="At least these along u and v; 0: those of the curves")
    refine: bpy.props.IntProperty(name="Refine", min=0, max=6, description="How often spans are halved")
    divide: bpy.props.IntProperty(name="Cells", min=1, max=64, default=12, description="Quads along each span of the mesh")


class Told:
    """Errors into Blender's report, with what to change."""

    bl_options = {"REGISTER", "UNDO"}

    def tried(self, call, *arguments, **named):
        try:
            made = call(*arguments, **named)
            if isinstance(made, bpy.types.Object) and "does not hold" in made["taut_certificate"].split("\n", 1)[0]:
                self.report({"WARNING"}, "The certificate does not hold: the panel says which claim")
            return made
        except (taut.Error, MemoryError) as error:
            self.report({"ERROR"}, hosts.told(error))
            return None


class TAUT_OT_between(Told, bpy.types.Operator):
    """A surface between the four selected curves"""

    bl_idname, bl_label = "taut.between", "Surface between Curves"

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Select four curves, in Object Mode")
        return context.mode == "OBJECT" and sum(one.type == "CURVE" for one in context.selected_objects) == 4

    def execute(self, context):
        curves = sorted((one for one in context.selected_objects if one.type == "CURVE"), key=lambda one: one.name)
        obj = self.tried(build, context, curves, shown(context))
        if obj is None:
            return {"CANCELLED"}
        for one in curves:
            one.select_set(False)
        obj.select_set(True)
        context.view_layer.objects.active = obj
        return {"FINISHED"}


class TAUT_OT_again(Told, bpy.types.Operator):
    """Makes the active surface again: its curves were moved, or the parameters changed"""

    bl_idname, bl_label = "taut.again", "Make Again"

    @classmethod
    def poll(cls, context):
        if context.object is not None and "taut_model" in context.object and len(curves_of(context.object)) < 4:
            cls.poll_message_set("A curve that the surface was made from was deleted: select four, and make it anew")
        return context.mode == "OBJECT" and len(curves_of(context.object)) == 4

    def execute(self, context):
        obj = self.tried(build, context, curves_of(context.object), shown(context), context.object)
        if obj is None:
            return {"CANCELLED"}
        context.view_layer.objects.active = obj
        return {"FINISHED"}


class TAUT_OT_drag(Told, bpy.types.Operator):
    """Drags a corner where two curves meet, and the surface follows. Click to keep, Escape to put back"""

    bl_idname, bl_label = "taut.drag", "Drag Corner"
    bl_options = {"REGISTER", "UNDO", "BLOCKING"}
    corner: bpy.props.IntProperty(name="Corner", min=0, max=3)
    offset: bpy.props.FloatVectorProperty(name="Offset", subtype="TRANSLATION", description="In the world")

    poll = TAUT_OT_again.poll

    def begin(self, context):
        """The ends of the curves at the corner, and where every point of these splines is."""
        self.obj, self.curves = context.object, curves_of(context.object)
        for curve in self.curves:
            curve_of(curve)
            if curve.matrix_world.to_3x3().determinant() == 0:
                raise taut.InputError(f"{curve.name}: its scale is 0, so that nothing can be dragged: apply the scale", "/boundary", "value")
        net = taut.Model.from_json(self.obj["taut_model"]).surfaces[0].points / context.scene.unit_settings.scale_length
        self.place = Vector(net[(0, -1, -1, 0)[self.corner], (0, 0, -1, -1)[self.corner]])
        self.saved = []
        for curve in self.curves:
            spline = curve.data.splines[0]
            points = spline.bezier_points if spline.type == "BEZIER" else spline.points
            for i in (0, len(points) - 1):
                point = points[i]
                here = curve.matrix_world @ Vector(point.co[:3])
                if (here - self.place).length <= 1e-4 * max(1.0, self.place.length):
                    handles = (point.handle_left.copy(), point.handle_right.copy(), point.handle_left_type, point.handle_right_type) if spline.type == "BEZIER" else None
                    self.saved.append((curve, point, point.co.copy(), handles))
        return True

    def move(self, context, offset, draft):
        for curve, point, place, handles in self.saved:
            step = curve.matrix_world.to_3x3().inverted() @ Vector(offset)
            if handles is not None:
                point.handle_left_type = point.handle_right_type = "FREE"
                point.co = place + step
                point.handle_left, point.handle_right = handles[0] + step, handles[1] + step
            else:
                point.co = (*(Vector(place[:3]) + step), place[3])
            curve.data.update_tag()
        context.view_layer.update()
        return self.tried(build, context, self.curves, self.obj.taut, self.obj, draft=draft)

    def execute(self, context):
        if not self.tried(self.begin, context):
            return {"CANCELLED"}
        obj = self.move(context, self.offset, False)
        if obj is None:
            return self.back(context)
        context.view_layer.objects.active = obj
        return {"FINISHED"}

    def invoke(self, context, event):
        if not self.tried(self.begin, context):
            return {"CANCELLED"}
        self.start = (event.mouse_region_x, event.mouse_region_y)
        context.window_manager.modal_handler_add(self)
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        from bpy_extras import view3d_utils
        if event.type == "MOUSEMOVE" and context.region_data is not None:
            here, there = (view3d_utils.region_2d_to_location_3d(context.region, context.region_data, place, self.place)
                           for place in (self.start, (event.mouse_region_x, event.mouse_region_y)))
            self.offset = there - here
            self.obj = self.move(context, self.offset, True) or self.obj
            context.area.tag_redraw()
        elif event.type in ("LEFTMOUSE", "RET"):
            return {"FINISHED"} if self.move(context, self.offset, False) is not None else self.back(context)
        elif event.type in ("RIGHTMOUSE", "ESC"):
            return self.back(context)
        return {"RUNNING_MODAL"}

    def back(self, context):
        self.move(context, (0, 0, 0), False)
        for _, point, _, handles in self.saved:
            if handles is not None:
                point.handle_left_type, point.handle_right_type = handles[2:]
        return {"CANCELLED"}


class TAUT_PT_panel(bpy.types.Panel):
    bl_idname, bl_label, bl_space_type, bl_region_type, bl_category = "TAUT_PT_panel", "Taut", "VIEW_3D", "UI", "Taut"

    def draw(self, context):
        settings, layout = shown(context), self.layout
        for name in ("construct", "result", "degree", "refine", "divide"):
            layout.prop(settings, name)
        for operator in ("taut.between", "taut.again"):
            layout.operator(operator)
        layout.label(text="Drag Corner")
        row = layout.row(align=True)
        for i in range(4):
            row.operator("taut.drag", text=str(i)).corner = i
        obj = context.object
        if obj is not None and "taut_certificate" in obj:
            box = layout.box()
            for line in obj["taut_certificate"].split("\n"):
                box.label(text=line)


CLASSES = (Settings, TAUT_OT_between, TAUT_OT_again, TAUT_OT_drag, TAUT_PT_panel)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.taut = bpy.props.PointerProperty(type=Settings)
    bpy.types.Object.taut = bpy.props.PointerProperty(type=Settings)


def unregister():
    del bpy.types.Scene.taut, bpy.types.Object.taut
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
