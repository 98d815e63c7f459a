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

        /// <summary>CPU time of the camera, without the time of the GPU. Not verified as a measure of the render time.</summary>
        CameraCpu,
    }

    /// <summary>
    /// Checks whether a number can be a measured render time Δt_render: 0.001 to 1000 ms. Used when measuring, logging and reading.
    /// </summary>
    /// <remarks>Drivers that do not measure report zero; a readback that spans a pause reports seconds.</remarks>
    static class MeasuredRenderTime
    {
        const double MinMs = 0.001, MaxMs = 1000;

        /// <param name="ms">Render time in ms; NaN is not a measured time.</param>
        public static bool Is(double ms) => ms >= MinMs && ms <= MaxMs;

        /// <exception cref="InputException">The value is out of range or not a number; the message uses the name of the column in files.</exception>
        internal static double RequireMs(double ms) => SettingRange.Require(ms, MinMs, MaxMs, "render_ms", "ms");
    }
}
