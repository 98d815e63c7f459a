using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Prediction;

[NonParallelizable] // measures allocations
public class BodyAllocationTests
{
    [TestCase("linear")]
    [TestCase("adaptive")]
    public void AddAndAt_Body_AllocateNothing(string name)
    {
        var predictor = new BodyPredictor(name, new PredictionLimits(), blend: 0.01);
        var sum = 0.0;
        Play(0, 300);

        var before = GC.GetAllocatedBytesForCurrentThread();
        Play(300, 900);
        var allocated = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.That(allocated, Is.Zero);
        Assert.That(sum, Is.Not.NaN);

        void Play(int from, int to)
        {
            for (var k = from; k < to; k++)
            {
                var t = 0.02 * k;
                var rotation = UnitQuaternion.Exp(new Vector3D(0.3 * Math.Sin(t), 0.2 * Math.Cos(2 * t), t));
                predictor.Add(new PoseSample(t, new Vector3D(Math.Sin(t), Math.Cos(t), 0.1 * t), rotation), t + 0.1);
                sum += predictor.At(t + 0.12).X + predictor.Hold.X;
            }
        }
    }
}
