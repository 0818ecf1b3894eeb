# SPDX-License-Identifier: MIT
# Installs scanbed::core into a folder of its own and builds and runs a project that finds it there.
#   cmake -DROOT=... -DWORK=... -DCXX=... -P core_installs.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}\n${output}")
  endif()
endfunction()

# What was built stays, so that the next run is quick; what is installed is made anew. United as in the presets: a third
# of the time.
file(REMOVE_RECURSE ${WORK}/prefix ${WORK}/consumer)
run(${CMAKE_COMMAND} -S ${ROOT} -B ${WORK}/core -G Ninja -DCMAKE_CXX_COMPILER=${CXX} -DSCANBED_CORE_ONLY=ON
  -DCMAKE_UNITY_BUILD=ON -DCMAKE_INSTALL_PREFIX=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/core --target install)
run(${CMAKE_COMMAND} -S ${ROOT}/tests/consumer -B ${WORK}/consumer -G Ninja -DCMAKE_CXX_COMPILER=${CXX}
  -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/consumer)
