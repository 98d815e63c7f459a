using System.Globalization;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;

namespace Nowpose.Unity.Calibration
{
    /// <summary>Status texts of a load sweep. They allocate, so they are created only when the status changes.</summary>
    static class SweepWords
    {
        public const string WaitingForClock = "waiting for the clock", Stopped = "sweep stopped", Judging = "sweep done, evaluating";

        public static string Building(int vertices) => Of("building {0} vertices", vertices);

        public static string Showing(SweepRun run, SweepPlan plan) =>
            Of("load {0} of {1}: {2} vertices", run.Index + 1, plan.Loads.Count, run.Vertices);

        public static string Begun(SweepPlan plan, string path) => Of(
            "load sweep of {0} loads up to {1} vertices, {2:0} s and the time to build them, to {3}",
            plan.Loads.Count, plan.MaxLoad, plan.Duration.TotalSeconds, path);

        public static string Changed(ConditionMismatch change) => Of(
            "load sweep stopped: {0} changed from '{1}' to '{2}' during the sweep; do not change it and sweep again",
            change.Label, change.Calibrated, change.Actual);

        static string Of(string format, params object[] values) => string.Format(CultureInfo.InvariantCulture, format, values);
    }
}
