#!/usr/bin/env python3
"""draw_architecture.py [--check] -- writes docs/architecture.svg, the rooms a document passes through; --check says
whether it is what the script draws, and whether every room is a folder of src/."""
import html
import os
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..")
TARGET = os.path.join(ROOT, "docs", "architecture.svg")
INK, LINE, PAPER = "#1a1a1a", "#555555", "#ffffff"
BUILD, PROVE, FLOOR = "#cfe3f5", "#f9dfb5", "#ebebeb"  # apart in lightness too
WIDTH, HEIGHT = 960, 470

# (room, what passes through it, x, y, width, colour, folders of src)
ROOMS = [
    ("document", "JSON, yours", 20, 40, 160, PAPER, []),
    ("problem", "what is asked for, in units", 220, 40, 160, BUILD, ["io", "problem"]),
    ("construct", "finds what is not known", 420, 40, 160, BUILD, ["construct"]),
    ("geometry", "the model: curves, surfaces", 620, 40, 160, BUILD, ["geometry"]),
    ("measure", "areas, energies, curvatures", 620, 170, 160, PROVE, ["measure"]),
    ("certify", "proves claims of the model", 420, 170, 160, PROVE, ["certify"]),
    ("certificate", "claim, kind, number, limit", 220, 170, 160, PROVE, []),
    ("mesh, shell", "triangles; closed bodies", 620, 300, 160, PAPER, ["mesh", "shell"]),
    ("io", "STEP, OBJ, STL, VTU, DXF", 420, 300, 160, PAPER, ["io"]),
    ("draw, page", "figures; a page to turn it in", 220, 300, 160, PAPER, ["draw", "page"]),
]


def text(x, y, words, size=13, weight="normal", anchor="middle", colour=INK):
    return ('<text x="%g" y="%g" font-size="%d" font-weight="%s" text-anchor="%s" fill="%s">%s</text>'
            % (x, y, size, weight, anchor, colour, html.escape(words)))


def box(x, y, width, height, colour):
    return '<rect x="%g" y="%g" width="%g" height="%g" rx="6" fill="%s" stroke="%s"/>' % (x, y, width, height, colour, LINE)


def line(points):
    return ('<polyline points="%s" fill="none" stroke="%s" stroke-width="1.6" marker-end="url(#tip)"/>'
            % (" ".join("%g,%g" % p for p in points), INK))


def draw():
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" height="%d" '
           'font-family="sans-serif" role="img" aria-labelledby="t d">' % (WIDTH, HEIGHT, WIDTH, HEIGHT),
           '<title id="t">How a document becomes a proved surface</title>',
           '<desc id="d">A document is read into a problem; a construction makes a model from it; the model is measured; '
           'certify proves claims of the model and the problem, and shares no code with construct; the model and its '
           'certificate are written to files, figures and pages.</desc>',
           '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
           '<path d="M0,0 L8,4 L0,8 z" fill="%s"/></marker></defs>' % INK,
           '<rect width="%d" height="%d" fill="%s"/>' % (WIDTH, HEIGHT, PAPER)]
    for name, words, x, y, width, colour, _ in ROOMS:
        out += [box(x, y, width, 66, colour), text(x + width / 2, y + 28, name, 15, "bold"),
                text(x + width / 2, y + 50, words, 11)]
    out += [line([(180, 73), (216, 73)]), line([(380, 73), (416, 73)]), line([(580, 73), (616, 73)]),
            line([(700, 106), (700, 166)]), line([(620, 203), (584, 203)]), line([(420, 203), (384, 203)]),
            line([(300, 106), (300, 138), (460, 138), (460, 166)]),  # the problem, to be proved against
            line([(780, 73), (830, 73), (830, 333), (784, 333)]),    # the model, to files
            line([(300, 236), (300, 296)]), line([(620, 333), (584, 333)]), line([(420, 333), (384, 333)])]
    out += [text(380, 132, "asked for", 11), text(838, 200, "the model", 11, anchor="start"),
            text(308, 272, "what is proved", 11, anchor="start")]
    # the two that never meet
    out += ['<line x1="540" y1="110" x2="540" y2="166" stroke="#b00020" stroke-width="2.5"/>',
            '<line x1="532" y1="138" x2="548" y2="138" stroke="#b00020" stroke-width="2.5"/>',
            text(556, 142, "no include", 11, anchor="start", colour="#b00020")]
    out += [box(20, 400, 760, 44, FLOOR),
            text(400, 427, "basis, numeric, core, platform: evaluation, quadrature, errors, memory: what both sides rest on", 12)]
    out.append("</svg>")
    return "\n".join(out) + "\n"


def main():
    wrong = [folder for room in ROOMS for folder in room[6] if not os.path.isdir(os.path.join(ROOT, "src", folder))]
    if wrong:
        print("draw_architecture.py: src/ has no " + ", ".join(wrong))
        return 1
    if sys.argv[1:] == ["--check"]:
        with open(TARGET, encoding="utf-8") as file:
            if file.read() != draw():
                print("docs/architecture.svg is not what tools/draw_architecture.py draws: run it")
                return 1
        return 0
    with open(TARGET, "w", encoding="utf-8") as file:
        file.write(draw())
    return 0


if __name__ == "__main__":
    sys.exit(main())
