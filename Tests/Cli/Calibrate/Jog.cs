using System.Globalization;
using Nowpose.Simulation;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Simulates a filmed jog: positions of robot and hologram in pixels, each of them with noise.</summary>
sealed record Jog(double LagMs)
{
    public int Seed { get; init; } = 1;
    public double Period { get; init; } = 2;
    public double Amplitude { get; init; } = 150;
    public double Seconds { get; init; } = 10;

    /// <summary>Time for which the hologram stays at each position, ms; 0 if it moves continuously.</summary>
    public double SamplingMs { get; init; }

    public double Scale { get; init; } = 1;

    /// <summary>Standard deviation of the noise, pixels.</summary>
    public double Noise { get; init; } = 1;

    /// <summary>Pictures per second.</summary>
    public double Fps { get; init; } = 60;

    /// <summary>Whether the robot moves at a constant speed between the ends instead of sinusoidally.</summary>
    public bool IsTriangle { get; init; }

    public IEnumerable<string> Lines()
    {
        var random = new Random(Seed);
        double phase = random.NextDouble(), taken = random.NextDouble();
        double Place(double t)
        {
            var sine = Math.Sin(2 * Math.PI * (t / Period + phase));
            return Amplitude * (IsTriangle ? Math.Asin(sine) * 2 / Math.PI : sine);
        }
        yield return "t_s,robot_px,hologram_px";
        for (var i = 0; i < Seconds * Fps; i++)
        {
            double t = i / Fps, shown = t - LagMs / 1000, interval = SamplingMs / 1000;
            if (interval > 0) shown = (Math.Floor(shown / interval + taken) - taken) * interval;
            double robot = 640 + Place(t) + Noise * random.NextNormal(), hologram = 500 + Scale * Place(shown) + Noise * random.NextNormal();
            yield return string.Create(CultureInfo.InvariantCulture, $"{t:0.######},{robot:0.###},{hologram:0.###}");
        }
    }
}
