/// OpenVDB's grid of floats. Its code is in the library: to compile it again would take half the time of each file.
#pragma once

#include <openvdb/openvdb.h>

extern template class openvdb::tree::Tree<openvdb::FloatTree::RootNodeType>;
extern template class openvdb::Grid<openvdb::FloatTree>;
