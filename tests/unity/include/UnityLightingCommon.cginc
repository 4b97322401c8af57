// A stand-in for Unity's include of this name, written for these tests.
#define _LightColor0 float4(handed_over(light_color[0].rgb), 1)
