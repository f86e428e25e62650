// Part of every sanitized program: its options, so that it needs none in the environment, wherever it is started
// from.

extern "C" {

// Libraries stay loaded to the end. LeakSanitizer looks then, and can neither name nor suppress what belongs to a
// driver or a layer that is gone.
int dlclose(void*) noexcept {
    return 0;
}

const char* __asan_default_options() {
    // Freed memory waits in a short quarantine, so that tests of how much is resident measure the program.
    return "detect_leaks=1:quarantine_size_mb=32";
}

const char* __ubsan_default_options() {
    return "print_stacktrace=1:halt_on_error=1";
}

const char* __lsan_default_options() {
    return "print_suppressions=0";
}

// Leaks of libraries that are not ours: a part of a function's, a file's or a library's name.
//
//   libVkLayer_khronos_validation  of Debian 12 (1.3.239) keeps the state of shader modules and descriptors of
//                                  destroyed devices
//   libvulkan_lvp                  (lavapipe of Mesa 22) keeps some names of the passes that it compiled
const char* __lsan_default_suppressions() {
    return "leak:libVkLayer_khronos_validation.so\n"
           "leak:libvulkan_lvp.so\n";
}

}  // extern "C"
