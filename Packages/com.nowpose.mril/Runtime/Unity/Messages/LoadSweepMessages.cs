using System;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;

namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages, status messages and results of a load sweep.</summary>
    static class LoadSweepMessages
    {
        public static string StoppedWithLog(string path) => $"load sweep stopped; its log is {path}";
        /// <param name="part">What was destroyed.</param>
        public static string Destroyed(string component, string part) =>
            $"load sweep '{component}' stopped, because its {part} was destroyed; assign another one and sweep again. The log of this sweep is kept";

        public static string GeneratorOff(string generator) =>
            $"load generator '{generator}' is switched off; the sweep needs it, so switch it on and sweep again";

        public static string Done(string verdict, string path) => $"load sweep done: {verdict}; log: {path}";

        public const string WaitingForClock = "waiting for the clock; then the code flashes\n4 to 30 times a second; do not look at it\n"
            + "if you are sensitive to flashing light";
        public const string Stopped = "sweep stopped", Judging = "sweep done, evaluating";

        public static string Building(int vertices) => $"building {vertices} vertices";

        public static string Showing(SweepRun run, SweepPlan plan) =>
            $"load {run.Index + 1} of {plan.Loads.Count}: {run.Vertices} vertices";

        public static string Begun(SweepPlan plan, string path) => FormattableString.Invariant(
            $"load sweep started: {plan.Loads.Count} loads up to {plan.MaxLoad} vertices; it takes {plan.Duration.TotalSeconds:0} s plus the time to build ")
            + $"the loads; its log is {path}";

        public static string Changed(ConditionMismatch change) =>
            $"load sweep stopped: {change.Label} changed from '{change.Calibrated}' to '{change.Actual}' during the sweep; "
            + "sweep again without changing it";
    }
}
