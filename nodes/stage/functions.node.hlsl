// What an engine calls that draws by shaders of its own, in a loop of its own over its own lights: the functions that
// `patina compile --functions` writes. [export] says under which name, behind the prefix.

/// The surface of this point, as its lighting takes it. A cutout surface is not drawn where its alpha is below alphaClip.
[export("lightingSurface")]
LightingSurface exportedSurface() {
    return asLit(lightingSurface());
}

/// What one light adds to LightSum.direct.
[export("direct")]
float3 exportedDirect(LightingSurface surface, Light light) {
    return direct(surface, light);
}

/// LightSum.indirect: all light that comes from no single light.
[export("indirect")]
float3 exportedIndirect(LightingSurface surface) {
    return indirect(surface);
}

/// The colour of the surface, linear.
[export("final")]
float3 exportedFinal(LightingSurface surface, LightSum sum) {
    return final(surface, sum);
}
