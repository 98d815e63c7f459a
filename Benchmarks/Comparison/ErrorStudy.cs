namespace Nowpose.Benchmarks.Comparison;

/// <summary>Computes the RMS error of each candidate under each condition, divided by the RMS error of hold.</summary>
public sealed class ErrorStudy
{
    readonly Dictionary<(string Candidate, string Condition), double> _ratios;

    public ErrorStudy(IEnumerable<int> seeds) => _ratios = (
        from candidate in Candidates.All.AsParallel()
        from condition in Conditions.All
        select (Key: (candidate.Name, condition.Name), Ratio: condition.Ratio(candidate, seeds)))
        .ToDictionary(result => result.Key, result => result.Ratio);

    public double this[Candidate candidate, Condition condition] => _ratios[(candidate.Name, condition.Name)];

    /// <summary>Gets the geometric mean over all conditions, all with the same weight.</summary>
    public double Mean(Candidate candidate) => Means.Geometric(Conditions.All.Select(condition => this[candidate, condition]));
}
