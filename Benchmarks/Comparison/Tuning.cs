using System.Globalization;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Comparison;

/// <summary>
/// Finds the competitors' constants: those with the minimum geometric mean of the errors under all conditions, with the tuning seeds.
/// </summary>
/// <remarks>Optimises one constant after another on a grid with a factor of √2, until the error no longer decreases or after six rounds.</remarks>
static class Tuning
{
    const int MaxRounds = 6;
    const int StepsEachWay = 6;

    // Errors within this factor count as equal. Of several values with equal errors, the one nearest to the current value is used. Otherwise, a
    // constant that has no effect would grow without limit.
    const double AsGood = 1.0005;

    public static void Run(TextWriter to)
    {
        to.WriteLine($"Tuned on seeds {string.Join(", ", ComparedMotions.TuningSeeds)}; RMS over hold:");
        Report(to, "Kalman (jerk to noise, s⁻⁵)", [1e10], x => ComparedPredictors.Kalman(x[0]));
        Report(to, "double exponential (time constant, s)", [0.01], x => ComparedPredictors.DoubleExponential(x[0]));
        Report(
            to, "One-Euro (minimum cut-off in Hz, Hz per mm/s, cut-off of the velocity in Hz)", [4, 0.01, 30],
            x => ComparedPredictors.OneEuro(x[0], x[1], x[2]));
    }

    static void Report(TextWriter to, string name, double[] start, Func<double[], JointPredictor> create)
    {
        to.WriteLine(name);
        Report(to, "all conditions, geometric mean", start, create, ComparedMotions.All);
        foreach (var condition in ComparedMotions.All) Report(to, condition.Name, start, create, [condition]);
    }

    static void Report(TextWriter to, string name, double[] start, Func<double[], JointPredictor> create, IReadOnlyList<ComparedMotion> conditions)
    {
        double[] constants = [.. start];
        var min = double.PositiveInfinity;
        for (var round = 0; round < MaxRounds; round++)
        {
            var before = min;
            for (var i = 0; i < constants.Length; i++) min = Improve(constants, i, create, conditions);
            if (!(min * AsGood < before)) break;
        }
        to.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"  {name}: {string.Join(", ", constants.Select(value => value.ToString("G3", CultureInfo.InvariantCulture)))} leaves {min:0.000}"));
    }

    // Finds the best value of one constant on the grid around its current value, and sets it.
    static double Improve(double[] constants, int index, Func<double[], JointPredictor> create, IReadOnlyList<ComparedMotion> conditions)
    {
        var centre = constants[index];
        var tried = Enumerable.Range(-StepsEachWay, 2 * StepsEachWay + 1).AsParallel()
            .Select(step =>
            {
                double[] values = [.. constants];
                values[index] = centre * Math.Pow(2, step / 2.0);
                return (Step: step, Value: values[index], Error: Mean(() => create(values), conditions));
            })
            // Excludes values that give no finite error, because NaN would count as the minimum.
            .Where(result => double.IsFinite(result.Error))
            .ToList();
        var min = tried.Min(result => result.Error);
        var best = tried.Where(result => result.Error <= AsGood * min).MinBy(result => Math.Abs(result.Step));
        constants[index] = best.Value;
        return best.Error;
    }

    static double Mean(Func<JointPredictor> create, IReadOnlyList<ComparedMotion> conditions)
    {
        var candidate = new ComparedPredictor("tried", create);
        return Means.Geometric(conditions.Select(condition => condition.Ratio(candidate, ComparedMotions.TuningSeeds)));
    }
}
