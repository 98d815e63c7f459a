using NUnit.Framework;
using UnityEngine;
using KnobRange = UnityEngine.RangeAttribute;

namespace Nowpose.Unity.Tests.Samples;

/// <summary>The displayed errors and the logged errors of a played sample.</summary>
static class SampleErrors
{
    /// <summary>
    /// Minimum error reduction. The measured values are 0.89 to 0.91, the same on every machine, because time is virtual and random numbers are
    /// seeded.
    /// </summary>
    public const double MinReduction = 0.85;

    public static double Rms(List<double> values) => Math.Sqrt(values.Average(value => value * value));

    public static string[] Complaints(PlayedSample sample) =>
        [.. sample.Player.Logs.Where(log => log.Type is LogType.Error or LogType.Exception).Select(log => log.Message)];
}
