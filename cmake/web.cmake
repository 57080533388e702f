# taut.wasm: the library as a WebAssembly module without a start (a reactor), and the calls of src/web/web.c.
find_program(WASM_OPT wasm-opt REQUIRED)
file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/*.c)
list(FILTER web_sources EXCLUDE REGEX "/src/(cli|modules|page|construct/gradient)/|/io/cad/(absent|answer|cad|helper|scan|wire)|avx2|avx512|/platform/(posix|windows)")
add_executable(taut_web ${web_sources})
target_link_libraries(taut_web PRIVATE taut_flags)
target_compile_options(taut_web PRIVATE -D_WASI_EMULATED_SIGNAL)
file(STRINGS ${CMAKE_SOURCE_DIR}/src/web/web.c exported REGEX "^[a-z].*[ *]taut_web_[a-z]+\\(.*\\);$")
list(TRANSFORM exported REPLACE ".*[ *](taut_web_[a-z]+)\\(.*" "-Wl,--export=\\1")
target_link_options(taut_web PRIVATE -mexec-model=reactor ${exported} -Wl,--gc-sections -Wl,--strip-all
  -Wl,-z,stack-size=1048576
  -O0) # no wasm-opt by the driver, which does not name the features: see below
target_link_libraries(taut_web PRIVATE wasi-emulated-signal m)
set_target_properties(taut_web PROPERTIES OUTPUT_NAME taut SUFFIX .wasm)
add_custom_command(TARGET taut_web POST_BUILD
  COMMAND ${WASM_OPT} -Oz --converge --enable-simd --enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext
          $<TARGET_FILE:taut_web> -o $<TARGET_FILE:taut_web> VERBATIM)
# Small code for all but what a hand that drags waits for: numbers, nets and their solves, areas, grids. Reading and setting a point
# stand between the two.
set(small_sources ${web_sources})
list(FILTER small_sources EXCLUDE REGEX "/src/(core|numeric|basis|geometry|io/json|io/problem|problem|web)/|/construct/(common|dirichlet|plateau|harmonic|biharmonic)/|/measure/integrate/|/certify/(common|dirichlet)/")
set_source_files_properties(${small_sources} PROPERTIES COMPILE_OPTIONS "-Oz")
set(middle_sources ${web_sources})
list(FILTER middle_sources INCLUDE REGEX "/src/(io/json|io/problem|problem|web|certify/common|certify/dirichlet|construct/harmonic|construct/biharmonic)/")
set_source_files_properties(${middle_sources} PROPERTIES COMPILE_OPTIONS "-Os")
# In those rooms, what steers, refines, converts and describes: it runs once where the loops beside it run a thousand times.
set(steering_sources ${web_sources})
list(FILTER steering_sources INCLUDE REGEX "/src/geometry/(operate|nurbs|boundary)/|/src/geometry/[a-z]*\\.c|/src/basis/([a-z_]*change|blossom|blossoms?)\\.c|/src/core/[a-z_]*\\.c|/measure/integrate/(integrate|integrals|absolute|jacobian|kinks|line|mean|near_zero|parameters)\\.c|/construct/plateau/(solve|refine|dual|direction|plateau|witness|trust_region|approach|directions|newton_step|cable|space)\\.c|/construct/dirichlet/(aspect|dirichlet|rational)\\.c|/numeric/(dense|runge|quadrature|bernstein|minimise)\\.c|/src/numeric/eigen/|/src/io/json/(place|nearest|slice|in|get|record)\\.c|/src/io/problem/|/src/problem/|/src/web/|/construct/(harmonic|biharmonic)/|/certify/common/|/certify/dirichlet/(dirichlet|remainder|plan|gradient)\\.c|/construct/common/")
list(FILTER steering_sources EXCLUDE REGEX "/src/geometry/(surface|surface_eval|lattice|net|scattered)\\.c")
set_source_files_properties(${steering_sources} PROPERTIES COMPILE_OPTIONS "-Oz")
# Vectors where loops over numbers are. Not elsewhere, and not out of straight code: of that clang 14 makes wrong code with
# them (a choice between two structs of two doubles, in certify/bonnet/proof.c, took the second where it was to take the first).
set(vector_sources ${web_sources})
list(FILTER vector_sources INCLUDE REGEX "/src/(numeric|geometry/grid)/|/plateau/area_baseline.c")
set_source_files_properties(${vector_sources} PROPERTIES COMPILE_OPTIONS "-msimd128;-fno-slp-vectorize")
