// Depth only, with alpha clipping.

[pass("depth-only")] [fragment] [lights("none")] [blend("opaque", "one", "zero")] [blend("cutout", "one", "zero")]
void depthFragment() {
    if (alphaClip) {
        LightingSurface lit = lightingSurface();
        discardIf(lit.alpha < lit.alphaClip);
    }
}
