namespace UnityEngine.Rendering;

public enum RenderingThreadingMode
{
    MultiThreaded = 2,
    NativeGraphicsJobs = 4,
}
