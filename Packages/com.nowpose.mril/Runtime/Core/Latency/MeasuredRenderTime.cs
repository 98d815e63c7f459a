namespace Nowpose.Latency
{
    /// <summary>Checks that a number is a measured render time Δt_render: 0.001 to 1000 ms, for measuring, logging and reading.</summary>
    /// <remarks>Drivers that do not measure report zero; a readback that spans a pause reports seconds.</remarks>
    static class MeasuredRenderTime
    {
        const double MinMs = 0.001, MaxMs = 1000;

        /// <param name="ms">Render time in ms; NaN is not a measured time.</param>
        public static bool Is(double ms) => ms >= MinMs && ms <= MaxMs;

        /// <exception cref="InputException">Out of range, or not a number; the message uses the name of the column in files.</exception>
        internal static double RequireMs(double ms) => SettingRange.Require(ms, MinMs, MaxMs, "render_ms", "ms");
    }
}
