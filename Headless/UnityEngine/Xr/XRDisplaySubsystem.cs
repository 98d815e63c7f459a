namespace UnityEngine.XR;

public class XRDisplaySubsystem : IntegratedSubsystem<XRDisplaySubsystemDescriptor>
{
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
