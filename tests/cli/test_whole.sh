# test_whole.sh -- a surface that lies on its parts, h of harmonic-extension, is not written on top of them: every format and picture has
# the parts, or with --surface h the whole; taut's own format has all three.
. "$SOURCE/tests/cli/cli.sh"

for name in harmonic-extension; do
    "$TAUT" example $name > problem.json
    run 0 make problem.json --quiet -o model.json -o all.obj -o all.step -o all.vtu -o all.html -o all.stl
    contains model.json '"whole": "h"'
    [ "$(grep -c '"u": {' model.json)" = 3 ] || complain "$name: the model lost a surface"
    ! grep -q "^g h$" all.obj || complain "$name: the whole is in OBJ"
    [ "$(grep -c '^g ' all.obj)" = 2 ] || complain "$name: $(grep -c '^g ' all.obj) groups in OBJ, expected 2"
    [ "$(grep -c 'B_SPLINE_SURFACE_WITH_KNOTS' all.step)" = 2 ] || complain "$name: $(grep -c B_SPLINE_SURFACE_WITH_KNOTS all.step) surfaces in STEP"
    [ "$(grep -o '"basis_u"' all.html | wc -l)" = 2 ] || complain "$name: the page has $(grep -o '"basis_u"' all.html | wc -l) surfaces"
    run 0 convert model.json --surface h -o whole.obj -o whole.step
    [ "$(grep -c '^g ' whole.obj)" = 1 ] || complain "$name: --surface h is not one surface"
    run 0 convert model.json -o again.json
    cmp -s model.json again.json || complain "$name: a copy differs"
    run 0 certify model.json problem.json
done

# A tangent-plane neighbour has no whole.
printf '{ "taut": 1, "construct": "harmonic-extension", "edge": "u1", "contact": "g1", "c": 2, "surface": %s }' \
    '{ "u": { "type": "bezier", "degree": 1 }, "v": { "type": "bezier", "degree": 1 }, "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]] }' > g1.json
run 0 make g1.json --quiet -o g1-model.json -o g1.obj
! grep -q '"whole"' g1-model.json || complain 'a tangent-plane neighbour names a whole'
[ "$(grep -c '^g ' g1.obj)" = 2 ] || complain "$(grep -c '^g ' g1.obj) groups of a tangent-plane neighbour"
finish
