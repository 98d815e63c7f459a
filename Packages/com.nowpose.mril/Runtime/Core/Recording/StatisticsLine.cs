using System;
using Nowpose.Session;
using Nowpose.Session.Hindcast;

namespace Nowpose.Recording
{
    /// <summary>The statistics of a session as the numbers of one line, and the names of these numbers.</summary>
    /// <remarks>
    /// The order is: numbers of the session, the reason why the errors are withheld, the tool's error over the last ten seconds and over the run, and
    /// each joint's error.
    /// </remarks>
    sealed class StatisticsLine
    {
        static readonly string[] Names =
        {
            "rtt_ms", "l_app_ms", "l_app_p95_ms", "l_visu_ms", "horizon_ms", "render_ms", "samples", "dropped", "current_share",
        };

        /// <summary>Number of values before the first error: the named values, and the reason.</summary>
        static readonly int BeforeErrors = Names.Length + 1;

        string[] _joints = Array.Empty<string>();

        /// <summary>Returns the required number of values.</summary>
        /// <param name="joints">Maximum number of joints with an error.</param>
        public static int CountFor(int joints) => BeforeErrors + (2 + joints) * ErrorNumbers.Count;

        /// <param name="numbers">Array to fill; unknown values become NaN.</param>
        public void Fill(SessionStatistics statistics, Span<double> numbers)
        {
            numbers[0] = Ms(statistics.RoundTripTime);
            numbers[1] = Ms(statistics.ApplicationLatency);
            numbers[2] = Ms(statistics.ApplicationLatency95);
            numbers[3] = Ms(statistics.VisualisationLatency);
            numbers[4] = Ms(statistics.Horizon);
            numbers[5] = Ms(statistics.RenderTime);
            numbers[6] = statistics.Samples;
            numbers[7] = statistics.Dropped;
            numbers[8] = statistics.CurrentShare ?? double.NaN;
            numbers[9] = (double)statistics.ErrorWithheld;
            ErrorNumbers.Fill(statistics.ToolError, Block(numbers, 0));
            ErrorNumbers.Fill(statistics.ToolErrorOfRun, Block(numbers, 1));
            // The joints do not change, so their names are read only once, when the first record is filled.
            if (_joints.Length != statistics.JointErrors.Count) _joints = NamesOf(statistics);
            for (var i = 0; i < _joints.Length; i++) ErrorNumbers.Fill(statistics.JointErrors[i].Error, Block(numbers, 2 + i));
        }

        public void Write(JsonLine line, Span<double> numbers)
        {
            for (var i = 0; i < Names.Length; i++) line.AddKnown(Names[i], numbers[i]);
            if (WithheldErrors.WordsOf((ErrorWithheldReason)numbers[9]) is { } withheld) line.Add("error_withheld", withheld);
            Write(line, "tool_mm", Block(numbers, 0));
            Write(line, "tool_of_run_mm", Block(numbers, 1));
            line.Open("joint_errors", '[');
            for (var i = 0; i < _joints.Length; i++)
            {
                var error = Block(numbers, 2 + i);
                if (!ErrorNumbers.AreKnown(error)) continue;
                line.OpenElement().Add("joint", _joints[i]);
                ErrorNumbers.Write(line, error);
                line.Close('}');
            }
            line.Close(']');
        }

        static void Write(JsonLine line, string name, ReadOnlySpan<double> error)
        {
            if (!ErrorNumbers.AreKnown(error)) return;
            line.Open(name, '{');
            ErrorNumbers.Write(line, error);
            line.Close('}');
        }

        static Span<double> Block(Span<double> numbers, int index) => numbers.Slice(BeforeErrors + index * ErrorNumbers.Count, ErrorNumbers.Count);

        static string[] NamesOf(SessionStatistics statistics)
        {
            var names = new string[statistics.JointErrors.Count];
            for (var i = 0; i < names.Length; i++) names[i] = statistics.JointErrors[i].Joint;
            return names;
        }

        static double Ms(TimeSpan? length) => length?.TotalMilliseconds ?? double.NaN;
    }
}
