using System;
using Nowpose.Session;

namespace Nowpose.Recording
{
    /// <summary>How the session does: the numbers of one line, and what they are called.</summary>
    static class StatisticsLine
    {
        static readonly string[] Names =
        {
            "rtt_ms", "l_app_ms", "l_app_p95_ms", "l_visu_ms", "horizon_ms", "render_ms", "hold_error_mm", "error_mm", "reduction",
            "samples", "dropped",
        };

        public static int Count => Names.Length;

        /// <param name="numbers">Filled; NaN where nothing is known.</param>
        public static void Fill(SessionStatistics statistics, double[] numbers)
        {
            numbers[0] = Ms(statistics.RoundTripTime);
            numbers[1] = Ms(statistics.ApplicationLatency);
            numbers[2] = Ms(statistics.ApplicationLatency95);
            numbers[3] = Ms(statistics.VisualisationLatency);
            numbers[4] = Ms(statistics.Horizon);
            numbers[5] = Ms(statistics.RenderTime);
            numbers[6] = statistics.HoldErrorMm ?? double.NaN;
            numbers[7] = statistics.ErrorMm ?? double.NaN;
            numbers[8] = statistics.ErrorReduction ?? double.NaN;
            numbers[9] = statistics.Samples;
            numbers[10] = statistics.Dropped;
        }

        public static void Write(JsonLine line, double[] numbers)
        {
            for (var i = 0; i < Names.Length; i++) line.AddKnown(Names[i], numbers[i]);
        }

        static double Ms(TimeSpan? length) => length?.TotalMilliseconds ?? double.NaN;
    }
}
