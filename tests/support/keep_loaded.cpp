// Only in builds with the address sanitizer: libraries that are loaded while a program runs (Vulkan drivers and layers)
// stay loaded, so that the leak check at its end can say whose memory is left, and tests/leaks.supp can name them.
extern "C" int dlclose(void*) noexcept {
    return 0;
}
