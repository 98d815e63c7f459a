namespace UnityEngine;

public sealed class SystemInfo
{
    public static string deviceModel => "Stand-in";
    public static string deviceName => "Stand-in 1";
    public static bool supportsAsyncGPUReadback => World.Current.Gpu.ReadbackFrames >= 0;
}
