# Two commands set everything up on a fresh Debian 12: `make demo` and `make test`.
# No logic here: what is built is in CMakeLists.txt, what is installed in tools/deps.sh.
TAUT = build/release/bin/taut

.PHONY: demo test build deps gallery bench bench-dirichlet bench-documents bench-elementary bench-evaluate bench-full bench-gaps bench-make bench-plateau bench-studio bench-web format check mutants reproduction reference site release install deb wasm studio \
  python bench-python plugins windows clean help

demo: build
	@mkdir -p out
	$(TAUT) example dirichlet-tent > out/demo-problem.json
	$(TAUT) make out/demo-problem.json -o out/demo.json -o out/demo.obj -o out/demo.png
	@printf '%s\n' '' 'Written:' \
	  '  out/demo-problem.json  the boundary that was given' \
	  '  out/demo.json          the surface, with its certificate' \
	  '  out/demo.obj           the same as a mesh' \
	  '  out/demo.png           and as a picture'

test:
	@tools/deps.sh build test
	@cmake --preset release
	@cmake --build --preset release
	@ctest --preset release -j "$$(nproc)"
	@tools/python.sh wheel
	@tools/left_out.sh build/release

build:
	@tools/deps.sh build
	@cmake --preset release
	@cmake --build --preset release --target product

deps:
	@tools/deps.sh build test browser check

studio: build
	@tools/deps.sh wasm
	@cmake --preset release
	@cmake --build --preset release --target studio
	@mkdir -p out
	$(TAUT) studio -o out/studio.html

site: build
	@tools/deps.sh site
	@tools/site.py --taut $(TAUT)

release:
	@tools/deps.sh build test check wasm windows site
	@tools/release.sh

gallery: build
	@tools/gallery.sh $(TAUT)

bench: bench-dirichlet bench-documents bench-elementary bench-evaluate bench-make bench-plateau

bench-dirichlet bench-documents bench-elementary bench-evaluate bench-make bench-plateau:
	@tools/deps.sh build bench
	@cmake --preset bench
	@cmake --build --preset bench --target $@
	@OPENBLAS_NUM_THREADS=1 build/bench/bin/$@

bench-full bench-gaps:
	@tools/deps.sh build
	@cmake --preset bench
	@cmake --build --preset bench --target $@
	@build/bench/bin/$@

bench-web:
	@tools/deps.sh build wasm
	@cmake --preset bench
	@cmake --build --preset bench --target bench-web-native
	@cmake --preset wasm
	@cmake --build --preset wasm
	@node --no-liftoff bench/web/web.mjs build/bench/bin/bench-web-native build/wasm/bin/taut.wasm

bench-studio: studio
	@tools/deps.sh browser
	@node bench/web/studio.mjs $(TAUT)

wasm: build
	@tools/deps.sh wasm
	@cmake --preset wasm
	@cmake --build --preset wasm
	@node --test tests/web/test_web.mjs

python: build
	@tools/deps.sh test
	@tools/python.sh wheel

bench-python: build
	@tools/python.sh bench

plugins: build
	@tools/deps.sh test
	@tools/plugins.sh zip

windows:
	@tools/deps.sh windows
	@cmake --preset mingw
	@cmake --build --preset mingw --target product
	@cd build/mingw && cpack -B .. && rm -r ../_CPack_Packages

format:
	@tools/check_format.sh --fix

check:
	@tools/deps.sh check
	@tools/check_all.sh

mutants:
	@tools/deps.sh build test
	@tools/mutants.sh

install: build
	@cmake --install build/release $(if $(PREFIX),--prefix "$(PREFIX)")
	@[ -z "$(PYTHON_FOLDER)" ] || tools/python.sh install "$(PYTHON_FOLDER)"
	@$(if $(PREFIX),tools/find_prefix.sh "$(PREFIX)",echo "ldconfig, as root, lets programs find the library in the folders of the system")

reproduction: build
	@tools/reproduction.sh

reference:
	@tools/reference.sh

deb: build
	@tools/deps.sh check
	@cd build/release && cpack -G DEB -B .. && rm -r ../_CPack_Packages

clean:
	@cmake -E rm -rf build out

help:
	@grep -o '^[a-z-]*:' Makefile | tr -d ':'
