using System.Diagnostics;
using Nowpose.Gateway.Clock;
using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>The headset's frame loop at 60 fps: read C2, play the frame, keep what is displayed.</summary>
sealed class DemoFrameLoop(DemoSettings settings, DemoHeadset headset, IHeadsetClock clock, DemoTruth truth)
{
    public const int FramesPerSecond = 60;

    readonly TimeSpan _visualisation = TimeSpan.FromMilliseconds(settings.VisualisationMs);

    bool _isScored;

    public DemoFrames Frames { get; } = new(settings.Robot.MovingJoints.Count, (int)(settings.Seconds * FramesPerSecond) + 1);

    /// <param name="report">Takes the seconds done and what to say about them.</param>
    public void Run(Action<double, Func<string>> report, CancellationToken cancel)
    {
        var begin = clock.Now;
        var beginCount = Stopwatch.GetTimestamp();
        var count = (int)(settings.Seconds * FramesPerSecond);
        for (var i = 0; i < count && !cancel.IsCancellationRequested; i++)
        {
            PreciseWait.Until(beginCount + (long)((double)i / FramesPerSecond * Stopwatch.Frequency));
            ShowFrame(begin);
            report((i + 1) / (double)FramesPerSecond, () => DemoProgress.Describe(headset.Session, clock.Now));
        }
    }

    void ShowFrame(HeadsetTime begin)
    {
        var start = clock.Now;
        BeginScoring(start, start - begin);
        var bytes = GC.GetAllocatedBytesForCurrentThread();
        var count = Stopwatch.GetTimestamp();
        headset.Step((start - begin).TotalSeconds);
        var cpu = Stopwatch.GetElapsedTime(count);
        bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
        var frame = headset.Frame;
        var model = headset.Session.Clock.ModelAt(start);
        var offsetErrorUs = model.IsKnown ? (model.OffsetAt(start) - truth.OffsetAt(start)).TotalMicroseconds : double.NaN;
        Frames.Add(frame == null ? [] : frame.Joints, frame == null ? [] : frame.HeldJoints, new DemoFrames.Row(
            start - begin, start, truth.ControlAt(start + _visualisation), frame?.DisplayTime, model,
            frame?.State ?? PoseState.Incomplete, offsetErrorUs, headset.Tool, headset.HeldTool, cpu.TotalMicroseconds, bytes));
    }

    // What the runtime measures itself shall be of the frames that are scored.
    void BeginScoring(HeadsetTime start, TimeSpan elapsed)
    {
        if (_isScored || elapsed < DemoScore.WarmUp || headset.Session?.Clock.ModelAt(start).State != ClockState.Synchronised) return;
        _isScored = true;
        headset.Session.RestartErrorRun();
    }
}
