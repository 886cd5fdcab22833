# Third parties of the libraries: for the build, and for those who link the static ones. OpenMesh and CGAL are
# looked for in meshing, VTK in studies.

find_package(Eigen3 3.4 CONFIG REQUIRED)
find_package(Boost 1.74 CONFIG REQUIRED)
find_package(Ceres 2.1 CONFIG REQUIRED)
find_package(TBB CONFIG REQUIRED)
find_package(tomlplusplus CONFIG REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(muparser CONFIG REQUIRED)

set(BLA_VENDOR OpenBLAS)
find_package(LAPACK REQUIRED)

# A library that has no package of CMake; what else it needs follows.
function(sbeh_import name header library)
  string(TOUPPER ${name} prefix)
  find_path(${prefix}_HEADERS ${header} REQUIRED)
  find_library(${prefix}_FILE ${library} REQUIRED)
  add_library(sbeh::${name} UNKNOWN IMPORTED)
  set_target_properties(sbeh::${name} PROPERTIES
    IMPORTED_LOCATION ${${prefix}_FILE}
    INTERFACE_INCLUDE_DIRECTORIES ${${prefix}_HEADERS}
    INTERFACE_LINK_LIBRARIES "${ARGN}")
endfunction()

if(NOT TARGET sbeh::mumps)
  sbeh_import(lapacke lapacke.h lapacke LAPACK::LAPACK)
  sbeh_import(metis metis.h metis)
  sbeh_import(smumps smumps_c.h smumps_seq)
  sbeh_import(mumps dmumps_c.h dmumps_seq sbeh::smumps)
endif()
