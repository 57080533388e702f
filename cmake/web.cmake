# taut.wasm: the library as a WebAssembly module without a start (a reactor), and the calls of src/web/web.c.
find_program(WASM_OPT wasm-opt REQUIRED)
# Without what nothing in a page asks for: among others flat pieces of cloth (pattern/flat), which only programs cut.
file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*.c)
list(FILTER web_sources EXCLUDE REGEX "/src/(cli|modules|page|construct/gradient)/|/io/cad/(absent|answer|cad|helper|looks|scan|sheets|wire)|/io/(csv|dxf)/|/io/geomdl/geomdl|/io/problem/(boundary_file|pattern|film_along|film_curves|film_patches)|/film/complex/|/problem/film_(complex|cells|places|rim|ropes)|/numeric/(front|sparse|modes_lent)|/geometry/boundary/|/geometry/chart/|/io/mesh/threemf|/io/mesh/cloth|/mesh/thicken|/shell/thick/|/io/step/assembly|/io/step/bodies|/numeric/strip|/pattern/flat/|/draw/flat_page|/measure/cloth/|/(construct|certify)/pattern/|/io/flat/(cloth|spread)|avx2|avx512|/platform/(posix|windows)")
# Nets of curves, where a film is how far from least, and faces without creases in STEP files are in the studio's module, which has room for them, and not in the one that any page may load.
option(TAUT_WEB_NETS "The module for browsers traces nets of curves" OFF)
if(TAUT_WEB_NETS)
  list(FILTER web_sources EXCLUDE REGEX "/web/left_out_nets")
else()
  list(FILTER web_sources EXCLUDE REGEX "/src/((construct/|certify/)?trace|pattern)/|/construct/common/told|/numeric/runge|/measure/dual/density|/io/step/cuts")
endif()
add_executable(taut_web ${web_sources})
target_link_libraries(taut_web PRIVATE taut_flags)
target_compile_options(taut_web PRIVATE -D_WASI_EMULATED_SIGNAL -DTAUT_SMALL_KERNEL -DTAUT_UNWATCHED -DTAUT_NO_MODULES # no page has a monitor, or modules on demand
  $<$<NOT:$<BOOL:${TAUT_WEB_NETS}>>:-DTAUT_WHOLE_FACES>)
file(STRINGS ${CMAKE_SOURCE_DIR}/src/web/web.c exported REGEX "^[a-z].*[ *]taut_web_[a-z]+\\(.*\\);$")
list(TRANSFORM exported REPLACE ".*[ *](taut_web_[a-z]+)\\(.*" "-Wl,--export=\\1")
target_link_options(taut_web PRIVATE -mexec-model=reactor ${exported} -Wl,--gc-sections -Wl,--strip-all
  -Wl,-z,stack-size=1048576 -Wl,--global-base=1024
  -O0) # no wasm-opt by the driver, which does not name the features: see below
target_link_libraries(taut_web PRIVATE wasi-emulated-signal m)
set_target_properties(taut_web PROPERTIES OUTPUT_NAME taut SUFFIX .wasm)
set(web_features --enable-simd --enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext)
if(TAUT_WEB_NETS) # quick code, which is larger; -Oz three times over would take minutes
  add_custom_command(TARGET taut_web POST_BUILD
    COMMAND ${WASM_OPT} --low-memory-unused -O3 -Oz ${web_features} $<TARGET_FILE:taut_web> -o $<TARGET_FILE:taut_web> VERBATIM)
else()
  # Once as the compiler left it, once more with what the linker promises: nothing lies below the first datum, at 1024, so that
  # small offsets go into loads and stores.
  add_custom_command(TARGET taut_web POST_BUILD
    COMMAND ${WASM_OPT} --flatten --rereloop -Oz -Oz -Oz --converge ${web_features}
            $<TARGET_FILE:taut_web> -o $<TARGET_FILE:taut_web>
    COMMAND ${WASM_OPT} --low-memory-unused --flatten --rereloop --optimize-added-constants-propagate -Oz -Oz -Oz ${web_features}
            $<TARGET_FILE:taut_web> -o $<TARGET_FILE:taut_web> VERBATIM)
endif()
# Small code, but in the loops over numbers that a hand that drags waits for. The studio is a file that need not be as small.
target_compile_options(taut_web PRIVATE $<IF:$<BOOL:${TAUT_WEB_NETS}>,-O2,-Oz>)
set(loops numeric/kernel numeric/band numeric/modes numeric/wide geometry/grid basis/basis basis/bspline
  measure/integrate/eight_ measure/integrate/cell certify/dirichlet/gradient_ construct/plateau/area construct/plateau/draft web/web)
list(JOIN loops "|" loops)
set(loop_sources ${web_sources})
list(FILTER loop_sources INCLUDE REGEX "/src/(${loops})")
set_source_files_properties(${loop_sources} PROPERTIES COMPILE_OPTIONS "-Os")
# Where that takes a seventh more time: two doubles a number, and proofs.
set(quick_sources ${loop_sources})
list(FILTER quick_sources INCLUDE REGEX "/src/(numeric/wide|measure/integrate|certify/dirichlet)")
set_source_files_properties(${quick_sources} PROPERTIES COMPILE_OPTIONS "-O2")
# Kernels whose lanes lie side by side gain nothing by unrolling.
list(FILTER loop_sources EXCLUDE REGEX "/src/measure/integrate/cell")
set_property(SOURCE ${loop_sources} APPEND PROPERTY COMPILE_OPTIONS -fno-unroll-loops)
# Vectors where loops over numbers are. Not elsewhere, and not out of straight code: of that clang 14 makes wrong code with
# them (a choice between two structs of two doubles, in certify/bonnet/proof.c, took the second where it was to take the first).
set(vector_sources ${web_sources})
list(FILTER vector_sources INCLUDE REGEX "/src/(numeric|geometry/grid)/|/plateau/(area_baseline|draft)\\.c|/(eight_baseline|gradient_baseline|integrate/cell)\\.c")
set_property(SOURCE ${vector_sources} APPEND PROPERTY COMPILE_OPTIONS -msimd128 -fno-slp-vectorize)
# clang 14 breaks down on -mbulk-memory elsewhere.
set_source_files_properties(${CMAKE_SOURCE_DIR}/src/web/bytes.c PROPERTIES COMPILE_OPTIONS "-mbulk-memory;-fno-builtin")
# Sums and products of two doubles (core/twice.h) take less time where they are, and less room, than called.
set(twice_sources ${web_sources})
list(FILTER twice_sources INCLUDE REGEX "/src/construct/(bi)?harmonic/")
set_property(SOURCE ${twice_sources} APPEND PROPERTY COMPILE_OPTIONS -mllvm -inline-threshold=50)
