# What of the libraries is installed, by the packages that it goes into: libpenpose0, libpenpose-dev, python3-penpose.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

add_dependencies(installed penpose_c)
install(TARGETS penpose_c
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libpenpose0 NAMELINK_COMPONENT libpenpose-dev)

# The archives are no part of an ordinary build; asking for the libraries builds them.
option(PENPOSE_INSTALL_CPP "Install the C++ libraries, penpose::core and its like" ON)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/penpose)
install(FILES penpose.h penpose.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT libpenpose-dev)
# Found wherever the prefix goes.
file(RELATIVE_PATH PENPOSE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(penpose.pc.in ${CMAKE_CURRENT_BINARY_DIR}/penpose.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/penpose.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT libpenpose-dev)

if(PENPOSE_INSTALL_CPP)
  get_property(archives GLOBAL PROPERTY PENPOSE_ARCHIVES)
  set_target_properties(${archives} PROPERTIES EXCLUDE_FROM_ALL OFF)
  add_dependencies(installed ${archives})
  install(TARGETS ${archives} EXPORT penpose ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libpenpose-dev)
  install(EXPORT penpose NAMESPACE penpose:: FILE penpose-targets.cmake DESTINATION ${config_dir} COMPONENT libpenpose-dev)
  configure_package_config_file(penpose-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/penpose-config.cmake
                                INSTALL_DESTINATION ${config_dir})
  write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/penpose-config-version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/penpose-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/penpose-config-version.cmake
          DESTINATION ${config_dir} COMPONENT libpenpose-dev)
  # Headers where they include each other from.
  foreach(folder core firmware_io replay)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/penpose/${folder}
            COMPONENT libpenpose-dev FILES_MATCHING PATTERN "*.h" PATTERN "internal" EXCLUDE PATTERN "absent" EXCLUDE)
  endforeach()
endif()

set(PENPOSE_PYTHON_DIR lib/python3/dist-packages CACHE STRING "Where Python modules are installed, below the prefix")
install(DIRECTORY ${PROJECT_SOURCE_DIR}/ui/python/penpose DESTINATION ${PENPOSE_PYTHON_DIR} COMPONENT python3-penpose
        FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE)
