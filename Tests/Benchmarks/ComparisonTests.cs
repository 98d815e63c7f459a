using Nowpose.Benchmarks.Comparison;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Benchmarks;

/// <summary>Tests that the default predictor has a smaller error than all candidates, with a seed that was not used for tuning.</summary>
public class ComparisonTests
{
    static readonly int[] Seeds = [ComparedMotions.CheckingSeeds[0]];

    static IEnumerable<TestCaseData> All => ComparedMotions.All.Select(condition => new TestCaseData(condition).SetArgDisplayNames(condition.Name));

    [TestCaseSource(nameof(All))]
    public void DefaultPredictor_AllCandidates_HasTheSmallestError(ComparedMotion condition)
    {
        var ours = condition.Ratio(ComparedPredictors.Named(Predictors.Default), Seeds);

        foreach (var other in ComparedPredictors.All.Where(candidate => candidate.Name != Predictors.Default))
            Assert.That(condition.Ratio(other, Seeds), Is.GreaterThan(1.05 * ours), $"{other.Name}, seed {Seeds[0]}");
    }
}
