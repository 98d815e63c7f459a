using System.Diagnostics;
using Nowpose.Latency;
using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>Runs the headset's frame loop at the rate of its display. Reads C2, plays each frame and records the displayed poses.</summary>
/// <param name="waitUntil">Waits until the headset clock reaches the given time.</param>
sealed class DemoFrameLoop(DemoSettings settings, IDemoHeadset headset, IHeadsetClock clock, IDemoTruth truth, Action<HeadsetTime> waitUntil)
{
    readonly DemoDisplay _display = new(settings);

    readonly DemoBodies _bodies = settings.Motion.Work is { } work ? new DemoBodies(work) : null;

    readonly DemoSignals _signals = settings.Motion.Work is { } work ? new DemoSignals(work) : null;

    bool _isScored;

    public DemoFrames Frames { get; } = new(settings.Robot.MovingJoints.Count, (int)(settings.Seconds * DemoDisplay.FramesPerSecond) + 1);

    /// <summary>The recorded poses of the cell's objects; null if the cell has none.</summary>
    public DemoBodies Bodies => _bodies;

    /// <summary>The recorded values of the cell's signals; null if the cell has none.</summary>
    public DemoSignals Signals => _signals;

    /// <param name="report">Receives the finished seconds and a status text.</param>
    public void Run(Action<double, Func<string>> report, CancellationToken cancel)
    {
        var begin = clock.Now;
        // Includes only whole frames. The margin of half a frame avoids rounding errors.
        var end = ((int)(settings.Seconds * DemoDisplay.FramesPerSecond) - 0.5) / DemoDisplay.FramesPerSecond;
        while (_display.NextStart.TotalSeconds < end && !cancel.IsCancellationRequested)
        {
            var due = _display.NextStart;
            waitUntil(begin + due);
            _display.Render();
            ShowFrame(begin, due);
            report(_display.NextStart.TotalSeconds, () => ConsoleProgress.Describe(headset.Session, clock.Now));
        }
    }

    void ShowFrame(HeadsetTime begin, TimeSpan due)
    {
        var start = clock.Now;
        BeginScoring(start, start - begin);
        if (_display.DriverTime is TimeSpan gpu) headset.ReportGpuTime(gpu);
        _bodies?.Follow(headset.Session);
        _signals?.Follow(headset.Session);
        var bytes = GC.GetAllocatedBytesForCurrentThread();
        var count = Stopwatch.GetTimestamp();
        headset.Step((start - begin).TotalSeconds);
        var cpu = Stopwatch.GetElapsedTime(count);
        bytes = GC.GetAllocatedBytesForCurrentThread() - bytes;
        var frame = headset.Frame;
        _bodies?.Add(frame);
        _signals?.Add();
        var model = headset.Session.Clock.ModelAt(start);
        var offsetErrorUs = model.IsKnown ? (model.OffsetAt(start) - truth.OffsetAt(start)).TotalMicroseconds : double.NaN;
        Frames.Add(frame == null ? [] : frame.Joints, frame == null ? [] : frame.HeldJoints, new DemoFrames.Row(
            start - begin, start, truth.ControlAt(start + _display.Visualisation), frame?.DisplayTime, model,
            frame?.State ?? PoseState.Incomplete, offsetErrorUs, headset.Tool, headset.HeldTool, cpu.TotalMicroseconds, bytes,
            frame?.Range ?? RangeState.Unknown, _display.Rendered ?? default, start - begin - due));
    }

    // Restarts the runtime's own statistics, so that they cover the scored frames only.
    void BeginScoring(HeadsetTime start, TimeSpan elapsed)
    {
        if (_isScored || elapsed < DemoScore.WarmUp || headset.Session?.Clock.ModelAt(start).State != ClockState.Synchronised) return;
        _isScored = true;
        headset.Session.RestartErrorRun();
    }
}
