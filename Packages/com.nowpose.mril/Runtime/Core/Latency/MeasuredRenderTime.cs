namespace Nowpose.Latency
{
    /// <summary>Which numbers are a measured render time, Δt_render: 0.001 to 1000 ms, wherever one is measured, logged or read.</summary>
    /// <remarks>Drivers that do not measure report zero; a readback that waited out a pause reports seconds.</remarks>
    static class MeasuredRenderTime
    {
        const double LeastMs = 0.001, GreatestMs = 1000;

        /// <param name="ms">Milliseconds; NaN is none.</param>
        public static bool Is(double ms) => ms >= LeastMs && ms <= GreatestMs;

        /// <exception cref="InputException">Out of range, or not a number; named as the column of the files that have it.</exception>
        internal static double RequireMs(double ms) => SettingRange.Require(ms, LeastMs, GreatestMs, "render_ms", "ms");
    }
}
