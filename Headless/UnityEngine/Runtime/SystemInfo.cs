namespace UnityEngine;

public sealed class SystemInfo
{
    public static string deviceModel => "Stand-in";
    public static bool supportsAsyncGPUReadback => World.Current.Gpu.ReadbackFrames >= 0;
}
