using System.Runtime.CompilerServices;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Prediction;

[NonParallelizable] // measures allocations
public class PredictorAllocationTests
{
    static IReadOnlyList<string> Names => Predictors.Names;

    [TestCaseSource(nameof(Names))]
    public void AddAndAt_AfterWarmUp_AllocateNothing(string name)
    {
        var predictor = Predictors.Create(name, new PredictionLimits(), blend: 0.01);
        Run(predictor, 0);

        var allocated = AllocatedByRun(predictor, out var sum);

        Assert.That(allocated, Is.EqualTo(0));
        Assert.That(sum, Is.Not.EqualTo(0));
    }

    // This is a separate method, because the compiler could otherwise move the boxing of the asserted numbers into the measured code.
    [MethodImpl(MethodImplOptions.NoInlining)]
    static long AllocatedByRun(JointPredictor predictor, out double sum)
    {
        var before = GC.GetAllocatedBytesForCurrentThread();
        sum = Run(predictor, 100);
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }

    static double Run(JointPredictor predictor, double start)
    {
        var (sum, displayed) = (0.0, double.NaN);
        for (var i = 0; i < 1000; i++)
        {
            var t = start + i * 0.05;
            predictor.Add(new JointSample(t, Math.Sin(t)), displayed);
            if (i % 10 == 0) predictor.Add(new JointSample(t - 0.06, 0.5), displayed);
            for (var frame = 0; frame < 3; frame++)
            {
                displayed = t + 0.1 + frame * 0.0167;
                sum += predictor.At(displayed).Position;
                predictor.DeviationAt(displayed);
            }
        }
        return sum;
    }
}
