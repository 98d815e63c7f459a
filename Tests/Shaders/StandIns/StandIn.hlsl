// Declares the names from Unity's includes that the package's shaders use, so that glslangValidator can compile them.
// unity-shader-names.txt next to this folder lists the names that exist in Unity; a test compares the two.
#ifndef NOWPOSE_STAND_IN_INCLUDED
#define NOWPOSE_STAND_IN_INCLUDED

#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };

#if defined(INSTANCING_ON)
#define UNITY_INSTANCING_ENABLED
#endif
#if defined(STEREO_INSTANCING_ON)
#define UNITY_STEREO_INSTANCING_ENABLED
#endif
#if defined(STEREO_MULTIVIEW_ON)
#define UNITY_STEREO_MULTIVIEW_ENABLED
#endif

// Index of the eye that is drawn.
#if defined(UNITY_SINGLE_PASS_STEREO) || defined(UNITY_STEREO_INSTANCING_ENABLED) || defined(UNITY_STEREO_MULTIVIEW_ENABLED)
#define USING_STEREO_MATRICES
#endif
#if defined(UNITY_STEREO_INSTANCING_ENABLED) || defined(UNITY_STEREO_MULTIVIEW_ENABLED)
static uint unity_StereoEyeIndex;
#else
CBUFFER_START(UnityStereoEyeIndex)
    int unity_StereoEyeIndex;
CBUFFER_END
#endif

// Matrices of the camera and the object.
#if defined(USING_STEREO_MATRICES)
CBUFFER_START(UnityStereoGlobals)
    float4x4 unity_StereoMatrixVP[2];
    float3 unity_StereoWorldSpaceCameraPos[2];
CBUFFER_END
#define unity_MatrixVP unity_StereoMatrixVP[unity_StereoEyeIndex]
#define _WorldSpaceCameraPos unity_StereoWorldSpaceCameraPos[unity_StereoEyeIndex]
#else
CBUFFER_START(UnityPerFrame)
    float4x4 unity_MatrixVP;
    float3 _WorldSpaceCameraPos;
CBUFFER_END
#endif
#define UNITY_MATRIX_VP unity_MatrixVP

// Instances: each has an index in the arrays. In stereo, each object has two consecutive instances, one for each eye.
#if defined(UNITY_INSTANCING_ENABLED) || defined(UNITY_STEREO_INSTANCING_ENABLED)
static uint unity_InstanceID;
#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : SV_InstanceID;
#define UNITY_TRANSFER_INSTANCE_ID(input, output) output.instanceID = input.instanceID
#if defined(UNITY_STEREO_INSTANCING_ENABLED)
#define UNITY_SETUP_INSTANCE_ID(input) { unity_StereoEyeIndex = input.instanceID & 1; unity_InstanceID = input.instanceID >> 1; }
#else
#define UNITY_SETUP_INSTANCE_ID(input) { unity_InstanceID = input.instanceID; }
#endif
#else
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#define UNITY_SETUP_INSTANCE_ID(input)
#endif

#if defined(UNITY_INSTANCING_ENABLED)
#define UNITY_INSTANCING_BUFFER_START(buf) cbuffer UnityInstancing_##buf { struct {
#define UNITY_INSTANCING_BUFFER_END(arr) } arr##Array[2]; };
#define UNITY_DEFINE_INSTANCED_PROP(type, var) type var;
#define UNITY_ACCESS_INSTANCED_PROP(arr, var) arr##Array[unity_InstanceID].var
UNITY_INSTANCING_BUFFER_START(PerDraw0)
    UNITY_DEFINE_INSTANCED_PROP(float4x4, unity_ObjectToWorldArray)
UNITY_INSTANCING_BUFFER_END(unity_Builtins0)
#define UNITY_MATRIX_M UNITY_ACCESS_INSTANCED_PROP(unity_Builtins0, unity_ObjectToWorldArray)
#else
#define UNITY_INSTANCING_BUFFER_START(buf) CBUFFER_START(buf)
#define UNITY_INSTANCING_BUFFER_END(arr) CBUFFER_END
#define UNITY_DEFINE_INSTANCED_PROP(type, var) type var;
#define UNITY_ACCESS_INSTANCED_PROP(arr, var) var
CBUFFER_START(UnityPerDraw)
    float4x4 unity_ObjectToWorld;
CBUFFER_END
#define UNITY_MATRIX_M unity_ObjectToWorld
#endif

// Output of a vertex that selects the eye.
#if defined(UNITY_STEREO_INSTANCING_ENABLED)
#define UNITY_VERTEX_OUTPUT_STEREO uint stereoTargetEyeIndex : SV_RenderTargetArrayIndex;
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) output.stereoTargetEyeIndex = unity_StereoEyeIndex
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = input.stereoTargetEyeIndex
#elif defined(UNITY_STEREO_MULTIVIEW_ENABLED)
#define UNITY_VERTEX_OUTPUT_STEREO float stereoTargetEyeIndex : BLENDWEIGHT0;
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) output.stereoTargetEyeIndex = unity_StereoEyeIndex
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = (uint)input.stereoTargetEyeIndex
#else
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#endif

#endif
