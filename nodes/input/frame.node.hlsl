// What is the same for a whole object or a whole picture, and values that an artist gives by hand.

/// Seconds since the start, for movement; and the waves most often made of it.
///
/// test: Time(2, 1.5) == 3
/// test: Time(1, 0.5235987755982988).sine == 0.5
/// test: Time(2, 0.5235987755982988).cosine == 0.5
[node("Input/Time")]
float Time(
    float speed = 1,                            ///< 2 runs twice as fast
    [hidden] [unit("s")] float seconds = time,  ///< the engine's clock
    out float sine,                             ///< sine of the result
    out float cosine                            ///< cosine of the result
) {
    float scaled = seconds * speed;
    sine = sin(scaled);
    cosine = cos(scaled);
    return scaled;
}

/// Where this pixel is in the picture: (0, 0) is the upper left corner, (1, 1) the lower right one.
///
/// test: ScreenUV(float2(0.25, 0.75)) == float2(0.25, 0.75)
[node("Input/Screen UV")]
float2 ScreenUV(
    [hidden] float2 position = screenUV  ///< the pixel
) {
    return position;
}

/// Where the camera is, in the world.
///
/// test: CameraPosition(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Camera Position")]
float3 CameraPosition(
    [hidden] [unit("m")] float3 position = cameraPositionWS  ///< the camera
) {
    return position;
}

/// Where the object's origin is, in the world: different for each copy of an object, so a seed for variety.
///
/// test: ObjectPosition(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Object Position")]
float3 ObjectPosition(
    [hidden] [unit("m")] float3 position = objectPositionWS  ///< the object's origin
) {
    return position;
}

/// A number or vector with a name, used in several places.
///
/// test: Constant(0.5) == 0.5
/// test: Constant(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Constant")]
floatN Constant(
    floatN value = 0  ///< the value
) {
    return value;
}

/// A colour with a name, used in several places.
///
/// test: Color(float4(0.1, 0.2, 0.3, 1)) == float4(0.1, 0.2, 0.3, 1)
/// test: Color(float4(0.1, 0.2, 0.3, 0.5)).alpha == 0.5
[node("Input/Color")]
float4 Color(
    [color] float4 color = 1,  ///< linear, with opacity
    out float alpha            ///< the opacity alone
) {
    alpha = color.a;
    return color;
}
