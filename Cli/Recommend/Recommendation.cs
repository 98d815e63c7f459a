using Nowpose.Prediction;

namespace Nowpose.Cli.Recommend;

/// <summary>Determines the recommended candidate under one condition.</summary>
/// <remarks>
/// A predictor other than the default is recommended only if it is better on both halves and the total gain exceeds the minimum. Among
/// twenty candidates, one can have a slightly smaller error than the default by chance.
/// </remarks>
sealed class Recommendation
{
    /// <summary>Minimum gain over the default for recommending another predictor.</summary>
    public const double MinGain = 0.02;

    /// <param name="subject">The recording on which the candidates were evaluated.</param>
    /// <param name="trials">The results of all candidates, including the default predictor and <c>hold</c>.</param>
    public Recommendation(ISubject subject, IReadOnlyCollection<Trial> trials)
    {
        Subject = subject;
        Trials = [.. trials.OrderBy(trial => trial.Rms)];
        Default = Trials.Single(trial => trial.Predictor == Predictors.Default);
        Recommended = Trials.FirstOrDefault(trial => IsBetter(trial, Default)) ?? Default;
    }

    /// <summary>Upper limit of the relative difference between the total errors in a tie, exclusive.</summary>
    const double MaxTieDifference = 0.5;

    public ISubject Subject { get; }

    /// <summary>The results of all candidates in increasing order of their error.</summary>
    public IReadOnlyList<Trial> Trials { get; }

    public Trial Default { get; }

    public Trial Recommended { get; }

    /// <summary>Gets whether a candidate and the recommended one are each better on one half, so that neither is clearly better.</summary>
    public bool IsTie(Trial trial) => trial != Recommended && Math.Abs(trial.GainOver(Recommended) ?? 0) < MaxTieDifference
        && trial.IsBetterThan(Recommended, Half.First) != trial.IsBetterThan(Recommended, Half.Second);

    /// <summary>The reason for the recommendation, as the end of a sentence.</summary>
    public string Reason
    {
        get
        {
            var best = Trials[0];
            if (Recommended != Default)
                return RecommendTexts.SmallerError(100 * Recommended.GainOver(Default), Default.Predictor, Percent(Half.First), Percent(Half.Second));
            if (best == Default) return RecommendTexts.NoneBetter;
            return IsTie(best)
                ? RecommendTexts.EquallyGood(best.Predictor)
                : RecommendTexts.LittleBetter(best.Predictor, 100 * MinGain);
        }
    }

    static bool IsBetter(Trial trial, Trial standard) => trial.IsBetterThan(standard, Half.First) && trial.IsBetterThan(standard, Half.Second)
        && trial.GainOver(standard) > MinGain;

    string Percent(Half half) => FormattableString.Invariant($"{100 * Recommended.GainOver(Default, half):0} %");
}
