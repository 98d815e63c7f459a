using System.Globalization;
using System.Text.RegularExpressions;
using Nowpose.Cli.Demo;
using Nowpose.Gateway.Plants;
using Nowpose.Motion;

namespace Nowpose.Benchmarks.Links;

/// <summary>The true clock and motion of a simulated gateway on this machine. All processes share the monotonic counter.</summary>
sealed partial class LinkTruth : IDemoTruth
{
    readonly PickAndPlaceMotion _motion;
    readonly ControlTime _motionStart;
    readonly long _interceptNs;
    readonly double _skew;

    /// <param name="clockLine">Parameters of the clock, as printed by the gateway.</param>
    /// <param name="motionStart">Start of the motion in control time, ns.</param>
    /// <param name="robot">Name of an included robot, such as "youbot", or path of a URDF.</param>
    public LinkTruth(string clockLine, string motionStart, string robot)
    {
        _motion = new PickAndPlaceMotion(RobotFiles.Load(robot));
        _motionStart = ControlTime.FromNanoseconds(long.Parse(motionStart, CultureInfo.InvariantCulture));
        var line = ClockLine().Match(clockLine);
        if (!line.Success) throw new InputException($"the gateway's clock line '{clockLine}' is not 'c1_ns = A + B * monotonic_ns'");
        _interceptNs = long.Parse(line.Groups["A"].Value, CultureInfo.InvariantCulture);
        _skew = double.Parse(line.Groups["B"].Value, CultureInfo.InvariantCulture) - 1;
    }

    public ControlTime ControlAt(HeadsetTime t) =>
        ControlTime.FromNanoseconds(_interceptNs + t.Nanoseconds + (long)Math.Round(t.Nanoseconds * _skew));

    public void JointsAt(ControlTime t, Span<double> positions) => _motion.At(MotionSecondsAt(t), positions);

    public double MotionSecondsAt(ControlTime t) => (t - _motionStart).Ticks / (double)TimeSpan.TicksPerSecond;

    public int CycleAt(ControlTime t) => (int)(MotionSecondsAt(t) / _motion.CycleSeconds);

    [GeneratedRegex(@"^c1_ns = (?<A>-?\d+) \+ (?<B>\S+) \* monotonic_ns$")]
    private static partial Regex ClockLine();
}
