namespace Nowpose.Benchmarks.Comparison;

/// <summary>Computes the RMS error of each candidate under each condition, divided by the RMS error of hold.</summary>
public sealed class ErrorStudy
{
    readonly Dictionary<(string ComparedPredictor, string ComparedMotion), double> _ratios;

    public ErrorStudy(IEnumerable<int> seeds) => _ratios = (
        from candidate in ComparedPredictors.All.AsParallel()
        from condition in ComparedMotions.All
        select (Key: (candidate.Name, condition.Name), Ratio: condition.Ratio(candidate, seeds)))
        .ToDictionary(result => result.Key, result => result.Ratio);

    public double this[ComparedPredictor candidate, ComparedMotion condition] => _ratios[(candidate.Name, condition.Name)];

    /// <summary>Gets the geometric mean over all conditions, all with the same weight.</summary>
    public double Mean(ComparedPredictor candidate) => Means.Geometric(ComparedMotions.All.Select(condition => this[candidate, condition]));
}
