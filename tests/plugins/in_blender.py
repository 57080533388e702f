"""Runs in blender -b: operators on curves, moves, undo, nonsense; prints what came of it."""
import json
import os
import sys
import traceback
import types

import bpy
import numpy as np

import taut_surfaces

given = json.loads(os.environ["TAUT_TEST"])


def add_curve(name, points):
    data = bpy.data.curves.new(name, "CURVE")
    data.dimensions = "3D"
    spline = data.splines.new("BEZIER")
    spline.bezier_points.add(1)
    a, b = spline.bezier_points
    for knot in (a, b):
        knot.handle_left_type = knot.handle_right_type = "FREE"
    a.co, a.handle_right, b.handle_left, b.co = points
    a.handle_left, b.handle_right = points[0], points[3]
    obj = bpy.data.objects.new(name, data)
    bpy.context.collection.objects.link(obj)
    return obj


def select(*objects):
    for one in bpy.context.view_layer.objects:
        one.select_set(one in objects)
    bpy.context.view_layer.objects.active = objects[0]


def told(call, **arguments):
    """What an operator refuses with."""
    try:
        return str(call(**arguments))
    except RuntimeError as error:
        return str(error)


def edges(curves):
    return [taut_surfaces.curve_of(one).points.tolist() for one in curves]


def state(obj, curves):
    data, result = obj.data, {"model": obj["taut_model"], "certificate": obj["taut_certificate"], "edges": edges(curves), "type": obj.type}
    if obj.type == "MESH":
        result["vertices"] = [list(one.co) for one in data.vertices]
        result["faces"] = len(data.polygons)
        result["smooth"] = all(one.use_smooth for one in data.polygons)
        data.calc_normals_split()
        normals = np.zeros((len(data.vertices), 3))
        for loop in data.loops:
            normals[loop.vertex_index] = loop.normal
        result["normals"] = normals.tolist()
        result["curvature"] = [one.value for one in data.attributes["mean_curvature"].data]
        result["colours"] = [list(one.color) for one in data.color_attributes["curvature"].data]
    return result


