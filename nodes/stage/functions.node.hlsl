// The functions that `patina compile --functions` writes, for an engine that has its own shaders and its own loop over
// lights. [export] gives the name of each function, after the prefix.

/// The surface at this point, as lighting reads it. A surface that is clipped is not drawn where its alpha is below
/// alphaClip.
[export("lightingSurface")]
LightingSurface exportedSurface() {
    LightingSurface surface = lightingSurface();
    bool hides = surface.alpha < surface.alphaClip;
    surface = asLit(surface);
    if (alphaClip) {
        if (premultiplied) { surface.alphaClip = hides ? 2 : 0; }
    }
    return surface;
}

/// The light that one light adds to LightSum.direct.
[export("direct")]
float3 exportedDirect(LightingSurface surface, Light light) {
    return direct(surface, light);
}

/// LightSum.indirect: all light that does not come from a single light.
[export("indirect")]
float3 exportedIndirect(LightingSurface surface) {
    return indirect(surface);
}

/// The colour of the surface, linear.
[export("final")]
float3 exportedFinal(LightingSurface surface, LightSum sum) {
    return final(surface, sum);
}
