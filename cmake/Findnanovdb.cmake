# SPDX-License-Identifier: Apache-2.0
# nanovdb::nanovdb, headers alone: they are compiled into the one file that includes them.
find_path(nanovdb_INCLUDE_DIR nanovdb/PNanoVDB.h)
mark_as_advanced(nanovdb_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(nanovdb REQUIRED_VARS nanovdb_INCLUDE_DIR)

if(nanovdb_FOUND AND NOT TARGET nanovdb::nanovdb)
  add_library(nanovdb::nanovdb INTERFACE IMPORTED)
  set_target_properties(nanovdb::nanovdb PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${nanovdb_INCLUDE_DIR}")
endif()
