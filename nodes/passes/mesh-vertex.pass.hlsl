// The vertex stage of every pass that draws meshes for the camera, and what a vertex stage reads of a draw. Without a
// fragment function this file is no rendering path.

/// The vertex in world space, with the 1 that objectToWorld keeps in w.
[semantic("vertex")]
float4 wholePositionWS(float3 position = positionOS) {
    return mul(objectToWorld, float4(position, 1));
}

// There is one expression for the position on the screen, so that a pass that tests for equal depth finds what another
// pass has written.
[pass("forward")] [pass("forward-base")] [pass("forward-add")] [pass("directional-base")] [pass("directional-add")]
[pass("vertex")] [pass("depth-only")] [pass("depth-normals")] [pass("gbuffer")] [pass("gbuffer-extended")]
[pass("gbuffer-ldr")] [pass("gbuffer-shadowmask")] [pass("deferred-local")] [pass("extended-local")]
[pass("ldr-local")] [pass("shadowmask-local")] [vertex]
float4 meshVertex(float4 position = wholePositionWS) {
    return mul(worldToClip, position);
}

/// Index of the drawn instance. It selects the properties and matrices of the instance (compiler/lower/instances.h).
[builtin("instanceIndex")] int instanceIndex;
/// Index of the vertex that the vertex stage computes.
[builtin("vertexIndex")] int vertexIndex;
