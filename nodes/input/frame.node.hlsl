// Values that are constant for an object or a frame, and named constants.

/// Seconds since the start, for animation, with their sine and cosine.
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

/// The position of this pixel on the screen: (0, 0) is the upper left corner, (1, 1) the lower right one.
///
/// test: ScreenUV(float2(0.25, 0.75)) == float2(0.25, 0.75)
[node("Input/Screen UV")]
float2 ScreenUV(
    [hidden] float2 position = screenUV  ///< position of the pixel
) {
    return position;
}

/// The position of the camera in world space.
///
/// test: CameraPosition(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Camera Position")]
float3 CameraPosition(
    [hidden] [unit("m")] float3 position = cameraPositionWS  ///< position of the camera
) {
    return position;
}

/// The position of the object's origin in world space. It differs for each copy, so it can seed variations.
///
/// test: ObjectPosition(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Object Position")] [also("Object", "ObjectPivot")]
float3 ObjectPosition(
    [hidden] [unit("m")] float3 position = objectPositionWS  ///< the object's origin
) {
    return position;
}

/// A named number or vector that several nodes can use.
///
/// test: Constant(0.5) == 0.5
/// test: Constant(float3(1, 2, 3)) == float3(1, 2, 3)
[node("Input/Constant")] [also("Float", "Integer", "Slider", "Value", "Vector1", "Vector2", "Vector3", "Vector4")]
floatN Constant(
    floatN value = 0  ///< the value
) {
    return value;
}

/// A named colour that several nodes can use.
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
