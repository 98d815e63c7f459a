namespace Nowpose.Latency
{
    /// <summary>Source of a render time. Times of different sources are not comparable.</summary>
    public enum RenderTimeSourceKind
    {
        /// <summary>The render time is not measured.</summary>
        None,

        /// <summary>GPU time of the frame as reported by the headset's runtime.</summary>
        DisplayGpuTime,

        /// <summary>GPU time of the frame as reported by the engine, which may include different work.</summary>
        EngineGpuTime,

        /// <summary>Time from the trigger of the render job until the application detects that the GPU has finished it.</summary>
        GpuCompletion,

        /// <summary>CPU time of the camera. Unverified: it does not include the time of the GPU.</summary>
        CameraCpu,
    }
}
