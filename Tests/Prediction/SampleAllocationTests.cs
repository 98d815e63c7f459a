using NUnit.Framework;
using Nowpose.Motion;
using Nowpose.Prediction;

namespace Nowpose.Headless.Tests.Prediction;

[NonParallelizable] // measures allocations
public class SampleAllocationTests
{
    static readonly PredictionLimits Drive = new(velocity: 1, acceleration: 4, jerk: 40);

    [TestCaseSource(typeof(Predictors), nameof(Predictors.Names))]
    public void Add_MovesOfADriveWithKnownLimits_AllocatesNothing(string name)
    {
        var predictor = Predictors.Create(name, Drive, blend: 0.01);
        var move = new SevenPhaseProfile(0.5, Drive.Velocity, Drive.Acceleration, Drive.Jerk);
        Play(predictor, move, 0, 10);

        var before = GC.GetAllocatedBytesForCurrentThread();
        Play(predictor, move, 10, 30);

        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
    }

    // Moves to a position, rests for half a second, and moves back. Each sample is displayed 0.1 s later.
    static void Play(JointPredictor predictor, SevenPhaseProfile move, double from, double to)
    {
        const double interval = 0.02;
        var half = move.Duration + 0.5;
        for (var time = from; time < to; time += interval)
        {
            var (turn, since) = ((int)(time / half), time % half);
            var way = move.PositionAt(Math.Min(since, move.Duration));
            predictor.Add(new JointSample(time, turn % 2 == 0 ? way : move.PositionAt(move.Duration) - way), time + 0.1);
            predictor.At(time + 0.1);
        }
    }
}
