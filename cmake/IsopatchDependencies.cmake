# Everything else that isopatch links. scripts/packages.txt names the Debian packages.

include("${CMAKE_CURRENT_LIST_DIR}/IsopatchSolveDependencies.cmake")
pkg_check_modules(NLOPT REQUIRED IMPORTED_TARGET nlopt)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore FiltersGeneral FiltersGeometry
  FiltersSources IOXML IOImage RenderingFreeType RenderingOpenGL2)
# By hand: the package file of Debian asks for libraries of OpenCASCADE's viewer, too.
find_path(OPENCASCADE_INCLUDE_DIR Standard_Version.hxx PATH_SUFFIXES opencascade REQUIRED)
set(OPENCASCADE_LIBRARIES)
foreach(library TKXDESTEP TKXDEIGES TKSTEP TKIGES TKXSBase TKXCAF TKLCAF TKCDF TKMesh TKBO TKShHealing TKTopAlgo TKGeomAlgo
        TKBRep TKGeomBase TKG3d TKG2d TKMath TKernel)
  find_library(OPENCASCADE_${library} ${library} REQUIRED)
  list(APPEND OPENCASCADE_LIBRARIES "${OPENCASCADE_${library}}")
endforeach()
find_package(X11 REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS OpenGL GLX)
pkg_check_modules(TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_file(THREE_JS three.min.js PATHS /usr/share/javascript/three /usr/share/nodejs/three/build REQUIRED)
if(ISOPATCH_TESTS)
  find_package(GTest REQUIRED)
  include(GoogleTest)
  find_package(benchmark REQUIRED)
  find_library(OPENBLAS_LIBRARY openblas REQUIRED)
  # The system's interpreter; one on the PATH may belong to an environment of the user.
  find_program(ISOPATCH_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
  find_program(ISOPATCH_PYTHON python3 REQUIRED)
endif()
