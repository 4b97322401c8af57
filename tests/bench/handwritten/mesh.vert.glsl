// The mesh in world space.
#version 450

layout(set = 0, binding = 1, std140) uniform Camera
{
    mat4 worldToClip;
    mat4 worldToView;
    vec3 cameraPositionWS;
    float viewIsOrthographic;
    vec3 cameraForwardWS;
    float shadowBias;
    mat4 clipToWorld;
    vec2 clipPlanes;
    float shadowNormalBias;
};

layout(set = 0, binding = 4, std140) uniform Object
{
    mat4 objectToWorld;
    mat4 worldToObject;
};

layout(location = 0) in vec3 inPosition;
layout(location = 1) in vec3 inNormal;
layout(location = 0) out vec3 position;
layout(location = 1) out vec3 normal;

void main()
{
    vec4 world = objectToWorld * vec4(inPosition, 1.0);
    position = world.xyz;
    normal = normalize((vec4(inNormal, 0.0) * worldToObject).xyz);
    gl_Position = worldToClip * world;
}
