"""Runs in Blender's window by simulated events: a surface, its panel, a corner dragged by the mouse, kept by a click, undone. Prints RESULT."""
import json
import os
import traceback

import bpy
import in_blender as common
import taut

import taut_surfaces

given, result = common.given, {}


def place():
    window = bpy.context.window_manager.windows[0]
    area = next(one for one in window.screen.areas if one.type == "VIEW_3D")
    region = {one.type: one for one in area.regions}
    return window, area, region


def corner():
    obj = next(one for one in bpy.data.objects if "taut_model" in one)
    return taut.Model.from_json(obj["taut_model"]).surfaces[0].points[0, 0].tolist()


def steps():
    taut_surfaces.register()
    window, area, region = place()
    for one in list(bpy.data.objects):
        bpy.data.objects.remove(one)
    curves = [common.add_curve(f"edge{i}", points) for i, points in enumerate(given["edges"])]
    bpy.context.view_layer.update()
    common.select(*curves)
    bpy.context.scene.taut.construct = "dirichlet"
    with bpy.context.temp_override(window=window, area=area, region=region["WINDOW"]):
        bpy.ops.taut.between()
        space = area.spaces.active
        space.shading.color_type, space.show_region_ui = "VERTEX", True
        space.overlay.show_floor = False
        bpy.ops.view3d.view_all()
        bpy.ops.ed.undo_push(message="made")
    yield
    result["before"] = corner()
    ui = region["UI"]
    for down in range(40, 280, 30):  # the tabs, from the top: that of the add-on is the last
        for value in ("PRESS", "RELEASE"):
            window.event_simulate(type="LEFTMOUSE", value=value, x=ui.x + ui.width - 8, y=ui.y + ui.height - down)
            yield
    middle = (region["WINDOW"].x + region["WINDOW"].width // 3, region["WINDOW"].y + region["WINDOW"].height // 2)
    window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=middle[0], y=middle[1])
    yield
    with bpy.context.temp_override(window=window, area=area, region=region["WINDOW"]):
        result["drag"] = list(bpy.ops.taut.drag("INVOKE_DEFAULT", True, corner=0))
    yield
    for step in range(1, 6):
        window.event_simulate(type="MOUSEMOVE", value="NOTHING", x=middle[0], y=middle[1] + 8 * step)
        yield
    result["live"] = corner()
    window.event_simulate(type="LEFTMOUSE", value="PRESS", x=middle[0], y=middle[1] + 40)
    yield
    window.event_simulate(type="LEFTMOUSE", value="RELEASE", x=middle[0], y=middle[1] + 40)
    yield
    result["kept"] = corner()
    obj = next(one for one in bpy.data.objects if "taut_model" in one)
    result["certificate"] = obj["taut_certificate"]
    result["drawn"] = list(obj.data.vertices[0].co)
    common.select(obj)
    yield
    yield
    if given.get("picture"):
        with bpy.context.temp_override(window=window, area=area):
            bpy.ops.screen.screenshot(filepath=given["picture"])
    with bpy.context.temp_override(window=window, area=area, region=region["WINDOW"]):
        bpy.ops.ed.undo()
    yield
    result["undone"] = corner()


generator = steps()


def tick():
    try:
        next(generator)
        return 0.15
    except StopIteration:
        os.write(1, f"RESULT {json.dumps(result)}\n".encode())
        os._exit(0)
    except BaseException:
        traceback.print_exc()
        os._exit(1)


bpy.app.timers.register(tick, first_interval=1.5, persistent=True)
