struct Stored {
    [target("first", "rgba8")] float4 first;
    [target("second", "rgba8")] int second;
    [target("third", "rgba8")] float4 third[2];
};

[pass("mine")] [vertex]
float3 mineVertex(float3 position = positionWS) {
    return position;
}
[pass("mine")] [fragment]
Stored mineFragment(float3 position = positionWS) {
    Stored made; return made;
}

[pass("other")] [vertex]
float4 otherVertex(float3 position = positionWS) {
    return float4(position, 1);
}
[pass("other")] [fragment]
bool otherFragment() {
    return true;
}
[semantic("vertex")]
Light sun(float3 position = positionWS) {
    return lightAt(0, position);
}
[gives("positionWS", "mine")]
float height() {
    return 1;
}
[builtin("frontFacing")] float side;

[semantic("pixel")] float viewDirWS() {
    return 1;
}
