// What a pass may call: the functions that the graph provides. Their parameters are semantics of the lighting graph;
// a body is what happens when the lighting graph leaves that output out.

/// The surface that the material and its workflow make of this point.
[slot]
LightingSurface lighting_surface();

/// The lighting graph for one light.
[slot]
float3 direct(LightingSurface surface, [per_light] Light light);

/// The lighting graph for all light that comes from no single light.
[slot]
float3 indirect(LightingSurface surface) {
    return float3(0);
}

/// The lighting graph's last word.
[slot]
float3 final(LightingSurface surface, LightSum sum) {
    return sum.direct + sum.indirect + surface.emission;
}
