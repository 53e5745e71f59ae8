# Run by cpack between installing and packing: what Debian's policy asks of files that `cmake --install` leaves as they are.
# Man pages are compressed (section 12.3), and every package has a changelog (12.7). Times do not show, so that the same
# sources give the same packages.
find_program(gzip gzip REQUIRED)
execute_process(COMMAND ${CMAKE_COMMAND} -E env LC_ALL=C date -u -R -d "${CPACK_PENPOSE_DATE}" OUTPUT_VARIABLE date
                OUTPUT_STRIP_TRAILING_WHITESPACE)
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(root ${CPACK_TEMPORARY_DIRECTORY}/${component})
  file(GLOB pages ${root}/usr/share/man/man1/*.1)
  foreach(page IN LISTS pages)
    execute_process(COMMAND ${gzip} -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  set(log ${root}/usr/share/doc/${component}/changelog)
  file(WRITE ${log} "penpose (${CPACK_PACKAGE_VERSION}) bookworm; urgency=medium

  * Release ${CPACK_PACKAGE_VERSION}; what changed is told by CHANGELOG.md in the sources.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
  execute_process(COMMAND ${gzip} -9nf ${log} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
