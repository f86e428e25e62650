// Part of every sanitized program: libraries stay loaded to the end. LeakSanitizer looks then, and can neither name
// nor suppress what belongs to a driver or a layer that is gone.
extern "C" int dlclose(void*) noexcept {
    return 0;
}
