using System.Diagnostics;
using System.Globalization;
using Nowpose.Cli.Demo;
using Nowpose.Gateway.Clock;
using Nowpose.Kinematics;
using Nowpose.Session;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Compares the poses in a headset's frames with the true poses of the robot at the times at which the frames were displayed.</summary>
sealed class PlantScore(IPlantTruth plant, RobotModel robot, TimeSpan visualisation)
{
    const double FramesPerSecond = 60;

    readonly ToolKinematics _kinematics = new(robot);
    readonly double[] _truth = new double[robot.MovingJoints.Count];
    readonly List<double> _shown = [], _held = [], _clock = [], _bound = [], _light = [], _sample = [];
    int _played;

    public double Rms => Root(_shown);
    public double HoldRms => Root(_held);
    public double Reduction => 1 - Rms / HoldRms;

    /// <summary>Fraction of the played frames whose pose was current.</summary>
    public double CurrentShare => (double)_shown.Count / _played;

    /// <summary>95th percentile of the absolute error of the headset's estimate of the plant's clock, in ms.</summary>
    public double ClockErrorMs => P95(_clock);

    /// <summary>95th percentile of the error bound of this estimate, in ms. It increases with the load of the machine.</summary>
    public double ClockBoundMs => P95(_bound);

    /// <summary>Fraction of the frames in which the true error of the clock was within the error bound.</summary>
    public double BoundHolds => _clock.Zip(_bound).Count(pair => pair.First <= pair.Second) / (double)_clock.Count;

    /// <summary>
    /// Median over the frames of the largest difference between the newest sample of a joint and its true position at the sample's time stamp, in rad
    /// or m.
    /// </summary>
    public double SampleError => _sample.Order().ElementAt(_sample.Count / 2);

    /// <summary>95th percentile of the absolute error of the display time for which a pose was predicted, in ms.</summary>
    public double LightErrorMs => P95(_light);

    /// <summary>Plays frames on the calling thread for the given time, and evaluates those whose pose is current.</summary>
    public void Play(CompensationSession session, IHeadsetClock clock, TimeSpan length)
    {
        var start = Stopwatch.GetTimestamp();
        for (; _played < length.TotalSeconds * FramesPerSecond; _played++)
        {
            PreciseWait.Until(start + (long)(_played / FramesPerSecond * Stopwatch.Frequency));
            var now = clock.Now;
            var frame = session.Tick(now);
            if (frame.State == PoseState.Current) Score(frame, session.Clock.ModelAt(now), now);
        }
    }

    public override string ToString() => string.Create(CultureInfo.InvariantCulture,
        $"{_shown.Count} of {_played} frames, tool {HoldRms:0.0} -> {Rms:0.00} mm RMS ({100 * Reduction:0.0} %), "
        + $"clock P95 {ClockErrorMs:0.000} ms, bound P95 {ClockBoundMs:0.000} ms "
        + $"(holds in {100 * BoundHolds:0.0} %), light P95 {LightErrorMs:0.000} ms, samples {SampleError:0.0000} rad");

    void Score(DisplayFrame frame, in ClockModel clock, HeadsetTime now)
    {
        var light = plant.TimeAt(now + visualisation);
        plant.TruthAt(robot, light, _truth);
        var tool = _kinematics.At(_truth);
        _shown.Add(tool.DistanceMm(_kinematics.At(frame.Joints)));
        _held.Add(tool.DistanceMm(_kinematics.At(frame.HeldJoints)));
        _clock.Add(Math.Abs((clock.ToControl(now) - plant.TimeAt(now)).TotalMilliseconds));
        _bound.Add(clock.ErrorBound.TotalMilliseconds);
        plant.TruthAt(robot, frame.DisplayTime.Value - frame.Horizon.Value, _truth);
        var largest = 0.0;
        for (var i = 0; i < _truth.Length; i++) largest = Math.Max(largest, Math.Abs(frame.HeldJoints[i] - _truth[i]));
        _sample.Add(largest);
        _light.Add(Math.Abs((frame.DisplayTime.Value - light).TotalMilliseconds));
    }

    static double Root(List<double> values) => Math.Sqrt(values.Sum(value => value * value) / values.Count);

    static double P95(List<double> values) => values.Order().ElementAt((int)(0.95 * (values.Count - 1)));
}
