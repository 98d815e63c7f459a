namespace UnityEngine;

public sealed class SystemInfo
{
    public static bool supportsAsyncGPUReadback => World.Current.Gpu.ReadbackFrames >= 0;
}
