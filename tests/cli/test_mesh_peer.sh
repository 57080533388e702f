# test_mesh_peer.sh -- a capped pipe as a mesh, in programs that print and draw: admesh has nothing to mend in the STL file; Blender
# imports STL, OBJ, PLY and GLB as closed bodies, the right side out, of the volume that the STL file has, under their names.
. "$SOURCE/tests/cli/cli.sh"
found=
printf '{ "taut": 1, "construct": "pipe", "radius": 20, "caps": true, "bend_radius": 60, "run": [[0,0,0],[0,200,0],[200,200,0]] }' > problem.json
run 0 make problem.json --quiet -o model.json -o pipe.stl -o pipe.obj -o pipe.ply -o pipe.glb
exact=$(tr -d ' \n' < model.json | sed -n 's/.*"volume":\([-+.e0-9]*\).*/\1/p')
near() { # near FOUND EXPECTED PART WHAT
    awk "BEGIN { d = $1 / $2 - 1; exit !(d < $3 && d > -$3) }" || complain "$4: $1, expected $2"
}
if command -v admesh > /dev/null; then
    found=1
    admesh pipe.stl > admesh.txt 2>&1 || complain "admesh: $(cat admesh.txt)"
    contains admesh.txt 'Number of parts *: *1 '
    contains admesh.txt 'Degenerate facets *: *0'
    contains admesh.txt 'Total disconnected facets *: *0 *0'
    for mended in 'Edges fixed' 'Facets removed' 'Facets added' 'Facets reversed' 'Backwards edges' 'Normals fixed'; do
        contains admesh.txt "$mended *: *0"
    done
    near "$(sed -n 's/.*Volume *: *\([-+.e0-9]*\).*/\1/p' admesh.txt)" "$exact" 5e-3 admesh # chords: by Pappus
fi
if command -v blender > /dev/null; then
    found=1
    cat > look.py <<'PY'
import bmesh, bpy, numpy
if not hasattr(numpy, "bool"):
    numpy.bool = bool # Debian's Blender reads GLB with a name that its numpy has no more
imports = {"stl": bpy.ops.import_mesh.stl, "obj": bpy.ops.wm.obj_import, "ply": bpy.ops.import_mesh.ply, "glb": bpy.ops.import_scene.gltf}
for kind, read in imports.items():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    read(filepath="pipe." + kind)
    whole, names = bmesh.new(), []
    for thing in bpy.data.objects:
        if thing.type == "MESH":
            one = thing.data.copy()
            one.transform(thing.matrix_world)
            whole.from_mesh(one)
            names.append(thing.name)
    size = max(v.co.length for v in whole.verts)
    bmesh.ops.remove_doubles(whole, verts=whole.verts, dist=1e-6 * size) # surfaces and seams of normals are apart in OBJ, PLY and GLB
    bmesh.ops.dissolve_degenerate(whole, edges=whole.edges, dist=1e-6 * size)
    open_edges = sum(not (edge.is_manifold and edge.is_contiguous) for edge in whole.edges)
    print("LOOK", kind, open_edges, repr(whole.calc_volume(signed=True)), *sorted(names))
PY
    blender --background --factory-startup --python-exit-code 1 --python look.py > blender.txt 2>&1 < /dev/null || complain "Blender: $(tail -n 5 blender.txt)"
    for kind in stl obj ply; do
        near "$(sed -n "s/^LOOK $kind 0 \([-+.e0-9]*\).*/\1/p" blender.txt | grep . || echo 0)" "$exact" 5e-3 "Blender, $kind: $(grep "LOOK $kind" blender.txt)"
    done
    near "$(sed -n 's/^LOOK glb 0 \([-+.e0-9]*\).*/\1/p' blender.txt | grep . || echo 0)" "$(awk "BEGIN { print 1e-9 * $exact }")" 5e-3 "Blender, glb: $(grep 'LOOK glb' blender.txt)" # in metres
    contains blender.txt '^LOOK obj 0 .* blend1 cap1 cap2 pipe1 pipe2$'
    contains blender.txt '^LOOK glb 0 .* blend1 cap1 cap2 pipe1 pipe2$'
fi
[ -n "$found" ] || echo 'left out: neither admesh nor Blender is here: apt-get install admesh blender (continuous integration goes without)'
finish
