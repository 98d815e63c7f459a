namespace UnityEngine.XR;

public class XRDisplaySubsystem : IntegratedSubsystem<XRDisplaySubsystemDescriptor>
{
    public enum ReprojectionMode
    {
        Unspecified = 0,
        PositionAndOrientation = 1,
        OrientationOnly = 2,
        None = 3,
    }

    public struct XRRenderPass
    {
        public bool shouldFillOutDepth;
    }

    public ReprojectionMode reprojectionMode { get; set; }

    /// <summary>Whether the display requests depth; null before its first frame.</summary>
    internal bool? AsksForDepth { get; set; }

    public int GetRenderPassCount() => AsksForDepth.HasValue ? 1 : 0;

    public void GetRenderPass(int renderPassIndex, out XRRenderPass renderPass)
    {
        if (renderPassIndex < 0 || renderPassIndex >= GetRenderPassCount()) throw new System.IndexOutOfRangeException(nameof(renderPassIndex));
        renderPass = new XRRenderPass { shouldFillOutDepth = AsksForDepth == true };
    }

    public bool TryGetAppGPUTimeLastFrame(out float gpuTimeLastFrame)
    {
        var time = World.Current.Gpu.DisplayGpuTime;
        gpuTimeLastFrame = time ?? 0;
        return running && time.HasValue;
    }

    public bool TryGetDisplayRefreshRate(out float displayRefreshRate)
    {
        var rate = World.Current.Gpu.DisplayHz;
        displayRefreshRate = rate ?? 0;
        return running && rate.HasValue;
    }
}

public class XRDisplaySubsystemDescriptor : IntegratedSubsystemDescriptor<XRDisplaySubsystem>
{
}
