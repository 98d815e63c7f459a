using Nowpose.Session;

namespace Nowpose.Cli.Demo;

/// <summary>A headset whose frames are played by the demo's frame loop.</summary>
interface IDemoHeadset : IDisposable
{
    /// <summary>The newest frame; null before the robot is known.</summary>
    DisplayFrame Frame { get; }

    CompensationSession Session { get; }

    /// <summary>Sync exchanges and application latencies of the session so far.</summary>
    DemoLog Log { get; }

    DemoRecording Recording { get; }

    /// <summary>Displayed position of the tool; the origin before the robot is known.</summary>
    ToolPosition Tool { get; }

    /// <summary>Position of the tool without compensation; the origin before the robot is known.</summary>
    ToolPosition HeldTool { get; }

    /// <summary>Number of alarms that were raised because the render time left the constant-latency range.</summary>
    int Alarms { get; }

    /// <summary>Reports the GPU time of the newest finished frame, as a display driver does.</summary>
    void ReportGpuTime(TimeSpan length);

    /// <summary>Plays one frame.</summary>
    /// <param name="seconds">Time since the start, s.</param>
    void Step(double seconds);
}
