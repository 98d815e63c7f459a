using System;
using Nowpose.Session;

namespace Nowpose.Recording
{
    /// <summary>Converts a displayed error to the numbers of a record, and to the fields of a line.</summary>
    static class ErrorNumbers
    {
        static readonly string[] Names =
        {
            "frames", "rms", "p95", "hold_rms", "hold_p95", "reduction", "reduction_uncertainty", "truth_uncertainty", "clock_uncertainty",
        };

        public static int Count => Names.Length;

        /// <param name="numbers">Array to fill; unknown values become NaN.</param>
        public static void Fill(DisplayedError? error, Span<double> numbers)
        {
            numbers.Slice(0, Count).Fill(double.NaN);
            if (!error.HasValue) return;
            var known = error.Value;
            numbers[0] = known.Frames;
            numbers[1] = known.Rms;
            numbers[2] = known.P95;
            numbers[3] = known.HoldRms;
            numbers[4] = known.HoldP95;
            numbers[5] = known.Reduction ?? double.NaN;
            numbers[6] = known.ReductionUncertainty ?? double.NaN;
            numbers[7] = known.TruthUncertainty;
            numbers[8] = known.ClockUncertainty;
        }

        public static bool AreKnown(ReadOnlySpan<double> numbers) => !double.IsNaN(numbers[0]);

        public static void Write(JsonLine line, ReadOnlySpan<double> numbers)
        {
            for (var i = 0; i < Count; i++) line.AddKnown(Names[i], numbers[i]);
        }
    }
}
