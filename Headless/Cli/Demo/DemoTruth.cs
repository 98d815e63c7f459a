using System.Diagnostics;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;

namespace Nowpose.Cli.Demo;

/// <summary>What only the simulation knows: how the two clocks stand, and where the robot is.</summary>
sealed class DemoTruth(StopwatchControlClock control, SimulatedCell cell, IMotion motion)
{
    /// <summary>The control time of a moment on the headset clock, exactly.</summary>
    public ControlTime ControlAt(HeadsetTime t) =>
        control.AtCount((long)((Int128)t.SinceEpoch.Ticks * Stopwatch.Frequency / TimeSpan.TicksPerSecond));

    /// <summary>Φ, exactly.</summary>
    public ClockOffset OffsetAt(HeadsetTime t) => new(t.SinceEpoch - ControlAt(t).SinceEpoch);

    /// <summary>Joint positions of the real robot at a control time, past or future, one per moving joint.</summary>
    public void JointsAt(ControlTime t, Span<double> positions) => cell.TruthAt(t, positions);

    /// <summary>Which cycle of its motion the robot is in, from 0.</summary>
    public int CycleAt(ControlTime t) => (int)((t - cell.Start).TotalSeconds / motion.CycleSeconds);
}
