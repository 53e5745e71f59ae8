# Debian packages of what is installed: one a component, and only those components that this build has. `cpack` in the build
# folder makes them; ui/install/make_packages.sh does so for every machine. Included last, when all install rules are known.
include(GNUInstallDirs)
get_cmake_property(components COMPONENTS)
set(CPACK_COMPONENTS_ALL "")
foreach(component penpose penpose-nogui libpenpose0 libpenpose-dev python3-penpose)
  if(component IN_LIST components)
    list(APPEND CPACK_COMPONENTS_ALL ${component})
    set(all "")
    if(component STREQUAL "penpose-nogui")
      set(all EXCLUDE_FROM_ALL)
    endif()
    install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${component} RENAME copyright
            COMPONENT ${component} ${all})
  endif()
endforeach()

set(PENPOSE_MAINTAINER "The penpose authors <penpose@penpose.org>" CACHE STRING "Who answers for the packages")
if(CMAKE_LIBRARY_ARCHITECTURE MATCHES "^aarch64")
  set(machine arm64)
elseif(CMAKE_LIBRARY_ARCHITECTURE MATCHES "^arm.*gnueabihf$")
  set(machine armhf)
elseif(CMAKE_LIBRARY_ARCHITECTURE MATCHES "^x86_64")
  set(machine amd64)
else()
  execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE machine OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME penpose)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${PENPOSE_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${PENPOSE_MAINTAINER}")
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE ${machine})
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/finish_packages.cmake)
set(CPACK_PENPOSE_DATE ${PENPOSE_DATE})

# penpose_package(COMPONENT SECTION SUMMARY "PARAGRAPH" [DEPENDS package...]). Names and versions are those of Debian 12; a
# test holds them against what the programs ask for.
function(penpose_package component section summary text)
  cmake_parse_arguments(PARSE_ARGV 4 arg "ANY" "" "DEPENDS;RECOMMENDS;CONFLICTS;PROVIDES")
  string(TOUPPER CPACK_DEBIAN_${component} prefix)
  set(${prefix}_PACKAGE_NAME ${component} PARENT_SCOPE)
  set(${prefix}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(${prefix}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
  string(REPLACE ";" ", " depends "${arg_DEPENDS}")
  set(${prefix}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  foreach(relation RECOMMENDS CONFLICTS PROVIDES)
    string(REPLACE ";" ", " packages "${arg_${relation}}")
    set(${prefix}_PACKAGE_${relation} "${packages}" PARENT_SCOPE)
  endforeach()
  set(${prefix}_PACKAGE_REPLACES "${arg_CONFLICTS}" PARENT_SCOPE)
  if(arg_ANY)
    set(${prefix}_PACKAGE_ARCHITECTURE all PARENT_SCOPE)
  endif()
endfunction()

set(c_library "libc6 (>= 2.36)" "libgcc-s1 (>= 3.5)" "libstdc++6 (>= 12)")
set(solver "libmeshoptimizer2d (>= 0.18+dfsg)" "libdraco7 (>= 1.5.5+dfsg)"  # tinygltf is compiled in
  "libpng16-16 (>= 1.6.2-1)" "libjpeg62-turbo (>= 1.3.1)" "libwebp7 (>= 1.2.4)")
set(headers libglm-dev libxxhash-dev libmeshoptimizer-dev libdraco-dev libpugixml-dev libpng-dev libjpeg-dev libwebp-dev)  # what find_package(penpose) and the C++ headers want
get_target_property(mesh_links core_mesh LINK_LIBRARIES)
list(APPEND solver "zlib1g (>= 1:1.1.4)")
list(APPEND headers zlib1g-dev)
if(mesh_links MATCHES "OpenMesh")
  list(APPEND solver "libopenmesh1 (>= 9.0)")
  list(APPEND headers libopenmesh-dev)
endif()
get_target_property(sound_links core_sound LINK_LIBRARIES)
if(sound_links MATCHES "SNDFILE")
  set(sounds "libsndfile1 (>= 1.0.20)")
endif()
get_target_property(speech_links ui_speech LINK_LIBRARIES)
if(speech_links MATCHES "pocketsphinx")
  list(APPEND sounds "libpocketsphinx3 (>= 0.8+5prealpha+1)" "libsphinxbase3 (>= 0.8+5prealpha+1)")
  set(english pocketsphinx-en-us)
endif()
if(TARGET ui_portal)
  get_target_property(portal_links ui_portal LINK_LIBRARIES)
  if(portal_links MATCHES "DBUS")
    set(desktop "libdbus-1-3 (>= 1.9.14)")
  endif()
endif()
set(tablets "libevdev2 (>= 0.9.1)" "libhidapi-hidraw0 (>= 0.8.0~rc1+git20140201.3a66d4e+dfsg)" "libusb-1.0-0 (>= 2:1.0.23~)")
penpose_package(penpose graphics "pose and rig 3D characters by drawing"
"A line is drawn where a feature of a character is, and another where it should
be: penpose finds the values of the rig that bring the one to the other. It
works with blend shapes, with joints, and with controls that were sketched on a
bare mesh, and reads pen tablets directly.
.
With the window and the drawing of pictures." DEPENDS ${c_library} ${solver} ${tablets} "libepoxy0 (>= 1.5.10)" "libdrm2 (>= 2.4.114)" "libpugixml1v5 (>= 1.13)" ${sounds} ${desktop}
  "libfontconfig1 (>= 2.12.6)" "libsdl2-2.0-0 (>= 2.26.0)" "libstb0 (>= 0.0~git20180212.15.e6afb9c)" libegl1 libgl1 fonts-dejavu-core RECOMMENDS libgl1-mesa-dri fonts-inter ffmpeg ${english} CONFLICTS penpose-nogui)
penpose_package(penpose-nogui graphics "pose and rig 3D characters by drawing, without a window"
"A line is drawn where a feature of a character is, and another where it should
be: penpose finds the values of the rig that bring the one to the other. It
works with blend shapes, with joints, and with controls that were sketched on a
bare mesh, and reads pen tablets directly.
.
The commands alone, for boards and farms: without the window, and so without
SDL and OpenGL. The processor draws the pictures." DEPENDS ${c_library} ${solver} ${tablets} "libpugixml1v5 (>= 1.13)"
  ${sounds} RECOMMENDS ${english} CONFLICTS penpose)
penpose_package(libpenpose0 libs "pose and rig 3D characters by drawing, the library"
"The solver of penpose for other programs, in C: rigs, curves, targets,
sketched deformers, recorded sessions, and pen tablets from their raw reports."
  DEPENDS ${c_library} ${solver})
penpose_package(libpenpose-dev libdevel "pose and rig 3D characters by drawing, for programs"
"The headers of penpose's library in C and in C++, and what CMake needs to find
them." DEPENDS "libpenpose0 (= ${PROJECT_VERSION})" ${headers})
penpose_package(python3-penpose python "pose and rig 3D characters by drawing, for Python"
"penpose's library for Python 3, with arrays of NumPy in and out." ANY DEPENDS "libpenpose0 (>= ${PROJECT_VERSION})" python3 python3-numpy)
set(CPACK_DEBIAN_LIBPENPOSE0_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/triggers)
set(CPACK_DEBIAN_PYTHON3-PENPOSE_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_LIST_DIR}/python/postinst ${CMAKE_CURRENT_LIST_DIR}/python/prerm)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS_POLICY ">=")
include(CPack)
