# boxcar_embed(target file...): puts files into a program, so that it runs from any folder.
#
#   boxcar_embed(boxcar samples/assets/fruits.jpg)   ->   extern "C" const unsigned char boxcar_fruits_jpg[], boxcar_fruits_jpg_end[];
#
# The assembler reads the bytes, so a large file costs no compile time.
function(boxcar_embed target)
    foreach(file IN LISTS ARGN)
        cmake_path(ABSOLUTE_PATH file)
        cmake_path(GET file FILENAME name)
        string(MAKE_C_IDENTIFIER "${target}_${name}" symbol)
        set(source ${CMAKE_CURRENT_BINARY_DIR}/${symbol}.S)
        file(CONFIGURE OUTPUT ${source} CONTENT [[
.section .rodata
.balign 16
.global @symbol@
.global @symbol@_end
@symbol@: .incbin "@file@"
@symbol@_end: .byte 0
.section .note.GNU-stack, "", %progbits
]] @ONLY)
        set_source_files_properties(${source} PROPERTIES OBJECT_DEPENDS ${file})
        target_sources(${target} PRIVATE ${source})
    endforeach()
endfunction()
