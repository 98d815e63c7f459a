using System.Diagnostics;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;

namespace Nowpose.Cli.Demo;

/// <summary>The true values of a cell in this process. Both clocks read the same hardware counter.</summary>
sealed class DemoTruth(StopwatchControlClock control, SimulatedCell cell) : IDemoTruth
{
    public ControlTime ControlAt(HeadsetTime t) =>
        control.AtCount((long)((Int128)t.SinceEpoch.Ticks * Stopwatch.Frequency / TimeSpan.TicksPerSecond));

    public void JointsAt(ControlTime t, Span<double> positions) => cell.TruthAt(t, positions);

    public double MotionSecondsAt(ControlTime t) => (t - cell.Start).TotalSeconds;

    public int CycleAt(ControlTime t) => (int)(MotionSecondsAt(t) / cell.Motion.CycleSeconds);
}
