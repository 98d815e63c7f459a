namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>What pictures are made of. Milliseconds.</summary>
sealed record SimulationSettings
{
    public int Pictures { get; init; } = 300;

    /// <summary>L_visu while frames are ready in time.</summary>
    public double VisuMs { get; init; } = 40;

    /// <summary>Share of pictures that something is wrong with.</summary>
    public double Spoiled { get; init; } = 0.02;

    /// <summary>Steps of the load from nothing to the greatest; 0 stays at a third of a million vertices.</summary>
    public int LoadSteps { get; init; } = 10;

    /// <summary>How long a frame is in the light, of the display's 16.7.</summary>
    public double LitMs { get; init; } = 4;

    /// <summary>Exposures are up to so long.</summary>
    public double ExposureMs { get; init; } = 8;

    /// <summary>Rolling shutter: how much later the last row is exposed than the first.</summary>
    public double ReadoutMs { get; init; }

    /// <summary>Latency for head motion of a headset that is turned to and fro with its camera; null for a still one.</summary>
    public double? HeadLatencyMs { get; init; }

    /// <summary>After so many pictures the camera stands elsewhere.</summary>
    public int PicturesPerPlace { get; init; } = 50;

    public int Seed { get; init; } = 1;
}
