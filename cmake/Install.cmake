# SPDX-License-Identifier: Apache-2.0
# What an installed twinray is: the program and its link `pathtracer`, the static libraries, the public headers under
# include/twinray, and a CMake package of which find_package(twinray) gives twinray::core, ::accel, ::integrators,
# ::check and ::io.
include(CMakePackageConfigHelpers)

# Headers that are not installed: users would compile the canonical tests with flags of their own. Each opens
# with "// Private"; a test compares, and sees that no public header includes one of them.
set(private_headers
  accel/backends.h
  accel/build/big_vector.h
  accel/build/binary_tree.h
  accel/build/box_lanes.h
  accel/build/cost_model.h
  accel/build/coverage.h
  accel/build/phase_timer.h
  accel/build/reinsertion.h
  accel/build/split.h
  accel/builders.h
  accel/bvh/build.h
  accel/bvh/engine.h
  accel/bvh/invariants.h
  accel/bvh/node.h
  accel/bvh/statistics.h
  accel/bvh/traversal.h
  accel/canonical/block_lanes-inl.h
  accel/canonical/block_test-inl.h
  accel/canonical/checked_ray.h
  accel/canonical/edge_lanes-inl.h
  accel/canonical/instance_packet-inl.h
  accel/canonical/instance_ray-inl.h
  accel/canonical/instance_ray.h
  accel/canonical/lane_bits-inl.h
  accel/canonical/load_ray-inl.h
  accel/canonical/moller_trumbore.h
  accel/canonical/nearest.h
  accel/canonical/packet_test-inl.h
  accel/canonical/primitive_block.h
  accel/canonical/ray_packet-inl.h
  accel/canonical/shape_test.h
  accel/canonical/slab.h
  accel/canonical/sphere.h
  accel/canonical/sphere_test-inl.h
  accel/canonical/triangle.h
  accel/compact/build.h
  accel/compact/grid.h
  accel/compact/kernel.h
  accel/compact/node.h
  accel/compact/packed_block.h
  accel/compact/partition.h
  accel/compact/unpack-inl.h
  accel/counting.h
  accel/embree/api.h
  accel/embree/bounds.h
  accel/embree/builder.h
  accel/embree/device.h
  accel/embree/direct.h
  accel/embree/embree.h
  accel/embree/leaf.h
  accel/embree/native.h
  accel/embree/ray.h
  accel/embree/rounding.h
  accel/wide/batch-inl.h
  accel/wide/box_test-inl.h
  accel/wide/build.h
  accel/wide/collapse.h
  accel/wide/engine.h
  accel/wide/forest.h
  accel/wide/inspection.h
  accel/wide/instanced-inl.h
  accel/wide/invariants.h
  accel/wide/kernel.h
  accel/wide/layout.h
  accel/wide/node.h
  accel/wide/occlusion.h
  accel/wide/open_leaves-inl.h
  accel/wide/packets-inl.h
  accel/wide/queries-inl.h
  accel/wide/scalar.h
  accel/wide/scalar_query.h
  accel/wide/stack-inl.h
  accel/wide/statistics.h
  accel/wide/survey.h
  accel/wide/tree.h
  check/exact.h
  core/fork_join.h
  core/lanes.h
  core/map_points.h
  core/same_size.h
  integrators/denoise/blend.h
  integrators/denoise/box_mean.h
  integrators/denoise/error_product.h
  integrators/denoise/patch_distance.h
  integrators/denoise/regression.h
  integrators/denoise/tile.h
  integrators/sample_maker.h
  integrators/channels.h
  integrators/wave/camera-inl.h
  integrators/wave/camera_stage.h
  integrators/wave/coats-inl.h
  integrators/wave/columns.h
  integrators/wave/draws-inl.h
  integrators/wave/double_lanes-inl.h
  integrators/wave/facets-inl.h
  integrators/wave/fetch-inl.h
  integrators/wave/follow_together.h
  integrators/wave/lambert-inl.h
  integrators/wave/lamps-inl.h
  integrators/wave/lanes-inl.h
  integrators/wave/light-inl.h
  integrators/wave/light_tree-inl.h
  integrators/wave/lobe_surfaces.h
  integrators/wave/lobes-inl.h
  integrators/wave/metals-inl.h
  integrators/wave/principled-inl.h
  integrators/wave/patches-inl.h
  integrators/wave/path_wave.h
  integrators/wave/receivers-inl.h
  integrators/wave/requests.h
  integrators/wave/scatter-inl.h
  integrators/wave/shape_table.h
  integrators/wave/sphere_light-inl.h
  integrators/wave/stages.h
  integrators/wave/surfaces-inl.h
  integrators/wave/warp-inl.h
  integrators/wave/wave.h
  io/assimp/import_function.h
  io/assimp/model_bytes.h
  io/exchange/camera.h
  io/exchange/entry.h
  io/exchange/json.h
  io/exchange/members.h
  io/exchange/texture.h
  io/exchange/words.h
  io/gltf/writer_file.h
  io/gltf/writer_material.h
  io/gltf/writer_texture.h
  io/gltf/writer_view.h
  io/lower_case.h
  io/obj/colors.h
  io/obj/material.h
  io/obj/material_text.h
  io/obj/reader.h
  io/obj/scene.h
  io/obj/statements.h
  io/obj/text.h
  io/picture/exr_attributes.h
  io/picture/exr_failures.h
  io/picture/exr_streams.h
  io/picture/openimageio_view.h
  io/stl/ascii.h
  io/stl/reader.h
  io/stl/scene.h
  io/three_mf/mesh.h
  io/three_mf/package.h
  io/three_mf/properties.h
  io/three_mf/scene.h)
list(TRANSFORM private_headers REPLACE "\\." "\\\\." OUTPUT_VARIABLE private_patterns)
list(JOIN private_patterns "|" private_patterns)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/twinray)
file(RELATIVE_PATH to_modules /${CMAKE_INSTALL_BINDIR} /${twinray_module_folder})
set_target_properties(twinray PROPERTIES INSTALL_RPATH "$ORIGIN/${to_modules}")
install(TARGETS twinray RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS twinray_image_codec twinray_scene_importer LIBRARY DESTINATION ${twinray_module_folder})
install(FILES $<TARGET_FILE_DIR:twinray>/pathtracer DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS twinray_core twinray_accel twinray_integrators twinray_check twinray_io EXPORT twinrayTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY core accel integrators check io DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/twinray
        FILES_MATCHING PATTERN "*.h" REGEX "/(${private_patterns})$" EXCLUDE)
install(EXPORT twinrayTargets NAMESPACE twinray:: DESTINATION ${package_folder})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/twinrayConfig.cmake.in twinrayConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(twinrayConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/twinrayConfig.cmake ${PROJECT_BINARY_DIR}/twinrayConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindLibZip.cmake ${CMAKE_CURRENT_LIST_DIR}/Findwebp.cmake
              ${CMAKE_CURRENT_LIST_DIR}/Findblosc.cmake
        DESTINATION ${package_folder})
