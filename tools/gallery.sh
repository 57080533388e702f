#!/bin/bash
# gallery.sh TAUT [PAGES] -- one figure (docs/gallery/<example>.png) and one page (PAGES/<example>.html, default
# out/gallery) of every worked example, docs/gallery/README.md that shows them by construction, and the pictures of the
# lessons (docs/tutorial). The figures are committed; the pages, of 0.8 MB each, are not: they are made where they are
# wanted. New examples appear by themselves.
set -eu
taut=$(realpath "$1")
cd "$(dirname "$0")/.."
pages=${2:-out/gallery}
gallery=${GALLERY:-docs/gallery}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$pages" "$gallery"

# How an example is drawn: with a dense net the surface is hidden, so it is left out and lines of equal u and v show the
# form; a construction that joins several surfaces shows them together, the frames of a deformation side by side.
words() { # words EXAMPLE
    case $1 in
    asymptotic*) echo --no-net --isolines 9 ;;
    harmonic-extension | harmonic-neighbour) echo --no-net --isolines 7 --view 300,15 ;;
    dirichlet-mast) echo --no-net --isolines 11 --view 120,35 ;;
    film-ridge) echo --no-net --view 300,55 ;;
    film-bubbles | film-gyroid | film-neovius | film-schwarz-* | film-tent) echo --no-net ;;
    film* | *-mast | *-through | biharmonic-c?) echo --no-net --isolines 11 ;;
    pattern-cone) echo --no-net --view 120,40 ;;
    pattern*) echo --no-net --view 285,50 ;;
    pipe-caps) echo --no-net --view 300,-25 ;;
    bonnet*) echo --no-net --isolines 9 ;;
    pipe* | trace*) echo --no-net ;;
    esac
}

member() { # member NAME FILE: the string that follows it first
    sed -n "s/.*\"$1\": *\"\([^\"]*\)\".*/\1/p" "$2" | head -n 1
}

: > "$work/list"
for name in $("$taut" example); do
    "$taut" example "$name" > "$work/problem.json"
    construct=$(member construct "$work/problem.json")
    # made at once, so that the certificate is a fresh one; where a claim does not hold, as the example says, the model alone is written
    # shellcheck disable=SC2046
    "$taut" make "$work/problem.json" --quiet -o "$gallery/$name.png" -o "$pages/$name.html" --width 600 $(words "$name") || {
        [ $? = 1 ]
        "$taut" make "$work/problem.json" --quiet -o "$work/model.json" || [ $? = 1 ]
        "$taut" convert "$work/model.json" -o "$gallery/$name.png" --width 600 $(words "$name")
        "$taut" view "$work/model.json" "$work/problem.json" -o "$pages/$name.html"
    }
    echo "$construct $name" >> "$work/list"
done

# Figures of the pages in docs/ that are no plain examples; EDIT is what sed makes of the document first.
show() { # [EDIT=...] show EXAMPLE PICTURE WORDS: a figure of an example's model
    example=$1 picture=$2
    shift 2
    "$taut" example "$example" | sed "${EDIT:-}" > "$work/problem.json"
    "$taut" make "$work/problem.json" --quiet -o "$gallery/$picture" "$@"
}
show dirichlet-mast figure-isothermality.png --colour I --isolines 8 --no-net --width 600
show plateau-skew least-skew.png --colour gap --no-net --width 600
show plateau-saddle least-saddle.png --colour gap --no-net --width 600
show dirichlet-bicubic-spline plateau-dirichlet.svg --colour H --no-net --divide 30
show plateau-bicubic-spline plateau-film.svg --colour H --no-net --divide 30
EDIT='s/"count": 12/&, "trim": 0.6/' show pattern-dome pattern-trim.png --colour strain --no-net --view 285,50 --width 600
EDIT='/"compensation"/d; s/"seams"/"flatten": "conformal", &/' show pattern-sail pattern-print.png --colour strain --no-net --view 285,50 --width 600
if command -v pdftoppm > "$work/where"; then # the first sheet of paper, behind the figure and the page of where they are
    "$taut" example pattern-sail > "$work/problem.json"
    "$taut" make "$work/problem.json" --quiet -o "$work/sheets.pdf" --tiles a4
    pdftoppm -f 3 -l 3 -r 50 -png -singlefile "$work/sheets.pdf" "$gallery/pattern-sheet"
fi

# The pictures of the lessons, of their own documents.
lessons=${LESSONS:-docs/tutorial}
cp docs/tutorial/*.json docs/tutorial/*.step "$work"
"$taut" make "$work/sail.json" --quiet -o "$work/form.json"
lesson() { # lesson COMMAND DOCUMENT PICTURE WORDS
    "$taut" "$1" "$work/$2" --quiet -o "$lessons/$3" "${@:4}"
}
lesson make tent.json tent.png --width 600
lesson make film.json film.png --colour gap --no-net --width 600
lesson panels roof.json roof.png --kind conical --divide 8,6 --no-net --view 315,60 --width 600
lesson make pipes.json pipes.png --no-net --width 600
lesson make cloth.json sail.png --no-net --width 1200
lesson trace gridshell.json gridshell.png --net asymptotic --cells 7 --width 900
if command -v rsvg-convert > "$work/where"; then # the left ends of the strips at the foot of the sheet, in lines that are seen
    "$taut" trace "$work/gridshell.json" --net asymptotic --cells 7 --strip standing --width 0.04 --thickness 0.0006 \
        --material steel-s235 --sheet 1.7x0.6 --quiet -o "$work/laths.json"
    "$taut" convert "$work/laths.json" -o "$work/laths.svg"
    sed 's/width="1700mm" height="600mm" viewBox="0 0 1700 600"/viewBox="0 238 600 362"/; s/stroke-width="[0-9.]*"/stroke-width="0.5"/' \
        "$work/laths.svg" | rsvg-convert -w 1200 -b white -o "$lessons/gridshell-sheets.png"
fi

{
    echo '# Gallery'
    echo
    echo 'Every worked example (`taut example`). `make gallery` draws the figures anew and writes a page to turn each in to'
    echo '`out/gallery/`; [view.md](../view.md) says what the pages can do.'
    for construct in $(cut -d ' ' -f 1 "$work/list" | sort -u); do
        printf '\n## %s\n\n' "$construct"
        sed -n "s/^$construct //p" "$work/list" | while read -r name; do
            printf '[![%s](%s.png)](%s.png "%s")\n' "$name" "$name" "$name" "$name"
            printf '`%s`: %s\n\n' "$name" "$(sed -n "s/^$name: //p" examples/titles.txt)"
        done
    done
} > "$gallery/README.md"
echo "$(wc -l < "$work/list") figures in $gallery, as many pages in $pages"
