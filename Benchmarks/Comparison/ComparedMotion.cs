using Nowpose.Cli.Studies;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>A kind of motion, with the sampling and transmission of its samples.</summary>
/// <param name="Name">Name in tables.</param>
/// <param name="Motion">Creates the motion from a seed.</param>
public sealed record ComparedMotion(string Name, Func<int, AxisMotion> Motion, StudySettings Settings)
{
    /// <summary>Gets the RMS error over all seeds, divided by the RMS error of hold.</summary>
    public double Ratio(ComparedPredictor candidate, IEnumerable<int> seeds)
    {
        var (predicted, held) = (0.0, 0.0);
        foreach (var seed in seeds)
        {
            var result = PredictionStudy.Run(Motion(seed), Settings with { Seed = seed }, candidate.Create);
            predicted += result.Rms * result.Rms;
            held += result.RmsHold * result.RmsHold;
        }
        return Math.Sqrt(predicted / held);
    }
}
