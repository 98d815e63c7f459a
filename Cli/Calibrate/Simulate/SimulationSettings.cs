using Nowpose.Latency.Sweep;
using Nowpose.Simulation;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Settings of simulated pictures. Times in ms.</summary>
sealed record SimulationSettings
{
    public int Pictures { get; init; } = 300;

    /// <summary>L_visu while frames are ready in time.</summary>
    public double VisuMs { get; init; } = 40;

    /// <summary>The simulated display; null for one with <see cref="VisuMs"/> and the real rate of displays sold as 60 Hz.</summary>
    public DisplayPipelineSettings Display { get; init; }

    /// <summary>Share of the pictures that have a defect.</summary>
    public double Spoiled { get; init; } = 0.02;

    /// <summary>Number of load steps from none to the maximum; 0 keeps a third of a million vertices.</summary>
    public int LoadSteps { get; init; } = 10;

    /// <summary>Number of vertices of the largest load.</summary>
    public int MaxVertices { get; init; } = SweepPlan.MaxVertices;

    /// <summary>Time for which a frame is lit, of the display's 16.7 ms interval.</summary>
    public double LitMs { get; init; } = 4;

    /// <summary>Maximum exposure time.</summary>
    public double ExposureMs { get; init; } = 8;

    /// <summary>Rolling shutter: delay of the last row's exposure after the first row's.</summary>
    public double ReadoutMs { get; init; }

    /// <summary>Latency for head motion of a headset that is turned to and fro with its camera; null for a still headset.</summary>
    public double? HeadLatencyMs { get; init; }

    /// <summary>Number of pictures after which the camera changes its position.</summary>
    public int PicturesPerPlace { get; init; } = 50;

    public int Seed { get; init; } = 1;
}
