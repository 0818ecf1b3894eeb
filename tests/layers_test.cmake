# SPDX-License-Identifier: MIT
# cmake -DTREE=<scratch folder> -P layers_test.cmake: layers.cmake passes a good tree and names each fault of
# a bad one.
cmake_minimum_required(VERSION 3.25)
if(NOT TREE)
  message(FATAL_ERROR "layers_test: give a scratch folder with -DTREE=<folder>")
endif()

# Runs the check over a tree in which the good files and `file` with `content` lie; fails the test unless the
# check fails with `expected` in its output, or passes where `expected` is PASS.
function(expect file content expected)
  file(REMOVE_RECURSE ${TREE})
  file(WRITE ${TREE}/core/scan/scan.hpp "#include <vector>\n#include <Eigen/Core>\n")
  file(WRITE ${TREE}/core/scan/scan.cpp "#include \"core/scan/scan.hpp\"\n")
  file(WRITE ${TREE}/tests/core/scan/scan_test.cpp "#include <gtest/gtest.h>\n")
  file(WRITE ${TREE}/scenarios/command/main.cpp "#include <CLI/CLI.hpp>\n#include \"hw/a.hpp\"\n#include \"sim/a.hpp\"\n")
  file(WRITE ${TREE}/${file} "${content}")
  execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${TREE} -P ${CMAKE_CURRENT_LIST_DIR}/layers.cmake
    RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(expected STREQUAL PASS)
    if(NOT code EQUAL 0)
      message(FATAL_ERROR "layers refuses a good tree (${file}):\n${output}")
    endif()
    return()
  endif()
  string(FIND "${output}" "${expected}" at)
  if(code EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "layers: expected failure with '${expected}', exit code is ${code}:\n${output}")
  endif()
endfunction()

expect(core/a.hpp "#include <cmath>\n" PASS)
expect(sim/a.hpp "#include <mujoco/mujoco.h>\n#include \"core/scan/scan.hpp\"\n" PASS)
expect(hw/a.hpp "#include <zlib.h>\n#  include <sys/stat.h>\n#include <unistd.h>\n" PASS)
expect(tests/sim/a_test.cpp "#include \"hw/a.hpp\"\n#include <gtest/gtest.h>\n" PASS)

expect(core/a.hpp "// x;y [z]\n\n#include \"sim/world/world.hpp\"\n" "core/a.hpp:3: core/ includes \"sim/world/world.hpp\"")
expect(core/a.hpp "#include <mujoco/mujoco.h>\n" "core/a.hpp:1: core/ includes <mujoco/mujoco.h>")
expect(core/a.hpp "\n#include <spdlog/spdlog.h>\n" "core/a.hpp:2: core/ includes <spdlog/spdlog.h>")
expect(core/a.hpp "#include <iostream>\n" "core/a.hpp:1: core/ includes <iostream>")
expect(core/a.hpp "#include \"scan.hpp\"\n" "core/a.hpp:1: core/ includes <scan.hpp>")
expect(sim/a.hpp "  # include \"hw/recording/carmen_log.hpp\"\n" "sim/a.hpp:1: sim/ includes")
expect(sim/a.hpp "#include <unistd.h>\n" "sim/a.hpp:1: sim/ includes <unistd.h>")
expect(hw/a.hpp "#include \"scenarios/run/runner.hpp\"\n" "hw/a.hpp:1: hw/ includes")
expect(hw/a.hpp "#include <nlohmann/json.hpp>\n" "hw/a.hpp:1: hw/ includes <nlohmann/json.hpp>")
expect(scenarios/a.hpp "#include \"tests/support/fake.hpp\"\n" "scenarios/a.hpp:1: scenarios/ includes")
expect(scenarios/a.hpp "#include SOME_MACRO\n" "scenarios/a.hpp:1: the header of this include is no literal")
expect(hw/serial/port.cpp "#include <vector>\n" "hw/serial/port.cpp:1: no mirrored test (expected tests/hw/serial/port_test.cpp)")

file(REMOVE_RECURSE ${TREE})
file(MAKE_DIRECTORY ${TREE})
execute_process(COMMAND ${CMAKE_COMMAND} -DROOT=${TREE} -P ${CMAKE_CURRENT_LIST_DIR}/layers.cmake
  RESULT_VARIABLE code OUTPUT_QUIET ERROR_QUIET)
if(code EQUAL 0)
  message(FATAL_ERROR "layers passes a tree without sources")
endif()
