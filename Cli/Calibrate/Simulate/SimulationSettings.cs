using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Settings of simulated pictures. Times are in ms.</summary>
sealed record SimulationSettings
{
    /// <summary>
    /// Settings with which the paper's Fig. 10 can be reproduced. Lit time and exposure are short, because the standard deviation of L_visu in range
    /// must be below a third of that of an even scatter over a refresh interval, 4.8 ms.
    /// </summary>
    public static SimulationSettings Paper { get; } = new() { LitMs = 4, ExposureMs = 1 };

    public int Pictures { get; init; } = 300;

    /// <summary>L_visu of frames that are ready in time.</summary>
    public double VisuMs { get; init; } = 40;

    /// <summary>The simulated display. If null, a display with <see cref="VisuMs"/> and a nominal rate of 60 Hz is used.</summary>
    public DisplayPipelineSettings Display { get; init; }

    /// <summary>Share of the pictures that have a defect.</summary>
    public double Spoiled { get; init; } = 0.02;

    /// <summary>Number of load steps from zero to the maximum. With 0, the load is constant at 300 000 vertices.</summary>
    public int LoadSteps { get; init; } = 10;

    /// <summary>Number of vertices of the largest load.</summary>
    public int MaxVertices { get; init; } = SweepPlan.MaxVertices;

    /// <summary>Time for which a frame is lit within the display's refresh interval of 16.7 ms.</summary>
    public double LitMs { get; init; } = 4;

    /// <summary>Maximum exposure time.</summary>
    public double ExposureMs { get; init; } = 8;

    /// <summary>
    /// Rate of a video, whose pictures are taken at fixed intervals with the maximum exposure time; null for pictures at random times with exposures
    /// from 1 ms to the maximum.
    /// </summary>
    public double? PicturesPerSecond { get; init; }

    /// <summary>Readout time of the rolling shutter: delay between the exposures of the first and the last row.</summary>
    public double ReadoutMs { get; init; }

    /// <summary>Latency for head motion of a headset that turns left and right with its camera; null for a still headset.</summary>
    public double? HeadLatencyMs { get; init; }

    /// <summary>Number of pictures after which the camera changes its position.</summary>
    public int PicturesPerPlace { get; init; } = 50;

    public int Seed { get; init; } = 1;
}
