# find_package(Fieldfab) defines fieldfab::fieldfab (the kernel), fieldfab::cam and fieldfab::openscad.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include(${CMAKE_CURRENT_LIST_DIR}/FieldfabTargets.cmake)
