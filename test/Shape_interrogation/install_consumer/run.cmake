# Installs the package below WORK, then configures, builds and runs the project there.

set(prefix ${WORK}/prefix)
set(build ${WORK}/build)
file(REMOVE_RECURSE ${WORK})

function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what} failed (${status}):\n${out}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

run("The installation" ${CMAKE_COMMAND} --install ${PACKAGE_BUILD} --prefix ${prefix}
  --config ${CONFIG})

# What is installed must not look back at where it was built.
file(GLOB_RECURSE configurations ${prefix}/*.cmake)
if(NOT configurations)
  message(FATAL_ERROR "No CMake configuration was installed below ${prefix}.")
endif()
foreach(configuration IN LISTS configurations)
  file(READ ${configuration} text)
  foreach(directory IN ITEMS ${PACKAGE_SOURCE} ${PACKAGE_BUILD})
    string(FIND "${text}" "${directory}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${configuration} mentions ${directory}, where the package was built.")
    endif()
  endforeach()
endforeach()

run("The project's configuration" ${CMAKE_COMMAND} -S ${PROJECT} -B ${build} -G ${GENERATOR}
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CXX_COMPILER})
run("The project's build" ${CMAKE_COMMAND} --build ${build})
run("The project's program" ${build}/consumer)
if(NOT output STREQUAL "1/9\n")
  message(FATAL_ERROR "The project's program was to print 1/9, and printed:\n${output}")
endif()
