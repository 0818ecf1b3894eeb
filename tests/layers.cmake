# SPDX-License-Identifier: MIT
# cmake -DROOT=<project> -P layers.cmake: arrows between folders point down, and every source has its test.
# Fails with file:line for an #include against the direction and for a source without a mirrored test. Linking
# cannot tell: all our folders share one include root, and all of Debian's headers lie in /usr/include.
cmake_minimum_required(VERSION 3.25)
if(NOT ROOT)
  message(FATAL_ERROR "layers: say which tree with -DROOT=<project>")
endif()

set(floors core sim hw scenarios)
set(everything core sim hw scenarios tests bench)

# Folders of ours that a floor may include.
set(ours_core core)
set(ours_sim core sim)
set(ours_hw core hw)
set(ours_scenarios core sim hw scenarios)

# A header of the standard library is a bare word: <vector>. Others are allowed by floor.
set(std "[a-z0-9_]+")
set(posix "(sys|net|netinet|arpa|linux|asm)/.*\\.h|(unistd|fcntl|termios|poll|pty|dirent|netdb|signal|pwd|grp|spawn|fnmatch)\\.h")
set(foreign_core "${std}|Eigen/.*|immintrin\\.h")
set(foreign_sim "${foreign_core}|mujoco/.*|box2d/.*|GL/.*|(png|cairo)\\.h|pugixml\\.hpp|Random123/.*")
set(foreign_hw "${foreign_core}|${posix}|asio\\.hpp|asio/.*|(zlib|bzlib|lz4|lz4frame|zstd)\\.h|(ros|rosbag)/.*")
set(foreign_scenarios "${foreign_core}|${posix}|CLI/.*|(yaml-cpp|nlohmann|valijson|spdlog|fmt|SQLiteCpp)/.*|asio\\.hpp|asio/.*|(pugixml\\.hpp|httplib\\.h)")
# The detectors are pure: they print nothing, read no file and start no thread.
set(refused_core "iostream|fstream|filesystem|thread|future")

set(faults "")

# The line on which `text` first stands in `content`.
function(line_of content text result)
  string(FIND "${content}" "${text}" at)
  string(SUBSTRING "${content}" 0 ${at} before)
  string(REGEX MATCHALL "\n" newlines "${before}")
  list(LENGTH newlines count)
  math(EXPR count "${count} + 1")
  set(${result} ${count} PARENT_SCOPE)
endfunction()

# Sets `result` to why the floor may not include the header, or to nothing.
function(judge floor header result)
  set(${result} "" PARENT_SCOPE)
  string(REGEX MATCH "^[^/]+" top "${header}")
  if(header MATCHES "/" AND top IN_LIST everything)
    if(NOT top IN_LIST ours_${floor})
      string(REPLACE ";" ", " allowed "${ours_${floor}}")
      set(${result} "${floor}/ includes \"${header}\" (allowed of ours: ${allowed})" PARENT_SCOPE)
    endif()
  elseif(NOT header MATCHES "^(${foreign_${floor}})$")
    set(${result} "${floor}/ includes <${header}>, which is not among its libraries (tests/layers.cmake)"
      PARENT_SCOPE)
  elseif(refused_${floor} AND header MATCHES "^(${refused_${floor}})$")
    set(${result} "${floor}/ includes <${header}>: it neither prints nor reads files nor starts threads"
      PARENT_SCOPE)
  endif()
endfunction()

function(check_includes floor file)
  file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
  foreach(line IN LISTS lines)
    if(NOT line MATCHES "include[ \t]*[<\"]([^>\"]+)[>\"]")
      set(why "the header of this include is no literal: ${line}")
    else()
      judge(${floor} "${CMAKE_MATCH_1}" why)
    endif()
    if(why)
      file(READ ${ROOT}/${file} content)
      line_of("${content}" "${line}" number)
      list(APPEND faults "${file}:${number}: ${why}")
    endif()
  endforeach()
  set(faults "${faults}" PARENT_SCOPE)
endfunction()

function(check_mirror file)
  if(NOT file MATCHES "\\.cpp$" OR file MATCHES "(^|/)main\\.cpp$")
    return()
  endif()
  string(REGEX REPLACE "\\.cpp$" "_test.cpp" test "tests/${file}")
  if(NOT EXISTS ${ROOT}/${test})
    list(APPEND faults "${file}:1: no mirrored test (expected ${test})")
  endif()
  set(faults "${faults}" PARENT_SCOPE)
endfunction()

set(num_files 0)
foreach(floor IN LISTS floors)
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${floor}/*.cpp ${ROOT}/${floor}/*.hpp ${ROOT}/${floor}/*.h)
  foreach(file IN LISTS files)
    check_includes(${floor} ${file})
    check_mirror(${file})
    math(EXPR num_files "${num_files} + 1")
  endforeach()
endforeach()

# A check that looks at nothing would pass for ever.
if(num_files EQUAL 0)
  message(FATAL_ERROR "layers: no sources below ${ROOT}")
endif()
if(faults)
  list(JOIN faults "\n" text)
  message("${text}")
  list(LENGTH faults num_faults)
  message(FATAL_ERROR "layers: ${num_faults} faults in ${num_files} files")
endif()
message(STATUS "layers: ${num_files} files are clean")
