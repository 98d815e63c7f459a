using Nowpose.Benchmarks.Comparison;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>Tests that the default predictor has a smaller error than all candidates, with a seed that was not used for tuning.</summary>
public class ComparisonTests
{
    static readonly int[] Seeds = [Conditions.CheckingSeeds[0]];

    static IEnumerable<TestCaseData> All => Conditions.All.Select(condition => new TestCaseData(condition).SetArgDisplayNames(condition.Name));

    [TestCaseSource(nameof(All))]
    public void DefaultPredictor_AllCandidates_HasTheSmallestError(Condition condition)
    {
        var ours = condition.Ratio(Candidates.Named(Predictors.Default), Seeds);

        foreach (var other in Candidates.All.Where(candidate => candidate.Name != Predictors.Default))
            Assert.That(condition.Ratio(other, Seeds), Is.GreaterThan(1.05 * ours), $"{other.Name}, seed {Seeds[0]}");
    }
}
