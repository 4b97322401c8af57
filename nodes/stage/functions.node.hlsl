// The functions that `patina compile --functions` writes, for an engine that has its own shaders and its own loop over
// lights. [export] gives the name of each function, after the prefix.

/// The surface at this point, as lighting reads it. A cutout surface is not drawn where its alpha is below alphaClip.
[export("lightingSurface")]
LightingSurface exportedSurface() {
    return asLit(lightingSurface());
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
