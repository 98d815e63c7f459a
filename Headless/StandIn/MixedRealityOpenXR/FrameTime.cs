namespace Microsoft.MixedReality.OpenXR;

public enum FrameTime
{
    OnUpdate = 0,
    OnBeforeRender,
}
