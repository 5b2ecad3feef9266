# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
#
# Run by the build: bundles SOURCE (web/) in BUILD with the programs NPM and ESBUILD and writes BUILD/web_assets.cpp, which embeds the
# result; or, where something is missing, one that says what, and BUILD/missing.txt.
set(oldest_esbuild 0.17)  # Debian 12's; nobody tried older ones
set(licenses "")

function(write_if_changed path content)
  set(previous "")
  if(EXISTS ${path})
    file(READ ${path} previous)
  endif()
  if(NOT previous STREQUAL content)
    file(WRITE ${path} "${content}")
  endif()
endfunction()

function(give_up reason)
  message(STATUS "no HTML reports: ${reason}")
  file(WRITE ${BUILD}/missing.txt "${reason}\n")
  file(WRITE ${BUILD}/web_assets.cpp "// Made by web_assets.cmake.
#include \"core/types/error.h\"
#include \"eval/report/html/web_assets.h\"

namespace hydrabench {

WebAssets webAssets() {
  throw InputError(\"this program was built without HTML reports: ${reason}\");
}

}  // namespace hydrabench
")
endfunction()

file(MAKE_DIRECTORY ${BUILD})
foreach(program IN ITEMS NPM ESBUILD)
  if(NOT ${program})
    string(TOLOWER ${program} name)
    give_up("${name} was not found; install it (scripts/setup does), configure and build again")
    return()
  endif()
endforeach()
execute_process(COMMAND ${ESBUILD} --version OUTPUT_VARIABLE esbuild_version OUTPUT_STRIP_TRAILING_WHITESPACE)
if(esbuild_version VERSION_LESS oldest_esbuild)
  give_up("esbuild ${esbuild_version} is too old, ${oldest_esbuild} or later is needed; install it, configure and build again")
  return()
endif()

# Packages are installed anew only when the lock file changes.
file(SHA256 ${SOURCE}/package-lock.json lock)
set(installed "")
if(EXISTS ${BUILD}/installed.txt)
  file(READ ${BUILD}/installed.txt installed)
endif()
if(NOT installed STREQUAL lock)
  file(REMOVE ${BUILD}/installed.txt)
  file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json DESTINATION ${BUILD})
  execute_process(COMMAND ${NPM} ci --ignore-scripts --omit=dev --no-audit --no-fund --fetch-retries=1 --fetch-timeout=20000
    WORKING_DIRECTORY ${BUILD} OUTPUT_FILE ${BUILD}/npm.log ERROR_FILE ${BUILD}/npm.log RESULT_VARIABLE failed TIMEOUT 300)
  if(failed)
    give_up("npm could not fetch its packages (${BUILD}/npm.log); with network, configure and build again")
    return()
  endif()
  file(WRITE ${BUILD}/installed.txt ${lock})
endif()

# What is in the bundle, and what made it: esbuild comes from the system, so its version can differ between builds of one commit.
set(packages "")
foreach(package IN ITEMS three uplot)
  file(READ ${BUILD}/node_modules/${package}/package.json description)
  string(JSON version GET "${description}" version)
  file(READ ${BUILD}/node_modules/${package}/LICENSE license)
  string(APPEND licenses "${package} ${version}\n\n${license}\n\n")
  list(APPEND packages "${package} ${version}")
endforeach()
list(JOIN packages ", " packages)
file(WRITE ${BUILD}/licenses.txt "${licenses}")

execute_process(
  COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=${BUILD}/node_modules
    ${ESBUILD} ${SOURCE}/main.js --bundle --minify --format=iife --target=es2020 --charset=utf8 --legal-comments=eof
    "--banner:js=/* Front end of hydrabench's reports with ${packages}, bundled by esbuild ${esbuild_version}. */"
    --outfile=${BUILD}/report.js
  OUTPUT_FILE ${BUILD}/esbuild.log ERROR_FILE ${BUILD}/esbuild.log RESULT_VARIABLE failed)
if(failed)
  file(READ ${BUILD}/esbuild.log log)
  message(FATAL_ERROR "esbuild cannot bundle ${SOURCE}:\n${log}")
endif()

file(READ ${BUILD}/node_modules/uplot/dist/uPlot.min.css library_style)
file(READ ${SOURCE}/style.css style)
file(WRITE ${BUILD}/report.css "${library_style}\n${style}")
file(COPY ${SOURCE}/page.html DESTINATION ${BUILD})

# The assembler takes the files in; a time in the source makes sure that the compiler runs again (and no cache answers for it).
set(assembly "")
set(views "")
foreach(asset IN ITEMS page:page.html style:report.css script:report.js licenses:licenses.txt)
  string(REPLACE ":" ";" asset ${asset})
  list(GET asset 0 name)
  list(GET asset 1 file)
  file(SHA256 ${BUILD}/${file} hash)
  string(APPEND assembly "asm(R\"(
  .pushsection .rodata  # ${hash}
  .global hydrabench_web_${name}, hydrabench_web_${name}_end
hydrabench_web_${name}: .incbin \"${BUILD}/${file}\"
hydrabench_web_${name}_end: .byte 0
  .popsection
)\");
extern \"C\" const char hydrabench_web_${name}[], hydrabench_web_${name}_end[];
")
  string(APPEND views "          {hydrabench_web_${name}, static_cast<std::size_t>(hydrabench_web_${name}_end - hydrabench_web_${name})},\n")
endforeach()
file(REMOVE ${BUILD}/missing.txt)
write_if_changed(${BUILD}/web_assets.cpp "// Made by web_assets.cmake.
#include <cstddef>

#include \"eval/report/html/web_assets.h\"

${assembly}
namespace hydrabench {

WebAssets webAssets() {
  return {
${views}  };
}

}  // namespace hydrabench
")
file(TOUCH ${BUILD}/web_assets.cpp)
