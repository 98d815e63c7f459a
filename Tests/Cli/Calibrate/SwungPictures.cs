using Nowpose.Cli.Calibrate.Vlc;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Simulates the readings of pictures of a headset that swings back and forth with its camera, without rendering the pictures.</summary>
sealed record SwungPictures
{
    const double RefreshMs = 1000 / 59.94;

    public double LatencyMs { get; init; }

    public double VisuMs { get; init; } = 40;

    /// <summary>Time over which the middles of the exposures are distributed, ms.</summary>
    public double LitMs { get; init; } = 4;

    /// <summary>Mean time of the exposures relative to the middle of the light, ms.</summary>
    public double ExposureOffsetMs { get; init; }

    public double AmplitudePx { get; init; } = 150;

    public double PeriodSeconds { get; init; } = 3;

    /// <summary>Standard deviation of both positions, px.</summary>
    public double NoisePx { get; init; } = 0.3;

    /// <summary>Time by which the camera exposes the rows of the headset's code later than the rows of the control code, ms.</summary>
    public double LaterMs { get; init; }

    /// <summary>
    /// Motion of the hologram in the picture divided by the motion of the control code; not 1 if their distances to the camera differ.
    /// </summary>
    public double Scale { get; init; } = 1;

    /// <summary>Distortion of lens or display: change of the distance between the codes per px² of the position.</summary>
    public double Distortion { get; init; }

    public int Count { get; init; } = 300;

    public int Seed { get; init; } = 1;

    /// <summary>Returns the readings of pictures at about 30 pictures per second. The headset's code has a resolution of 1 ms.</summary>
    public IReadOnlyList<PictureResult> Take()
    {
        var random = new Random(Seed);
        double Noise() => NoisePx * (random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5) * 2;
        double PlaceAt(double ms) => AmplitudePx * Math.Sin(2 * Math.PI * ms / 1000 / PeriodSeconds);
        return [.. Enumerable.Range(0, Count).Select(i =>
        {
            var start = 1000 + 2 * i * RefreshMs;
            var light = start + VisuMs;
            var middle = light + ExposureOffsetMs + LitMs * (random.NextDouble() - 0.5);
            double control = PlaceAt(middle - LaterMs) + Noise();
            double shown = PlaceAt(light - LatencyMs);
            var headset = 200 + Scale * shown + Distortion * shown * shown + Noise();
            return new PictureResult($"p{i}", middle, Math.Floor(start), middle - Math.Floor(start) - 0.5, null)
            {
                Places = new CodePlaces((640 + control, 360 + 0.2 * control), (640 + headset, 360 + 0.2 * headset), LaterMs),
            };
        })];
    }
}
