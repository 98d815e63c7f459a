namespace Nowpose.Latency
{
    /// <summary>What a render time was measured with. Times of different sources must not be compared.</summary>
    public enum RenderTimeSourceKind
    {
        /// <summary>Nothing measures.</summary>
        None,

        /// <summary>Time the GPU worked on the frame, as the headset's runtime reports it.</summary>
        DisplayGpuTime,

        /// <summary>The same as the engine reports it: it need not count the same work.</summary>
        EngineGpuTime,

        /// <summary>From the trigger of the render job until the program learns that the GPU has finished it.</summary>
        GpuCompletion,

        /// <summary>Time the processor spent on the camera: unverified, for it does not see how long the GPU takes.</summary>
        CameraCpu,
    }
}
