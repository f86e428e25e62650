# boxcar_add_shaders(target manifest): compiles the shaders that the manifest lists, at build time, into the target.
#
#   boxcar_add_shaders(passes hlsl/passes.cfg)
#
#   #include "passes_shaders.h"
#   boxcar::passes_shaders::Find("shaders/sat_pass.ps.TAPS=4")    // an EmbeddedShader: SPIR-V and layout
#
# What links the target finds its shaders too: others draw with quad.vs.
#
# A change in an .hlsl, an .hlsli or the manifest compiles again what depends on it, and nothing else.
function(boxcar_add_shaders target manifest)
    cmake_path(ABSOLUTE_PATH manifest NORMALIZE)
    set(name ${target}_shaders)
    set(dir ${CMAKE_CURRENT_BINARY_DIR}/${name})
    add_custom_command(
        OUTPUT ${dir}/${name}.cpp
        BYPRODUCTS ${dir}/${name}.h
        COMMAND bxc build ${manifest} -o ${dir} --embed ${name} --depfile ${dir}/${name}.d
        DEPENDS bxc ${manifest}
        DEPFILE ${dir}/${name}.d
        COMMENT "Compiling the shaders of ${target}"
        VERBATIM)
    target_sources(${target} PRIVATE ${dir}/${name}.cpp)
    target_include_directories(${target} PUBLIC ${dir})
    target_link_libraries(${target} PRIVATE layout)
endfunction()