def run():
    taut_surfaces.register()
    for one in list(bpy.data.objects):
        bpy.data.objects.remove(one)
    scene, result = bpy.context.scene, {}
    curves = [add_curve(f"edge{i}", points) for i, points in enumerate(given["edges"])]
    bpy.context.view_layer.update()
    bpy.ops.ed.undo_push(message="curves")
    for construct in ("dirichlet", "plateau", "harmonic"):
        scene.taut.construct = construct
        select(*curves)
        assert bpy.ops.taut.between() == {"FINISHED"}
        result[construct] = state(bpy.context.object, curves)
    # all move, and the surface is made again
    bpy.context.object.taut.construct = scene.taut.construct = "dirichlet"
    for one in curves:
        one.location = given["shift"]
    bpy.context.view_layer.update()
    surface = bpy.context.object
    curves[1].name = "renamed"  # it stays the surface's
    select(surface)
    assert bpy.ops.taut.again() == {"FINISHED"}
    curves[1].name = "edge1"
    result["moved"] = state(bpy.context.object, curves)
    assert bpy.ops.taut.drag(corner=0, offset=(0.25, 0, 0.5)) == {"FINISHED"}
    result["dragged"] = state(bpy.context.object, curves)
    curves[0].location = (0, 0, 9)
    bpy.context.view_layer.update()
    result["broken"] = told(bpy.ops.taut.again)
    result["kept"] = bpy.context.object["taut_model"] == result["dragged"]["model"]
    curves[0].location = given["shift"]
    bpy.context.view_layer.update()
    # parameters are the surface's own, whatever the next one's are; its name, place and materials stay
    scene.taut.construct = "harmonic"
    bpy.context.object.taut.result = "nurbs"
    bpy.context.object.name, bpy.context.object.location = "Sail", (0, 0, 2)
    bpy.context.object.data.materials.append(bpy.data.materials.new("Cloth"))
    assert bpy.ops.taut.again() == {"FINISHED"}
    obj = bpy.context.object
    result["stays"] = [obj.name, list(obj.location), [one.name for one in obj.data.materials], obj["taut_certificate"].split(":")[0],
                       [one.name for one in obj.users_collection] == [one.name for one in curves[0].users_collection]]
    scene.taut.construct = "dirichlet"
    net = obj.data.splines[0]
    result["nurbs"] = {**state(obj, curves), "points": [list(one.co) for one in net.points], "count": [net.point_count_u, net.point_count_v],
                       "order": [net.order_u, net.order_v], "splines": len(obj.data.splines)}
    obj = taut_surfaces.build(bpy.context, curves, obj.taut, obj)  # as each move of the mouse does
    result["active"] = bpy.context.object == obj and obj.select_get() and obj.name == "Sail"
    obj.taut.degree = (7, 7)
    result["degree"] = told(bpy.ops.taut.again)
    ends = [knot for one in curves for knot in one.data.splines[0].bezier_points]
    for knot in ends:
        knot.handle_left_type = knot.handle_right_type = "ALIGNED"
    before = [[*knot.co, *knot.handle_left, *knot.handle_right] for knot in ends]
    says = told(bpy.ops.taut.drag, corner=0, offset=(0, 0, 1))
    off = np.abs(np.array(before) - [[*knot.co, *knot.handle_left, *knot.handle_right] for knot in ends]).max()
    result["put back"] = [says, float(off), sorted({one for knot in ends for one in (knot.handle_left_type, knot.handle_right_type)})]
    for knot in ends:
        knot.handle_left_type = knot.handle_right_type = "FREE"
    obj.taut.degree = (0, 0)
    curves[2].scale = (1, 0, 1)
    bpy.context.view_layer.update()
    result["flat"] = told(bpy.ops.taut.drag, corner=0, offset=(0, 0, 1))
    curves[2].scale = (1, 1, 1)
    bpy.context.view_layer.update()
    scene.taut.refine, scene.taut.divide, count = 6, 64, len(bpy.data.objects)
    select(*curves)
    result["many"] = [told(bpy.ops.taut.between), len(bpy.data.objects) - count]
    scene.taut.refine, scene.taut.divide = 0, 12
    point = bpy.data.objects.new("point", bpy.data.curves.new("point", "CURVE"))
    point.data.splines.new("POLY")
    bpy.context.collection.objects.link(point)
    select(point, *curves[1:])
    result["point"] = told(bpy.ops.taut.between)
    bpy.data.objects.remove(point)
    select(*curves[:3])
    result["three"] = told(bpy.ops.taut.between)
    curves[1].data.splines[0].use_cyclic_u = True
    select(*curves)
    result["cyclic"] = told(bpy.ops.taut.between)
    curves[1].data.splines[0].use_cyclic_u = False
    # a certificate that does not hold is warned of
    true = taut_surfaces.hosts.between

    def false(*arguments, **named):
        document = json.loads(true(*arguments, **named).to_json())
        document["certificate"]["holds"] = document["certificate"]["claims"][0]["holds"] = False
        return taut_surfaces.taut.Model.from_json(json.dumps(document))

    taut_surfaces.hosts.between = false
    select(*curves)
    said = []
    teller = types.SimpleNamespace(report=lambda kind, text: said.append([sorted(kind), text]))
    result["false"] = [list(bpy.ops.taut.between()), bpy.context.object["taut_certificate"], said]
    taut_surfaces.Told.tried(teller, lambda: bpy.context.object)
    taut_surfaces.hosts.between = true
    bpy.data.objects.remove(bpy.context.object)
    bpy.ops.ed.undo_push(message="before")
    before = len(bpy.data.objects)
    select(*curves)
    bpy.ops.taut.between()
    bpy.ops.ed.undo_push(message="after")
    between = len(bpy.data.objects)
    bpy.ops.ed.undo()
    result["undo"] = [before, between, len(bpy.data.objects)]
    made = [one for one in bpy.data.objects if "taut_model" in one][-1]
    select(taut_surfaces.curves_of(made)[0])
    bpy.ops.object.delete()  # as the key X does
    bpy.context.view_layer.objects.active = made
    result["deleted"] = [len(taut_surfaces.curves_of(made)), told(bpy.ops.taut.again)]
    bpy.data.objects.remove(taut_surfaces.curves_of(made)[0], do_unlink=True)
    result["deleted"].append(len(taut_surfaces.curves_of(made)))
    taut_surfaces.unregister()
    return result


if __name__ == "__main__":
    try:
        print("RESULT " + json.dumps(run()), flush=True)
    except BaseException:
        traceback.print_exc()
        sys.exit(1)
